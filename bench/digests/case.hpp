#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "digests/digest.hpp"

namespace gmcr::bench {

/// A problem with a seed of its own; solving it twice gives the same bits.
struct Case {
  std::string group;  ///< those whose times are summed
  std::string name;   ///< unique
  /// Draws and solves it, and adds all it found.
  std::function<void(Digest& digest, int num_threads)> solve;
};

using Cases = std::vector<Case>;

/// A seed for a problem: its name's hash, so that more problems do not change the others.
std::uint64_t seed_of(const std::string& name);

/// All of those below.
Cases all_cases();

/// That of the answer; that an input is refused is an answer too.
Digest digest_of(const Case& item, int num_threads);

void add_known_scale(Cases& cases);
void add_unknown_scale(Cases& cases);
void add_certified(Cases& cases);
void add_drawn(Cases& cases);  ///< the synthetic problems of a model themselves
void add_degenerate(Cases& cases);
void add_instances(Cases& cases);
void add_evaluations(Cases& cases);
void add_cliques(Cases& cases);
void add_clouds(Cases& cases);
void add_real(Cases& cases);

}  // namespace gmcr::bench
