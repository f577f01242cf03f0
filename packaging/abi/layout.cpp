// Prints size and alignment of each public type: programs hold them by value. tools/abi compares
// them.
#include <cstdio>

#include "gmcr/clique.hpp"
#include "gmcr/descriptors.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/invalid_option.hpp"
#include "gmcr/io.hpp"
#include "gmcr/metrics.hpp"
#include "gmcr/prepared_cloud.hpp"
#include "gmcr/registration.hpp"
#include "gmcr/report.hpp"
#include "gmcr/synthetic.hpp"

#define SHOW(type) std::printf("%s %zu %zu\n", #type, sizeof(gmcr::type), alignof(gmcr::type))

int main() {
  SHOW(Alternative);
  SHOW(BitsetGraph);
  SHOW(Certificate);
  SHOW(CliqueOptions);
  SHOW(CliqueResult);
  SHOW(CliqueSolver);
  SHOW(Cloud);
  SHOW(CloudMatches);
  SHOW(CloudOptions);
  SHOW(CloudResult);
  SHOW(Consensus);
  SHOW(Covariance);
  SHOW(DescriptorMatches);
  SHOW(DescriptorMatching);
  SHOW(Detail);
  SHOW(Diagnostics);
  SHOW(Evidence);
  SHOW(EvidenceCertificate);
  SHOW(FrontendOptions);
  SHOW(GravityPrior);
  SHOW(InitialPose);
  SHOW(InstanceOptions);
  SHOW(InvalidOption);
  SHOW(IoError);
  SHOW(Limit);
  SHOW(LimitHit);
  SHOW(Matches);
  SHOW(Method);
  SHOW(NoiseEstimate);
  SHOW(NoiseMode);
  SHOW(NoiseShape);
  SHOW(NormalOrientation);
  SHOW(Options);
  SHOW(PoseGraph);
  SHOW(PreparedCloud);
  SHOW(Priors);
  SHOW(Progress);
  SHOW(Refine);
  SHOW(Refinement);
  SHOW(ReportContext);
  SHOW(ReportLine);
  SHOW(Result);
  SHOW(RivalPose);
  SHOW(ScaleMode);
  SHOW(ScaleRange);
  SHOW(Similarity);
  SHOW(StageTime);
  SHOW(Status);
  SHOW(SurfaceFit);
  SHOW(SyntheticKind);
  SHOW(SyntheticOptions);
  SHOW(SyntheticProblem);
  SHOW(Tone);
  SHOW(Uncertainty);
  SHOW(Verdict);
  SHOW(WeakDirection);
  SHOW(WeightedCliqueOptions);
  SHOW(WeightedCliqueResult);
}
