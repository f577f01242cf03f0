#include "output/report.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include "output/json_text.hpp"
#include "output/terminal.hpp"

namespace gmcr::cli {

void Report::line(std::string_view label, std::string_view text, Tone tone) {
  lines_.push_back({std::string(label), std::string(text), tone});
}

void Report::add(const std::vector<ReportLine>& lines) {
  lines_.insert(lines_.end(), lines.begin(), lines.end());
}

void Report::print() const {
  if (output_.quiet) return;
  fmt::print("{}", to_text(lines_, takes_colours(STDOUT_FILENO)));
}

void print_answer(const OutputArguments& output, const std::function<std::string()>& json,
                  const std::function<std::vector<ReportLine>()>& lines,
                  const std::vector<std::string>& written) {
  if (output.json) {
    print_json(json());
    return;
  }
  Report report(output);
  report.add(lines());
  for (const std::string& path : written) report.line("written", path);
  report.print();
}

}  // namespace gmcr::cli
