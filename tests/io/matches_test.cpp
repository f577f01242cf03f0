#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "gmcr/io.hpp"
#include "io/expect_io_error.hpp"
#include "io/temporary_folder.hpp"

namespace gmcr::io {
namespace {

using test::TemporaryFolder;

void expect_refused(const std::filesystem::path& path, std::size_t line, const std::string& words) {
  test::expect_io_error([&] { read_matches(path); }, path, line, words);
}

RC_GTEST_PROP(Matches, AreReadBackBitForBit, (std::vector<double> values)) {
  const TemporaryFolder folder;
  for (double& value : values) {
    if (!std::isfinite(value)) value = -1e300;
  }
  values.resize(values.size() / 6 * 6);
  // whole numbers in the first column of an .npy of seven may be those of the matches
  if (!values.empty()) values[0] = 0.5;
  const auto count = static_cast<Index>(values.size()) / 6;
  const Points source = Eigen::Map<const Points>(values.data(), 3, count);
  const Points target = Eigen::Map<const Points>(values.data() + 3 * count, 3, count);
  std::vector<double> bounds;
  for (Index i = 0; i < count; ++i) {
    const double value = std::abs(source(0, i));
    bounds.push_back(value > 0 ? value : 5e-324);
  }
  for (const char* name : {"a.csv", "a.npy"}) {
    write_matches(folder / name, source, target);
    const Matches matches = read_matches(folder / name);
    RC_ASSERT(matches.source.cols() == count);
    RC_ASSERT(matches.source == source);
    RC_ASSERT(matches.target == target);
    RC_ASSERT(matches.noise_bounds.empty());
    write_matches(folder / name, source, target, bounds);
    const Matches with_bounds = read_matches(folder / name);
    RC_ASSERT(with_bounds.source == source);
    RC_ASSERT(with_bounds.target == target);
    RC_ASSERT(with_bounds.noise_bounds == bounds);
  }
}

TEST(ReadMatches, FindsTheColumnsThatAHeaderNames) {
  const TemporaryFolder folder;
  for (const char* text :
       {"1,2,3,4,5,6\n", "ax,ay,az,bx,by,bz\n1,2,3,4,5,6\n",
        "sx,sy,sz,tx,ty,tz,gt_residual\n1,2,3,4,5,6,99\n",
        "i,j,sx,sy,sz,tx,ty,tz,pfh_distance\n7,8,1,2,3,4,5,6,nan\n",
        "bz;by;bx;az;ay;ax;name\n6;5;4;3;2;1;first\n",
        "source_x source_y source_z target_x target_y target_z\n1 2 3 4 5 6\n",
        "SRC_X,SRC_Y,SRC_Z,DST_X,DST_Y,DST_Z\n1,2,3,4,5,6\n", "u,v,w,p,q,r\n1,2,3,4,5,6\n",
        "\"1\",\"2\",\"3\",\"4\",\"5\",\"6\"\n", "# bx by bz ax ay az\n4 5 6 1 2 3\n"}) {
    const Matches matches = read_matches(folder.write("a.csv", text));
    EXPECT_EQ(matches.source, (Points{{1}, {2}, {3}})) << text;
    EXPECT_EQ(matches.target, (Points{{4}, {5}, {6}})) << text;
    EXPECT_TRUE(matches.noise_bounds.empty()) << text;
  }
}

TEST(ReadMatches, KnowsSourceAndTargetByWhatTheirColumnsAreCalledInAnyOrder) {
  const TemporaryFolder folder;
  for (const char* header :
       {"x_2,y_2,z_2,x_1,y_1,z_1", "xt,yt,zt,xs,ys,zs", "q_x,q_y,q_z,p_x,p_y,p_z",
        "to_x,to_y,to_z,from_x,from_y,from_z", "X1,Y1,Z1,X0,Y0,Z0", "x_b,y_b,z_b,x_a,y_a,z_a",
        "ref_x,ref_y,ref_z,mov_x,mov_y,mov_z", "fixed.x,fixed.y,fixed.z,moving.x,moving.y,moving.z",
        "X Dest,Y Dest,Z Dest,X Source,Y Source,Z Source", "tgt_x,tgt_y,tgt_z,src_x,src_y,src_z",
        "target_x,target_y,target_z,x,y,z", "x,y,z,source_x,source_y,source_z",
        "kp1_x,kp1_y,kp1_z,kp0_x,kp0_y,kp0_z", "zTarget,yTarget,xTarget,zSource,ySource,xSource",
        "N2 [m],E2 [m],H2 [m],N1 [m],E1 [m],H1 [m]"}) {
    const bool is_zyx = header[0] == 'z';
    const bool is_north_first = header[0] == 'N';
    const std::string rows = is_zyx           ? "\n6,5,4,3,2,1\n"
                             : is_north_first ? "\n5,4,6,2,1,3\n"
                                              : "\n4,5,6,1,2,3\n";
    const Matches matches = read_matches(folder.write("a.csv", header + rows));
    EXPECT_EQ(matches.source, (Points{{1}, {2}, {3}})) << header;
    EXPECT_EQ(matches.target, (Points{{4}, {5}, {6}})) << header;
    EXPECT_TRUE(matches.notes.empty()) << header;
  }
}

TEST(ReadMatches, LeavesOutFurtherColumnsEvenThoseThatAreTwice) {
  const TemporaryFolder folder;
  const Matches matches = read_matches(
      folder.write("a.csv", "ax,ay,az,bx,by,bz,nx,ny,nz,nx,ny,nz\n1,2,3,4,5,6,0,0,1,0,0,1\n"));
  EXPECT_EQ(matches.source, (Points{{1}, {2}, {3}}));
  EXPECT_EQ(matches.target, (Points{{4}, {5}, {6}}));
  const Matches others = read_matches(
      folder.write("a.csv", "id,model_x,model_y,model_z,scene_x,scene_y,scene_z\n7,1,2,3,4,5,6\n"));
  EXPECT_EQ(others.source, (Points{{1}, {2}, {3}}));
  EXPECT_EQ(others.target, (Points{{4}, {5}, {6}}));
}

TEST(ReadMatches, TakesTheFirstSideForTheSourceWhereTheNamesDoNotTellAndSaysSo) {
  const TemporaryFolder folder;
  const std::string rows = "\n1,2,3,4,5,6\n";
  for (const auto& [header, source] :
       {std::pair{"model_x,model_y,model_z,scene_x,scene_y,scene_z", "'model_x', 'model_y'"},
        {"x,y,z,x',y',z'", "'x', 'y', 'z'"},
        {"x,y,z,x.1,y.1,z.1", "'x', 'y', 'z'"},
        {"u,v,w,p,q,r", "'u', 'v', 'w'"}}) {
    const Matches matches = read_matches(folder.write("a.csv", header + rows));
    EXPECT_EQ(matches.source, (Points{{1}, {2}, {3}})) << header;
    EXPECT_EQ(matches.target, (Points{{4}, {5}, {6}})) << header;
    ASSERT_EQ(matches.notes.size(), 1U) << header;
    EXPECT_TRUE(matches.notes[0].starts_with("columns " + std::string(source))) << header;
    EXPECT_NE(matches.notes[0].find("taken for the source"), std::string::npos) << header;
  }
  const Matches turned =
      read_matches(folder.write("a.csv", "z_cad,y_cad,x_cad,x_scan,y_scan,z_scan\n3,2,1,4,5,6\n"));
  EXPECT_EQ(turned.source, (Points{{1}, {2}, {3}}));
}

TEST(ReadMatches, RefusesNamesOfWhichTwoAreOneCoordinate) {
  const TemporaryFolder folder;
  for (const char* header : {"ax,ay,az,ax,ay,az", "x,y,z,X,Y,Z"}) {
    expect_refused(folder.write("a.csv", std::string(header) + "\n1,2,3,4,5,6\n"), 1,
                   "are the same coordinate");
  }
  expect_refused(
      folder.write("a.csv", "ax,ay,az,bx,by,bz,x1,y1,z1,x2,y2,z2\n1,2,3,4,5,6,1,2,3,4,5,6\n"), 1,
      "several pairs of columns");
  expect_refused(folder.write("a.csv", "px,py,pz,qx,qy,qz,qw\n1,2,3,0,0,0,1\n"), 1, "7 columns");
}

TEST(ReadMatches, FindsTheNoiseBoundOfEachCorrespondence) {
  const TemporaryFolder folder;
  for (const char* text :
       {"1,2,3,4,5,6,0.7\n10,20,30,40,50,60,0.07\n",
        "ax,ay,az,bx,by,bz,noise_bound\n1,2,3,4,5,6,0.7\n10,20,30,40,50,60,0.07\n",
        "Beta;tx;ty;tz;sz;sy;sx;note\n0.7;4;5;6;3;2;1;a\n0.07;40;50;60;30;20;10;b\n",
        "BOUND ax ay az bx by bz residual\n.7 1 2 3 4 5 6 9\n.07 10 20 30 40 50 60 9\n",
        "u,v,w,Noise_Bound,p,q,r\n1,2,3,0.7,4,5,6\n10,20,30,0.07,40,50,60\n"}) {
    const Matches matches = read_matches(folder.write("a.csv", text));
    EXPECT_EQ(matches.source, (Points{{1, 10}, {2, 20}, {3, 30}})) << text;
    EXPECT_EQ(matches.target, (Points{{4, 40}, {5, 50}, {6, 60}})) << text;
    EXPECT_EQ(matches.noise_bounds, (std::vector<double>{0.7, 0.07})) << text;
  }
}

TEST(ReadMatches, TakesASeventhColumnWithoutANameForBoundsOnlyWhereItIsNoScore) {
  const TemporaryFolder folder;
  const Matches bounds =
      read_matches(folder.write("a.csv", "1,2,3,4,5,6,0.2\n9,20,30,4,5,60,0.1\n"));
  EXPECT_EQ(bounds.noise_bounds, (std::vector<double>{0.2, 0.1}));
  EXPECT_EQ(bounds.notes, std::vector<std::string>{
                              "the 7th column, 0.1 to 0.2, is taken for noise bounds in metres"});
  std::string scores, weights;
  for (int i = 0; i < 10; ++i) {
    const std::string row = std::to_string(i * i) + ",2," + std::to_string(i) + ",4,5,6,";
    scores += row + "0." + std::to_string(70 - i) + "\n";
    weights += row + std::to_string(90 - i) + "\n";
  }
  expect_refused(folder.write("b.csv", scores), 0,
                 "has no name and goes from 0.61 to 0.7: noise bounds in metres, or scores?");
  expect_refused(folder.write("c.csv", weights), 0, "or scores?");
  const Points points = Points::Random(3, 10);
  const std::vector<double> confidences{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1};
  write_matches(folder / "d.npy", points, points, confidences);
  expect_refused(folder / "d.npy", 0, "or scores?");
}

TEST(ReadMatches, LeavesScoresOutAndSaysSo) {
  const TemporaryFolder folder;
  for (const char* text :
       {"x1,y1,z1,x2,y2,z2,score\n1,2,3,4,5,6,0.7\n", "ax,ay,az,bx,by,bz,Weight\n1,2,3,4,5,6,0.7\n",
        "u,v,w,p,q,r,confidence\n1,2,3,4,5,6,0.7\n"}) {
    const Matches matches = read_matches(folder.write("a.csv", text));
    EXPECT_EQ(matches.source, (Points{{1}, {2}, {3}})) << text;
    EXPECT_EQ(matches.target, (Points{{4}, {5}, {6}})) << text;
    EXPECT_TRUE(matches.noise_bounds.empty()) << text;
    ASSERT_FALSE(matches.notes.empty()) << text;
    EXPECT_TRUE(matches.notes.back().starts_with("not used: column '")) << matches.notes.back();
  }
}

TEST(ReadMatches, RefusesAFirstColumnThatCountsTheRows) {
  const TemporaryFolder folder;
  std::string text;
  for (int i = 1; i < 9; ++i) text += std::to_string(i) + ",0.5,1.5,2.5,3.5,4.5,5.5\n";
  expect_refused(folder.write("a.csv", text), 1, "counts the rows");
}

TEST(ReadMatches, RefusesAFirstColumnOfSevenThatMayNumberTheRows) {
  const TemporaryFolder folder;
  const std::string others = ",0.5,1.5,2.5,3.5,4.5,5.5\n";
  for (const std::vector<const char*>& numbers :
       std::vector<std::vector<const char*>>{{"101", "102", "104", "105"},  // gaps
                                             {"7", "3", "9", "1"},          // shuffled
                                             {"20.000", "10.000", "30.000"}}) {
    std::string text;
    Eigen::MatrixXd rows(7, static_cast<Index>(numbers.size()));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      text += numbers[i] + others;
      rows.col(static_cast<Index>(i)) << std::stod(numbers[i]), 0.5, 1.5, 2.5, 3.5, 4.5, 5.5;
    }
    expect_refused(folder.write("a.csv", text), 1, "the others may be shifted");
    write_matches(folder / "a.npy", rows.topRows<3>(), rows.middleRows<3>(3),
                  std::vector<double>(numbers.size(), 5.5));
    expect_refused(folder / "a.npy", 0, "the others may be shifted");
    EXPECT_EQ(read_matches(folder.write("b.csv", "id,ax,ay,az,bx,by,bz\n" + text)).source(0, 0),
              0.5);
  }
}

TEST(ReadMatches, TakesAFirstCoordinateInWholeMetresForOne) {
  const TemporaryFolder folder;
  for (const char* text : {"1,2,3,4,5,6,7\n1,5,3,4,5,6,7\n1,2,9,4,5,6,7\n",
                           "1.0,2.5,3,4,5,6,7\n1.0,5,3,4,5,6,7\n1.0,2,9,4,5,6,7\n"}) {
    EXPECT_EQ(read_matches(folder.write("a.csv", text)).noise_bounds.size(), 3U) << text;
  }
}

TEST(ReadMatches, RefusesABoundThatIsNotPositiveAndFinite) {
  const TemporaryFolder folder;
  for (const char* bound : {"0", "-1", "nan", "inf"}) {
    const std::string text = "ax,ay,az,bx,by,bz,beta\n1,2,3,4,5,6,1\n1,2,3,4,5,6," +
                             std::string(bound) + "\n1,2,3,4,5,6,1\n";
    expect_refused(
        folder.write("a.csv", text), 3,
        "row 1 (from 0): noise bound " + std::string(bound) + " is not a positive finite");
  }
  expect_refused(folder.write("b.csv", "1,2,3,4,5,6,wide\n"), 1, "column 7: 'wide' is no number");
}

TEST(ReadMatches, TakesAHeaderWithoutRowsForNoMatches) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_matches(folder.write("a.csv", "ax,ay,az,bx,by,bz\n")).source.cols(), 0);
}

