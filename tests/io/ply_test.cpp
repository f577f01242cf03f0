#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gmcr/io.hpp"
#include "io/expect_io_error.hpp"
#include "io/file_bytes.hpp"
#include "io/temporary_folder.hpp"

namespace gmcr::io {
namespace {

using test::bytes_of;
using test::TemporaryFolder;

const Points kTwo{{1, 4}, {2, 5}, {3, 6}};

std::string header(const std::string& format, const std::string& properties, int count = 2) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(count) + "\n" +
         properties + "end_header\n";
}

std::string properties_of(const std::string& type, const std::string& names) {
  std::string text;
  for (const char name : names) text += "property " + type + " " + name + "\n";
  return text;
}

template <typename Number>
void expect_type(const char* name) {
  const TemporaryFolder folder;
  for (const auto& [format, order] : {std::pair{"binary_little_endian", std::endian::little},
                                      {"binary_big_endian", std::endian::big}}) {
    std::string data;
    for (const int value : {1, 2, 3, 4, 5, 6}) data += bytes_of(static_cast<Number>(value), order);
    const auto path = folder.write("a.ply", header(format, properties_of(name, "xyz")) + data);
    EXPECT_EQ(read_cloud(path).points, kTwo) << name << " " << format;
  }
  const auto path =
      folder.write("a.ply", header("ascii", properties_of(name, "xyz")) + "1 2 3\n4 5 6\n");
  EXPECT_EQ(read_cloud(path).points, kTwo) << name << " ascii";
}

TEST(Ply, OfEveryTypeAndByteOrderIsRead) {
  expect_type<std::int8_t>("char");
  expect_type<std::int8_t>("int8");
  expect_type<std::uint8_t>("uchar");
  expect_type<std::uint8_t>("uint8");
  expect_type<std::int16_t>("short");
  expect_type<std::int16_t>("int16");
  expect_type<std::uint16_t>("ushort");
  expect_type<std::uint16_t>("uint16");
  expect_type<std::int32_t>("int");
  expect_type<std::int32_t>("int32");
  expect_type<std::uint32_t>("uint");
  expect_type<std::uint32_t>("uint32");
  expect_type<float>("float");
  expect_type<float>("float32");
  expect_type<double>("double");
  expect_type<double>("float64");
}

TEST(Ply, TakesItsCoordinatesInAnyOrder) {
  const TemporaryFolder folder;
  std::string order = "xyz";
  do {
    std::vector<float> values;
    for (const float first : {1.F, 4.F}) {
      for (const char axis : order) values.push_back(first + static_cast<float>(axis - 'x'));
    }
    const auto path = folder.write(
        "a.ply", header("binary_little_endian", properties_of("float", order)) + bytes_of(values));
    EXPECT_EQ(read_cloud(path).points, kTwo) << order;
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Ply, TakesOtherElementsListsAndBlanks) {
  const TemporaryFolder folder;
  const std::string text =
      "ply \r\nformat ascii 1.0 \r\n\r\ncomment a \r\nelement camera 1\r\nproperty float view\r\n"
      "element vertex 2\r\nproperty list uchar int seen_by\r\nproperty double Y\r\n"
      "property float X\r\nproperty uchar red\r\nproperty int Z\r\nend_header \r\n"
      "0.5\r\n2 7 8 2 1 255 3\r\n0 5 4 \r\n0 6\r\n";
  EXPECT_EQ(read_cloud(folder.write("a.ply", text)).points, kTwo);
  std::string old_mac = header("ascii", properties_of("float", "xyz")) + "1 2 3\n4 5 6\n";
  std::replace(old_mac.begin(), old_mac.end(), '\n', '\r');
  EXPECT_EQ(read_cloud(folder.write("b.ply", old_mac)).points, kTwo);
}

TEST(Ply, AsTextKeepsMoreDigitsThanItsTypeHas) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.ply", header("ascii", properties_of("float", "xyz"), 1) +
                                              "694303.989 5155404.494 379.446\n");
  EXPECT_EQ(read_cloud(path).points, (Points{{694303.989}, {5155404.494}, {379.446}}));
}

TEST(Ply, TakesNotANumberAsEveryLibraryWritesIt) {
  const TemporaryFolder folder;
  for (const char* word : {"nan", "-nan", "NaN", "-nan(ind)", "1.#QNAN", "-1.#IND", "1.#INF", "inf",
                           "-inf", "Infinity", "1.#IND00"}) {
    const std::string text = header("ascii", properties_of("float", "xyzs")) + "1 2 3 " + word +
                             "\n4 " + word + " 6 0\n";
    const Cloud cloud = read_cloud(folder.write("a.ply", text));
    EXPECT_EQ(cloud.points, Points(kTwo.col(0))) << word;
    EXPECT_EQ(cloud.num_dropped, 1) << word;
    ASSERT_EQ(cloud.notes.size(), 1U);
    EXPECT_EQ(cloud.notes[0], "dropped 1 points that are not finite");
  }
}

