#pragma once

#include <string>
#include <vector>

#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

/// Name of the instruction set that the vectorised loops use on this machine, such as "AVX2".
/// Every one gives the same bits.
std::string active_isa();

/// Instruction sets that the library was built for and this machine has, best first.
std::vector<std::string> supported_isas();

/// Threads that `num_threads = 0` stands for: every core that this process may use.
int hardware_threads();

}  // namespace gmcr
