#include <stdexcept>

#include "gmcr/io.hpp"
#include "io/file.hpp"
#include "io/tables/table.hpp"
#include "io/tables/text.hpp"

namespace gmcr {
namespace {

io::ColumnChoice pose_columns(const io::TableShape& shape) {
  if (!shape.names.empty()) throw std::invalid_argument("no row of numbers");
  if (shape.num_columns != 4) {
    throw std::invalid_argument(std::to_string(shape.num_columns) +
                                " columns, expected a 4 x 4 matrix");
  }
  return {{0, 1, 2, 3}, {}};
}

}  // namespace

Similarity read_transform(const std::filesystem::path& path) {
  const io::Table rows =
      io::parse_table(path, io::read_file(path), pose_columns, {.checks_end = false});
  if (rows.values.cols() != 4) {
    throw IoError(path, 0, std::to_string(rows.values.cols()) + " rows, expected a 4 x 4 matrix");
  }
  try {
    return Similarity::from_matrix(rows.values.transpose());
  } catch (const std::invalid_argument& error) {
    throw IoError(path, 0, error.what());
  }
}

void write_transform(const std::filesystem::path& path, const Similarity& transform) {
  io::write_file(path, io::format_rows(transform.matrix().transpose(), ' ', ""));
}

}  // namespace gmcr
