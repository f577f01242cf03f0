// The parallel loop in a build that has no library of threads.
#include <algorithm>

#include "parallel/parallel_for.hpp"

namespace gmcr::parallel {

int resolve_num_threads(int) { return 1; }

void parallel_for(Index count, Index grain, int,
                  const std::function<void(Index begin, Index end)>& body) {
  for (Index begin = 0; begin < count; begin += grain) body(begin, std::min(count, begin + grain));
}

}  // namespace gmcr::parallel