TEST(Ply, SaysWhatStandsBehindItsLastElement) {
  const TemporaryFolder folder;
  const std::string text = header("ascii", properties_of("float", "xyz")) + "1 2 3\n4 5 6\n7 8 9\n";
  const Cloud cloud = read_cloud(folder.write("a.ply", text));
  EXPECT_EQ(cloud.points, kTwo);
  ASSERT_EQ(cloud.notes.size(), 1U);
  EXPECT_NE(cloud.notes[0].find("5 bytes behind"), std::string::npos) << cloud.notes[0];
}

TEST(Ply, ThatIsMalformedIsAnError) {
  const TemporaryFolder folder;
  const auto expect = [&](const std::string& text, std::size_t line, const std::string& words) {
    const auto path = folder.write("a.ply", text);
    test::expect_io_error([&] { read_cloud(path); }, path, line, words);
  };
  const std::string binary = "binary_little_endian";
  const std::string xyz = properties_of("float", "xyz");
  // what no file can hold is refused before memory is taken for it
  expect(header(binary, xyz, 2000000000), 0, "truncated: fewer than 2000000000 points");
  expect(header("ascii", xyz, 2000000000) + "1 2 3\n", 7, "truncated: fewer than");
  expect(header(binary, properties_of("float", "xxy"), 1) + std::string(12, 'a'), 0,
         "'x' is there twice");
  expect(header(binary, properties_of("float", "xxyz"), 1) + std::string(16, 'a'), 0,
         "'x' is there twice");
  expect(header(binary, "property list uchar float x\n" + properties_of("float", "yz"), 1) + "abc",
         0, "lack x, y or z");
  expect(header(binary, "property list char uchar q\n" + xyz, 1) + "\xFF" + std::string(300, 'a'),
         0, "a list of negative length");
  expect(header(binary, "property list float uchar q\n" + xyz, 1), 4, "has to be an integer");
  expect(header("ascii", "property list uchar int q\n" + xyz, 1) + "1.5 1 2 3\n", 9,
         "a list of negative length");
  expect(header("ascii", xyz, 1) + "1 2 " + std::string(5000, 'q') + "\n", 8, "has 0 of 1 rows");
  expect("ply\nformat ascii 1.0\nelement vertex 1\n" + xyz +
             "element face 1\nproperty list uchar int vertex_indices\nend_header\n1 2 3\n3 0 0 7\n",
         0, "none of the 1 vertices");
  expect("ply\nformat ascii 2.0\n", 2, "unknown format");
  expect("ply\nformat ascii 1.0\nelement vertex many\n", 3, "'element vertex many'");
  expect("ply\nformat ascii 1.0\nproperty float x\n", 3, "before the first element");
  expect("plyx\n", 1, "not a PLY file");
}

TEST(Ply, OfAsciiRowsLongerThanItsHeaderSaysIsRefused) {
  const TemporaryFolder folder;
  const std::string start = header("ascii", properties_of("float", "xyz"));
  for (const char* rows : {"1 2 3 7\n4 5 6 7\n", "1 2 3 1 2 3\n4 5 6 4 5 6\n"}) {
    const auto path = folder.write("a.ply", start + rows);
    test::expect_io_error([&] { read_cloud(path); }, path, 8, " values in a line, expected 3");
  }
  // what the vertices leave is no face
  const std::string mesh = "ply\nformat ascii 1.0\nelement vertex 2\n" +
                           properties_of("float", "xyz") +
                           "element face 1\nproperty list uchar int vertex_index\nend_header\n";
  const auto path = folder.write("a.ply", mesh + "1 2 3 7.5\n4 5 6 7.5\n3 0 1 1\n");
  test::expect_io_error([&] { read_cloud(path); }, path, 10, "4 values in a line, expected 3");
  for (const char* rows : {"1 2 3 4 5 6\n", "1 2\n3 4 5\n6\n", "1\n2\n3\n4\n5\n6\n"}) {
    EXPECT_EQ(read_cloud(folder.write("a.ply", start + rows)).points, kTwo) << rows;
  }
  EXPECT_EQ(read_cloud(folder.write("a.ply", start + "1 2 3\n4 5 6\n7 8 9\n")).points, kTwo);
}

}  // namespace
}  // namespace gmcr::io
