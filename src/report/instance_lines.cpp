#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "report/lines.hpp"

namespace gmcr {
namespace report {
namespace {

void add_instances(Lines& lines, const std::vector<Result>& instances) {
  const auto is_found = [](const Result& result) { return result.status == Status::Ok; };
  const auto count = std::count_if(instances.begin(), instances.end(), is_found);
  lines.add("instances", fmt::format("{} found", count));
  constexpr const char* kRow = "{:>2} {:>8} {:>9}  {:<9}  {:<45}  {}";
  if (count > 0) {
    lines.add_more(
        fmt::format(kRow, "", "inliers", "evidence", "verdict", "rotation", "translation"));
  }
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const Result& instance = instances[i];
    if (!is_found(instance)) continue;
    const Similarity& pose = instance.target_from_source;
    lines.add_more(fmt::format(
        kRow, i + 1, instance.inliers.size(), fmt::format("{:.1f}", instance.evidence),
        to_string(instance.verdict), rotation_text(pose.rotation), vector_text(pose.translation)));
  }
}

}  // namespace
}  // namespace report

std::vector<ReportLine> report_lines(const std::vector<Result>& instances, Detail detail,
                                     const ReportContext& context) {
  if (instances.empty()) throw std::invalid_argument("instances: there is none");
  report::Lines lines;
  report::add_result(lines, instances.front(), detail, context);
  report::add_verdict(lines, instances.front().verdict, instances.front().verdict_reason);
  report::add_instances(lines, instances);
  return std::move(lines).take();
}

}  // namespace gmcr