TEST(ReadMatches, NamesTheLineOfAnError) {
  const TemporaryFolder folder;
  expect_refused(folder.write("a.csv", "1,2,3,4,5,6,7,8\n"), 1, "8 columns, expected 6");
  expect_refused(folder.write("a.csv", "u,v,w,p,q,r,x\n"), 1, "7 columns, expected 6");
  expect_refused(folder.write("b.csv", "i,j,u,v,w,p,q,r\n"), 1, "8 columns, expected 6");
  expect_refused(folder.write("c.csv", "1,2,3,4,5,6\n1,2,3,4,5\n"), 2, "5 columns");
  expect_refused(folder.write("d.csv", "1,2,3,4,5,6\n1,2,3,4,5,six\n"), 2, "'six'");
  expect_refused(folder.write("e.csv", "1,2,x,4,5,6\n1,2,3,4,5,6\n"), 1, "'x'");
  expect_refused(folder.write("f.csv", "ax,ay,az,bx,by,bz\n\n1,2,3,4,5,6\n1,2,3,4,nan,6\n"), 4,
                 "row 1 (from 0): a value is not finite");
  expect_refused(folder.write("g.csv", "1,2,3,4,5,1e999\n"), 1, "'1e999'");
}

TEST(ReadMatches, RefusesARowWithoutNumbersByItsLineWhereverItIs) {
  const TemporaryFolder folder;
  const std::string header = "bx,by,bz,ax,ay,az\n";
  const std::string row = "4,5,6,1,2,3.5\n";
  for (const char* missing : {"NA,NA,NA,NA,NA,NA\n", "null,null,null,null,null,null\n",
                              "None,None,None,None,None,None\n", "-,-,-,-,-,-\n", ",,,,,\n"}) {
    expect_refused(folder.write("a.csv", header + missing + row), 2,
                   "row 0 (from 0): a value is not finite");
    expect_refused(folder.write("a.csv", header + row + missing + row), 3,
                   "row 1 (from 0): a value is not finite");
    expect_refused(folder.write("a.csv", missing + row), 1, "row 0 (from 0)");
  }
  const Matches matches = read_matches(folder.write("a.csv", header + "m,m,m,m,m,m\n" + row));
  EXPECT_EQ(matches.source, (Points{{1}, {2}, {3.5}}));
}

