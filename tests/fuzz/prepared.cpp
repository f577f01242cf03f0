// Files of prepared clouds: refused by name, or used as any other cloud. The fuzzer cannot guess a
// checksum, so what a changed file says is read under the right one too.
#include <cstdint>
#include <cstdio>
#include <string>

#include "fuzz/target.hpp"
#include "gmcr/prepared_cloud.hpp"

namespace gmcr::fuzz {
namespace {

constexpr std::string_view kChecksum = "comment checksum ";
constexpr std::string_view kEnd = "\nend_header\n";
constexpr std::size_t kDigits = 16;

/// FNV-1a of all but the line of the checksum, as docs/files.md says.
std::string with_checksum(std::string_view bytes) {
  std::string mended(bytes);
  const std::size_t line = mended.find(kChecksum);
  if (line == std::string::npos) return mended;
  const std::size_t first = line + kChecksum.size(), body = first + kDigits + kEnd.size();
  if (body > mended.size()) return mended;
  std::uint64_t hash = 0xcbf29ce484222325;
  for (std::size_t i = 0; i < mended.size(); ++i) {
    if (i == line) i = body;
    if (i < mended.size()) hash = (hash ^ static_cast<unsigned char>(mended[i])) * 0x100000001b3;
  }
  char digits[kDigits + 1];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return mended.replace(first, kDigits, digits);
}

void use(const PreparedCloud& cloud) {
  const std::string bytes = cloud.to_bytes();
  require(PreparedCloud::is_prepared(bytes), "it says what it is");
  require(PreparedCloud::from_bytes(bytes).to_bytes() == bytes, "the same again");
  require(cloud.points().allFinite(), "finite points");
  Options options;
  options.num_threads = 1;
  options.time_limit = 0.5;
  try {
    const CloudMatches matches = match_clouds(cloud, cloud, {}, options);
    require(matches.source.cols() == matches.target.cols(), "pairs");
    require(matches.source.allFinite() && matches.target.allFinite(), "finite matches");
  } catch (const std::invalid_argument& error) {
    require(std::string(error.what()).find(": ") != std::string::npos, "a refusal by name");
  }
}

void read(std::string_view bytes) {
  try {
    use(PreparedCloud::from_bytes(bytes));
  } catch (const std::invalid_argument& error) {
    require(std::string(error.what()).find(": ") != std::string::npos, "a refusal by name");
  }
}

}  // namespace

void read_prepared_cloud(std::string_view bytes) {
  read(bytes);
  read(with_checksum(bytes));
}

}  // namespace gmcr::fuzz
