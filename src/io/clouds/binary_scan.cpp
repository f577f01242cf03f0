#include <algorithm>
#include <cmath>
#include <optional>

#include "io/bytes.hpp"
#include "io/clouds/cloud_file.hpp"

namespace gmcr::io {
namespace {

constexpr Index kKittiColumns = 4;
constexpr Index kKnownColumns[] = {3, 4, 5, 6};
// Rows are sampled in blocks: every number of columns above divides a block, so that under a wrong
// number each column gets the same share of every true one.
constexpr Index kBlockRows = 60;
constexpr Index kMostBlocks = 60;
constexpr Index kFewestRows = 2 * kBlockRows;
// Of the largest difference between two columns, from 0 to 1.
constexpr double kClearDifference = 0.15;
constexpr double kClearLead = 0.05;

std::size_t bytes_of(Index num_columns) {
  return static_cast<std::size_t>(num_columns) * sizeof(float);
}

bool fits(std::string_view bytes, Index num_columns) {
  return bytes.size() % bytes_of(num_columns) == 0;
}

/// The sampled values of a column, in order.
std::vector<float> sample_column(std::string_view bytes, Index num_columns, Index column) {
  const Index num_rows = static_cast<Index>(bytes.size() / bytes_of(num_columns));
  const Index num_blocks = std::min(kMostBlocks, num_rows / kBlockRows);
  std::vector<float> values;
  for (Index block = 0; block < num_blocks; ++block) {
    const Index first = (num_rows - kBlockRows) * block / std::max<Index>(1, num_blocks - 1);
    for (Index row = first; row < first + kBlockRows; ++row) {
      const auto at = static_cast<std::size_t>(row * num_columns + column) * sizeof(float);
      const float value = load<float>(bytes.data() + at);
      if (std::isfinite(value)) values.push_back(value);
    }
  }
  std::sort(values.begin(), values.end());
  return values;
}

/// Largest difference of the distributions (Kolmogorov-Smirnov), 0 to 1.
double difference(const std::vector<float>& a, const std::vector<float>& b) {
  double largest = 0;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const float value = std::min(a[i], b[j]);
    while (i < a.size() && a[i] <= value) ++i;
    while (j < b.size() && b[j] <= value) ++j;
    const double share_a = static_cast<double>(i) / static_cast<double>(a.size());
    const double share_b = static_cast<double>(j) / static_cast<double>(b.size());
    largest = std::max(largest, std::abs(share_a - share_b));
  }
  return largest;
}

using Columns = std::vector<std::vector<float>>;

Columns sample_columns(std::string_view bytes, Index num_columns) {
  Columns columns;
  for (Index j = 0; j < num_columns; ++j) columns.push_back(sample_column(bytes, num_columns, j));
  return columns;
}

/// Under the right number, columns hold different things; under a wrong one, the same mixture.
double largest_difference(const Columns& columns) {
  double largest = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (std::size_t j = i + 1; j < columns.size(); ++j) {
      largest = std::max(largest, difference(columns[i], columns[j]));
    }
  }
  return largest;
}

/// Six columns of which the last three are as the first are two points.
bool repeats(const Columns& columns) {
  if (columns.size() != 6) return false;
  double largest = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    largest = std::max(largest, difference(columns[j], columns[j + 3]));
  }
  return largest < kClearDifference;
}

struct Candidate {
  Index num_columns = 0;
  double difference = 0;
};

std::vector<Candidate> candidates_of(std::string_view bytes) {
  std::vector<Candidate> candidates;
  for (const Index count : kKnownColumns) {
    if (!fits(bytes, count)) continue;
    const Columns columns = sample_columns(bytes, count);
    if (count == 6 && fits(bytes, 3)) {
      if (repeats(columns)) continue;
      std::erase_if(candidates, [](const Candidate& known) { return known.num_columns == 3; });
    }
    candidates.push_back({count, largest_difference(columns)});
  }
  std::stable_sort(
      candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.difference > b.difference; });
  return candidates;
}

/// So few rows that their columns tell nothing.
bool is_small(std::string_view bytes) {
  return static_cast<Index>(bytes.size() / bytes_of(kKittiColumns)) < kFewestRows;
}

/// The number of columns that what they hold speaks for; nullopt: for none.
std::optional<Index> clear_choice(std::string_view bytes) {
  if (is_small(bytes)) return std::nullopt;
  const auto candidates = candidates_of(bytes);
  if (candidates.empty() || candidates[0].difference < kClearDifference) return std::nullopt;
  if (candidates.size() > 1 && candidates[0].difference < candidates[1].difference + kClearLead) {
    return std::nullopt;
  }
  return candidates[0].num_columns;
}

