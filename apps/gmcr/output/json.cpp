#include "output/json.hpp"

#include "gmcr/types.hpp"
#include "output/json_text.hpp"

namespace gmcr::cli {

Json rows_of(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  Json rows = Json::array();
  for (Index i = 0; i < matrix.rows(); ++i) {
    Json row = Json::array();
    for (Index j = 0; j < matrix.cols(); ++j) row.push_back(matrix(i, j));
    rows.push_back(std::move(row));
  }
  return rows;
}

void print(const Json& json) { print_json(json.dump(kJsonIndent)); }

}  // namespace gmcr::cli
