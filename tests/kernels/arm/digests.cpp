// Prints a digest of what each kernel makes of fixed pseudo-random input: the same on each machine.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "gmcr/clique.hpp"
#include "kernels/bits/bit_block.hpp"
#include "kernels/bits/bit_columns.hpp"
#include "kernels/bits/bit_row.hpp"
#include "kernels/bits/branch_choice.hpp"
#include "kernels/features/descriptor_distances.hpp"
#include "kernels/features/nearest_features.hpp"
#include "kernels/features/pair_angles.hpp"
#include "kernels/pairs/byte_sums.hpp"
#include "kernels/pairs/consistency_row.hpp"
#include "kernels/pairs/consistency_tiles.hpp"
#include "kernels/pairs/rotation_row.hpp"
#include "kernels/pairs/scale_row.hpp"
#include "kernels/points/near_points.hpp"
#include "kernels/points/residuals.hpp"

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

gmcr::geometry::CorrespondenceArrays matched_arrays(Random& random, Index count) {
  gmcr::geometry::CorrespondenceArrays arrays{random.points(count), random.points(count),
                                              Eigen::ArrayXd::Constant(count, 0.01)};
  for (Index i = 0; i < count; i += 3) {
    arrays.target.row(i) = arrays.source.row(i);
    arrays.target(i, 0) += random.uniform(-0.01, 0.01);
  }
  return arrays;
}

void digest_consistency(const char* name, const gmcr::geometry::CorrespondenceArrays& arrays,
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

void digest_residuals(Random& random, const gmcr::geometry::CorrespondenceArrays& arrays) {
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

/// Bins whose edges need no logarithm: the last digit of that is a library's own.
void digest_scales(const gmcr::geometry::CorrespondenceArrays& arrays) {
  using kernels::ScaleCells;
  const auto cell_of = [](double scale) {
    return std::bit_cast<std::uint64_t>(scale) >> ScaleCells::kShift;
  };
  std::vector<std::uint64_t> entries;
  ScaleCells cells{0.25, 4, cell_of(0.25)};
  for (std::uint64_t cell = cells.first, below = 0; cell <= cell_of(cells.max); ++cell) {
    const bool has_edge = cell % 3 == 0;
    entries.push_back((below << ScaleCells::kShift) + (has_edge ? ScaleCells::kRest / 2 : 0));
    below += has_edge;
  }
  cells.entries = entries.data();
  Digest digest;
  std::vector<kernels::BinSpan> spans(static_cast<std::size_t>(arrays.size()));
  for (Index i = 0; i < arrays.size(); ++i) {
    kernels::scale_row(arrays, cells, i, i + 1, spans);
    for (Index j = i + 1; j < arrays.size(); ++j) {
      digest.add(std::uint64_t{spans[static_cast<std::size_t>(j)].packed});
    }
  }
  digest.print("scale_row");
}

/// A search makes hundreds of choices, in rows of each width that has loops of its own.
void digest_branches(Random& random) {
  for (const Index num_vertices : {120, 400, 700, 1300}) {
    gmcr::BitsetGraph graph(num_vertices);
    for (Index u = 0; u < num_vertices; ++u) {
      for (Index v = 0; v < u; ++v) {
        if (random.uniform(0, 1) < 0.6) graph.add_edge(u, v);
      }
    }
    gmcr::CliqueOptions options;
    options.max_nodes = 300;
    options.num_threads = 1;
    const gmcr::CliqueResult result = max_clique(graph, options);
    Digest digest;
    for (const Index v : result.vertices) digest.add(static_cast<std::uint64_t>(v));
    digest.add(static_cast<std::uint64_t>(result.upper_bound));
    digest.add(result.nodes);
    digest.print(("branch_choice " + std::to_string(num_vertices)).c_str());
  }
}

void digest_bits(Random& random) {
  Digest rows, blocks, chosen;
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
    kernels::BitColumns columns;
    columns.reset(a.data(), words);
    std::vector<std::uint64_t> front(static_cast<std::size_t>((columns.num_columns() + 63) / 64));
    columns.copy(b.data(), front.data());
    chosen.add_all(front);
    kernels::BitBlock block{};
    for (auto& word : block) word = random.word();
    kernels::transpose(block);
    blocks.add_all(block);
  }
  rows.print("bit_row");
  chosen.print("bit_columns");
  blocks.print("bit_block");
}

void digest_features(Random& random) {
  constexpr Index kBins = 33, kCount = 150;
  std::vector<float> values(static_cast<std::size_t>(kBins * kCount));
  for (float& value : values) value = static_cast<float>(random.uniform(0, 60));
  const kernels::IntegerFeatures features(values.data(), kBins, kCount, 64);
  kernels::NearestSources nearest_sources(features);
  Digest digest;
  for (Index first = 0; first < kCount; first += kernels::kFeatureQueries) {
    kernels::NearestFeature nearest[kernels::kFeatureQueries];
    const Index count = std::min(kernels::kFeatureQueries, kCount - first);
    kernels::nearest_features(features, first, count, features, nearest, nearest_sources);
    for (Index q = 0; q < count; ++q) {
      digest.add(static_cast<std::uint64_t>(nearest[q].second));
      digest.add(static_cast<std::uint64_t>(nearest[q].index));
    }
  }
  for (const std::int32_t source : nearest_sources.indices) {
    digest.add(static_cast<std::uint64_t>(source));
  }
  digest.print("nearest_features");
}

void digest_points(Random& random) {
  constexpr std::int32_t kCount = 150;
  const Eigen::MatrixX3d points = random.points(kCount + kernels::PointColumns::kPadding);
  const Eigen::MatrixX3d normals = random.points(kCount).rowwise().normalized();
  const kernels::PointColumns columns{points.col(0).data(), points.col(1).data(),
                                      points.col(2).data()};
  const kernels::PointRun runs[] = {{0, 13}, {15, 15}, {20, 90}, {91, kCount}};
  std::vector<std::int64_t> found(kCount + kernels::NearPoints::kSlack);
  std::vector<double> squared_distances(found.size());
  Digest near, angles, sums;
  for (Index i = 0; i < kCount; ++i) {
    const Eigen::Vector3d query = points.row(i);
    const Index count = kernels::near_points(columns, runs, query.data(), 0.5,
                                             {found.data(), squared_distances.data()});
    std::vector<std::int32_t> neighbours;
    std::vector<float> weights;
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
      near.add(static_cast<std::uint64_t>(found[k]));
      near.add(squared_distances[k]);
      neighbours.push_back(static_cast<std::int32_t>(found[k]));
      weights.push_back(static_cast<float>(squared_distances[k]));
    }
    const Eigen::Vector3d beside = query.array() + 0.1;
    const auto nearest = kernels::nearest_point(columns, runs, beside.data(), 0.5);
    near.add(static_cast<std::uint64_t>(nearest.index));
    near.add(nearest.squared_distance);
    std::int32_t counts[kernels::kPairAngles * kernels::kAngleRow] = {};
    kernels::count_pair_angles({columns.x, columns.y, columns.z, normals.col(0).data(),
                                normals.col(1).data(), normals.col(2).data()},
                               i, neighbours.data(), count, counts);
    for (const std::int32_t number : counts) angles.add(static_cast<std::uint64_t>(number));
    std::vector<float> histograms(static_cast<std::size_t>(kCount * kernels::kHistogramStride));
    for (std::size_t k = 0; k < histograms.size(); ++k) {
      histograms[k] = static_cast<float>(k % 101) / 7;
    }
    float sum[kernels::kHistogramStride];
    kernels::add_histograms(histograms.data(), neighbours.data(), weights.data(), count, sum);
    for (const float value : sum) sums.add(static_cast<double>(value));
  }
  near.print("near_points");
  angles.print("pair_angles");
  sums.print("add_histograms");
}

