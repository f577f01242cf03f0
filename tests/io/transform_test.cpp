#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>

#include "gmcr/io.hpp"
#include "io/expect_io_error.hpp"
#include "io/temporary_folder.hpp"

namespace gmcr::io {
namespace {

using test::TemporaryFolder;

RC_GTEST_PROP(Transform, IsReadBackToTheLastBits, (int angle, int shift)) {
  const TemporaryFolder folder;
  Similarity transform;
  transform.scale = 0.25 + std::abs(angle % 100) / 10.0;
  transform.rotation =
      Eigen::AngleAxisd(angle % 1000 * 0.01, Eigen::Vector3d(1, -2, 3).normalized()).matrix();
  transform.translation << shift % 10000 / 7.0, -1e6, 1e-9;
  write_transform(folder / "T.txt", transform);
  const Similarity read = read_transform(folder / "T.txt");
  RC_ASSERT(std::abs(read.scale / transform.scale - 1) < 1e-14);
  RC_ASSERT((read.rotation - transform.rotation).norm() < 1e-14);
  RC_ASSERT(read.translation == transform.translation);
}

TEST(ReadTransform, SkipsComments) {
  const TemporaryFolder folder;
  const auto path = folder.write("T.txt", "# a shift\n1 0 0 5\n0 1 0 6\n0 0 1 7\n0 0 0 1\n");
  EXPECT_EQ(read_transform(path).translation, Eigen::Vector3d(5, 6, 7));
}

TEST(ReadTransform, RefusesWhatIsNoSimilarity) {
  const TemporaryFolder folder;
  const auto expect = [&](const std::string& text, std::size_t line, const std::string& words) {
    const auto path = folder.write("T.txt", text);
    test::expect_io_error([&] { read_transform(path); }, path, line, words);
  };
  expect("", 0, "empty");
  expect("1 0 0 0\n0 1 0 0\n0 0 1 0\n", 0, "3 rows");
  expect("1 0 0\n0 1 0\n0 0 1\n", 1, "3 columns");
  expect("1 0 0 0\n0 1 0 0\n0 0 one 0\n0 0 0 1\n", 3, "'one'");
  expect("1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 0 1\n", 0, "determinant");
  expect("1 0 0 0\n0 2 0 0\n0 0 1 0\n0 0 0 1\n", 0, "orthonormal");
  expect("1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 1 1\n", 0, "last row");
  expect("nan 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n", 0, "not finite");
}

TEST(WriteIndices, WritesOneALine) {
  const TemporaryFolder folder;
  const std::vector<Index> indices{3, 14, 15};
  write_indices(folder / "inliers.txt", indices);
  EXPECT_EQ(test::content_of(folder / "inliers.txt"), "3\n14\n15\n");
}

}  // namespace
}  // namespace gmcr::io
