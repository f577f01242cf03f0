#pragma once

#include <sys/types.h>

namespace gmcr::cli {

/// While it lives, what asks the program to end (SIGINT, SIGTERM, SIGHUP) ends the program that it
/// waits for instead; then, with the object, it ends this one, after what was to be cleaned up.
class HeldSignals {
 public:
  HeldSignals();
  ~HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  /// Whether one came.
  static bool came();

  /// The program to end; 0: none.
  static void pass_to(pid_t child);
};

}  // namespace gmcr::cli
