#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::io {

/// What a kind of table may hold beside rows of numbers.
struct TableRules {
  const char* row_name = "points";
  bool allows_counts = false;   ///< lines that say how many rows follow
  bool allows_missing = false;  ///< cells that are empty, NA, null: NaN
  bool checks_end = true;       ///< a last line without an end may be cut
};

/// What the first rows of a table say of a column.
struct ColumnFacts {
  bool is_numeric = true;     ///< every cell is a number
  bool is_integer = true;     ///< every cell is an integer, written as one
  bool is_distinct = true;    ///< every cell is a whole number, however written, and no two are one
  bool is_increasing = true;  ///< strictly
  bool counts_rows = true;    ///< each number is the one before plus one
};

/// What the first lines of a table say.
struct TableShape {
  /// Of the header, in lower case, without quotes and units; empty: none
  std::vector<std::string> names;
  std::size_t num_columns = 0;
  std::vector<ColumnFacts> columns;  ///< empty where there are no rows
  std::size_t num_rows = 0;          ///< from which `columns` come
};

/// How the lines of a table are to be read.
struct TableLayout {
  char separator = ' ';  ///< ' ': any white space
  char decimal = '.';
  bool has_trailing_separator = false;
  std::size_t first_line = 0;  ///< of the header, or of the first row; 0: neither
  std::size_t first_row = 0;   ///< line of the first row of numbers; 0: none
  TableShape shape;
  std::vector<std::string> notes;
};

/// Decides how a table is to be read by its first lines. Blank lines and comments (`#`, `//`, `%`)
/// are no rows; lines before the first row without any number may be headers: `find_header`.
/// Rows are separated by `;` if they hold one, else by `,` unless this leaves cells that are no
/// numbers and taking it for the decimal mark between blanks does not, else by white space.
/// @throws IoError where nothing fits or two readings do.
TableLayout find_layout(const std::filesystem::path& path, std::string_view text,
                        const TableRules& rules);

/// The cells of a row, without a comment at its end.
std::vector<std::string_view> split_row(std::string_view line, const TableLayout& layout);

/// Whether the first of several columns may be a number of the row instead of a coordinate: whole
/// numbers that count the rows, or beside three columns that are none.
bool may_number_rows(const TableShape& shape);

/// What `find_layout` says of a text, of an array without names: column x row.
TableShape shape_of(const Eigen::Ref<const Eigen::MatrixXd>& values);

/// Whether a line is neither blank nor a comment.
bool is_content(std::string_view line);

/// The number of a line that holds one integer and nothing else.
std::optional<Index> lone_integer(std::string_view line);

/// Digits behind the decimal mark.
std::size_t num_decimals(std::string_view cell, char decimal);

/// Whether a cell says that there is no number.
bool is_missing(std::string_view cell);

}  // namespace gmcr::io
