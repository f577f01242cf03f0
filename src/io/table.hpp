#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::io {

/// Numbers of the chosen columns of a text table.
struct Table {
  Eigen::MatrixXd values;          ///< chosen column x row, so that a row of the file is contiguous
  std::vector<std::size_t> lines;  ///< line of the file of each row
};

/// What the first line of a table says.
struct TableShape {
  std::vector<std::string>
      names;  ///< of the header, in lower case, without quotes; empty: no header
  std::size_t num_columns = 0;
};

/// Picks columns by index; may throw std::invalid_argument with a reason.
using ColumnChooser = std::function<std::vector<std::size_t>(const TableShape&)>;

/// Parses rows of cells, separated by `;` if the first row holds one, else by `,` if it holds one,
/// else by white space. Blank lines and lines that start with `#` or `//` are skipped. The first
/// row is a header if none of its cells is a number.
/// @param lines_to_skip  lines at the start of the text to leave out.
/// @throws IoError with the line where a row has another number of cells than the first, or where a
///   chosen cell is no number; where the chooser throws; where there is neither header nor row.
Table parse_table(const std::filesystem::path& path, std::string_view text,
                  const ColumnChooser& choose, std::size_t lines_to_skip = 0);

/// `header`, then the columns of `values` as lines of cells between separators, at full precision.
std::string format_rows(const Eigen::Ref<const Eigen::MatrixXd>& values, char separator,
                        std::string_view header);

/// Indices of `wanted` in `names`; empty where one is missing.
std::vector<std::size_t> find_columns(const std::vector<std::string>& names,
                                      const std::vector<std::string>& wanted);

}  // namespace gmcr::io
