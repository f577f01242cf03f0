// Raw clouds with default options: runs `gmcr register` on every real pair, as a user would.

#include <fmt/core.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>

#include "gmcr/io.hpp"
#include "gmcr/metrics.hpp"
#include "gmcr/synthetic.hpp"
#include "support/data_sets.hpp"
#include "support/solve.hpp"

namespace {

using namespace gmcr;
using namespace gmcr::bench;

constexpr double kMaxRotationErrorDeg = 5;
constexpr double kMaxErrorOfExtent = 0.05;
constexpr double kMaxSymmetricError = 0.02;

struct Settings {
  std::string out = "out/bench/clouds.jsonl";
  std::string tool;
  std::vector<std::string> sets{"stanford_scans", "mian_views",  "mining_lidar", "lidar",
                                "3dmatch",        "rgbd_frames", "objects_uwa",  "objects_ycb",
                                "object_scans",   "objects_rgbd"};
  std::vector<std::string> refinements{"none", "icp"};
  std::vector<std::string> arguments;
  int repetitions = 1;
};

/// A pair as the tool gets to see it.
struct Pair {
  std::string set;
  std::string name;
  std::filesystem::path source_path;
  std::filesystem::path target_path;
  Points source;
  Points target;
  Similarity truth;
};

struct Output {
  int exit_code = 0;
  std::string text;
  double wall_ms = 0;
};

/// Folder that disappears with its owner.
class TemporaryFolder {
 public:
  TemporaryFolder()
      : path_(std::filesystem::temp_directory_path() / fmt::format("gmcr_bench_{}", getpid())) {
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

Output run_command(const std::vector<std::string>& words) {
  std::string command;
  for (const std::string& word : words) command += quoted(word) + " ";
  const auto start = std::chrono::steady_clock::now();
  std::FILE* pipe = popen((command + "2>/dev/null").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot start " + words.front());
  Output output;
  char buffer[4096];
  for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) {
    output.text.append(buffer, n);
  }
  const int status = pclose(pipe);
  output.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
  output.wall_ms = wall.count();
  return output;
}

/// Whether the pair hardly moves, so that doing nothing would count as a success.
bool is_nearly_at_rest(const Similarity& truth) {
  return rotation_error_deg(truth.rotation, Eigen::Matrix3d::Identity()) < 0.5 &&
         truth.translation.norm() < 0.1;
}

Pair load(const std::filesystem::path& folder, const std::filesystem::path& scratch) {
  Pair pair;
  pair.set = folder.parent_path().filename().string();
  pair.name = folder.filename().string();
  pair.source_path = folder / "source.ply";
  pair.target_path = folder / "target.ply";
  pair.source = read_cloud(pair.source_path).points;
  pair.target = read_cloud(pair.target_path).points;
  pair.truth = read_transform(folder / "T_target_source.txt");
  if (is_nearly_at_rest(pair.truth)) {
    // A rotation about the origin keeps the sensor where it is.
    SyntheticOptions draw;
    draw.num_correspondences = 0;
    draw.max_translation = 0;
    const Similarity motion = make_synthetic(draw).target_from_source;
    pair.source = motion.apply(pair.source);
    pair.truth = pair.truth * motion.inverse();
    pair.source_path = scratch / (pair.name + ".ply");
    write_cloud(pair.source_path, pair.source);
  }
  return pair;
}

Similarity parse_transform(const Json& rows) {
  Eigen::Matrix4d matrix;
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) {
      matrix(r, c) = rows.at(static_cast<std::size_t>(r)).at(static_cast<std::size_t>(c));
    }
  }
  return Similarity::from_matrix(matrix);
}

/// Mean distance of the source at one pose from its nearest point at the other one, over its
/// diameter: 0 where the poses differ by a symmetry of it. Some of many points are asked.
double symmetric_error(const Similarity& a, const Similarity& b, const Points& source) {
  constexpr Index kQueries = 500;
  const Points there = b.apply(source);
  const Index stride = (source.cols() + kQueries - 1) / kQueries;
  double sum = 0, count = 0;
  for (Index i = 0; i < source.cols(); i += stride, ++count) {
    const Eigen::Vector3d point = a * source.col(i);
    sum += std::sqrt((there.colwise() - point).colwise().squaredNorm().minCoeff());
  }
  return sum / count / (there.rowwise().maxCoeff() - there.rowwise().minCoeff()).norm();
}

/// Adds the errors of the pose that the tool gave.
void judge(Json& record, const Json& answer, const Pair& pair) {
  record["success"] = false;
  if (!answer.contains("target_from_source") || answer["target_from_source"].is_null()) return;
  const double extent =
      (pair.target.rowwise().maxCoeff() - pair.target.rowwise().minCoeff()).maxCoeff();
  const Similarity found = parse_transform(answer["target_from_source"]);
  Json errors = errors_of(found, pair.truth, pair.source);
  errors["symmetric_of_diameter"] = symmetric_error(found, pair.truth, pair.source);
  errors["translation_of_extent"] = errors["translation"].get<double>() / extent;
  errors["mean_point_of_extent"] = errors["mean_point"].get<double>() / extent;
  record["success"] = errors["rotation_deg"] <= kMaxRotationErrorDeg &&
                      errors["mean_point_of_extent"] <= kMaxErrorOfExtent;
  record["success_of_translation"] = errors["rotation_deg"] <= kMaxRotationErrorDeg &&
                                     errors["translation_of_extent"] <= kMaxErrorOfExtent;
  record["success_by_symmetry"] =
      record["success"] || errors["symmetric_of_diameter"] <= kMaxSymmetricError;
  record["errors"] = errors;
}

Json run_pair(const Settings& settings, const Pair& pair, const std::string& refinement) {
  std::vector<std::string> words{
      settings.tool, "register", pair.source_path.string(), pair.target_path.string(), "--json",
      "--refine",    refinement};
  words.insert(words.end(), settings.arguments.begin(), settings.arguments.end());
  Json record = {{"scenario", pair.set + "/" + pair.name},
                 {"set", pair.set},
                 {"method", "gmcr register --refine " + refinement},
                 {"refine", refinement},
                 {"seed", 0},
                 {"input_hash", input_hash(pair.source, pair.target)}};
  std::vector<double> wall_ms;
  Output output;
  for (int i = 0; i < settings.repetitions; ++i) {
    output = run_command(words);
    wall_ms.push_back(output.wall_ms);
  }
  record["exit_code"] = output.exit_code;
  record["wall_ms"] = quantile(wall_ms, 0.5);
  record["repetitions"] = settings.repetitions;
  const Json answer = Json::parse(output.text, nullptr, false);
  if (answer.is_discarded()) {
    record["status"] = "error";
    record["success"] = false;
    return record;
  }
  for (const auto& [key, value] : answer.items()) {
    if (key != "inliers" && !record.contains(key)) record[key] = value;
  }
  judge(record, answer, pair);
  return record;
}

std::string summary(const Json& record) {
  std::string text =
      fmt::format("{} {}: {}", record["scenario"].get<std::string>(),
                  record["refine"].get<std::string>(), record["success"] ? "right" : "WRONG");
  if (record.contains("errors")) {
    text += fmt::format(", {:.2f} deg, {:.2f} % of extent, {:.2f} % of diameter by symmetry",
                        record["errors"]["rotation_deg"].get<double>(),
                        100 * record["errors"]["mean_point_of_extent"].get<double>(),
                        100 * record["errors"]["symmetric_of_diameter"].get<double>());
  }
  return text + fmt::format(", verdict {}, {:.0f} ms", record.value("verdict", "-"),
                            record["wall_ms"].get<double>());
}

void run(const Settings& settings) {
  if (!std::filesystem::exists(settings.tool)) {
    throw std::runtime_error(settings.tool + ": absent; build the tool or give --tool");
  }
  std::vector<std::filesystem::path> folders;
  for (const std::string& set : settings.sets) {
    const auto pairs = pairs_of_set(data_root(), set);
    if (pairs.empty()) fmt::print(stderr, "skipped: {} is absent\n", set);
    folders.insert(folders.end(), pairs.begin(), pairs.end());
  }
  const TemporaryFolder scratch;
  Records records(settings.out, "clouds", folders.size() * settings.refinements.size());
  for (const auto& folder : folders) {
    const Pair pair = load(folder, scratch.path());
    for (const std::string& refinement : settings.refinements) {
      const Json record = run_pair(settings, pair, refinement);
      records.write(std::vector<Json>(1, record), summary(record));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Runs `gmcr register` with default options on every real pair of clouds."};
  Settings settings;
  settings.tool = (std::filesystem::path(argv[0]).parent_path() / "gmcr").string();
  app.add_option("--out", settings.out, "file for the records")->capture_default_str();
  app.add_option("--tool", settings.tool, "the gmcr binary")->capture_default_str();
  app.add_option("--sets", settings.sets, "sets of pairs")->delimiter(',');
  app.add_option("--refine", settings.refinements, "none, icp")->delimiter(',');
  app.add_option("--repetitions", settings.repetitions, "runs a record")->capture_default_str();
  app.add_option("--argument", settings.arguments, "further argument for the tool, repeatable");
  CLI11_PARSE(app, argc, argv);
  try {
    run(settings);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_clouds: {}\n", error.what());
    return 1;
  }
}
