#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gmcr::bench {

/// Where the real data lies: $GMCR_DATA, else the folder shared/data next to the checkout.
std::filesystem::path data_root();

/// Folders of a set that hold a pair (a source, a target and their transform), sorted by name;
/// empty where the set is absent.
std::vector<std::filesystem::path> pairs_of_set(const std::filesystem::path& root,
                                                const std::string& set);

/// Mean distance of neighbouring points of a pair, as listed in INVENTORY.csv.
std::optional<double> listed_resolution(const std::filesystem::path& root, const std::string& set,
                                        const std::string& name);

}  // namespace gmcr::bench
