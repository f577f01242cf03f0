#include "input/read_estimate.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "gmcr/io.hpp"
#include "output/json.hpp"

namespace gmcr::cli {
namespace {

Estimate parse_json(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw IoError(path, 0, std::strerror(errno));
  const Json json = Json::parse(file, nullptr, false);
  if (json.is_discarded()) throw IoError(path, 0, "no JSON");
  try {
    Eigen::Matrix4d matrix;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        matrix(static_cast<Index>(i), static_cast<Index>(j)) =
            json.at("target_from_source").at(i).at(j).get<double>();
      }
    }
    return {json.value("status", "ok"), Similarity::from_matrix(matrix)};
  } catch (const nlohmann::json::exception&) {
    throw IoError(path, 0, "no field target_from_source with 4 rows of 4 numbers");
  } catch (const std::invalid_argument& error) {
    throw IoError(path, 0, error.what());
  }
}

/// A JSON object starts with a brace, which no 4 x 4 text does.
bool is_json(const std::filesystem::path& path) {
  char first = 0;
  return std::ifstream(path) >> first && first == '{';
}

}  // namespace

Estimate read_estimate(const std::filesystem::path& path) {
  if (is_json(path)) return parse_json(path);
  return {"ok", read_transform(path)};
}

}  // namespace gmcr::cli
