#include <fmt/ranges.h>

#include "arguments/option_flags.hpp"
#include "commands/commands.hpp"
#include "gmcr/clique.hpp"
#include "gmcr/io.hpp"
#include "gmcr/options.hpp"
#include "gmcr/version.hpp"
#include "input/input_file.hpp"
#include "output/json.hpp"
#include "output/report.hpp"
#include "output/stopwatch.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kCliqueExamples =
    R"(GRAPH is DIMACS (.clq, .col) or MatrixMarket (.mtx), or - for one of them from stdin. Vertices count from 1, as in the file.

Examples:
  gmcr clique brock200_4.clq
  gmcr clique web.mtx --time-limit 10 --json)";

struct CliqueArguments {
  std::string graph;
  CliqueOptions options;
  Options limits;  ///< of which the memory is that of the graph
  OutputArguments output;
};

Json clique_json(const BitsetGraph& graph, const CliqueResult& result,
                 const std::vector<Index>& vertices, double seconds) {
  Json json;
  json["status"] = "ok";
  json["num_vertices"] = graph.num_vertices();
  json["num_edges"] = graph.num_edges();
  json["clique_size"] = vertices.size();
  json["vertices"] = vertices;
  json["first_vertex"] = 1;
  json["upper_bound"] = result.upper_bound;
  json["proven_optimal"] = result.proven_optimal;
  json["nodes"] = result.nodes;
  json["time_ms"] = {{"total", 1000 * seconds}};
  json["version"] = kVersion;
  return json;
}

void print_report(Report report, const BitsetGraph& graph, const CliqueResult& result,
                  const std::vector<Index>& vertices, double seconds) {
  report.line("graph",
              fmt::format("{} vertices, {} edges", graph.num_vertices(), graph.num_edges()));
  report.line("clique", fmt::format("{} vertices: {}", vertices.size(), fmt::join(vertices, " ")));
  if (result.proven_optimal) {
    report.line("certificate", "no clique is larger: proven optimal", Report::Tone::Good);
  } else {
    report.line("certificate", fmt::format("no clique has more than {}", result.upper_bound),
                Report::Tone::Fair);
  }
  report.line("time", fmt::format("{}, {} nodes", duration(seconds), result.nodes));
  report.print();
}

ExitCode run_clique(const CliqueArguments& arguments) {
  const InputFile file(arguments.graph, TextKind::Graph);
  const BitsetGraph graph =
      file.read([&](const auto& path) { return read_graph(path, arguments.limits.memory_limit); });
  const Stopwatch stopwatch;
  const CliqueResult result = max_clique(graph, arguments.options);
  const double seconds = stopwatch.seconds();
  std::vector<Index> vertices = result.vertices;
  for (Index& vertex : vertices) ++vertex;
  if (arguments.output.json) {
    print(clique_json(graph, result, vertices, seconds));
  } else {
    print_report(Report(arguments.output), graph, result, vertices, seconds);
  }
  return kPoseFound;
}

}  // namespace

void add_clique_command(CLI::App& app, Work& work) {
  const auto arguments = std::make_shared<CliqueArguments>();
  CLI::App& command = *app.add_subcommand("clique", "Maximum clique of a graph file");
  command.add_option("GRAPH", arguments->graph, "Graph, .clq, .col or .mtx, or - for stdin")
      ->required();
  add_flags(command, arguments->options, [](const std::string& name) {
    return name == "time_limit" || name == "max_nodes" || name == "num_threads";
  });
  add_flags(command, arguments->limits,
            [](const std::string& name) { return name == "memory_limit"; });
  arguments->output.add_to(command);
  command.footer(kCliqueExamples);
  command.callback([arguments, &work] { work = [arguments] { return run_clique(*arguments); }; });
}

}  // namespace gmcr::cli
