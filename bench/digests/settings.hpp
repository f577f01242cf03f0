#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "gmcr/frontend.hpp"
#include "gmcr/options.hpp"
#include "gmcr/registration.hpp"
#include "support/problem.hpp"

namespace gmcr::bench {

// All that the digests know of the names of options; no time limit binds.

enum class Scale {
  Known,  ///< that of the truth
  Range,  ///< estimated, between half and twice that of the truth
  Free,   ///< estimated, from the data alone
};

/// "known", "range" or "free".
std::string_view name_of(Scale scale);

/// A named choice of options.
struct Variant {
  std::string name;
  std::function<void(Options&, const Problem&)> apply;
};

/// Every option of a registration, alone and some together, but the proofs, which take long.
const std::vector<Variant>& all_variants();

/// Those of the names; throws `std::invalid_argument` where one is unknown.
std::vector<Variant> variants_named(const std::vector<std::string>& names);

/// Options that prove the consensus a maximum one.
const std::vector<Variant>& certifying_variants();

/// Options for the problem.
Options options_for(const Problem& problem, Scale scale, const Variant& variant, int num_threads);

/// Options for clouds, whose bound comes from the voxels.
Options cloud_options(Scale scale, double known_scale, int num_threads);

/// A named choice of options of the front end.
struct FrontendVariant {
  std::string name;
  FrontendOptions options;
};

/// The first is the standard; `voxel_size` 0 chooses one from the clouds.
std::vector<FrontendVariant> frontend_variants(double voxel_size);

InstanceOptions instance_options(int max_instances, Index min_inliers, double min_share);

}  // namespace gmcr::bench
