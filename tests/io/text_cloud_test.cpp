#include <gtest/gtest.h>

#include "gmcr/io.hpp"
#include "io/expect_io_error.hpp"
#include "io/file_bytes.hpp"
#include "io/temporary_folder.hpp"

namespace gmcr::io {
namespace {

using test::TemporaryFolder;

const Points kTwoOfText{{1.5, 4.5}, {2.5, 5.25}, {-3, 6}};

TEST(TextCloud, IsReadByWhatItHoldsWhateverItsExtension) {
  const TemporaryFolder folder;
  for (const char* text : {
           "1.5 2.5 -3\n4.5 5.25 6\n",
           "1.5,2.5,-3\r\n4.5,5.25,6\r\n",
           "1.5;2.5;-3\n4.5;5.25;6\n",
           "\t1.5\t2.5\t-3\t\n\t4.5\t5.25\t6\t\n",
           "2\n1.5 2.5 -3\n4.5 5.25 6\n",     // a count
           "1\n1.5 2.5 -3\n1\n4.5 5.25 6\n",  // of two scans
           "//X;Y;Z;R;Nx\n2\n1.5;2.5;-3;9;1\n4.5;5.25;6;9;1\n",
           "x y z\n1.5 2.5 -3\n4.5 5.25 6\n",
           "# made by hand\n#z y x\n-3 2.5 1.5\n6 5.25 4.5\n",
           "Exported scan\nX [m],Y [m],Z [m],\n1.5,2.5,-3,\n4.5,5.25,6,\n",
           "\"East\",\"North\",\"Elevation\",\"i\"\n1.5,2.5,-3,9\n4.5,5.25,6,9\n",
           "i,Points:0,Points:1,Points:2\n9,1.5,2.5,-3\n9,4.5,5.25,6\n",
           "1,5;2,5;-3\n4,5;5,25;6\n",  // decimal commas
           "1,5 2,5 -3\n4,5 5,25 6\n",
           "1.5D+00 2.5d0 -3.0D0\n4.5D0 5.25D0 6\n",  // Fortran
           "1.5 2.5 -3 # first\n4.5 5.25 6 # second\n",
           "x;y;z;label\n1,5;2,5;-3;wall\n4,5;5,25;6;floor\n",
           "\"1.5\",\"2.5\",\"-3\"\n\"4.5\",\"5.25\",\"6\"\n",  // between quotation marks
           "'1.5','2.5','-3'\n'4.5','5.25','6'\n",
           "\"a, "
           "b\",\"y\",\"x\",\"z\"\n\"p q\",\"2,5\",\"1,5\",\"-3\"\n\"\",\"5,25\",\"4,5\",\"6\"\n",
           "z,y,x\nm,m,m\n-3,2.5,1.5\n6,5.25,4.5\n",  // units and types
           "id,z,y,x\n-,[m],[m],[m]\n7,-3,2.5,1.5\n7,6,5.25,4.5\n",
           "z,y,x\nfloat,float,float\n-3,2.5,1.5\n6,5.25,4.5\n",
           "# i z y x\n# units: m\n7 -3 2.5 1.5\n7 6 5.25 4.5\n",
           "# columns: i z y x\n# made by Tool 1\n7 -3 2.5 1.5\n7 6 5.25 4.5\n",
           "i [-] Z [m] Y [m] X [m]\n7 -3 2.5 1.5\n7 6 5.25 4.5\n",
           "%time,field.z,field.y,field.x\n7,-3,2.5,1.5\n7,6,5.25,4.5\n",
           "//Z Y X Scalar field #2 Nx\n-3 2.5 1.5 7 0\n6 5.25 4.5 7 0\n",  // blanks in names
       }) {
    for (const char* name : {"a.xyz", "a.txt", "a.asc", "a.pts", "a.csv"}) {
      EXPECT_EQ(read_cloud(folder.write(name, text)).points, kTwoOfText) << name << "\n" << text;
    }
  }
}

TEST(TextCloud, KnowsCoordinatesByManyNames) {
  const TemporaryFolder folder;
  for (const char* header : {"i,Z,Y,X",
                             "t_s,Z_m,Y_m,X_m",
                             "i,Z/m,Y/m,X/m",
                             "i,z_coord,y_coord,x_coord",
                             "i,zcoord,ycoord,xcoord",
                             "i,pose.position.z,pose.position.y,pose.position.x",
                             "i,Z-Coordinate,Y-Coordinate,X-Coordinate",
                             "i,Z Coord,Y Coord,X Coord",
                             "i,.z,.y,.x",
                             "i,Points_m_XYZ:2,Points_m_XYZ:1,Points_m_XYZ:0",
                             "i,XYZ[2],XYZ[1],XYZ[0]",
                             "i,Z_UTM,Y_UTM,X_UTM",
                             "i,pz,py,px",
                             "id,U,N,E",
                             "Nr,H,N,E",
                             "i,Z,N,E",
                             "i,H\xC3\xB6he,Hochwert,Rechtswert",
                             "i,H\xF6he,Hochwert,Rechtswert",
                             "i,Height (m),Northing (m),Easting (m)",
                             "i,H,Y,X",
                             "u,z,northing,easting",
                             "z_local,z,y,x"}) {
    const std::string text = header + std::string("\n9,-3,2.5,1.5\n9,6,5.25,4.5\n");
    EXPECT_EQ(read_cloud(folder.write("a.csv", text)).points, kTwoOfText) << header;
  }
  for (const char* header : {"N,E,Z", "Hochwert;Rechtswert;H\xC3\xB6he", "y1 x1 z1"}) {
    const std::string text = header + std::string("\n2.5 1.5 -3\n5.25 4.5 6\n");
    const Cloud cloud = read_cloud(folder.write("a.txt", text));
    EXPECT_EQ(cloud.points, kTwoOfText) << header;
    ASSERT_EQ(cloud.notes.size(), 1U) << header;
    EXPECT_TRUE(cloud.notes[0].starts_with("x, y, z are the columns")) << cloud.notes[0];
  }
}

TEST(TextCloud, ThatNamesSomeCoordinatesOnlyIsRefused) {
  const TemporaryFolder folder;
  for (const char* header : {"x,y,intensity", "x,y,range", "t,x,y", "E,N,v", "x1,y1,i"}) {
    const auto path = folder.write("a.csv", header + std::string("\n1,2,3.5\n"));
    test::expect_io_error([&] { read_cloud(path); }, path, 1, "do not name all of x, y and z");
  }
  const auto path = folder.write("a.csv", "x,y,z,X,Y,Z\n1,2,3,4,5,6.5\n");
  test::expect_io_error([&] { read_cloud(path); }, path, 1, "are the same coordinate");
}

TEST(TextCloud, TakesTheFirstThreeOfMoreColumnsAndSaysSo) {
  const TemporaryFolder folder;
  const Cloud cloud = read_cloud(folder.write("a.pts", "1.5 2.5 -3 9 1 1 1\n4.5 5.25 6 9 1 1 1\n"));
  EXPECT_EQ(cloud.points, kTwoOfText);
  ASSERT_EQ(cloud.notes.size(), 1U);
  EXPECT_EQ(cloud.notes[0], "x, y, z are the first 3 of 7 columns");
}

TEST(TextCloud, ThatIsMostlyOnePointIsSaidToBeSo) {
  const TemporaryFolder folder;
  const Cloud cloud = read_cloud(folder.write("a.xyz", "1 2 3\n9 9 9\n1 2 3\n8 8 8\n1 2 3\n"));
  EXPECT_EQ(cloud.points.cols(), 5);
  EXPECT_EQ(cloud.notes, std::vector<std::string>{"3 of 5 points are one and the same"});
  EXPECT_TRUE(read_cloud(folder.write("b.xyz", "1 2 3\n9 9 9\n1 2 3\n8 8 8\n")).notes.empty());
}

TEST(TextCloud, DropsRowsWithoutANumberForACoordinate) {
  const TemporaryFolder folder;
  const Cloud cloud = read_cloud(folder.write(
      "a.csv",
      "x,y,z\n1.5,2.5,-3\n,,\nNA,1,1\n-1.#IND,2,3\n-nan(ind),2,3\n4.5,5.25,6\n1,null,2\n"));
  EXPECT_EQ(cloud.points, kTwoOfText);
  EXPECT_EQ(cloud.num_dropped, 5);
}

TEST(TextCloud, KeepsItsHeaderWhereTheFirstRowsHoldNoNumber) {
  const TemporaryFolder folder;
  for (const char* row : {"NA,NA,NA", "null,null,null", "None,None,None", "N/A,N/A,N/A", "-,-,-",
                          ",,", "nan,nan,nan", "#NUM!,#NUM!,#NUM!"}) {
    const std::string text = "z,y,x\n" + std::string(row) + "\n-3,2.5,1.5\n6,5.25,4.5\n";
    const Cloud cloud = read_cloud(folder.write("a.csv", text));
    EXPECT_EQ(cloud.points, kTwoOfText) << row;
    EXPECT_EQ(cloud.num_dropped, 1) << row;
  }
}

TEST(TextCloud, IsReadAsUtf16) {
  const TemporaryFolder folder;
  const std::string text = "z;y;x;h\xE4\n-3;2,5;1,5;0\n6;5,25;4,5;0\n";
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    for (const bool has_mark : {true, false}) {
      std::string bytes = has_mark ? test::bytes_of(std::uint16_t{0xFEFF}, order) : "";
      for (const char c : text) {
        bytes += test::bytes_of(std::uint16_t{static_cast<unsigned char>(c)}, order);
      }
      EXPECT_EQ(read_cloud(folder.write("a.csv", bytes)).points, kTwoOfText);
    }
  }
}

TEST(TextCloud, ThatIsAmbiguousIsRefusedWithWhatToSay) {
  const TemporaryFolder folder;
  const auto expect = [&](const std::string& text, std::size_t line, const std::string& words) {
    const auto path = folder.write("a.txt", text);
    test::expect_io_error([&] { read_cloud(path); }, path, line, words);
  };
  expect("1,5,2,05,-3,0\n4,5,5,25,6,0\n", 1, "decimal commas: put a line with the names");
  expect("0 1.5 2.5 -3\n1 4.5 5.25 6\n2 4.5 5.25 7\n", 1, "index or a time of the point");
  expect("17 1.5 2.5 -3.5\n3 4.5 5.25 6.5\n8 4.5 5.25 7.5\n", 1, "index or a time of the point");
  expect("lat,lon,alt\n48.1,11.5,500.5\n", 1, "latitude");
  expect("a,b,c,d\n1,2,3,4\n", 1,
         "'a', 'b', 'c', 'd': expected 3 or a header that names x, y and z");
  expect("x,y,z\n1,2\n", 2, "2 columns where line 1 has 3");
  expect("x y z\n1 2 3 4\n", 2, "4 columns where line 1 has 3");  // of R, with names of rows
  expect("//R G B X Y Z Scalar field\n1 2 3 4 5 6.5 7\n", 2, "7 columns where line 1 has 8");
  expect("x,y,z\nwall,wall,wall\n1,2,3\n", 2, "column 1: 'wall' is no number");
  expect("3\n1 2 3\n4 5 6\n", 0, "2 points, the first line says 3");
  expect("//X Y Z\n3\n1 2 3\n4 5 6\n", 0, "2 points, line 2 says 3");
  expect("1,234.5 6,789.0 3\n", 1, "is no number");
  expect(std::string("1 2 3\n\0 5 6\n", 12), 0, "bytes of value 0");
  expect("only words\n", 1, "expected 3");
  std::string transposed;
  for (int i = 0; i < 3 * 30; ++i)
    transposed += std::to_string(i) + (i % 30 == 29 ? ".5\n" : ".5 ");
  expect(transposed, 1, "3 rows of 30 columns: a row is a point");
}

TEST(TextCloud, CutInsideItsLastNumberIsRefusedWhereItShows) {
  const TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 9; ++i) text += "1.250000 2.500000 " + std::to_string(i) + ".125000\n";
  ASSERT_EQ(read_cloud(folder.write("a.xyz", text)).points.cols(), 9);
  for (std::size_t cut = 2; cut <= 7; ++cut) {
    const auto path = folder.write("a.xyz", text.substr(0, text.size() - cut));
    test::expect_io_error([&] { read_cloud(path); }, path, 9, "the file ends inside a line");
  }
  const Cloud whole = read_cloud(folder.write("a.xyz", text.substr(0, text.size() - 1)));
  ASSERT_EQ(whole.notes.size(), 1U);
  EXPECT_EQ(whole.notes[0], "the last line has no end: the file may be cut there");
}

