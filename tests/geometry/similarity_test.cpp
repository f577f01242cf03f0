#include "gmcr/similarity.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "random_geometry.hpp"

namespace gmcr::geometry {
namespace {

TEST(Similarity, MapsAPointByScaleThenRotationThenTranslation) {
  Similarity quarter_turn;
  quarter_turn.scale = 2;
  quarter_turn.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  quarter_turn.translation << 10, 20, 30;
  EXPECT_EQ(quarter_turn * Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(10, 22, 30));
}

TEST(Similarity, CompositionActsAsOneAfterTheOther) {
  testing::RandomGeometry random(1);
  const Similarity c_from_b = random.similarity(0.1, 10, 5),
                   b_from_a = random.similarity(0.1, 10, 5);
  const Eigen::Vector3d point = random.in_ball(3);
  EXPECT_LT(((c_from_b * b_from_a) * point - c_from_b * (b_from_a * point)).norm(), 1e-12);
}

TEST(Similarity, InverseUndoesTheTransform) {
  testing::RandomGeometry random(2);
  const Similarity t = random.similarity(0.1, 10, 5);
  const Points points = random.in_cube(20);
  EXPECT_LT((t.inverse().apply(t.apply(points)) - points).norm(), 1e-12);
}

TEST(Similarity, MatrixActsOnHomogeneousPointsAsTheTransformOnPoints) {
  testing::RandomGeometry random(3);
  const Similarity t = random.similarity(0.1, 10, 5);
  const Eigen::Vector3d point = random.in_ball(2);
  const Eigen::Vector4d image = t.matrix() * point.homogeneous();
  EXPECT_LT((image.hnormalized() - t * point).norm(), 1e-12);
  EXPECT_EQ(t.matrix().row(3), Eigen::RowVector4d(0, 0, 0, 1));
}

TEST(Similarity, FromMatrixReadsWhatMatrixWrote) {
  testing::RandomGeometry random(4);
  const Similarity t = random.similarity(0.1, 10, 5);
  const Similarity read = Similarity::from_matrix(t.matrix());
  EXPECT_NEAR(read.scale, t.scale, 1e-12);
  EXPECT_LT((read.rotation - t.rotation).norm(), 1e-12);
  EXPECT_EQ(read.translation, t.translation);
}

TEST(Similarity, FromMatrixRefusesWhatIsNoSimilarity) {
  const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
  Eigen::Matrix4d mirrored = identity, sheared = identity, projective = identity, broken = identity,
                  flat = identity;
  mirrored(0, 0) = -1;
  sheared(0, 1) = 0.1;
  projective(3, 0) = 1;
  broken(1, 3) = std::numeric_limits<double>::quiet_NaN();
  flat(2, 2) = 0;
  for (const auto& matrix : {mirrored, sheared, projective, broken, flat}) {
    EXPECT_THROW(Similarity::from_matrix(matrix), std::invalid_argument) << matrix;
  }
  EXPECT_NO_THROW(Similarity::from_matrix(sheared, 0.2));
}

}  // namespace
}  // namespace gmcr::geometry
