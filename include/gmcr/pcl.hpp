#pragma once

#include <pcl/common/transforms.h>
#include <pcl/registration/registration.h>

#include "gmcr/frontend.hpp"
#include "gmcr/points.hpp"
#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

/// `register_clouds` as a registration of PCL, to take the place of another in a program:
///
///     gmcr::PclRegistration<pcl::PointXYZ, pcl::PointXYZ> registration;
///     registration.setInputSource(source);
///     registration.setInputTarget(target);
///     registration.align(aligned);
///     if (registration.hasConverged()) use(registration.getFinalTransformation());
///
/// No initial guess is needed, and one that is given is not used. It has converged where the pose
/// is not `Verdict::Untrusted`; where there is no pose the transformation is the identity. Points
/// that are not finite are left out, though PCL's own `getFitnessScore` takes none. Limits of
/// iterations and distances of the base class have no say: the options are `frontend` and
/// `options`. Header only: link gmcr::frontend, and PCL as before. Cost: that of `register_clouds`.
template <class PointSource, class PointTarget, class Scalar = float>
class PclRegistration : public pcl::Registration<PointSource, PointTarget, Scalar> {
  using Base = pcl::Registration<PointSource, PointTarget, Scalar>;

 public:
  using Matrix4 = typename Base::Matrix4;                    ///< as in PCL
  using PointCloudSource = typename Base::PointCloudSource;  ///< as in PCL

  FrontendOptions frontend;  ///< used by the next `align`
  Options options;           ///< used by the next `align`

  PclRegistration() { this->reg_name_ = "gmcr"; }

  /// All that is known of the last pose: verdict, covariance, certificate, overlap.
  const CloudResult& result() const { return result_; }

 protected:
  /// Called by `align`.
  /// @throws std::invalid_argument where an option is out of range.
  void computeTransformation(PointCloudSource& output, const Matrix4&) override {
    PointCloudSource source;  // the points that the caller chose by their indices
    pcl::copyPointCloud(*this->input_, *this->indices_, source);
    result_ = register_clouds(finite_points(points_from(source)),
                              finite_points(points_from(*this->target_)), frontend, options);
    this->final_transformation_ =
        result_.registration.target_from_source.matrix().template cast<Scalar>();
    this->transformation_ = this->final_transformation_;
    this->converged_ = result_.verdict != Verdict::Untrusted;
    pcl::transformPointCloud(output, output, this->final_transformation_);
  }

 private:
  CloudResult result_;
};

}  // namespace gmcr
