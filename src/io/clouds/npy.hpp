#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::io {

/// The transpose of an .npy array of shape (N, W), W one of `num_columns`: W x N, so that one row
/// of the file is one column. `allows_more`: or of more columns, where there are more rows than
/// those.
/// @throws IoError unless it is an array of that shape of float32, float64 or integers, in any byte
///   order, complete and with nothing behind it.
Eigen::MatrixXd parse_npy(const std::filesystem::path& path, std::string_view bytes,
                          const std::vector<Index>& num_columns, bool allows_more = false);

/// The bytes of the .npy file of the transpose of `values`: version 1.0, float64, C order.
std::string format_npy(const Eigen::Ref<const Eigen::MatrixXd>& values);

}  // namespace gmcr::io
