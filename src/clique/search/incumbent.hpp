#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::clique {

/// The largest clique known so far and the size that a clique must exceed to be of interest.
class Incumbent {
 public:
  Incumbent(std::vector<Index> clique, Index must_exceed)
      : clique_(std::move(clique)), must_exceed_(must_exceed) {}

  /// Keeps `clique` if it is larger than the present one.
  void offer(std::vector<Index> clique) {
    if (clique.size() > clique_.size()) clique_ = std::move(clique);
  }

  const std::vector<Index>& clique() const { return clique_; }
  Index size() const { return static_cast<Index>(clique_.size()); }
  Index to_beat() const { return std::max(size(), must_exceed_); }

 private:
  std::vector<Index> clique_;
  Index must_exceed_;
};

}  // namespace gmcr::clique
