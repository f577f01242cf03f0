#include "gmcr/result.hpp"

namespace gmcr {

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
