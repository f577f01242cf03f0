#include "frontend/map/structure_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace gmcr::frontend {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::infinity();
constexpr Index kGroundReach = 3;  // cells: what stands on the ground has some this near
constexpr double kMostCells = 1e8;
constexpr double kStray = 0.001;  // share of the voxels at either side that may lie anywhere
/// Voxels: what reaches into a band by less is taken to be in the next one as well.
constexpr double kBandBorder = 1;

/// Smallest of the values within a reach, along one axis.
void spread_least(std::vector<float>& values, Index count, Index stride, Index num_lines,
                  Index line_stride) {
  std::vector<float> line(static_cast<std::size_t>(count));
  for (Index k = 0; k < num_lines; ++k) {
    float* const at = values.data() + k * line_stride;
    for (Index i = 0; i < count; ++i) line[static_cast<std::size_t>(i)] = at[i * stride];
    for (Index i = 0; i < count; ++i) {
      const auto from = line.begin() + std::max<Index>(0, i - kGroundReach);
      const auto to = line.begin() + std::min(count, i + kGroundReach + 1);
      at[i * stride] = *std::min_element(from, to);
    }
  }
}

std::pair<double, double> range_without_strays(std::vector<double> values) {
  const auto last = static_cast<Index>(values.size()) - 1;
  const auto skipped = static_cast<Index>(kStray * static_cast<double>(values.size()));
  std::nth_element(values.begin(), values.begin() + skipped, values.end());
  const double low = values[static_cast<std::size_t>(skipped)];
  std::nth_element(values.begin(), values.begin() + (last - skipped), values.end());
  return {low, values[static_cast<std::size_t>(last - skipped)]};
}

}  // namespace

StructureGrid::StructureGrid(const Points& voxels) {
  lay_out(voxels);
  find_ground(voxels);
  mark(voxels);
}

int StructureGrid::band(double height) {
  const double above = height - kLeastHeight;
  return above < 0 ? -1 : std::min(kNumBands - 1, static_cast<int>(above / kBand));
}

void StructureGrid::lay_out(const Points& voxels) {
  Index sizes[2] = {0, 0};
  for (int axis = 0; axis < 2 && voxels.cols() > 0; ++axis) {
    const Eigen::VectorXd row = voxels.row(axis);
    const auto [low, high] = range_without_strays({row.data(), row.data() + row.size()});
    origin_[axis] = low - kCell * static_cast<double>(kMargin);
    const double cells = (high - low) / kCell + 2 * static_cast<double>(kMargin) + 1;
    if (!(cells < kMostCells)) throw std::invalid_argument("map: it spreads over too many voxels");
    sizes[axis] = static_cast<Index>(cells);
  }
  if (static_cast<double>(sizes[0]) * static_cast<double>(sizes[1]) > kMostCells) {
    std::ostringstream message;
    message << "map: it spreads over " << sizes[0] << " x " << sizes[1]
            << " cells of two voxels, too many: take larger voxels or leave out stray points";
    throw std::invalid_argument(message.str());
  }
  width_ = sizes[0];
  height_ = sizes[1];
}

Index StructureGrid::cell_of(double x, double y) const {
  const auto column = static_cast<Index>(std::floor((x - origin_.x()) / kCell));
  const auto row = static_cast<Index>(std::floor((y - origin_.y()) / kCell));
  const bool is_inside =
      column >= kMargin && row >= kMargin && column < width_ - kMargin && row < height_ - kMargin;
  return is_inside ? row * width_ + column : -1;
}

void StructureGrid::find_ground(const Points& voxels) {
  const auto num_cells = static_cast<std::size_t>(width_ * height_);
  ground_.assign(num_cells, kUnknown);
  for (Index i = 0; i < voxels.cols(); ++i) {
    const Index cell = cell_of(voxels(0, i), voxels(1, i));
    if (cell < 0) continue;
    float& least = ground_[static_cast<std::size_t>(cell)];
    least = std::min(least, static_cast<float>(voxels(2, i)));
  }
  const std::vector<float> lowest = ground_;
  spread_least(ground_, width_, 1, height_, width_);
  spread_least(ground_, height_, width_, width_, 1);
  is_ground_.assign(num_cells, 0);
  for (std::size_t cell = 0; cell < num_cells; ++cell) {
    is_ground_[cell] = lowest[cell] < kUnknown && lowest[cell] - ground_[cell] < kLeastHeight;
  }
}

void StructureGrid::mark(const Points& voxels) {
  std::vector<std::uint8_t> bits(static_cast<std::size_t>(width_ * height_), 0);
  for (Index i = 0; i < voxels.cols(); ++i) {
    const Index cell = cell_of(voxels(0, i), voxels(1, i));
    if (cell < 0) continue;
    const auto at = static_cast<std::size_t>(cell);
    const double height = voxels(2, i) - static_cast<double>(ground_[at]);
    if (band(height) < 0) continue;
    for (const double border : {-kBandBorder, kBandBorder}) {
      bits[at] = static_cast<std::uint8_t>(bits[at] | 1 << std::max(0, band(height + border)));
    }
  }
  near_ = bits;
  for (Index row = 1; row + 1 < height_; ++row) {
    for (Index column = 1; column + 1 < width_; ++column) {
      std::uint8_t& near = near_[static_cast<std::size_t>(row * width_ + column)];
      for (Index y = row - 1; y <= row + 1; ++y) {
        for (Index x = column - 1; x <= column + 1; ++x) {
          near |= bits[static_cast<std::size_t>(y * width_ + x)];
        }
      }
    }
  }
}

}  // namespace gmcr::frontend
