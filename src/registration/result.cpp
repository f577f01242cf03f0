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

}  // namespace gmcr
