#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <type_traits>

#include "c/objects.hpp"
#include "gmcr/report.hpp"

namespace gmcr::c {
namespace {

static_assert(std::is_same_v<Index, std::ptrdiff_t>);
static_assert(static_cast<int>(Status::Ok) == GMCR_OK);
static_assert(static_cast<int>(Status::TooFewCorrespondences) == GMCR_TOO_FEW_CORRESPONDENCES);
static_assert(static_cast<int>(Status::NoConsensus) == GMCR_NO_CONSENSUS);
static_assert(static_cast<int>(Status::Degenerate) == GMCR_DEGENERATE);
static_assert(static_cast<int>(Verdict::Trusted) == GMCR_TRUSTED);
static_assert(static_cast<int>(Verdict::Doubtful) == GMCR_DOUBTFUL);
static_assert(static_cast<int>(Verdict::Untrusted) == GMCR_UNTRUSTED);

constexpr const char* kNone = "";

bool is_usable(const gmcr_result* result) {
  return result != nullptr && result->error == GMCR_SUCCESS;
}

template <int kRows>
void write_rows(const Eigen::Matrix<double, kRows, kRows>& matrix, double* rows) {
  Eigen::Map<Eigen::Matrix<double, kRows, kRows, Eigen::RowMajor>>(rows).noalias() = matrix;
}

}  // namespace
}  // namespace gmcr::c

using gmcr::c::is_usable;

void gmcr_result_free(gmcr_result* result) { delete result; }

gmcr_error gmcr_result_error(const gmcr_result* result) {
  return result == nullptr ? GMCR_OUT_OF_MEMORY : result->error;
}

const char* gmcr_result_message(const gmcr_result* result) {
  return result == nullptr ? "out of memory" : result->message.c_str();
}

gmcr_status gmcr_result_status(const gmcr_result* result) {
  if (!is_usable(result)) return GMCR_NO_CONSENSUS;
  return static_cast<gmcr_status>(result->registration().status);
}

const char* gmcr_result_status_reason(const gmcr_result* result) {
  if (!is_usable(result)) return gmcr_result_message(result);
  return result->registration().status_reason.c_str();
}

gmcr_verdict gmcr_result_verdict(const gmcr_result* result) {
  if (!is_usable(result)) return GMCR_UNTRUSTED;
  return static_cast<gmcr_verdict>(result->clouds ? result->clouds->verdict
                                                  : result->result.verdict);
}

const char* gmcr_result_verdict_reason(const gmcr_result* result) {
  if (!is_usable(result)) return gmcr_result_message(result);
  return (result->clouds ? result->clouds->verdict_reason : result->result.verdict_reason).c_str();
}

void gmcr_result_pose(const gmcr_result* result, double matrix[16]) {
  const gmcr::Similarity pose =
      is_usable(result) ? result->registration().target_from_source : gmcr::Similarity{};
  gmcr::c::write_rows<4>(pose.matrix(), matrix);
}

double gmcr_result_scale(const gmcr_result* result) {
  return is_usable(result) ? result->registration().target_from_source.scale : 1;
}

const ptrdiff_t* gmcr_result_inliers(const gmcr_result* result, size_t* count) {
  *count = is_usable(result) ? result->registration().inliers.size() : 0;
  return *count == 0 ? nullptr : result->registration().inliers.data();
}

void gmcr_result_certificate(const gmcr_result* result, ptrdiff_t* lower, ptrdiff_t* upper) {
  const bool usable = is_usable(result);
  *lower = usable ? result->registration().certificate.lower : 0;
  *upper = usable ? result->registration().certificate.upper : 0;
}

int gmcr_result_covariance(const gmcr_result* result, gmcr_pose_graph convention,
                           double matrix[36]) {
  if (!is_usable(result) || !result->registration().covariance) return 0;
  const gmcr::Result& registration = result->registration();
  gmcr::c::write_rows<6>(
      gmcr::pose_graph_covariance(
          *registration.covariance, registration.target_from_source,
          convention == GMCR_ROS ? gmcr::PoseGraph::Ros : gmcr::PoseGraph::Gtsam),
      matrix);
  return 1;
}

double gmcr_result_fitness(const gmcr_result* result) {
  return is_usable(result) && result->clouds ? result->clouds->fitness : 0;
}

char* gmcr_result_to_json(const gmcr_result* result) {
  if (!is_usable(result)) return nullptr;
  char* copy = nullptr;
  std::string message;
  gmcr::c::guarded(message, [&] {
    const gmcr::ReportContext context{&result->options, {}};
    const std::string text = result->clouds ? gmcr::to_json(*result->clouds, context)
                                            : gmcr::to_json(result->result, context);
    copy = static_cast<char*>(std::malloc(text.size() + 1));
    if (copy != nullptr) std::memcpy(copy, text.c_str(), text.size() + 1);
  });
  return copy;
}

void gmcr_string_free(char* string) { std::free(string); }