void digest_bytes(Random& random) {
  constexpr Index kRows = 40, kLength = 301, kFirst = 3;
  std::vector<std::uint8_t> bytes(kRows * (kFirst + kLength + kernels::kByteSlack));
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.word());
  std::vector<const std::uint8_t*> rows;
  for (Index r = 0; r < kRows; ++r) {
    rows.push_back(bytes.data() + r * (kFirst + kLength + kernels::kByteSlack));
  }
  std::vector<std::uint8_t> sums(kLength);
  kernels::sum_bytes(rows.data(), kRows, kFirst, kLength, sums.data());
  Digest digest;
  for (const std::uint8_t sum : sums) digest.add(std::uint64_t{sum});
  digest.print("byte_sums");
}

void digest_descriptors(Random& random) {
  constexpr Index kValues = 33, kCount = 70;
  using kernels::GroupedDescriptors;
  const auto value = [&] { return static_cast<float>(random.uniform(-1, 1)); };
  const GroupedDescriptors<float> floats(kValues, kCount, [&](Index, Index) { return value(); });
  const GroupedDescriptors<std::uint64_t> words(kValues, kCount,
                                                [&](Index, Index) { return random.word(); });
  std::vector<float> query(kValues);
  std::vector<std::uint64_t> query_words(kValues);
  std::vector<float> distances(
      static_cast<std::size_t>(GroupedDescriptors<float>::kGroup * floats.num_groups()));
  Digest digest;
  for (int k = 0; k < 20; ++k) {
    for (float& v : query) v = value();
    for (std::uint64_t& v : query_words) v = random.word();
    kernels::squared_distances(floats, query.data(), distances.data());
    for (const float distance : distances) digest.add(static_cast<double>(distance));
    kernels::hamming_distances(words, query_words.data(), distances.data());
    for (const float distance : distances) digest.add(static_cast<double>(distance));
  }
  digest.print("descriptor_distances");
}

}  // namespace

int main() {
  Random random;
  auto arrays = matched_arrays(random, 700);
  digest_consistency("one scale", arrays, 1, 1);
  digest_consistency("a range", arrays, 0.8, 1.2);
  digest_residuals(random, arrays);
  digest_scales(arrays);
  for (double& bound : arrays.bounds) bound = random.uniform(0.001, 0.1);
  digest_consistency("many bounds", arrays, 1, 1);
  arrays.bounds.setConstant(1e-9);
  digest_consistency("tiny bounds", arrays, 1, 1);
  digest_rotation(random, 200);
  digest_bits(random);
  digest_branches(random);
  digest_features(random);
  digest_points(random);
  digest_descriptors(random);
  digest_bytes(random);
}
