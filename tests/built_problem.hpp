#pragma once

#include "problem/problem.hpp"
#include "problems.hpp"

namespace gmcr::testing {

/// A problem as the stages of a solve see it, with all that it refers to.
struct BuiltProblem {
  Points source, target;
  Options options;
  problem::Run run{options};
  problem::Problem problem{source, target, options, run};

  BuiltProblem(const Problem& matches, const Options& some)
      : source(matches.source), target(matches.target), options(some) {}
  BuiltProblem(const BuiltProblem&) = delete;
  BuiltProblem& operator=(const BuiltProblem&) = delete;

  const problem::Objective& objective() const { return problem.objective(); }

  problem::CentredPose centred(const Similarity& pose) const {
    return problem::centre(problem::CallerPose{pose}, problem.correspondences());
  }
};

/// Options at scale 1 with one bound for all.
inline Options options_with(Evidence evidence, double noise_bound = 0.01) {
  Options options;
  options.noise_bound = noise_bound;
  options.evidence = evidence;
  return options;
}

}  // namespace gmcr::testing
