#include <string>
#include <string_view>
#include <utility>

#include "gmcr/report.hpp"

namespace gmcr {

std::string stage_in_words(std::string_view stage) {
  constexpr std::pair<std::string_view, std::string_view> kWords[] = {
      {"voxel", "voxel grids"},
      {"matching", "nearest features"},
      {"start", "poses of samples"},
      {"scale_votes", "votes for scales"},
      {"evidence", "distinct evidence"},
      {"graph", "consistency graph"},
      {"clique", "clique search"},
      {"pose", "judging poses"},
      {"bounds", "upper bounds"},
      {"consensus_sets", "consensus sets"},
      {"certify", "proof"},
      {"fit", "likeliest pose"},
      {"verdict", "odds of chance"},
      {"noise", "choosing the noise bound"},
      {"other_bounds", "other noise bounds"},
      {"comparison", "comparing surfaces"}};
  for (const auto& [name, words] : kWords) {
    if (stage == name) return std::string(words);
  }
  return std::string(stage);
}

}  // namespace gmcr
