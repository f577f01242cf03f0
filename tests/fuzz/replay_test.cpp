// Every input that fuzzing kept, through its target: those that reach new code, and those that once
// broke something.
#include <gtest/gtest.h>

#include <cstdlib>

#include "fuzz/corpus.hpp"
#include "fuzz/target.hpp"

namespace gmcr::fuzz {
namespace {

class Corpus : public ::testing::TestWithParam<Target> {};

TEST_P(Corpus, FindsNothing) {
  const Target& target = GetParam();
  const std::string folder = std::string(std::getenv("GMCR_SOURCE_DIR")) + "/tests/fuzz/corpus/";
  std::vector<std::string> inputs = read_corpus(folder + std::string(target.name) + ".txt");
  EXPECT_GE(inputs.size(), 3U);
  inputs.emplace_back();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    EXPECT_NO_THROW(target.run(inputs[i])) << target.name << ", input " << i << ": " << inputs[i];
  }
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus, ::testing::ValuesIn(targets()),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace gmcr::fuzz