TEST(ReadMatches, TakesALineOfOneIntegerForTheirNumber) {
  const TemporaryFolder folder;
  const std::string rows = "1 2 3 4 5 6\n7 8 9 10 11 12\n";
  EXPECT_EQ(read_matches(folder.write("a.txt", "2\n" + rows)).source.cols(), 2);
  expect_refused(folder.write("a.txt", "3\n" + rows), 0, "2 matches, the first line says 3");
}

TEST(ReadMatches, RefusesOtherFiles) {
  const TemporaryFolder folder;
  expect_refused(folder / "a.csv", 0, "No such file");
  expect_refused(folder.write("a.csv", ""), 0, "empty");
  expect_refused(folder.write("a.ply", "ply\n"), 0,
                 "unknown extension '.ply' (known: .csv, .txt, .npy)");
  expect_refused(folder.write("a.npy", "1,2,3,4,5,6\n"), 0, "no .npy file");
  write_cloud(folder / "cloud.npy", Points::Ones(3, 2));
  expect_refused(folder / "cloud.npy", 0, "shape (2, 3), expected (N, 6) or (N, 7)");
  Points bad = Points::Ones(3, 2);
  bad(0, 1) = INFINITY;
  write_matches(folder / "bad.npy", bad, bad);
  expect_refused(folder / "bad.npy", 0, "row 1 (from 0)");
}

TEST(WriteMatches, RefusesSidesOfDifferentLengthAndBadBounds) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_matches(folder / "a.csv", Points::Ones(3, 2), Points::Ones(3, 1)),
               std::invalid_argument);
  const Points points = Points::Ones(3, 2);
  for (const std::vector<double>& bounds :
       std::vector<std::vector<double>>{{1}, {1, 2, 3}, {1, 0}, {-1, 1}, {1, NAN}, {INFINITY, 1}}) {
    EXPECT_THROW(write_matches(folder / "a.csv", points, points, bounds), std::invalid_argument)
        << testing::PrintToString(bounds);
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "a.csv"));
  EXPECT_THROW(write_matches(folder / "a.foo", Points::Ones(3, 1), Points::Ones(3, 1)), IoError);
}

}  // namespace
}  // namespace gmcr::io
