// parallel_for by threads of the standard library, for a build with ThreadSanitizer: that sees
// every access of ours, but not how a library without its instrumentation orders them.
#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "parallel/chunk_queue.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::parallel {

int resolve_num_threads(int num_threads) {
  if (num_threads > 0) return num_threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallel_for(Index count, Index grain, int num_threads,
                  const std::function<void(Index begin, Index end)>& body) {
  ChunkQueue chunks(count, grain);
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      chunks.work_off(body);
    } catch (...) {
      const std::scoped_lock lock(mutex);
      failure = std::current_exception();
    }
  };
  const Index num_others =
      std::min<Index>(resolve_num_threads(num_threads), chunks.num_chunks()) - 1;
  {
    std::vector<std::jthread> others;
    for (Index i = 0; i < num_others; ++i) others.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace gmcr::parallel
