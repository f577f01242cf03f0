#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "gmcr/frontend.hpp"
#include "gmcr/options.hpp"
#include "gmcr/result.hpp"
#include "gmcr/synthetic.hpp"

namespace gmcr::python {

/// The class in gmcr/_enums.py that an enumeration becomes, and the words for its values.
template <class T>
struct Choices;

template <>
struct Choices<Status> {
  static constexpr const char* kName = "Status";
  static constexpr std::pair<Status, const char*> kWords[] = {
      {Status::Ok, "ok"},
      {Status::TooFewCorrespondences, "too_few_correspondences"},
      {Status::NoConsensus, "no_consensus"},
      {Status::Degenerate, "degenerate"}};
};

template <>
struct Choices<Method> {
  static constexpr const char* kName = "Method";
  static constexpr std::pair<Method, const char*> kWords[] = {{Method::Gmcr, "gmcr"},
                                                              {Method::Paper, "paper"}};
};

template <>
struct Choices<Evidence> {
  static constexpr const char* kName = "Evidence";
  static constexpr std::pair<Evidence, const char*> kWords[] = {{Evidence::Distinct, "distinct"},
                                                                {Evidence::Count, "count"}};
};

template <>
struct Choices<ScaleMode> {
  static constexpr const char* kName = "ScaleMode";
  static constexpr std::pair<ScaleMode, const char*> kWords[] = {
      {ScaleMode::Known, "known"}, {ScaleMode::Estimated, "estimated"}};
};

template <>
struct Choices<NoiseMode> {
  static constexpr const char* kName = "NoiseMode";
  static constexpr std::pair<NoiseMode, const char*> kWords[] = {
      {NoiseMode::Given, "given"}, {NoiseMode::Estimated, "estimated"}};
};

template <>
struct Choices<NormalOrientation> {
  static constexpr const char* kName = "NormalOrientation";
  static constexpr std::pair<NormalOrientation, const char*> kWords[] = {
      {NormalOrientation::Automatic, "automatic"},
      {NormalOrientation::TowardViewpoint, "toward_viewpoint"},
      {NormalOrientation::Outward, "outward"}};
};

template <>
struct Choices<Verdict> {
  static constexpr const char* kName = "Verdict";
  static constexpr std::pair<Verdict, const char*> kWords[] = {{Verdict::Trusted, "trusted"},
                                                               {Verdict::Doubtful, "doubtful"},
                                                               {Verdict::Untrusted, "untrusted"}};
};

template <>
struct Choices<SyntheticKind> {
  static constexpr const char* kName = "SyntheticKind";
  static constexpr std::pair<SyntheticKind, const char*> kWords[] = {
      {SyntheticKind::Ball, "ball"},
      {SyntheticKind::Random, "random"},
      {SyntheticKind::Structured, "structured"}};
};

template <>
struct Choices<NoiseShape> {
  static constexpr const char* kName = "NoiseShape";
  static constexpr std::pair<NoiseShape, const char*> kWords[] = {
      {NoiseShape::Ball, "ball"}, {NoiseShape::Gaussian, "gaussian"}, {NoiseShape::Cube, "cube"}};
};

template <class T>
const char* name_of(T value) {
  for (const auto& [choice, word] : Choices<T>::kWords) {
    if (choice == value) return word;
  }
  throw std::logic_error("a choice without a word");
}

/// @throws std::invalid_argument naming the field, the word and the words there are.
template <class T>
T parse_choice(const std::string& word, const char* field) {
  std::string words;
  for (const auto& [choice, known] : Choices<T>::kWords) {
    if (word == known) return choice;
    words += (words.empty() ? "'" : ", '") + std::string(known) + "'";
  }
  throw std::invalid_argument(std::string(field) + ": '" + word + "' is not one of " + words);
}

}  // namespace gmcr::python