/// Coordinates in metres or millimetres are 0 or above this. Other types read as float32 have parts
/// of their digits for exponents.
constexpr double kTiniest = 1e-15;

/// Whether nearly all numbers of that type and byte order are 0 or of a size that is measured.
template <typename Number>
bool may_hold(std::string_view bytes, std::endian order) {
  constexpr std::size_t kSampled = 3000;
  const std::size_t count = bytes.size() / sizeof(Number);
  const std::size_t step = std::max<std::size_t>(1, count / kSampled) | 1;  // odd: every column
  std::size_t num_sampled = 0;
  std::size_t num_odd = 0;
  for (std::size_t i = 0; i < count; i += step, ++num_sampled) {
    const auto value = static_cast<double>(load<Number>(bytes.data() + i * sizeof(Number), order));
    const double size = std::abs(value);
    if (!(value == 0 || (size > kTiniest && size < 1 / kTiniest))) ++num_odd;
  }
  return 100 * num_odd < num_sampled;
}

/// Refuses points that are none because the numbers are of another type.
void check_type(const std::filesystem::path& path, std::string_view bytes, const Points& points) {
  constexpr double kLargestShare = 0.05;
  const auto num_tiny = ((points.array() != 0) && (points.array().abs() < kTiniest)).count();
  if (static_cast<double>(num_tiny) <= kLargestShare * static_cast<double>(points.size())) return;
  // a flat scan has what rounding leaves in one coordinate, and nothing huge
  const bool has_huge = (!(points.array().abs() < 1 / kTiniest)).any();
  if (!has_huge && (points.array().abs() >= kTiniest).rowwise().any().count() > 1) return;
  const std::string guess = may_hold<double>(bytes, std::endian::little) ? "they may be float64"
                            : may_hold<float>(bytes, std::endian::big)   ? "they may be big-endian"
                                                                       : "they are of another type";
  throw IoError(path, 0,
                "read as float32, " + std::to_string(100 * num_tiny / points.size()) +
                    " % of the coordinates are below 1e-15: " + guess +
                    "; write float32, or an .npy, which says its type");
}

std::string sizes_that_fit(std::string_view bytes) {
  std::string text;
  for (const Index count : kKnownColumns) {
    if (fits(bytes, count)) text += (text.empty() ? "" : " or ") + std::to_string(count);
  }
  return text;
}

}  // namespace

CloudFile parse_binary_scan(const std::filesystem::path& path, std::string_view bytes,
                            Index num_columns) {
  if (!fits(bytes, num_columns)) {
    throw IoError(path, 0,
                  "truncated: " + std::to_string(bytes.size()) + " bytes are no multiple of " +
                      std::to_string(bytes_of(num_columns)) + " (" + std::to_string(num_columns) +
                      " float32 a point)");
  }
  CloudFile file;
  file.points.resize(3, static_cast<Index>(bytes.size() / bytes_of(num_columns)));
  const char* row = bytes.data();
  for (Index i = 0; i < file.points.cols(); ++i, row += bytes_of(num_columns)) {
    for (Index j = 0; j < 3; ++j) file.points(j, i) = load<float>(row + 4 * j);
  }
  check_type(path, bytes, file.points);
  return file;
}

CloudFile parse_unknown_scan(const std::filesystem::path& path, std::string_view bytes) {
  const std::string fitting = sizes_that_fit(bytes);
  if (fitting == std::to_string(kKittiColumns) || fitting.empty()) {
    return parse_binary_scan(path, bytes, kKittiColumns);
  }
  const auto clear = clear_choice(bytes);
  if (!clear && !fits(bytes, kKittiColumns)) {
    throw IoError(path, 0,
                  "truncated, or ambiguous: " + std::to_string(bytes.size()) +
                      " bytes are no multiple of 16 (4 float32 a point); they fit " + fitting +
                      ", but the columns do not tell: say bin_columns");
  }
  if (!clear && !is_small(bytes)) {
    throw IoError(path, 0,
                  "ambiguous: " + std::to_string(bytes.size()) + " bytes fit " + fitting +
                      " float32 a point, and the columns do not tell: say bin_columns");
  }
  CloudFile file = parse_binary_scan(path, bytes, clear.value_or(kKittiColumns));
  file.notes.push_back(clear ? "its size fits " + fitting + " float32 a point: read as " +
                                   std::to_string(*clear) + ", by what the columns hold"
                             : "its size fits " + fitting +
                                   " float32 a point, and so few rows do not tell: read as " +
                                   std::to_string(kKittiColumns) + "; bin_columns says otherwise");
  return file;
}

}  // namespace gmcr::io
