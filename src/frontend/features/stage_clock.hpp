#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gmcr/options.hpp"
#include "gmcr/result.hpp"
#include "parallel/stopwatch.hpp"

namespace gmcr::frontend {

/// Adds `seconds` to the stage of that name, which is appended where it is new.
inline void add_stage(std::vector<StageTime>& stages, const std::string& name, double seconds) {
  for (StageTime& stage : stages) {
    if (stage.name == name) {
      stage.seconds += seconds;
      return;
    }
  }
  stages.push_back({name, seconds});
}

/// Tells the caller that a stage begins.
/// @return false where the caller, who is asked by that, wants the work to end.
inline bool begin_stage(const Options& options, const char* stage) {
  return !options.progress || options.progress(Progress{stage, 0});
}

/// Splits the time since its construction among stages.
class StageClock {
 public:
  explicit StageClock(std::vector<StageTime>& stages) : stages_(stages) {}

  /// Books the time since the last lap on the stage `name`.
  void lap(const char* name) { add_stage(stages_, name, since_last()); }

  /// Books it on stages that ran side by side, in proportion to the times that these took; where
  /// none ran, it is left to the next lap.
  void lap(std::initializer_list<std::span<const StageTime>> side_by_side) {
    double sum = 0;
    for (const auto stages : side_by_side) {
      for (const StageTime& stage : stages) sum += stage.seconds;
    }
    if (!(sum > 0)) return;
    const double elapsed = since_last();
    for (const auto stages : side_by_side) {
      for (const StageTime& stage : stages) {
        add_stage(stages_, stage.name, elapsed * stage.seconds / sum);
      }
    }
  }

 private:
  double since_last() {
    const double now = watch_.elapsed();
    return now - std::exchange(last_, now);
  }

  std::vector<StageTime>& stages_;
  parallel::Stopwatch watch_;
  double last_ = 0;
};

}  // namespace gmcr::frontend