std::string scan_of(int num_columns, int num_points) {
  test::Noise noise(7);
  std::string bytes;
  for (int i = 0; i < num_points; ++i) {
    for (int j = 0; j < num_columns; ++j) {
      const double value = noise.uniform();
      const double spread = j == 0 ? 80 * value - 40 : j == 1 ? 40 * value - 10 : value - 2;
      bytes += test::bytes_of(static_cast<float>(j == 3 ? value * value : j > 3 ? 30 : spread));
    }
  }
  return bytes;
}

TEST(BinaryScan, OfASizeThatFitsSeveralLayoutsIsReadByWhatItHolds) {
  const TemporaryFolder folder;
  for (const int num_columns : {3, 4, 5}) {
    const auto path = folder.write("a.bin", scan_of(num_columns, 1200));
    const Cloud cloud = read_cloud(path);
    EXPECT_EQ(cloud.points.cols(), 1200) << num_columns;
    EXPECT_LT(cloud.points.row(2).maxCoeff(), 0) << num_columns;
    ASSERT_EQ(cloud.notes.size(), 1U) << num_columns;
    const std::string words =
        "read as " + std::to_string(num_columns) + ", by what the columns hold";
    EXPECT_NE(cloud.notes[0].find(words), std::string::npos) << cloud.notes[0];
    EXPECT_EQ(read_cloud(path, {.bin_columns = 3}).points.cols(), 400 * num_columns);
  }
}

