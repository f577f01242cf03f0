#include "gmcr/descriptors.hpp"

#include "bindings.hpp"
#include "conversion/record.hpp"

namespace gmcr::python {
namespace {

/// (N, D), C order: a descriptor a row.
template <class Value>
using DescriptorArray =
    nb::ndarray<const Value, nb::numpy, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

template <class Value>
DescriptorMatches match(const DescriptorArray<Value>& source, const DescriptorArray<Value>& target,
                        const DescriptorMatching& options) {
  using Matrix = Eigen::Matrix<Value, Eigen::Dynamic, Eigen::Dynamic>;
  const auto columns_of = [](const DescriptorArray<Value>& array) {
    return Eigen::Map<const Matrix>(array.data(), static_cast<Index>(array.shape(1)),
                                    static_cast<Index>(array.shape(0)));
  };
  const nb::gil_scoped_release no_gil;
  return match_descriptors(columns_of(source), columns_of(target), options);
}

}  // namespace

void bind_descriptors(nb::module_& module) {
  Record<DescriptorMatches>(module, "DescriptorMatches", "Pairs of descriptors that match.")
      .field("source_indices", &DescriptorMatches::source_indices,
             "(K,) int64, rows of the source, ascending.")
      .field("target_indices", &DescriptorMatches::target_indices,
             "(K,) int64, rows of the target; for each source nearest first.")
      .field("distances", &DescriptorMatches::distances,
             "(K,) float64, Euclidean, or the number of bits that differ.")
      .read_only();
  module.def("match_descriptors",
             [](const DescriptorArray<float>& source, const DescriptorArray<float>& target, int k,
                bool mutual, double ratio, int num_threads) {
               return match(source, target, {k, mutual, ratio, num_threads});
             });
  module.def("match_binary_descriptors", [](const DescriptorArray<std::uint8_t>& source,
                                            const DescriptorArray<std::uint8_t>& target, int k,
                                            bool mutual, double ratio, int num_threads) {
    return match(source, target, {k, mutual, ratio, num_threads});
  });
}

}  // namespace gmcr::python
