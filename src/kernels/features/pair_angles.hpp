#pragma once

#include <cstdint>

#include "gmcr/types.hpp"

namespace gmcr::kernels {

/// Points with normals, an array for each coordinate.
struct OrientedPoints {
  const double *x, *y, *z;
  const double *normal_x, *normal_y, *normal_z;  ///< unit, or 0 where there is none
};

constexpr Index kAngleBins = 11;
/// Counts of an angle, and those of the pairs without angles after them.
constexpr Index kAngleRow = kAngleBins + 1;
constexpr Index kPairAngles = 3;

/// Adds the pairs of point `i` with its neighbours to the histograms of the angles theta, cos alpha
/// and cos phi of their Darboux frames (Rusu, Blodow and Beetz 2009, eq. 1 and 2), each of 11 equal
/// bins over [-pi, pi] and [-1, 1]. The frame sits at the point whose normal is closer to the line
/// between the two, at `i` where the cosines tie to 1e-9.
///
/// A pair has no angles where it coincides, where one has no normal or where the offset is along
/// the normal of the frame.
/// @param counts  kPairAngles x kAngleRow, a row after the other.
/// The bin of theta is the number of edges that the direction has passed, by the signs of cross
/// products: no arc tangent. The same counts as the reference on every instruction set.
/// Cost O(count).
void count_pair_angles(const OrientedPoints& points, Index i, const std::int32_t* neighbours,
                       Index count, std::int32_t* counts);

/// The same, one pair after the other: the specification.
void count_pair_angles_reference(const OrientedPoints& points, Index i,
                                 const std::int32_t* neighbours, Index count, std::int32_t* counts);

/// Floats of a histogram that `add_histograms` sums: those of 33 bins, filled up.
constexpr Index kHistogramStride = 48;

/// Sum over k of weights[k] times histogram indices[k], in the order of k.
/// @param histograms  kHistogramStride values each.
/// @param sum         kHistogramStride values, overwritten.
/// The same bits as the reference on every instruction set. Cost O(count).
void add_histograms(const float* histograms, const std::int32_t* indices, const float* weights,
                    Index count, float* sum);

/// The same, one value after the other: the specification.
void add_histograms_reference(const float* histograms, const std::int32_t* indices,
                              const float* weights, Index count, float* sum);

/// Cosine and sine of the edges of the bins of theta at (2 k + 1) pi / 11, k = 0 to 4.
struct ThetaEdge {
  double cosine, sine;
};
inline constexpr ThetaEdge kThetaEdges[] = {{0.9594929736144974, 0.28173255684142967},
                                            {0.6548607339452851, 0.7557495743542583},
                                            {0.14231483827328514, 0.9898214418809327},
                                            {-0.4154150130018864, 0.9096319953545183},
                                            {-0.8412535328311812, 0.5406408174555976}};
/// Cosines of the angles to the line that count as equal.
inline constexpr double kCosineTie = 1e-9;

}  // namespace gmcr::kernels
