#include <fmt/format.h>

#include "gmcr/report.hpp"

namespace gmcr {
namespace {

/// Number of the colour of a terminal.
int terminal_colour(Tone tone) { return tone == Tone::Good ? 32 : tone == Tone::Fair ? 33 : 31; }

const char* css_colour(Tone tone) {
  return tone == Tone::Good ? "#188038" : tone == Tone::Fair ? "#b06000" : "#c5221f";
}

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      default:
        safe += letter;
    }
  }
  return safe;
}

}  // namespace

const char* to_string(Tone tone) {
  switch (tone) {
    case Tone::Good:
      return "good";
    case Tone::Fair:
      return "fair";
    case Tone::Bad:
      return "bad";
    default:
      return "";
  }
}

std::string to_text(const std::vector<ReportLine>& lines, bool coloured) {
  std::string text;
  for (const ReportLine& line : lines) {
    text += coloured && line.tone != Tone::Plain
                ? fmt::format("{:<13} \x1b[{}m{}\x1b[0m\n", line.label, terminal_colour(line.tone),
                              line.text)
                : fmt::format("{:<13} {}\n", line.label, line.text);
  }
  return text;
}

std::string to_html(const std::vector<ReportLine>& lines) {
  std::string html = "<table>";
  for (const ReportLine& line : lines) {
    const std::string colour =
        line.tone == Tone::Plain ? "" : fmt::format("; color: {}", css_colour(line.tone));
    html += fmt::format(
        "<tr><th style=\"text-align: left\">{}</th>"
        "<td style=\"text-align: left; white-space: pre{}\">{}</td></tr>",
        escaped(line.label), colour, escaped(line.text));
  }
  return html + "</table>";
}

std::string duration(double seconds) {
  return seconds < 1 ? fmt::format("{:.2f} ms", 1000 * seconds) : fmt::format("{:.2f} s", seconds);
}

}  // namespace gmcr
