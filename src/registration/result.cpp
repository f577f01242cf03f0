#include "gmcr/result.hpp"

namespace gmcr {

Eigen::Matrix<double, 6, 6> pose_graph_covariance(const Covariance& covariance,
                                                  const Similarity& target_from_source,
                                                  PoseGraph convention) {
  // ours is of  exp([omega]x) R x + t + tau
  Eigen::Matrix<double, 6, 6> map = Eigen::Matrix<double, 6, 6>::Zero();
  if (convention == PoseGraph::Ros) {
    map.topRightCorner<3, 3>().setIdentity();
    map.bottomLeftCorner<3, 3>().setIdentity();
  } else {  // R exp([xi_1]x) = exp([R xi_1]x) R,  t + R xi_2
    map.topLeftCorner<3, 3>() = target_from_source.rotation.transpose();
    map.bottomRightCorner<3, 3>() = target_from_source.rotation.transpose();
  }
  return map * covariance.matrix.topLeftCorner<6, 6>() * map.transpose();
}

const char* to_string(Status status) {
  switch (status) {
    case Status::Ok:
      return "ok";
    case Status::TooFewCorrespondences:
      return "too_few_correspondences";
    case Status::NoConsensus:
      return "no_consensus";
    case Status::Degenerate:
      return "degenerate";
  }
  return "unknown";
}

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::Trusted:
      return "trusted";
    case Verdict::Doubtful:
      return "doubtful";
    case Verdict::Untrusted:
      return "untrusted";
  }
  return "unknown";
}

const char* to_string(Limit limit) {
  switch (limit) {
    case Limit::Time:
      return "time";
    case Limit::Stopped:
      return "stopped";
    case Limit::Memory:
      return "memory";
    case Limit::CliqueSearch:
      return "clique_search";
    case Limit::EvidenceSearch:
      return "evidence_search";
    case Limit::ScaleSearch:
      return "scale_search";
    case Limit::ConsensusSearch:
      return "consensus_search";
  }
  return "unknown";
}

}  // namespace gmcr
