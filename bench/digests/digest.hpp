#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gmcr/clique.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/registration.hpp"
#include "gmcr/synthetic.hpp"

namespace gmcr::bench {

/// 64-bit FNV-1a hash over the bits of numbers, of all of them and of each named part.
class Digest {
 public:
  struct Part {
    std::string name;
    std::uint64_t hash = 0;
  };

  /// What is added from here on belongs to this part.
  void begin(std::string_view part);

  void add(std::uint64_t word);
  void add(double value);
  void add(Index value) { add(static_cast<std::uint64_t>(value)); }
  void add(int value) { add(static_cast<std::uint64_t>(value)); }
  void add(bool value) { add(std::uint64_t{value}); }
  void add(std::string_view text);

  std::uint64_t hash() const { return hash_; }
  const std::vector<Part>& parts() const { return parts_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
  std::vector<Part> parts_;
};

/// All of a result but its times, its words and the number of threads.
void add(Digest& digest, const Result& result);
void add(Digest& digest, const std::vector<Result>& results);
void add(Digest& digest, const Consensus& consensus);
void add(Digest& digest, const Uncertainty& uncertainty);
void add(Digest& digest, const CloudMatches& matches);
void add(Digest& digest, const CloudResult& result);
void add(Digest& digest, const CliqueResult& result);
void add(Digest& digest, const WeightedCliqueResult& result);
void add(Digest& digest, const SyntheticProblem& problem);

}  // namespace gmcr::bench
