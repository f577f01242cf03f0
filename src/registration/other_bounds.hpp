#pragma once

#include "gmcr/result.hpp"
#include "registration/estimated_noise.hpp"

namespace gmcr::registration {

/// The answer at a noise bound; or, where chance would give what agrees there, a surer pose that is
/// found at a third or three times the bound.
///
/// A bound far below the noise leaves of the right matches fewer than agree by chance, one far
/// above it makes more agree by chance than are right; both leave a pose that holds the most and is
/// not the right one. Whether it is one of these is told by false alarms at the bound and without
/// one
/// (`noise::PoseAlarms`). Then two more solves ask the other bounds. Of a pose that is surer the
/// covariance and the verdict are those at its own bound, as the reason says; the inliers and the
/// certificate are those of the given bound.
/// Nothing is tried where the scale is searched, where several hypotheses or a proof are asked for,
/// and where the time has ended.
/// @param at_given  the answer of `solve` at the bound of the options.
Result at_surest_bound(Result at_given, const PointsRef& source, const PointsRef& target,
                       const Options& options, const Solve& solve);

}  // namespace gmcr::registration
