#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "gmcr/frontend.hpp"
#include "gmcr/options.hpp"
#include "gmcr/result.hpp"
#include "gmcr/synthetic.hpp"

namespace gmcr::options {

/// An enumerator in words: the same in Python, in JSON and on the command line, which also takes
/// the alias.
template <class Enum>
struct Word {
  Enum value;
  const char* word;
  const char* alias = "";
};

/// Name of an enumeration and the words for all of its values.
template <class Enum>
struct Words;

template <>
struct Words<Status> {
  static constexpr const char* name = "Status";
  static constexpr Word<Status> words[] = {
      {Status::Ok, "ok"},
      {Status::TooFewCorrespondences, "too_few_correspondences"},
      {Status::NoConsensus, "no_consensus"},
      {Status::Degenerate, "degenerate"}};
};

template <>
struct Words<Verdict> {
  static constexpr const char* name = "Verdict";
  static constexpr Word<Verdict> words[] = {{Verdict::Trusted, "trusted"},
                                            {Verdict::Doubtful, "doubtful"},
                                            {Verdict::Untrusted, "untrusted"}};
};

template <>
struct Words<Method> {
  static constexpr const char* name = "Method";
  static constexpr Word<Method> words[] = {{Method::Gmcr, "gmcr"}, {Method::Paper, "paper"}};
};

template <>
struct Words<Evidence> {
  static constexpr const char* name = "Evidence";
  static constexpr Word<Evidence> words[] = {{Evidence::Distinct, "distinct"},
                                             {Evidence::Count, "count"}};
};

template <>
struct Words<ScaleMode> {
  static constexpr const char* name = "ScaleMode";
  static constexpr Word<ScaleMode> words[] = {{ScaleMode::Known, "known"},
                                              {ScaleMode::Estimated, "estimated"}};
};

template <>
struct Words<NoiseMode> {
  static constexpr const char* name = "NoiseMode";
  static constexpr Word<NoiseMode> words[] = {{NoiseMode::Given, "given"},
                                              {NoiseMode::Estimated, "estimated"}};
};

template <>
struct Words<NormalOrientation> {
  static constexpr const char* name = "NormalOrientation";
  static constexpr Word<NormalOrientation> words[] = {
      {NormalOrientation::Automatic, "automatic", "auto"},
      {NormalOrientation::TowardViewpoint, "toward_viewpoint", "viewpoint"},
      {NormalOrientation::Outward, "outward"}};
};

template <>
struct Words<Refine> {
  static constexpr const char* name = "Refine";
  static constexpr Word<Refine> words[] = {{Refine::Icp, "icp"}, {Refine::None, "none"}};
};

template <>
struct Words<SyntheticKind> {
  static constexpr const char* name = "SyntheticKind";
  static constexpr Word<SyntheticKind> words[] = {{SyntheticKind::Ball, "ball"},
                                                  {SyntheticKind::Random, "random"},
                                                  {SyntheticKind::Structured, "structured"}};
};

template <>
struct Words<NoiseShape> {
  static constexpr const char* name = "NoiseShape";
  static constexpr Word<NoiseShape> words[] = {
      {NoiseShape::Ball, "ball"}, {NoiseShape::Gaussian, "gaussian"}, {NoiseShape::Cube, "cube"}};
};

/// The word for a value; "unknown" where it is no enumerator.
template <class Enum>
const char* word_of(Enum value) {
  for (const auto& known : Words<Enum>::words) {
    if (known.value == value) return known.word;
  }
  return "unknown";
}

/// The value of a word or, where these are admitted, of an alias; nullopt where it is neither.
template <class Enum>
std::optional<Enum> value_of(std::string_view word, bool or_alias = false) {
  for (const auto& known : Words<Enum>::words) {
    if (word == known.word) return known.value;
    if (or_alias && !word.empty() && word == known.alias) return known.value;
  }
  return std::nullopt;
}

/// All words, such as "gmcr|paper".
template <class Enum>
std::string list_words(const char* separator = "|") {
  std::string list;
  for (const auto& known : Words<Enum>::words) {
    list += (list.empty() ? "" : separator) + std::string(known.word);
  }
  return list;
}

}  // namespace gmcr::options
