#include "gmcr/registration.hpp"

#include "bindings.hpp"
#include "conversion/interruptible.hpp"

namespace gmcr::python {
namespace {

/// (N, N) bool.
nb::object dense(const BitsetGraph& graph) {
  const auto is_edge = [&](Index u, Index v) { return u != v && graph.has_edge(u, v); };
  const Index n = graph.num_vertices();
  using Rows = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  auto* rows = new Rows(Rows::NullaryExpr(n, n, is_edge));
  const nb::capsule owner(rows, [](void* memory) noexcept { delete static_cast<Rows*>(memory); });
  const auto size = static_cast<std::size_t>(n);
  return nb::cast(nb::ndarray<nb::numpy, bool>(rows->data(), {size, size}, owner));
}

nb::object graph_of(const PointsArray& source, const PointsArray& target, const Options& options) {
  return dense(interruptible(options, [&](const Options& watched) {
    return consistency_graph(points_of(source), points_of(target), watched);
  }));
}

}  // namespace

void bind_registration(nb::module_& module) {
  module.def("register_correspondences",
             [](const PointsArray& source, const PointsArray& target, const Options& options) {
               return interruptible(options, [&](const Options& watched) {
                 return register_correspondences(points_of(source), points_of(target), watched);
               });
             });
  module.def(
      "register_instances",
      [](const PointsArray& source, const PointsArray& target, const Options& options,
         const InstanceOptions& instances) {
        const auto results = interruptible(options, [&](const Options& watched) {
          return register_instances(points_of(source), points_of(target), watched, instances);
        });
        return Convert<std::vector<Result>>::to_python(results, {});
      },
      nb::sig("def register_instances(source: numpy.typing.NDArray[numpy.float64], target: "
              "numpy.typing.NDArray[numpy.float64], options: Options, instances: InstanceOptions) "
              "-> list[Result]"));
  module.def("evaluate_consensus", [](const Similarity& pose, const PointsArray& source,
                                      const PointsArray& target, const Options& options) {
    return evaluate_consensus(pose, points_of(source), points_of(target), options);
  });
  module.def(
      "evaluate_uncertainty",
      [](const Similarity& pose, const PointsArray& source, const PointsArray& target,
         nb::handle inliers, const Options& options) {
        return evaluate_uncertainty(pose, points_of(source), points_of(target),
                                    Convert<std::vector<Index>>::from_python(inliers, "inliers"),
                                    options);
      },
      nb::sig("def evaluate_uncertainty(target_from_source: Similarity, source: "
              "numpy.typing.NDArray[numpy.float64], target: numpy.typing.NDArray[numpy.float64], "
              "inliers: numpy.typing.ArrayLike, options: Options) -> Uncertainty"));
  module.def("consistency_graph", &graph_of,
             nb::sig("def consistency_graph(source: numpy.typing.NDArray[numpy.float64], target: "
                     "numpy.typing.NDArray[numpy.float64], options: Options) -> "
                     "numpy.typing.NDArray[numpy.bool_]"));
}

}  // namespace gmcr::python
