#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "gmcr/types.hpp"
#include "io/tables/table_layout.hpp"

namespace gmcr::io {

/// Numbers of the chosen columns of a text table.
struct Table {
  Eigen::MatrixXd values;          ///< chosen column x row, so that a row of the file is contiguous
  std::vector<std::size_t> lines;  ///< line of the file of each row
  std::vector<std::string> notes;  ///< what had to be decided, as sentences
};

/// Columns by index, and sentences where they had to be guessed.
struct ColumnChoice {
  std::vector<std::size_t> indices;
  std::vector<std::string> notes;
};

/// Picks columns; may throw std::invalid_argument with a reason.
using ColumnChooser = std::function<ColumnChoice(const TableShape&)>;

/// Parses rows of cells as `find_layout` finds them.
/// @throws IoError with the line where a row has another number of cells than the first, or where a
///   chosen cell is no number; where the chooser throws; where there is neither header nor row;
///   where the number of rows contradicts a count; where the last line is cut.
Table parse_table(const std::filesystem::path& path, std::string_view text,
                  const ColumnChooser& choose, const TableRules& rules = {});

/// `header`, then the columns of `values` as lines of cells between separators, at full precision.
std::string format_rows(const Eigen::Ref<const Eigen::MatrixXd>& values, char separator,
                        std::string_view header);

/// The names of columns between quotation marks, for messages; of all where there are no indices.
std::string quoted_names(const std::vector<std::string>& names,
                         const std::vector<std::size_t>& indices = {});

}  // namespace gmcr::io
