#pragma once

#include "gmcr/clique.hpp"
#include "options/option.hpp"

namespace gmcr::options {

template <>
struct Table<CliqueOptions> : TableDefaults {
  static constexpr std::tuple options{
      Option{&CliqueOptions::time_limit,
             {.name = "time_limit",
              .help = "Wall time for the search",
              .unit = "seconds",
              .range = kZeroOrMore}},
      Option{&CliqueOptions::max_nodes,
             {.name = "max_nodes", .help = "Search nodes to visit, never exceeded"}},
      Option{&CliqueOptions::max_work,
             {.name = "max_work", .help = "Word operations, about; 2**30 take about a second"}},
      Option{&CliqueOptions::initial_clique,
             {.name = "initial_clique", .help = "Known clique to start from; may be empty"}},
      Option{&CliqueOptions::must_exceed,
             {.name = "must_exceed",
              .help = "Report only a clique with more vertices than this; 0 reports any",
              .range = kZeroOrMore}},
      Option{&CliqueOptions::num_threads,
             {.name = "num_threads",
              .help = "Threads, which do not change the result; 0 uses every core",
              .range = kThreads,
              .alias = "threads"}},
      Option{&CliqueOptions::max_memory,
             {.name = "max_memory", .help = "Memory for copies of the graph", .unit = "bytes"}}};
};

template <>
struct Table<WeightedCliqueOptions> : TableDefaults {
  static constexpr std::tuple options{
      Option{&WeightedCliqueOptions::time_limit,
             {.name = "time_limit",
              .help = "Wall time for the search",
              .unit = "seconds",
              .range = kZeroOrMore}},
      Option{&WeightedCliqueOptions::max_nodes,
             {.name = "max_nodes", .help = "Search nodes to visit"}},
      Option{&WeightedCliqueOptions::max_work,
             {.name = "max_work", .help = "Word operations, about; 2**30 take about a second"}},
      Option{&WeightedCliqueOptions::max_memory,
             {.name = "max_memory", .help = "Memory for copies of the graph", .unit = "bytes"}},
      Option{&WeightedCliqueOptions::must_exceed,
             {.name = "must_exceed",
              .help = "Report only a clique that weighs more than this; 0 reports any",
              .range = kZeroOrMore}},
      Option{&WeightedCliqueOptions::num_threads,
             {.name = "num_threads",
              .help = "Threads, which do not change the result; 0 uses every core",
              .range = kThreads,
              .alias = "threads"}}};
};

}  // namespace gmcr::options
