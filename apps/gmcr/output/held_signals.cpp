#include "output/held_signals.hpp"

#include <array>
#include <atomic>
#include <csignal>

namespace gmcr::cli {
namespace {

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};

// a handler sees nothing else
std::atomic<int> g_signal{0};
std::atomic<pid_t> g_child{0};
int g_depth = 0;
std::array<struct sigaction, kSignals.size()> g_before;

void hold(int signal) {
  g_signal = signal;
  // not the same one, on which Python would print where it was
  if (const pid_t child = g_child; child != 0) kill(child, SIGTERM);
}

}  // namespace

HeldSignals::HeldSignals() {
  if (g_depth++ > 0) return;
  struct sigaction action {};
  action.sa_handler = hold;
  action.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], nullptr, &g_before[i]);
    // what the parent of this program ignores stays ignored
    if (g_before[i].sa_handler != SIG_IGN) sigaction(kSignals[i], &action, nullptr);
  }
}

HeldSignals::~HeldSignals() {
  if (--g_depth > 0) return;
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &g_before[i], nullptr);
  if (const int signal = g_signal.exchange(0); signal != 0) raise(signal);
}

bool HeldSignals::came() { return g_signal != 0; }

void HeldSignals::pass_to(pid_t child) {
  g_child = child;
  if (child != 0 && came()) kill(child, SIGTERM);  // before it was known
}

}  // namespace gmcr::cli
