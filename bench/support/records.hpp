#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gmcr/result.hpp"
#include "gmcr/types.hpp"

namespace gmcr::bench {

using Json = nlohmann::ordered_json;

/// What every record says about where it was made: version, CPU, ISA of the CPU, cores.
Json environment();

/// Hash of the bits of the points of a problem, as 16 hexadecimal digits (FNV-1a).
std::string input_hash(const PointsRef& source, const PointsRef& target);

/// What a result says of itself: status, inliers, certificates, estimated noise, stage times,
/// counts.
Json describe(const Result& result);

/// Appends one JSON line a run to a file, and tells how far the program is on stderr.
class Records {
 public:
  /// Starts the file anew.
  /// @throws std::runtime_error where it cannot be written.
  Records(const std::filesystem::path& path, std::string program, std::size_t num_groups);

  /// Writes each record with the program's name and the environment, a line each.
  /// @param note  what to say of all of them on stderr.
  void write(const std::vector<Json>& group, const std::string& note);

 private:
  std::ofstream file_;
  std::string program_;
  Json environment_;
  std::size_t num_groups_;
  std::size_t num_written_ = 0;
};

}  // namespace gmcr::bench
