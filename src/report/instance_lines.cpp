#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "report/lines.hpp"

namespace gmcr {
namespace report {

void add_instances(Lines& lines, const std::vector<InstanceRow>& instances) {
  const auto is_found = [](const InstanceRow& row) { return row.result.status == Status::Ok; };
  const auto count = std::count_if(instances.begin(), instances.end(), is_found);
  lines.add("instances", fmt::format("{} found", count));
  constexpr const char* kRow = "{:>2} {:>8} {:>9}  {:<9}  {:<45}  {}";
  if (count > 0) {
    lines.add_more(
        fmt::format(kRow, "", "inliers", "evidence", "verdict", "rotation", "translation"));
  }
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const Result& instance = instances[i].result;
    if (!is_found(instances[i])) continue;
    const Similarity& pose = instance.target_from_source;
    lines.add_more(fmt::format(kRow, i + 1, instance.inliers.size(),
                               fmt::format("{:.1f}", instance.evidence),
                               to_string(instances[i].verdict), rotation_text(pose.rotation),
                               vector_text(pose.translation)));
  }
}

}  // namespace report

std::vector<ReportLine> report_lines(const std::vector<Result>& instances, Detail detail,
                                     const ReportContext& context) {
  if (instances.empty()) throw std::invalid_argument("instances: there is none");
  report::Lines lines;
  report::add_result(lines, instances.front(), detail, context);
  report::add_verdict(lines, instances.front().verdict, instances.front().verdict_reason);
  std::vector<report::InstanceRow> rows;
  for (const Result& instance : instances) rows.push_back({instance, instance.verdict});
  report::add_instances(lines, rows);
  return std::move(lines).take();
}

std::vector<ReportLine> report_lines(const std::vector<CloudResult>& instances, Detail detail,
                                     const ReportContext& context) {
  if (instances.empty()) throw std::invalid_argument("instances: there is none");
  report::Lines rows_only;
  std::vector<report::InstanceRow> rows;
  for (const CloudResult& instance : instances) {
    rows.push_back({instance.registration, instance.verdict});
  }
  report::add_instances(rows_only, rows);
  std::vector<ReportLine> lines = report_lines(instances.front(), detail, context);
  for (ReportLine& line : std::move(rows_only).take()) lines.push_back(std::move(line));
  return lines;
}

}  // namespace gmcr
