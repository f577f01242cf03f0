#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/tables/table_layout.hpp"

namespace gmcr::io {

/// Rows by which a table is judged.
constexpr std::size_t kSampledRows = 200;

/// A line of a table, counted from 1.
struct TableLine {
  std::string_view text;  ///< without the mark of a comment
  std::size_t number = 0;
  bool is_comment = false;
  bool is_prose = false;  ///< a comment that need not speak of columns, unlike one of `//`
};

/// The first lines of a table.
struct TableSample {
  std::vector<TableLine> before;  ///< lines without any number before the first row, not blank
  std::vector<TableLine> rows;
};

/// @throws IoError where the text holds bytes of value 0, or 50 lines of words and no row.
TableSample sample_table(const std::filesystem::path& path, std::string_view text,
                         const TableRules& rules);

/// What the lines before the first row of numbers say.
struct TableHeader {
  std::vector<std::string> names;  ///< one a column; empty: none
  TableLine line;                  ///< of the names, or of words that are none; number 0: none
  std::size_t num_names = 0;       ///< that the line holds, more than columns or fewer
  bool names_coordinates = false;
  std::vector<TableLine> rows;  ///< behind it, of cells that hold no number
};

/// The last line that names coordinates in as many cells as there are columns, or in the first of
/// more; else the last that names coordinates, but without the names; else the last of words. A
/// line of units or types directly behind it is no row.
/// @param num_columns  0: as many as the line has cells.
TableHeader find_header(const std::vector<TableLine>& before, char separator,
                        std::size_t num_columns);

/// Cells of a line, without their quotation marks; ' ' stands for any white space. A separator
/// between quotation marks is part of its cell.
std::vector<std::string_view> split_quoted(std::string_view line, char separator);

}  // namespace gmcr::io
