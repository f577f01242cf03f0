#include "kernels/bits/branch_choice.hpp"

namespace gmcr::kernels {

void BranchScratch::resize(Index num_vertices) {
  const auto num_words = static_cast<std::size_t>(padded_words(num_vertices));
  for (AlignedWords* row : {&uncoloured, &free, &in_use, &compatible}) row->resize(num_words);
  // one more, as a list may be written to behind its end
  const auto length = static_cast<std::size_t>(num_vertices) + 1;
  for (auto* list : {&members, &compatible_members, &other_members}) list->resize(length);
  for (auto* list : {&first_member, &unit_vertices, &unit_classes, &involved, &class_of,
                     &next_member, &removed_by}) {
    list->resize(length);
  }
  branches.resize(length);
}

}  // namespace gmcr::kernels
