#pragma once

#include <cstdint>
#include <random>

#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::bench {

/// Numbers that are the same with any standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low, double high);
  Index index(Index size);  ///< in [0, size)
  Eigen::Vector3d point(double low, double high);
  Points points(Index size, double low, double high);
  Eigen::Matrix3d rotation();

 private:
  std::mt19937_64 engine_;
};

}  // namespace gmcr::bench
