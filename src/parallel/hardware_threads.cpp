#include "gmcr/isa.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr {

int hardware_threads() { return parallel::resolve_num_threads(0); }

}  // namespace gmcr
