#pragma once

#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "gmcr/similarity.hpp"

namespace gmcr::fuzz {

/// Something that takes bytes from anywhere. Its function returns, whatever the bytes are; an
/// exception out of it is a finding, and so is what a sanitizer says.
struct Target {
  std::string_view name;
  void (*run)(std::string_view bytes);
};

/// What GoogleTest calls it, which would print addresses.
inline void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

/// All of them, by name.
const std::vector<Target>& targets();

/// A finding where `holds` is false.
inline void require(bool holds, const std::string& what) {
  if (!holds) throw std::logic_error("must hold: " + what);
}

/// A finding where it is no similarity.
void check_pose(const Similarity& pose);

void read_matches_csv(std::string_view bytes);
void read_matches_npy(std::string_view bytes);
void read_pose(std::string_view bytes);
void read_estimate(std::string_view bytes);
void read_graph_clq(std::string_view bytes);
void read_graph_mtx(std::string_view bytes);
void solve(std::string_view bytes);
void find_cliques(std::string_view bytes);
void register_small_clouds(std::string_view bytes);
void read_prepared_cloud(std::string_view bytes);

/// `Extension` with its dot.
void read_cloud_of(const char* extension, std::string_view bytes);

}  // namespace gmcr::fuzz
