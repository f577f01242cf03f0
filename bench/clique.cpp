// Times max_clique against other exact solvers. igraph and cliquer are GPL: this program is not
// shipped, and neither the library nor the tool links them.

#include <fmt/core.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <optional>
#include <stdexcept>

#include "clique/graphs.hpp"
#include "clique/solvers.hpp"
#include "support/records.hpp"
#include "support/solve.hpp"

namespace {

using namespace gmcr;
using namespace gmcr::bench;

constexpr double kSecondsToRepeat = 0.2;
constexpr int kMaxRepetitions = 9;
constexpr double kSecondsToPrepare = 120;

struct Settings {
  std::string out = "out/bench/clique.jsonl";
  std::vector<std::string> methods;
  std::string only;
  double time_limit = 60;
  double memory_limit_gb = 6;
  bool quick = false;
};

/// What a child process reports through its pipe: once before its first run, once at its end.
struct Message {
  CliqueAnswer answer;
  double wall_ms = 0;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void send(int pipe, const Message& message) {
  if (write(pipe, &message, sizeof message) != sizeof message) _exit(1);
}

/// The child's part: median of a few runs, or of one where that is slow.
[[noreturn]] void solve_in_child(const CliqueContestant& contestant, const BitsetGraph& graph,
                                 const Settings& settings, int pipe) {
  const auto bytes = static_cast<rlim_t>(settings.memory_limit_gb * 1e9);
  const rlimit memory{bytes, bytes};
  setrlimit(RLIMIT_AS, &memory);
  try {
    const auto run = contestant.prepare(graph);
    Message message;
    send(pipe, message);
    std::vector<double> times;
    const auto begin = std::chrono::steady_clock::now();
    do {
      const auto start = std::chrono::steady_clock::now();
      message.answer = run();
      times.push_back(1e3 * seconds_since(start));
    } while (static_cast<int>(times.size()) < kMaxRepetitions &&
             seconds_since(begin) < kSecondsToRepeat);
    message.wall_ms = quantile(times, 0.5);
    send(pipe, message);
  } catch (const std::exception&) {
    _exit(1);
  }
  _exit(0);
}

/// The next message of the child; nothing where it takes longer than that or ends without one.
std::optional<Message> receive(int pipe, double seconds, bool& timed_out) {
  pollfd waiting{pipe, POLLIN, 0};
  timed_out = poll(&waiting, 1, static_cast<int>(1e3 * seconds)) == 0;
  Message message;
  if (timed_out || read(pipe, &message, sizeof message) != sizeof message) return std::nullopt;
  return message;
}

Json solve_in_time(const CliqueContestant& contestant, const BitsetGraph& graph,
                   const Settings& settings) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe to a child process");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no child process");
  if (child == 0) {
    close(ends[0]);
    solve_in_child(contestant, graph, settings, ends[1]);
  }
  close(ends[1]);
  Json record = {{"method", contestant.name}, {"status", "error"}};
  bool timed_out = false;
  if (receive(ends[0], kSecondsToPrepare, timed_out)) {
    const auto outcome = receive(ends[0], settings.time_limit, timed_out);
    if (outcome) {
      record["status"] = outcome->answer.proven ? "ok" : "unproven";
      record["clique_size"] = outcome->answer.size;
      record["wall_ms"] = outcome->wall_ms;
    }
  }
  if (timed_out) record["status"] = "time limit";
  close(ends[0]);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  return record;
}

std::vector<CliqueContestant> chosen_contestants(const Settings& settings) {
  std::vector<CliqueContestant> chosen;
  for (CliqueContestant& contestant : clique_contestants()) {
    const auto& names = settings.methods;
    if (names.empty() || std::find(names.begin(), names.end(), contestant.name) != names.end()) {
      chosen.push_back(std::move(contestant));
    }
  }
  if (chosen.empty()) throw std::invalid_argument("--methods: names none of the solvers");
  return chosen;
}

void run(const Settings& settings) {
  const auto contestants = chosen_contestants(settings);
  std::vector<GraphCase> cases = clique_graphs(settings.quick);
  std::erase_if(cases, [&](const GraphCase& item) {
    return (item.family + " " + item.name).find(settings.only) == std::string::npos;
  });
  Records records(settings.out, "clique", cases.size());
  for (const GraphCase& item : cases) {
    const BitsetGraph graph = item.make();
    std::vector<Json> group;
    std::string note = item.family + " " + item.name + ":";
    for (const CliqueContestant& contestant : contestants) {
      Json record = {{"scenario", item.family},
                     {"graph", item.name},
                     {"num_vertices", graph.num_vertices()},
                     {"num_edges", graph.num_edges()},
                     {"time_limit", settings.time_limit}};
      record.update(solve_in_time(contestant, graph, settings));
      note += record.contains("wall_ms")
                  ? fmt::format(" {} {:.3g} ms", contestant.name, record["wall_ms"].get<double>())
                  : fmt::format(" {} {}", contestant.name, record["status"].get<std::string>());
      group.push_back(std::move(record));
    }
    records.write(group, note);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Times max_clique against igraph and cliquer."};
  Settings settings;
  app.add_option("--out", settings.out, "file for the records")->capture_default_str();
  app.add_option("--methods", settings.methods, "gmcr,gmcr-1,igraph,igraph-largest,cliquer")
      ->delimiter(',');
  app.add_option("--only", settings.only, "graphs whose family and name contain this");
  app.add_option("--time-limit", settings.time_limit, "seconds a solver and graph")
      ->capture_default_str();
  app.add_option("--memory-limit", settings.memory_limit_gb, "gigabytes a solver")
      ->capture_default_str();
  app.add_flag("--quick", settings.quick, "no consistency graphs of N > 1,000, no G(1000, 0.5)");
  CLI11_PARSE(app, argc, argv);
  try {
    run(settings);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_clique: {}\n", error.what());
    return 1;
  }
}
