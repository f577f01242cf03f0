#include "parallel/parallel_for.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace gmcr::parallel {

int resolve_num_threads(int num_threads) {
  return num_threads > 0 ? num_threads : std::max(1, tbb::this_task_arena::max_concurrency());
}

void parallel_for(Index count, Index grain, int num_threads,
                  const std::function<void(Index begin, Index end)>& body) {
  if (count <= 0) return;
  const Index num_chunks = (count + grain - 1) / grain;
  const auto run_chunk = [&](Index chunk) {
    body(chunk * grain, std::min(count, (chunk + 1) * grain));
  };
  const int threads = resolve_num_threads(num_threads);
  if (threads == 1 || num_chunks == 1) {
    for (Index chunk = 0; chunk < num_chunks; ++chunk) run_chunk(chunk);
    return;
  }
  // lets TBB have as many threads as asked for, also more than there are cores
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<Index>(0, num_chunks, 1), [&](const auto& range) {
      for (Index chunk = range.begin(); chunk != range.end(); ++chunk) run_chunk(chunk);
    });
  });
}

}  // namespace gmcr::parallel
