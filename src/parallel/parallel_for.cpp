#include "parallel/parallel_for.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "parallel/chunk_queue.hpp"

namespace gmcr::parallel {
namespace {

/// As many threads as TBB would give.
int allowed_threads(int num_threads) {
  const auto limit =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return static_cast<int>(std::min(static_cast<std::size_t>(num_threads), limit));
}

}  // namespace

int resolve_num_threads(int num_threads) {
  return num_threads > 0 ? num_threads : std::max(1, tbb::this_task_arena::max_concurrency());
}

void parallel_for(Index count, Index grain, int num_threads,
                  const std::function<void(Index begin, Index end)>& body) {
  ChunkQueue chunks(count, grain);
  const Index threads =
      std::min<Index>(allowed_threads(resolve_num_threads(num_threads)), chunks.num_chunks());
  if (threads <= 1) return chunks.work_off(body);
  // No task_arena, which would keep to the number of threads by itself: TBB 2021 leaves 7 KB behind
  // for each that ends before its workers leave it, and goes on looking through all of them.
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_for(
        Index{0}, threads, [&](Index) { chunks.work_off(body); }, tbb::simple_partitioner());
  });
}

}  // namespace gmcr::parallel
