#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "options/check.hpp"
#include "options/json.hpp"
#include "options/words.hpp"

namespace gmcr::options {
namespace {

/// All names and aliases of a struct.
/// @param prefix  of the names: aliases are whole.
template <class Struct>
std::vector<std::string> names_of(const std::string& prefix = "") {
  std::vector<std::string> names;
  for_each_option<Struct>([&](const auto& option) {
    names.push_back(prefix + option.about.name);
    if (*option.about.alias) names.emplace_back(option.about.alias);
  });
  return names;
}

TEST(Table, HasNoNameTwiceAmongWhatACommandTakes) {
  std::set<std::string> seen;
  for (const auto& names :
       {names_of<Options>(), names_of<FrontendOptions>(), names_of<InstanceOptions>(),
        names_of<GravityPrior>("gravity."), names_of<InitialPose>("initial_pose.")}) {
    for (const std::string& name : names) EXPECT_TRUE(seen.insert(name).second) << name;
  }
}

template <class Struct>
void expect_texts() {
  const std::set<std::string> units = {"", "metres", "radians", "seconds", "bytes", "voxels"};
  for_each_option<Struct>([&](const auto& option) {
    const std::string help = option.about.help;
    EXPECT_FALSE(help.empty()) << option.about.name;
    EXPECT_NE(help.back(), '.') << help;
    EXPECT_TRUE(units.contains(option.about.unit)) << option.about.unit;
  });
}

TEST(Table, SaysWhatEachOptionIs) {
  expect_texts<Options>();
  expect_texts<FrontendOptions>();
  expect_texts<InstanceOptions>();
  expect_texts<GravityPrior>();
  expect_texts<InitialPose>();
  expect_texts<CliqueOptions>();
  expect_texts<WeightedCliqueOptions>();
  expect_texts<SyntheticOptions>();
}

TEST(Table, HasDefaultsWithinTheirRanges) {
  EXPECT_NO_THROW(check_ranges(Options{}));
  EXPECT_NO_THROW(check_ranges(FrontendOptions{}));
  EXPECT_NO_THROW(check_ranges(InstanceOptions{}));
  EXPECT_NO_THROW(check_ranges(CliqueOptions{}));
  EXPECT_NO_THROW(check_ranges(WeightedCliqueOptions{}));
  EXPECT_NO_THROW(check_ranges(SyntheticOptions{}));
}

template <class Struct>
void expect_refusals() {
  for_each_option<Struct>([](const auto& option) {
    using Value = ValueOf<Struct, decltype(option.place)>;
    if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, int>) {
      if (!option.about.range.holds) return;
      Struct values;
      std::invoke(option.place, values) = Value{-1};
      try {
        check_ranges(values);
        ADD_FAILURE() << option.about.name;
      } catch (const InvalidOption& error) {
        EXPECT_EQ(error.option(), option.about.name);
        EXPECT_EQ(error.problem(), std::string("-1 is not ") + option.about.range.words);
        EXPECT_EQ(error.what(), error.option() + ": " + error.problem());
      }
    }
  });
}

TEST(Table, NamesTheOptionThatIsOutOfRangeAndItsRange) {
  expect_refusals<Options>();
  expect_refusals<FrontendOptions>();
  expect_refusals<InstanceOptions>();
  expect_refusals<CliqueOptions>();
  expect_refusals<WeightedCliqueOptions>();
  expect_refusals<SyntheticOptions>();
}

TEST(Describe, GivesUnitAndRange) {
  EXPECT_EQ(describe({.name = "x", .help = "How far", .unit = "metres", .range = kPositive}),
            "How far (metres, positive and finite)");
  EXPECT_EQ(describe({.name = "x", .help = "How much", .range = kShare}), "How much (in [0, 1])");
  EXPECT_EQ(describe({.name = "x", .help = "Whether"}), "Whether");
}

template <class Enum>
void expect_words_and_back() {
  for (const auto& known : Words<Enum>::words) {
    EXPECT_EQ(word_of(known.value), std::string(known.word));
    EXPECT_EQ(value_of<Enum>(known.word), known.value);
    if (!*known.alias) continue;
    EXPECT_EQ(value_of<Enum>(known.alias, true), known.value);
    EXPECT_EQ(value_of<Enum>(known.alias), std::nullopt) << "an alias is of the command line";
  }
  EXPECT_EQ(value_of<Enum>("", true), std::nullopt);
}

TEST(Words, ArePairedWithTheirValues) {
  expect_words_and_back<Status>();
  expect_words_and_back<Verdict>();
  expect_words_and_back<Method>();
  expect_words_and_back<Evidence>();
  expect_words_and_back<ScaleMode>();
  expect_words_and_back<NoiseMode>();
  expect_words_and_back<NormalOrientation>();
  expect_words_and_back<Refine>();
  expect_words_and_back<SyntheticKind>();
  expect_words_and_back<NoiseShape>();
  EXPECT_EQ(list_words<Method>(), "gmcr|paper");
  for (const auto& known : Words<Status>::words) {
    EXPECT_EQ(to_string(known.value), std::string(known.word));
  }
}

}  // namespace
}  // namespace gmcr::options
