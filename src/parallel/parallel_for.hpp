#pragma once

#include <functional>

#include "gmcr/types.hpp"

namespace gmcr::parallel {

/// Threads that `num_threads` asks for: itself, or every core this process may use for 0.
int resolve_num_threads(int num_threads);

/// Threads for work on all pairs of so many: one where starting more would take longer than it.
inline int threads_for_pairs(Index count, int num_threads) {
  constexpr Index kFew = 512;
  return count < kFew ? 1 : num_threads;
}

/// Calls body(begin, end) on disjoint ranges that cover [0, count), on up to `num_threads` threads.
///
/// The ranges have `grain` indices each (the last may have fewer) for any number of threads, so a
/// body that writes only to its own range, or to a slot of index begin / grain, gives the same bits
/// for any number of threads. An exception of a body reaches the caller.
///
/// The threads are TBB's: no more than it allows the process (as many as there are cores, or what a
/// host program set) or the arena that this is called in; tasks of the host wait until it is done.
void parallel_for(Index count, Index grain, int num_threads,
                  const std::function<void(Index begin, Index end)>& body);

/// Calls both, at once where there are threads; each may have loops of its own.
inline void call_both(int num_threads, const std::function<void()>& first,
                      const std::function<void()>& second) {
  parallel_for(2, 1, num_threads, [&](Index k, Index) { (k == 0 ? first : second)(); });
}

}  // namespace gmcr::parallel
