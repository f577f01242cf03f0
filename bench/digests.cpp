// Prints a hash of the answer to each of some thousand problems: a restructuring changes none.

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "digests/case.hpp"

namespace {

using namespace gmcr::bench;

struct Settings {
  std::string filter;
  std::string compare;
  std::string only;
  int threads = 0;
  bool prints_parts = false;
  bool prints_times = false;
};

struct Timing {
  std::string name;
  double seconds = 0;
};

struct Total {
  int problems = 0;
  double seconds = 0;
};

using Record =
    std::map<std::string, std::string>;  // hash and, where printed, those of the parts, by name

constexpr std::size_t kNumSlowest = 20;

bool is_asked_for(const Settings& settings, const std::string& name) {
  return name.find(settings.filter) != std::string::npos;
}

std::string in_hex(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

Record read_record(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  Record record;
  for (std::string line; std::getline(file, line);) {
    const std::size_t space = line.find(' ');
    if (space != std::string::npos) record[line.substr(0, space)] = line.substr(space + 1);
  }
  return record;
}

Cases cases_asked_for(const Settings& settings) {
  Cases cases = all_cases();
  if (!settings.only.empty()) {
    const Record record = read_record(settings.only);
    std::erase_if(cases, [&](const Case& item) { return !record.contains(item.name); });
  }
  std::erase_if(cases, [&](const Case& item) { return !is_asked_for(settings, item.name); });
  return cases;
}

/// Two threads for each eighth, one for the others, or as many as all shall have.
int threads_for(const Settings& settings, const Case& item) {
  if (settings.threads > 0) return settings.threads;
  return seed_of(item.name) % 8 == 0 ? 2 : 1;
}

std::string in_words(const Settings& settings, const Digest& digest) {
  std::string words = in_hex(digest.hash());
  if (settings.prints_parts) {
    for (const auto& [name, hash] : digest.parts()) words += ' ' + name + '=' + in_hex(hash);
  }
  return words;
}

void print_times(std::vector<Timing> timings, const std::map<std::string, Total>& totals) {
  for (const auto& [group, total] : totals) {
    fmt::print(stderr, "{:<16} {:>5} problems {:>8.2f} s\n", group, total.problems, total.seconds);
  }
  const auto slower = [](const Timing& a, const Timing& b) { return a.seconds > b.seconds; };
  std::sort(timings.begin(), timings.end(), slower);
  timings.resize(std::min(timings.size(), kNumSlowest));
  for (const Timing& slow : timings) {
    fmt::print(stderr, "{:>8.3f} s {}\n", slow.seconds, slow.name);
  }
}

/// Of all threads; hardly depends on what else the machine does.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The hashes; prints them, where there is nothing to compare them with.
Record solve_all(const Settings& settings, const Cases& cases) {
  Record record;
  std::vector<Timing> timings;
  std::map<std::string, Total> totals;
  for (const Case& item : cases) {
    const double start = processor_seconds();
    const Digest digest = digest_of(item, threads_for(settings, item));
    const double seconds = processor_seconds() - start;
    timings.push_back({item.name, seconds});
    totals[item.group].problems += 1;
    totals[item.group].seconds += seconds;
    const std::string words = in_words(settings, digest);
    if (settings.compare.empty()) {
      fmt::print("{} {}\n", item.name, words);
      std::fflush(stdout);  // the last line says where it hangs
    }
    if (!record.emplace(item.name, words).second) {
      throw std::logic_error(item.name + ": named twice");
    }
  }
  if (settings.prints_times) print_times(timings, totals);
  return record;
}

/// "pose work" where these parts of an answer differ; empty where only the whole is known of both.
std::string parts_that_differ(const std::string& before, const std::string& now) {
  std::istringstream old_words(before), new_words(now);
  std::string parts, old_word, new_word;
  old_words >> old_word;
  new_words >> new_word;
  while (old_words >> old_word && new_words >> new_word) {
    if (old_word != new_word) parts += ' ' + new_word.substr(0, new_word.find('='));
  }
  return parts;
}

bool is_same(const std::string& before, const std::string& now) {
  return before.substr(0, before.find(' ')) == now.substr(0, now.find(' '));
}

/// Prints the names that differ, or that only one of the two has, and returns how many there are.
int compare(const Settings& settings, const Record& now) {
  int num_different = 0;
  const auto differs = [&](const std::string& name, const std::string& how) {
    fmt::print("{} {}\n", name, how);
    ++num_different;
  };
  const Record before = read_record(settings.compare);
  for (const auto& [name, hash] : now) {
    const auto known = before.find(name);
    if (known == before.end()) {
      differs(name, "is new");
    } else if (!is_same(known->second, hash)) {
      differs(name, "differs:" + parts_that_differ(known->second, hash));
    }
  }
  for (const auto& [name, hash] : before) {
    if (is_asked_for(settings, name) && !now.contains(name)) differs(name, "is missing");
  }
  return num_different;
}

int run(const Settings& settings) {
  const Record record = solve_all(settings, cases_asked_for(settings));
  if (settings.compare.empty()) return 0;
  const int num_different = compare(settings, record);
  fmt::print("{} problems, {} differ\n", record.size(), num_different);
  return num_different == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Prints a hash of the bits of the answer to each of many small problems."};
  Settings settings;
  app.add_option("--filter", settings.filter, "only problems whose name contains this");
  app.add_option("--compare", settings.compare,
                 "a recorded output: print what differs from it; exit 1 if anything does");
  app.add_option("--only", settings.only, "a recorded output: only the problems that it names");
  app.add_option("--threads", settings.threads, "for every problem; 0: 1, and 2 for some")
      ->check(CLI::NonNegativeNumber);
  app.add_flag("--parts", settings.prints_parts, "print the hash of each part of an answer too");
  app.add_flag("--times", settings.prints_times, "print processor times to standard error");
  CLI11_PARSE(app, argc, argv);
  try {
    return run(settings);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_digests: {}\n", error.what());
    return 2;
  }
}
