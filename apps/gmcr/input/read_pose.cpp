#include "input/read_pose.hpp"

#include "gmcr/io.hpp"
#include "input/input_file.hpp"
#include "input/read_estimate.hpp"

namespace gmcr::cli {

Similarity read_pose(const std::string& path) {
  const InputFile file(path);
  const Estimate estimate = file.read(&read_estimate);
  if (estimate.status == "ok") return estimate.pose;
  throw IoError(file.name(), 0, "a result of status '" + estimate.status + "' has no pose");
}

}  // namespace gmcr::cli
