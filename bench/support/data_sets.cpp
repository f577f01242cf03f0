#include "support/data_sets.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace gmcr::bench {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

}  // namespace

std::filesystem::path data_root() {
  const char* given = std::getenv("GMCR_DATA");
  return given != nullptr ? given : GMCR_DEFAULT_DATA;
}

std::vector<std::filesystem::path> pairs_of_set(const std::filesystem::path& root,
                                                const std::string& set) {
  std::vector<std::filesystem::path> pairs;
  if (!std::filesystem::is_directory(root / set)) return pairs;
  for (const auto& entry : std::filesystem::directory_iterator(root / set)) {
    if (std::filesystem::exists(entry.path() / "T_target_source.txt")) {
      pairs.push_back(entry.path());
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::optional<double> listed_resolution(const std::filesystem::path& root, const std::string& set,
                                        const std::string& name) {
  std::ifstream inventory(root / "INVENTORY.csv");
  std::string line;
  std::getline(inventory, line);
  const std::vector<std::string> header = split(line);
  const auto column = static_cast<std::size_t>(
      std::find(header.begin(), header.end(), "resolution") - header.begin());
  while (std::getline(inventory, line)) {
    const std::vector<std::string> cells = split(line);
    if (cells.size() > column && cells[0] == set && cells[1] == name && !cells[column].empty()) {
      return std::stod(cells[column]);
    }
  }
  return std::nullopt;
}

}  // namespace gmcr::bench
