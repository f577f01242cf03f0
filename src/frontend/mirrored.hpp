#pragma once

#include <optional>

#include "frontend/cloud_pair.hpp"
#include "gmcr/frontend.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::frontend {

/// The features of a mirrored cloud from those of the cloud: of the three angles the one whose
/// cosine is a triple product changes its sign.
Features mirrored_features(const Features& features);

/// One attempt with the mirrored source, judged; compared with its rivals where it would be
/// trusted. What is known of the source is not made anew.
/// @return nullopt where priors say where the source lies, or the time is up.
std::optional<CloudResult> register_mirrored(CloudScales& source, CloudScales& target,
                                             const FrontendOptions& frontend,
                                             const Options& options, const FrontendSetting& setting,
                                             const parallel::Deadline& deadline);

}  // namespace gmcr::frontend
