// Problems of all kinds, again and again, from many threads of several processes that were forked
// from one that had solved them all: the answers stay the same, and memory does not grow.

#include <fmt/core.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "digests/case.hpp"
#include "support/records.hpp"

namespace {

using namespace gmcr;
using namespace gmcr::bench;
using Clock = std::chrono::steady_clock;

struct Settings {
  std::string out = "out/bench/soak.jsonl";
  double minutes = 60;
  int num_threads = 8;
  int num_processes = 2;
  double most_seconds = 0.05;  ///< of a problem, on its first time
};

struct Known {
  Case item;
  std::uint64_t hash;
};

/// Those that are solved quickly, with their answers.
std::vector<Known> answers(const Settings& settings) {
  std::vector<Known> known;
  for (const Case& item : all_cases()) {
    const auto start = Clock::now();
    const std::uint64_t hash = digest_of(item, 2).hash();
    const std::chrono::duration<double> seconds = Clock::now() - start;
    if (seconds.count() <= settings.most_seconds) known.push_back({item, hash});
  }
  return known;
}

/// Megabytes that the process has in memory.
double resident_megabytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0, resident = 0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// What one process did.
struct Tally {
  std::atomic<std::uint64_t> num_solves = 0;
  std::atomic<std::uint64_t> num_different = 0;
};

/// Solves until the time is up, each time another problem, with one to three threads.
void solve_until(Clock::time_point end, const std::vector<Known>& known, std::uint64_t start,
                 Tally& tally) {
  std::uint64_t state = start;
  while (Clock::now() < end) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    const Known& next = known[(state >> 33) % known.size()];
    const int num_threads = static_cast<int>(1 + (state >> 20) % 3);
    if (digest_of(next.item, num_threads).hash() != next.hash) {
      ++tally.num_different;
      fmt::print(stderr, "{} differs with {} threads\n", next.item.name, num_threads);
    }
    ++tally.num_solves;
  }
}

/// The whole life of a process: what it says is one line of JSON.
Json live(const Settings& settings, const std::vector<Known>& known, int process) {
  const auto start = Clock::now();
  const auto duration = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(60 * settings.minutes));
  Tally tally;
  std::vector<std::jthread> threads;
  for (int t = 0; t < settings.num_threads; ++t) {
    const auto seed = static_cast<std::uint64_t>(1000 * process + t + 1);
    threads.emplace_back([&, seed] { solve_until(start + duration, known, seed, tally); });
  }
  // a tenth of the time in, each thread has what it keeps
  std::this_thread::sleep_until(start + duration / 10);
  double megabytes = resident_megabytes();
  Json record = {{"process", process}, {"megabytes_after_a_tenth", megabytes}};
  double most = megabytes;
  for (int k = 1; k <= 100; ++k) {
    std::this_thread::sleep_until(start + duration / 10 + duration / 1000 * 9 * k);
    megabytes = resident_megabytes();
    most = std::max(most, megabytes);
    if (k == 50) record["megabytes_at_half"] = megabytes;
  }
  threads.clear();
  record["megabytes_at_the_end"] = resident_megabytes();
  record["most_megabytes"] = most;
  record["solves"] = tally.num_solves.load();
  record["different"] = tally.num_different.load();
  return record;
}

/// Starts a process that writes its record to the pipe.
int forked(const Settings& settings, const std::vector<Known>& known, int process) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child > 0) {
    close(ends[1]);
    return ends[0];
  }
  int code = 1;
  try {
    const std::string line = live(settings, known, process).dump();
    code = write(ends[1], line.data(), line.size()) == static_cast<ssize_t>(line.size()) ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_soak: {}\n", error.what());
  }
  _exit(code);
}

std::string all_of(int end) {
  std::string text;
  char chunk[4096];
  for (ssize_t count = 0; (count = read(end, chunk, sizeof chunk)) > 0;) {
    text.append(chunk, static_cast<std::size_t>(count));
  }
  close(end);
  return text;
}

int run(const Settings& settings) {
  const std::vector<Known> known = answers(settings);
  if (known.empty()) throw std::runtime_error("no problem is that quick");
  std::vector<int> ends;
  for (int p = 0; p < settings.num_processes; ++p) ends.push_back(forked(settings, known, p));
  Records records(settings.out, "soak", 1);
  std::vector<Json> all;
  std::uint64_t num_bad = 0;
  for (const int end : ends) {
    const Json record = Json::parse(all_of(end), nullptr, false);
    if (record.is_discarded()) throw std::runtime_error("a process died");
    all.push_back({{"minutes", settings.minutes},
                   {"threads", settings.num_threads},
                   {"problems", known.size()}});
    all.back().update(record);
    num_bad += record["different"].get<std::uint64_t>();
    fmt::print("{}\n", all.back().dump());
  }
  while (wait(nullptr) > 0) {
  }
  records.write(all, fmt::format("{} answers differ", num_bad));
  return num_bad == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Solves problems of all kinds again and again; the answers must not change."};
  Settings settings;
  app.add_option("--out", settings.out, "file for the records")->capture_default_str();
  app.add_option("--minutes", settings.minutes)->capture_default_str();
  app.add_option("--threads", settings.num_threads, "of each process")->capture_default_str();
  app.add_option("--processes", settings.num_processes)->capture_default_str();
  app.add_option("--most-seconds", settings.most_seconds, "of a problem, to be among them")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    return run(settings);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_soak: {}\n", error.what());
    return 2;
  }
}
