#pragma once

#include <string>

#include "digests/case.hpp"
#include "digests/settings.hpp"
#include "gmcr/synthetic.hpp"

namespace gmcr::bench {

/// Which problem of which benchmark.
struct Draw {
  SyntheticKind kind = SyntheticKind::Ball;
  Index size = 0;
  double outlier_rate = 0;
};

/// Such as "ball-100-0.9".
std::string name_of(const Draw& draw);

/// Scales between 1/2 and 2; noise bounds as in the benchmarks of each kind.
Problem draw_problem(const Draw& draw, std::uint64_t seed);

/// Adds the registration of the problem by the variant.
void add_registration(Cases& cases, const std::string& group, const Draw& draw, Scale scale,
                      const Variant& variant);

}  // namespace gmcr::bench
