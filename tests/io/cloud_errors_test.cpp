#include <gtest/gtest.h>

#include "gmcr/io.hpp"
#include "io/expect_io_error.hpp"
#include "io/temporary_folder.hpp"

namespace gmcr::io {
namespace {

using test::TemporaryFolder;

const Points kThreePoints{{1, 4, 7}, {2, 5.25, 8}, {3, -6, 9e-7}};

void expect_error(const std::filesystem::path& path, std::size_t line, const std::string& words) {
  test::expect_io_error([&] { read_cloud(path); }, path, line, words);
}

class AnyCloud : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Extensions, AnyCloud,
                         testing::Values("ply", "pcd", "xyz", "txt", "asc", "pts", "csv", "npy",
                                         "bin", "pcd.bin", "obj", "off", "stl"));

TEST_P(AnyCloud, ThatIsMissingIsAnError) {
  const TemporaryFolder folder;
  expect_error(folder / (std::string("a.") + GetParam()), 0, "No such file");
}

TEST_P(AnyCloud, ThatIsEmptyIsAnError) {
  const TemporaryFolder folder;
  expect_error(folder.write(std::string("a.") + GetParam(), ""), 0, "empty");
}

TEST_P(AnyCloud, ThatIsAFolderIsAnError) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("a.") + GetParam());
  std::filesystem::create_directory(path);
  expect_error(path, 0, "directory");
}

TEST_P(AnyCloud, ThatHoldsSomethingElseIsAnError) {
  const TemporaryFolder folder;
  const auto path = folder.write(std::string("a.") + GetParam(),
                                 "\x7F"
                                 "ELF\x02\x01\x01 what?");
  EXPECT_THROW(read_cloud(path), IoError);
}

class CompleteCloud : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Extensions, CompleteCloud, testing::Values("ply", "pcd", "npy"));

TEST_P(CompleteCloud, CutAnywhereIsAnError) {
  const TemporaryFolder folder;
  const std::string name = std::string("a.") + GetParam();
  write_cloud(folder / name, kThreePoints);
  const std::string whole = test::content_of(folder / name);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    folder.write(name, whole.substr(0, size));
    EXPECT_THROW(read_cloud(folder / name), IoError) << size << " of " << whole.size() << " bytes";
  }
}

TEST(AsciiCloud, CutBeforeItsLastNumberIsAnError) {
  const TemporaryFolder folder;
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n1 2 3\n4 5 6";
  const std::string pcd =
      "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n1 2 3\n4 5 6";
  const std::string pts = "2\n1 2 3\n4 5 6";
  for (const auto& [name, whole] : {std::pair{"a.ply", ply}, {"a.pcd", pcd}, {"a.pts", pts}}) {
    EXPECT_EQ(read_cloud(folder.write(name, whole)).points.cols(), 2);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      EXPECT_THROW(read_cloud(folder.write(name, whole.substr(0, size))), IoError)
          << name << " " << size << " of " << whole.size() << " bytes";
    }
  }
}

TEST(BinaryScan, CutInsideAPointIsAnError) {
  const TemporaryFolder folder;
  expect_error(folder.write("a.bin", std::string(47, 'a')), 0, "multiple of 16");
  expect_error(folder.write("a.pcd.bin", std::string(48, 'a')), 0, "multiple of 20");
}

TEST(PlyHeader, ThatLiesIsAnError) {
  const TemporaryFolder folder;
  const std::string properties = "property float x\nproperty float y\nproperty float z\n";
  const auto expect = [&](const std::string& header, std::size_t line, const std::string& words) {
    expect_error(folder.write("a.ply", header), line, words);
  };
  const std::string start = "ply\nformat binary_little_endian 1.0\n";
  expect(start + "element vertex 2000000000\n" + properties + "end_header\nabc", 0, "truncated");
  expect(start + "element vertex 99999999999999999999\n" + properties + "end_header\nabc", 3,
         "COUNT");
  expect(start + "element vertex -1\n" + properties + "end_header\nabc", 3, "COUNT");
  expect(start + "element vertex 0\n" + properties + "end_header\n", 0, "no points");
  expect(start + "element vertex 1\nproperty float x\nend_header\nabcd", 0, "lack x, y or z");
  expect(start + "element face 1\nproperty list uchar int i\nend_header\nabcd", 0, "'vertex'");
  expect(start + "element vertex 1\nproperty real x\n", 4, "type");
  expect(start + "element vertex 1\n" + properties, 0, "end_header");
  expect(start + "element huge 2000000000\nelement vertex 1\n" + properties + "end_header\n" +
             std::string(12, 'a'),
         0, "no properties");
  expect(start + "element face 1\nproperty list uint int i\nelement vertex 1\n" + properties +
             "end_header\n\xFF\xFF\xFF\xFF" + std::string(12, 'a'),
         0, "truncated");
  expect("ply\nelement vertex 1\n" + properties + "end_header\nabc", 6, "format");
  expect("ply\nformat ascii 1.0\nelement vertex 2\n" + properties + "end_header\n1 2 3\n4 oops 6\n",
         9, "'vertex' has 1 of 2");
}

