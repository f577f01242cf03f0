#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "gmcr/report.hpp"
#include "report/results.hpp"

namespace gmcr {
namespace {

using test::make_cloud_result;
using test::make_result;

std::string full(const Result& result, const Options* options = nullptr) {
  ReportContext context;
  context.options = options;
  return to_text(report_lines(result, Detail::Full, context));
}

testing::AssertionResult says(const std::string& text, const std::string& words) {
  if (text.find(words) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "'" << words << "' is not in\n" << text;
}

TEST(Report, SaysAllThatTheToolPrints) {
  const std::string text = full(make_result());
  for (const char* line :
       {"status        pose found\n", "scale         2\n",
        "rotation      90.000 deg about (0.0000, 0.0000, 1.0000)\n",
        "translation   (1, 2, 3) m, length 3.74166 m\n", "inliers       3 of 10 (30.0 %)\n",
        "used          9 of 10 (90.0 %), those that the priors admit\n",
        "              another pose holds 4, but is less likely\n",
        "evidence      3.2, at most 4.5 possible\n", "time          2.00 s with 14 threads\n",
        "              consistency graph      250.00 ms\n",
        "limit         the time budget ended the search\n",
        "verdict       trusted: chance would give this once in 10^9\n"}) {
    EXPECT_TRUE(says(text, line));
  }
}

TEST(Report, BriefIsAPartOfFull) {
  for (const Result& result : {make_result(), Result{}}) {
    const std::vector<ReportLine> all = report_lines(result, Detail::Full);
    const std::vector<ReportLine> some = report_lines(result, Detail::Brief);
    EXPECT_LE(some.size(), all.size());
    auto place = all.begin();
    for (const ReportLine& line : some) {
      place = std::find_if(place, all.end(), [&](const ReportLine& other) {
        return other.label == line.label && other.text == line.text && other.tone == line.tone;
      });
      ASSERT_NE(place, all.end()) << line.label << " " << line.text;
    }
  }
}

TEST(Report, SpeaksOfAnUnfinishedProofOnlyWhereItWasAskedFor) {
  Result result = make_result();
  result.diagnostics.limits_hit = {{Limit::EvidenceSearch, "a search ended before its proof"}};
  Options options;
  for (const Options* given : {static_cast<const Options*>(nullptr), &std::as_const(options)}) {
    EXPECT_EQ(full(result, given).find("proof"), std::string::npos);
  }
  options.certify = true;
  EXPECT_TRUE(says(full(result, &options), "proof         not finished: a longer time limit"));
  result.diagnostics.limits_hit = {{Limit::Time, "the time budget ended the search"}};
  EXPECT_EQ(full(result, &options).find("proof "), std::string::npos);
}

TEST(Report, ClaimsNothingOfPosesThatPriorsMayExclude) {
  EXPECT_TRUE(says(full(make_result()), "no admitted pose can have more than 5"));
  Options options;
  EXPECT_TRUE(says(full(make_result(), &options), "  no pose can have more than 5"));
  options.max_translation = 4;
  EXPECT_TRUE(
      says(full(make_result(), &options), "no pose that the priors admit can have more than 5"));
  EXPECT_TRUE(says(full(make_result()), ", at scales from 0.5 to 4"));
}

TEST(Report, SaysAProofWhereThereIsOne) {
  Result result = make_result();
  result.certificate = {3, 3, true, {2.5, 2.5, true}, {}, {}};
  const std::vector<ReportLine> lines = report_lines(result, Detail::Full);
  const auto line = std::find_if(lines.begin(), lines.end(), [](const ReportLine& candidate) {
    return candidate.label == "certificate";
  });
  ASSERT_NE(line, lines.end());
  EXPECT_TRUE(says(line->text, "can have more than 3 inliers: proven optimal"));
  EXPECT_EQ(line->tone, Tone::Good);
}

TEST(Report, CallsPosesOfMoreThanFourFifthsOfTheEvidenceAmbiguous) {
  Result result = make_result();
  result.alternatives.front().evidence = 2;  // of 2.5
  EXPECT_EQ(full(result).find("ambiguous"), std::string::npos);
  result.alternatives.front().evidence = 2.01;
  EXPECT_TRUE(says(full(result), "ambiguous     another pose has 80 % of the evidence"));
  EXPECT_TRUE(says(to_text(report_lines(result, Detail::Brief)), "ambiguous"));
}

TEST(Report, SaysHowSureAnEstimatedNoiseBoundIs) {
  Result result = make_result();
  const auto text_at = [&](double log10) {
    result.noise_estimate = NoiseEstimate{0.5, 0.25, 0.75, log10};
    return full(result);
  };
  EXPECT_TRUE(says(text_at(0.5), "0.5 m chosen from the matches: chance explains this"));
  EXPECT_TRUE(says(text_at(-1), "chance would give this once in 10\n"));
  EXPECT_TRUE(says(text_at(-12.5), "chance would give this once in 10^12\n"));
  EXPECT_TRUE(says(text_at(-INFINITY), "chance cannot give this"));
  EXPECT_TRUE(says(text_at(-1), "the same pose with bounds from 0.25 to 0.75 m"));
}

TEST(Report, OfDataWithoutAnAnswerGivesNoPose) {
  Result result;
  result.status_reason = "2 correspondences, but 3 are needed";
  const std::string text = full(result);
  EXPECT_TRUE(says(text, "too_few_correspondences: 2 correspondences, but 3 are needed"));
  EXPECT_EQ(text.find("rotation"), std::string::npos);
}

TEST(Report, OfInstancesHasARowForEachThatWasFound) {
  Result none;
  const std::string text = to_text(report_lines({make_result(), none}, Detail::Full));
  EXPECT_TRUE(says(text, "instances     1 found\n"));
  EXPECT_TRUE(says(text, " 1        3       2.5  trusted    90.000 deg about"));
}

TEST(Report, OfCloudsEndsWithTheVerdict) {
  const std::vector<ReportLine> lines = report_lines(make_cloud_result(), Detail::Full);
  EXPECT_EQ(lines.front().text, "200 points, 20 voxels of 0.25 m");
  EXPECT_EQ(lines[2].text, "10, noise bound 0.75 m");
  EXPECT_EQ(lines.back().label, "verdict");
  EXPECT_EQ(lines.back().text, "doubtful: few matches agree");
  EXPECT_EQ(lines.back().tone, Tone::Fair);
}

TEST(Report, HasColoursOnlyWhereAsked) {
  const std::vector<ReportLine> lines = {{"label", "good news", Tone::Good}, {"", "more"}};
  EXPECT_EQ(to_text(lines), "label         good news\n              more\n");
  EXPECT_EQ(to_text(lines, true), "label         \x1b[32mgood news\x1b[0m\n              more\n");
}

TEST(Report, OfANotebookEscapesWhatIsNoHtml) {
  const std::string html = to_html({{"a<b", "x & y", Tone::Bad}});
  EXPECT_TRUE(says(html, ">a&lt;b</th>"));
  EXPECT_TRUE(says(html, ">x &amp; y</td>"));
  EXPECT_TRUE(says(html, "color: #c5221f"));
}

TEST(Report, GivesShortTimesInMilliseconds) {
  EXPECT_EQ(duration(0.00123), "1.23 ms");
  EXPECT_EQ(duration(45.6), "45.60 s");
}

}  // namespace
}  // namespace gmcr
