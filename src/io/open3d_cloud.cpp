#include "io/open3d_cloud.hpp"

#include <locale.h>
#include <open3d/geometry/PointCloud.h>
#include <open3d/io/PointCloudIO.h>
#include <open3d/utility/Logging.h>

#include "gmcr/io.hpp"

namespace gmcr::io {
namespace {

/// Open3D parses text by the locale of the thread; this makes it "C" for a while.
class ScopedCLocale {
 public:
  ScopedCLocale() : locale_(newlocale(LC_ALL_MASK, "C", nullptr)), before_(uselocale(locale_)) {}
  ~ScopedCLocale() {
    uselocale(before_);
    if (locale_) freelocale(locale_);
  }
  ScopedCLocale(const ScopedCLocale&) = delete;
  ScopedCLocale& operator=(const ScopedCLocale&) = delete;

 private:
  locale_t locale_;
  locale_t before_;
};

}  // namespace

Points read_with_open3d(const std::filesystem::path& path, Index num_points) {
  const ScopedCLocale c_locale;
  const open3d::utility::VerbosityContextManager quiet(open3d::utility::VerbosityLevel::Error);
  open3d::geometry::PointCloud cloud;
  bool is_read = false;
  try {
    is_read = open3d::io::ReadPointCloud(path.string(), cloud);
  } catch (const std::runtime_error& error) {
    throw IoError(path, 0, error.what());
  }
  if (!is_read || static_cast<Index>(cloud.points_.size()) != num_points) {
    throw IoError(path, 0, "Open3D could not read it");
  }
  static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double));
  return Eigen::Map<const Points>(cloud.points_.front().data(), 3, num_points);
}

}  // namespace gmcr::io
