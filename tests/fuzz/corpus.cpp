#include "fuzz/corpus.hpp"

#include <fstream>
#include <stdexcept>

namespace gmcr::fuzz {
namespace {

std::string unescaped(const std::string& line) {
  std::string bytes;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != '\\') {
      bytes += line[i];
      continue;
    }
    if (i + 3 >= line.size() || line[i + 1] != 'x') throw std::runtime_error("no \\xHH: " + line);
    bytes += static_cast<char>(std::stoi(line.substr(i + 2, 2), nullptr, 16));
    i += 3;
  }
  return bytes;
}

}  // namespace

std::vector<std::string> read_corpus(const std::filesystem::path& path) {
  std::vector<std::string> inputs;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line[0] != '#') inputs.push_back(unescaped(line));
  }
  return inputs;
}

}  // namespace gmcr::fuzz
