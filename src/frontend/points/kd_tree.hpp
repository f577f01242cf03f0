#pragma once

#include <nanoflann.hpp>

#include "gmcr/types.hpp"

namespace gmcr::frontend {

/// What nanoflann asks of a set of points: its size and its coordinates.
struct KdTreePoints {
  const PointsRef& points;

  std::size_t kdtree_get_point_count() const { return static_cast<std::size_t>(points.cols()); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return points(static_cast<Index>(axis), static_cast<Index>(i));
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using KdTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, KdTreePoints>,
                                        KdTreePoints, 3, std::int32_t>;

}  // namespace gmcr::frontend
