#include "output/report.hpp"

#include <fmt/core.h>
#include <unistd.h>

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

}  // namespace gmcr::cli