TEST(PcdHeader, ThatLiesIsAnError) {
  const TemporaryFolder folder;
  const std::string fields = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";
  const auto expect = [&](const std::string& text, std::size_t line, const std::string& words) {
    expect_error(folder.write("a.pcd", text), line, words);
  };
  expect(fields + "POINTS 2000000000\nDATA binary\nabc", 0, "truncated");
  expect(fields + "POINTS 99999999999\nDATA binary\nabc", 5, "out of range");
  expect(fields + "POINTS 0\nDATA binary\n", 0, "no points");
  expect(fields + "DATA binary\nabc", 0, "POINTS");
  expect("FIELDS x y z\nSIZE 4 4\nTYPE F F F\nPOINTS 1\nDATA binary\nabc", 0, "different lengths");
  expect("FIELDS x y q\nSIZE 4 4 4\nTYPE F F F\nPOINTS 1\nDATA ascii\n1 2 3\n", 0, "no x, y and z");
  expect("FIELDS x y z\nSIZE 4 4 3\nTYPE F F F\nPOINTS 1\nDATA ascii\n1 2 3\n", 0, "'z'");
  expect(fields + "POINTS 1\nDATA ascii\n1 2\n", 7, "expected 3");
  expect(fields + "POINTS 1\nDATA ascii\n1 2 3\n4 5 6\n", 8, "more rows");
  expect(fields + "POINTS 2\nDATA ascii\n1 2 3\n4 x 6\n", 8, "'x' is no number");
  expect(fields + "POINTS 1\nDATA runes\n", 6, "DATA");
  const std::string sizes{"\x04\x00\x00\x00\xFF\xFF\xFF\x7F", 8};
  expect(fields + "POINTS 9\nDATA binary_compressed\n" + sizes + "abcd", 0, "not possible");
}

TEST(NpyHeader, ThatIsNotAnNByThreeFloatArrayIsAnError) {
  const TemporaryFolder folder;
  const auto expect = [&](const std::string& dictionary, const std::string& words) {
    std::string bytes("\x93NUMPY\x01\x00", 8);
    bytes += static_cast<char>(dictionary.size());
    bytes += '\0';
    expect_error(folder.write("a.npy", bytes + dictionary + std::string(24, '\0')), 0, words);
  };
  expect("{'descr': [('x', '<f4'), ('y', '<f4')], 'fortran_order': False, 'shape': (2,), }",
         "a structured dtype");
  expect("{'descr': '<c8', 'fortran_order': False, 'shape': (1, 3), }", "'<c8'");
  expect("{'descr': '|O', 'fortran_order': False, 'shape': (1, 3), }", "not an array of numbers");
  expect("{'descr': '<f8', 'fortran_order': False, 'shape': (3,), }", "shape (3,)");
  expect("{'descr': '<f8', 'fortran_order': False, 'shape': (3, 1), }", "expected (N, 3)");
  expect("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }", "does not fit");
  expect("{'descr': '<f8', 'fortran_order': False, 'shape': (768614336404564651, 3), }", "not fit");
  expect(
      "{'descr': '<f8', 'fortran_order': False, 'shape': (2305843009213693953, "
      "2305843009213693952), }",
      "expected (N, 3)");
  expect("{'descr': '<f8', 'fortran_order': False, }", "malformed");
  expect("{'descr': '<f8', 'fortran_order': Maybe, 'shape': (1, 3), }", "malformed");
  expect("{'descr': '<f8', 'fortran_order': False, 'shape': (1, 3), 'more': 1}", "malformed");
  expect("{'descr': '<f8', 'fortran_order': False, 'shape': (1, 3)", "malformed");
  expect("{'descr': '<f8', 'fortran_order': False, 'shape': (0, 3), }", "does not fit");
}

TEST(TextCloud, WithACellThatIsNoNumberNamesTheLine) {
  const TemporaryFolder folder;
  expect_error(folder.write("a.csv", "x,y,z\n1,2,3\n4,oops,6\n"), 3,
               "column 2: 'oops' is no number");
  expect_error(folder.write("b.csv", "1,2,oops\n"), 1, "'oops'");
  expect_error(folder.write("c.csv", "1;2,5.0;3\n"), 1, "'2,5.0'");
  expect_error(folder.write("d.csv", "1,2,3\n4,5\n"), 2, "2 columns where line 1 has 3");
  expect_error(folder.write("e.csv", "1,2,3,4\n"), 1, "4 columns");
  expect_error(folder.write("f.csv", "x,y,z\n"), 0, "no points");
  expect_error(folder.write("g.csv", "\n\n"), 0, "no rows");
  expect_error(folder.write("a.xyz", "1 2\n"), 1, "3 columns");
  expect_error(folder.write("b.xyz", "1 2 3\n\n1 2 0x3\n"), 3, "'0x3'");
  expect_error(folder.write("a.pts", "3\n1 2 3\n4 5 6\n"), 0, "2 points, the first line says 3");
  expect_error(folder.write("c.pts", "0\n"), 0, "no rows");
}

TEST(Cloud, WithoutAFinitePointIsAnError) {
  const TemporaryFolder folder;
  expect_error(folder.write("a.csv", "nan,2,3\n4,inf,6\n"), 0, "no finite point among 2");
}

TEST(Cloud, WithAnUnknownExtensionIsAnError) {
  const TemporaryFolder folder;
  expect_error(folder.write("a.foo", "1 2 3\n"), 0, "unknown extension '.foo' (known: .ply");
  expect_error(folder.write("cloud", "1 2 3\n"), 0, "no extension");
  const auto path = folder / "a.pts";
  test::expect_io_error([&] { write_cloud(path, kThreePoints); }, path, 0,
                        "unknown extension '.pts'");
}

TEST(Cloud, ThatCannotBeWrittenIsAnError) {
  const TemporaryFolder folder;
  const auto path = folder / "nowhere/a.ply";
  test::expect_io_error([&] { write_cloud(path, kThreePoints); }, path, 0, "No such file");
  std::filesystem::create_symlink("/dev/full", folder / "full.csv");
  test::expect_io_error([&] { write_cloud(folder / "full.csv", kThreePoints); },
                        folder / "full.csv", 0, "No space");
}

}  // namespace
}  // namespace gmcr::io
