#pragma once

#include <algorithm>
#include <atomic>
#include <functional>

#include "gmcr/types.hpp"

namespace gmcr::parallel {

/// The ranges of `grain` indices that [0, count) is cut into, taken by threads one after the other.
class ChunkQueue {
 public:
  ChunkQueue(Index count, Index grain) : count_(std::max<Index>(count, 0)), grain_(grain) {}

  Index num_chunks() const { return (count_ + grain_ - 1) / grain_; }

  /// Calls body(begin, end) on chunk after chunk until none is left, in as many threads at once as
  /// call this; after an exception, which it passes on, no thread takes another.
  void work_off(const std::function<void(Index begin, Index end)>& body) {
    try {
      for (Index chunk = take(); chunk < num_chunks(); chunk = take()) {
        body(chunk * grain_, std::min(count_, (chunk + 1) * grain_));
      }
    } catch (...) {
      next_.store(num_chunks(), std::memory_order_relaxed);
      throw;
    }
  }

 private:
  /// Relaxed: the count of chunks must not order what they do.
  Index take() { return next_.fetch_add(1, std::memory_order_relaxed); }

  Index count_;
  Index grain_;
  std::atomic<Index> next_ = 0;
};

}  // namespace gmcr::parallel