TEST(BinaryScan, ThatDoesNotTellIsKittiWithADoubt) {
  const TemporaryFolder folder;
  const Cloud cloud = read_cloud(folder.write("a.bin", scan_of(4, 3)));
  EXPECT_EQ(cloud.points.cols(), 3);
  ASSERT_EQ(cloud.notes.size(), 1U);
  EXPECT_NE(cloud.notes[0].find("fits 3 or 4 or 6 float32"), std::string::npos) << cloud.notes[0];
  test::Noise noise(3);
  std::vector<float> cube;  // of which every column holds the same
  for (int i = 0; i < 3 * 4000; ++i) cube.push_back(static_cast<float>(noise.uniform()));
  const auto same = folder.write("c.bin", test::bytes_of(cube));
  test::expect_io_error([&] { read_cloud(same); }, same, 0,
                        "fit 3 or 4 or 5 or 6 float32 a point, and");
  EXPECT_EQ(read_cloud(same, {.bin_columns = 3}).points.cols(), 4000);
  const auto cut = folder.write("b.bin", scan_of(4, 1200).substr(0, 4 * 4797));
  test::expect_io_error([&] { read_cloud(cut); }, cut, 0, "truncated");
  EXPECT_THROW(read_cloud(cut, {.bin_columns = 2}), std::invalid_argument);
  EXPECT_THROW(read_cloud(cut, {.mesh_points = -1}), std::invalid_argument);
}

TEST(BinaryScan, OfNumbersOfAnotherTypeIsRefusedWithWhatTheyMayBe) {
  const TemporaryFolder folder;
  test::Noise noise(5);
  std::string doubles, big_endian, integers;
  for (int i = 0; i < 4 * 500; ++i) {
    const double value = 80 * noise.uniform() - 40;
    doubles += test::bytes_of(value);
    big_endian += test::bytes_of(static_cast<float>(value), std::endian::big);
    integers += test::bytes_of(static_cast<std::int32_t>(1000 * value));
  }
  for (const auto& [bytes, words] : {std::pair{doubles, "they may be float64"},
                                     {big_endian, "they may be big-endian"},
                                     {integers, "they are of another type"}}) {
    const auto path = folder.write("a.bin", bytes);
    for (const Index columns : {4, 5}) {
      test::expect_io_error([&] { read_cloud(path, {.bin_columns = columns}); }, path, 0, words);
    }
  }
}

}  // namespace
}  // namespace gmcr::io
