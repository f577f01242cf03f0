#include <limits>
#include <memory>

#include "c/objects.hpp"
#include "gmcr/points.hpp"
#include "gmcr/registration.hpp"
#include "gmcr/version.hpp"

namespace gmcr::c {
namespace {

std::size_t size_of(gmcr_number type, const std::string& name) {
  if (type == GMCR_FLOAT64) return sizeof(double);
  if (type == GMCR_FLOAT32) return sizeof(float);
  throw std::invalid_argument(name + ".type: is neither GMCR_FLOAT64 nor GMCR_FLOAT32");
}

Points points_of(const gmcr_points& given, const std::string& name) {
  const std::size_t least = 3 * size_of(given.type, name);
  const std::size_t stride = given.stride == 0 ? least : given.stride;
  if (stride < least) {
    throw std::invalid_argument(name + ".stride: " + std::to_string(stride) + " is less than " +
                                std::to_string(least) + " bytes");
  }
  if (given.count > 0 && given.data == nullptr) {
    throw std::invalid_argument(name + ".data: is null");
  }
  if (given.count > static_cast<std::size_t>(std::numeric_limits<Index>::max()) / stride) {
    throw std::invalid_argument(name + ".count: " + std::to_string(given.count) +
                                " points are more than memory can hold");
  }
  return given.type == GMCR_FLOAT64 ? points_from_strided<double>(given.data, given.count, stride)
                                    : points_from_strided<float>(given.data, given.count, stride);
}

/// A result that `work` fills, or the error that it ended with.
template <class Work>
gmcr_result* result_of(const gmcr_options* given, Work&& work) {
  std::unique_ptr<gmcr_result> result;
  try {
    result = std::make_unique<gmcr_result>();
  } catch (...) {
    return nullptr;
  }
  result->error = guarded(result->message, [&] {
    const gmcr_options options = given == nullptr ? gmcr_options{} : *given;
    result->options = options.options;
    result->options.progress = nullptr;
    std::forward<Work>(work)(*result, options);
  });
  return result.release();
}

}  // namespace
}  // namespace gmcr::c

const char* gmcr_version(void) { return gmcr::kVersion; }

gmcr_result* gmcr_register_correspondences(gmcr_points source, gmcr_points target,
                                           const gmcr_options* options) {
  return gmcr::c::result_of(options, [&](gmcr_result& result, const gmcr_options& with) {
    result.result = gmcr::register_correspondences(
        gmcr::c::points_of(source, "source"), gmcr::c::points_of(target, "target"), with.options);
  });
}

gmcr_result* gmcr_register_clouds(gmcr_points source, gmcr_points target,
                                  const gmcr_options* options) {
  return gmcr::c::result_of(options, [&](gmcr_result& result, const gmcr_options& with) {
    result.clouds =
        gmcr::register_clouds(gmcr::c::points_of(source, "source"),
                              gmcr::c::points_of(target, "target"), with.frontend, with.options);
  });
}
