#include "frontend/mirrored.hpp"

#include <utility>

#include "frontend/attempts.hpp"

namespace gmcr::frontend {
namespace {

KnownSurface mirrored(KnownSurface surface) {
  surface.viewpoint.x() *= -1;
  surface.voxels.row(0) *= -1;
  surface.normals.row(0) *= -1;
  surface.features = mirrored_features(surface.features);
  return surface;
}

}  // namespace

Features mirrored_features(const Features& features) {
  if (features.size() == 0) return features;
  constexpr int kBins = kFpfhBins / 3;
  Features mirrored = features;
  mirrored.middleRows<kBins>(kBins) = features.middleRows<kBins>(kBins).colwise().reverse();
  return mirrored;
}

std::optional<CloudResult> register_mirrored(CloudScales& source, CloudScales& target,
                                             const FrontendOptions& frontend,
                                             const Options& options, const FrontendSetting& setting,
                                             const parallel::Deadline& deadline) {
  if (deadline.expired() || !options.admit_all()) return std::nullopt;
  Points points = source.points();
  points.row(0) *= -1;
  const PointsRef mirrored_points = points;
  CloudScales from(mirrored_points);
  from.set_voxel_size(source.voxel_size());
  for (KnownSurface& known : source.known()) from.add(mirrored(std::move(known)));
  FrontendOptions seen = frontend;
  seen.source_viewpoint.x() *= -1;
  Attempts attempts(from, target, seen, options, deadline);
  attempts.add(setting);
  return attempts.best().result.verdict == Verdict::Trusted ? attempts.compared()
                                                            : attempts.best().result;
}

}  // namespace gmcr::frontend
