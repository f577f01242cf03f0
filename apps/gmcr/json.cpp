#include "json.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "gmcr/io.hpp"

namespace gmcr::cli {
namespace {

constexpr int kIndent = 2;

}  // namespace

Json rows_of(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  Json rows = Json::array();
  for (Index i = 0; i < matrix.rows(); ++i) {
    Json row = Json::array();
    for (Index j = 0; j < matrix.cols(); ++j) row.push_back(matrix(i, j));
    rows.push_back(std::move(row));
  }
  return rows;
}

void print(const Json& json) {
  fmt::print("{}\n", json.dump(kIndent));
  if (std::fflush(stdout) != 0) throw IoError("standard output", 0, std::strerror(errno));
}

void write(const std::filesystem::path& path, const Json& json) {
  std::ofstream file(path, std::ios::binary);
  file << json.dump(kIndent) << '\n';
  file.close();
  if (!file) throw IoError(path, 0, std::strerror(errno));
}

}  // namespace gmcr::cli
