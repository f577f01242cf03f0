#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include "conversion/convert.hpp"
#include "gmcr/report.hpp"

namespace gmcr::python {

/// What is written of a result with the options in hand; they have to outlive it.
inline ReportContext context_of(const Options* options) {
  ReportContext context;
  context.options = options;
  return context;
}

/// A result as JSON and in words: to_json, report, str, and what notebooks show.
template <class T>
void add_report(nb::class_<T>& bound) {
  bound
      .def(
          "to_json",
          [](const T& self, const Options* options, int indent) {
            return to_json(self, context_of(options), indent);
          },
          nb::arg("options") = nb::none(), nb::kw_only(), nb::arg("indent") = -1,
          "One JSON object, as the tool prints it: docs/json.md lists its fields. What the "
          "options\n"
          "decide, such as a noise bound that was given, is there where these are given.")
      .def(
          "report",
          [](const T& self, const Options* options) {
            return to_text(report_lines(self, Detail::Full, context_of(options)));
          },
          nb::arg("options") = nb::none(),
          "The report in words that the tool prints; str() is a brief one.")
      .def("__str__",
           [](const T& self) {
             std::string text = to_text(report_lines(self, Detail::Brief));
             text.pop_back();  // print adds the end of the last line
             return text;
           })
      .def(
          "_repr_html_", [](const T& self) { return to_html(report_lines(self, Detail::Brief)); },
          "What a notebook shows.");
}

}  // namespace gmcr::python
