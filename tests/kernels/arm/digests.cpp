// Prints a digest of what each kernel makes of fixed pseudo-random input: the same on each machine.
#include <bit>
#include <cmath>
#include <cstdio>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "kernels/bit_block.hpp"
#include "kernels/bit_row.hpp"
#include "kernels/consistency_row.hpp"
#include "kernels/consistency_tiles.hpp"
#include "kernels/residuals.hpp"
#include "kernels/rotation_row.hpp"

namespace {

using gmcr::Index;
namespace kernels = gmcr::kernels;

/// FNV-1a over words.
class Digest {
 public:
  void add(std::uint64_t word) { hash_ = (hash_ ^ word) * 0x100000001b3; }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  template <typename Values>
  void add_all(const Values& values) {
    for (const auto value : values) add(value);
  }
  void print(const char* name) const { std::printf("%s %016llx\n", name, hash_); }

 private:
  unsigned long long hash_ = 0xcbf29ce484222325;
};

class Random {
 public:
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(generator_() >> 11) * 0x1p-53);
  }
  std::uint64_t word() { return generator_(); }
  Eigen::MatrixX3d points(Index count) {
    Eigen::MatrixX3d result(count, 3);
    for (Index k = 0; k < result.size(); ++k) result.data()[k] = uniform(-1, 1);
    return result;
  }

 private:
  std::mt19937_64 generator_{7};
};

kernels::CorrespondenceArrays matched_arrays(Random& random, Index count) {
  kernels::CorrespondenceArrays arrays{random.points(count), random.points(count),
                                       Eigen::ArrayXd::Constant(count, 0.01)};
  for (Index i = 0; i < count; i += 3) {
    arrays.target.row(i) = arrays.source.row(i);
    arrays.target(i, 0) += random.uniform(-0.01, 0.01);
  }
  return arrays;
}

void digest_consistency(const char* name, const kernels::CorrespondenceArrays& arrays,
                        double scale_min, double scale_max) {
  Digest rows, tiles;
  std::vector<std::uint64_t> row(static_cast<std::size_t>((arrays.size() + 63) / 64));
  for (Index i = 0; i < arrays.size(); ++i) {
    kernels::consistency_row(arrays, i, scale_min, scale_max, row);
    rows.add_all(row);
  }
  const kernels::ConsistencyTiles all(arrays, scale_min, scale_max);
  tiles.add(std::uint64_t{all.is_single_precision()});
  for (Index r = 0; r < all.num_blocks(); ++r) {
    for (Index c = 0; c < all.num_blocks(); ++c) tiles.add_all(all.tile(r, c));
  }
  rows.print((std::string("consistency_row ") + name).c_str());
  tiles.print((std::string("consistency_tiles ") + name).c_str());
}

void digest_lengths(const kernels::CorrespondenceArrays& arrays) {
  Digest digest;
  for (Index i = 0; i < arrays.size(); i += 17) {
    std::vector<double> source(static_cast<std::size_t>(arrays.size() - i - 1)), target(source);
    kernels::pair_lengths(arrays, i, source, target);
    digest.add_all(source);
    digest.add_all(target);
  }
  digest.print("pair_lengths");
}

void digest_residuals(Random& random, const kernels::CorrespondenceArrays& arrays) {
  gmcr::Similarity pose;
  pose.scale = 1.01;
  pose.rotation << 2, -1, 2, 2, 2, -1, -1, 2, 2;
  pose.rotation /= 3;
  pose.translation = Eigen::Vector3d(random.uniform(-1, 1), 0.5, -0.25);
  Digest residuals, consensus;
  residuals.add_all(kernels::squared_residuals(pose, arrays.source, arrays.target));
  const Eigen::ArrayXd squared_bounds = Eigen::ArrayXd::Constant(arrays.size(), 0.3);
  const auto agreeing = kernels::consensus(pose, arrays.source, arrays.target, squared_bounds, 1.5);
  for (const Index i : agreeing.indices) consensus.add(static_cast<std::uint64_t>(i));
  consensus.add_all(agreeing.squared_residuals);
  residuals.print("squared_residuals");
  consensus.print("consensus");
}

void digest_rotation(Random& random, Index count) {
  kernels::DirectionArrays arrays{random.points(count), random.points(count), Eigen::ArrayXd(count),
                                  Eigen::ArrayXd(count)};
  for (Index k = 0; k < count; ++k) {
    // normalised operation by operation: the order in which a library sums is its own
    for (Eigen::MatrixX3d* directions : {&arrays.source, &arrays.target}) {
      const double x = (*directions)(k, 0), y = (*directions)(k, 1), z = (*directions)(k, 2);
      const double norm = std::sqrt(x * x + y * y + z * z);
      (*directions).row(k) << x / norm, y / norm, z / norm;
    }
    arrays.cos_gamma[k] = k % 9 == 0 ? -1 : random.uniform(0.8, 1);
    const double cosine = arrays.cos_gamma[k];
    arrays.sin_gamma[k] = std::sqrt(1 - cosine * cosine);
  }
  Digest digest;
  std::vector<std::uint64_t> row(static_cast<std::size_t>((count + 63) / 64));
  for (Index k = 0; k < count; ++k) {
    kernels::rotation_row(arrays, k, row);
    digest.add_all(row);
  }
  digest.print("rotation_row");
}

void digest_bits(Random& random) {
  Digest rows, blocks;
  for (Index words = 0; words < 70; ++words) {
    std::vector<std::uint64_t> a(static_cast<std::size_t>(words)), b(a);
    for (auto& word : a) word = random.word() | random.word();
    for (auto& word : b) word = random.word() | random.word();
    std::vector<std::int64_t> values(static_cast<std::size_t>(64 * words));
    for (auto& value : values) value = static_cast<std::int64_t>(random.word()) >> 20;
    rows.add(static_cast<std::uint64_t>(kernels::count_bits(a.data(), words)));
    rows.add(static_cast<std::uint64_t>(kernels::count_common_bits(a.data(), b.data(), words)));
    rows.add(static_cast<std::uint64_t>(kernels::sum_over_common_bits(
        a.data(), b.data(), words, values.data(), static_cast<Index>(values.size()))));
    kernels::BitBlock block{};
    for (auto& word : block) word = random.word();
    kernels::transpose(block);
    blocks.add_all(block);
  }
  rows.print("bit_row");
  blocks.print("bit_block");
}

}  // namespace

int main() {
  Random random;
  auto arrays = matched_arrays(random, 700);
  digest_consistency("one scale", arrays, 1, 1);
  digest_consistency("a range", arrays, 0.8, 1.2);
  digest_lengths(arrays);
  digest_residuals(random, arrays);
  for (double& bound : arrays.bounds) bound = random.uniform(0.001, 0.1);
  digest_consistency("many bounds", arrays, 1, 1);
  arrays.bounds.setConstant(1e-9);
  digest_consistency("tiny bounds", arrays, 1, 1);
  digest_rotation(random, 200);
  digest_bits(random);
}
