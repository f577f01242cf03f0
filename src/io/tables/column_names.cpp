#include "io/tables/column_names.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "io/tables/text.hpp"

namespace gmcr::io {
namespace {

enum class Axis { X, Y, Z, East, North, Up, UpLetter };

/// Coordinates that make a point, in the order in which they are sought.
constexpr std::array<std::array<Axis, 3>, 6> kFrames = {{
    {Axis::X, Axis::Y, Axis::Z},
    {Axis::X, Axis::Y, Axis::Up},
    {Axis::X, Axis::Y, Axis::UpLetter},
    {Axis::East, Axis::North, Axis::Z},
    {Axis::East, Axis::North, Axis::Up},
    {Axis::East, Axis::North, Axis::UpLetter},
}};

constexpr std::pair<std::string_view, Axis> kLetters[] = {
    {"x", Axis::X}, {"y", Axis::Y}, {"z", Axis::Z}};

constexpr std::pair<std::string_view, Axis> kNumbers[] = {
    {"0", Axis::X}, {"1", Axis::Y}, {"2", Axis::Z}};

// the umlaut as UTF-8 and as Latin-1, which have no lower case here
constexpr std::pair<std::string_view, Axis> kCompass[] = {
    {"e", Axis::East},          {"east", Axis::East},      {"easting", Axis::East},
    {"rechtswert", Axis::East}, {"n", Axis::North},        {"north", Axis::North},
    {"northing", Axis::North},  {"hochwert", Axis::North}, {"h", Axis::UpLetter},
    {"u", Axis::UpLetter},      {"up", Axis::Up},          {"height", Axis::Up},
    {"elevation", Axis::Up},    {"elev", Axis::Up},        {"altitude", Axis::Up},
    {"alt", Axis::Up},          {"hoehe", Axis::Up},       {"h\xC3\xB6he", Axis::Up},
    {"h\xC3\x96he", Axis::Up},  {"h\xF6he", Axis::Up},     {"h\xD6he", Axis::Up},
};

/// Words that say nothing of whose point it is.
constexpr std::string_view kPlainWords[] = {
    "point", "points", "pos",        "position",    "pose",  "location", "field", "xyz",
    "coord", "coords", "coordinate", "coordinates", "utm",   "m",        "mm",    "cm",
    "km",    "ft",     "meter",      "meters",      "metre", "metres"};

constexpr std::string_view kSources[] = {"source", "src", "s", "from", "moving", "mov", "a", "p"};
constexpr std::string_view kTargets[] = {"target",    "tgt",         "t",     "to",  "dst",
                                         "dest",      "destination", "fixed", "fix", "ref",
                                         "reference", "b",           "q"};

using Words = std::vector<std::string>;

template <class Words>
bool holds(const Words& words, std::string_view word) {
  return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

template <class Known>
std::optional<Axis> axis_of(const Known& known, std::string_view word) {
  for (const auto& [name, axis] : known) {
    if (name == word) return axis;
  }
  return std::nullopt;
}

enum class Kind { Mark, Digit, Letter };

Kind kind_of(char c) {
  if (c >= '0' && c <= '9') return Kind::Digit;
  // the dash of x' tells it from x; what is not ASCII belongs to a word
  const bool is_letter = (c >= 'a' && c <= 'z') || c == '\'' || static_cast<unsigned char>(c) > 127;
  return is_letter ? Kind::Letter : Kind::Mark;
}

Words words_of(std::string_view name) {
  Words words;
  Kind before = Kind::Mark;
  for (const char c : to_lower(name)) {
    const Kind kind = kind_of(c);
    if (kind != Kind::Mark) {
      if (kind != before) words.emplace_back();
      words.back() += c;
    }
    before = kind;
  }
  return words;
}

struct Coordinate {
  Axis axis;
  std::string owner;
  bool is_plain;  ///< no further words, not even those that say nothing
};

/// Takes the word that is a coordinate from the others.
std::optional<Axis> take_axis(Words& words) {
  const auto take = [&](const auto& known) -> std::optional<Axis> {
    for (auto word = words.begin(); word != words.end(); ++word) {
      const auto axis = axis_of(known, *word);
      if (!axis) continue;
      words.erase(word);
      return axis;
    }
    return std::nullopt;
  };
  if (const auto axis = take(kLetters)) return axis;
  if (const auto axis = take(kCompass)) return axis;
  if (holds(words, "points") || holds(words, "xyz")) return take(kNumbers);
  if (words.size() != 1) return std::nullopt;
  std::string& word = words.front();
  for (const std::size_t at : {std::size_t{0}, word.size() - 1}) {
    const auto axis = axis_of(kLetters, std::string_view(word).substr(at, 1));
    if (!axis) continue;
    word.erase(at, 1);
    return axis;
  }
  return std::nullopt;
}

std::optional<Coordinate> coordinate_of(std::string_view name) {
  Words words = words_of(name);
  const auto axis = take_axis(words);
  if (!axis) return std::nullopt;
  Coordinate coordinate{*axis, "", words.empty()};
  for (const std::string& word : words) {
    if (holds(kPlainWords, word)) continue;
    coordinate.owner += (coordinate.owner.empty() ? "" : " ") + word;
  }
  return coordinate;
}

using Coordinates = std::vector<std::optional<Coordinate>>;

Coordinates coordinates_of(const std::vector<std::string>& names) {
  Coordinates coordinates;
  for (const std::string& name : names) coordinates.push_back(coordinate_of(name));
  return coordinates;
}

/// The columns of the first frame that is complete among those of which `is_meant` holds.
template <class IsMeant>
std::optional<Axes> find_axes(const std::vector<std::string>& names, const Coordinates& coordinates,
                              const IsMeant& is_meant) {
  for (const auto& frame : kFrames) {
    std::array<std::vector<std::size_t>, 3> found;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!coordinates[i] || !is_meant(*coordinates[i])) continue;
      const auto axis = std::find(frame.begin(), frame.end(), coordinates[i]->axis);
      if (axis != frame.end()) found[static_cast<std::size_t>(axis - frame.begin())].push_back(i);
    }
    if (found[0].empty() || found[1].empty() || found[2].empty()) continue;
    for (const auto& columns : found) {
      if (columns.size() == 1) continue;
      throw std::invalid_argument("columns " + io::quoted(names[columns[0]]) + " and " +
                                  io::quoted(names[columns[1]]) + " are the same coordinate");
    }
    return Axes{found[0][0], found[1][0], found[2][0]};
  }
  return std::nullopt;
}

/// In the order of their first columns.
std::vector<std::string> owners_of(const Coordinates& coordinates) {
  std::vector<std::string> owners;
  for (const auto& coordinate : coordinates) {
    if (coordinate && !holds(owners, coordinate->owner)) owners.push_back(coordinate->owner);
  }
  return owners;
}

/// Whether the words of two owners, but for those that both have, say source and target.
bool is_match(std::string_view source, std::string_view target) {
  const auto a = split_words(source);
  const auto b = split_words(target);
  const auto is_pair = [](std::string_view of_a, std::string_view of_b) {
    return (holds(kSources, of_a) && holds(kTargets, of_b)) || (of_a == "0" && of_b == "1") ||
           (of_a == "1" && of_b == "2");
  };
  return std::any_of(a.begin(), a.end(), [&](std::string_view of_a) {
    return !holds(b, of_a) && std::any_of(b.begin(), b.end(), [&](std::string_view of_b) {
      return !holds(a, of_b) && is_pair(of_a, of_b);
    });
  });
}

}  // namespace

std::vector<NamedPoint> find_points(const std::vector<std::string>& names) {
  const Coordinates coordinates = coordinates_of(names);
  std::vector<NamedPoint> points;
  std::string ambiguous;
  for (const std::string& owner : owners_of(coordinates)) {
    if (owner == "q" && (holds(names, "qw") || holds(names, "q_w"))) continue;  // a quaternion
    try {
      const auto axes = find_axes(names, coordinates, [&](const Coordinate& coordinate) {
        return coordinate.owner == owner;
      });
      if (axes) points.push_back({owner, *axes});
    } catch (const std::invalid_argument& error) {
      ambiguous = error.what();
    }
  }
  // columns that say a thing twice matter where the others do not say enough
  if (points.size() < 2 && !ambiguous.empty()) throw std::invalid_argument(ambiguous);
  return points;
}

std::optional<Axes> find_cloud_point(const std::vector<std::string>& names) {
  const Coordinates coordinates = coordinates_of(names);
  const auto is_plain = [](const Coordinate& coordinate) { return coordinate.is_plain; };
  const auto has_no_owner = [](const Coordinate& coordinate) {
    return coordinate.owner.empty() || coordinate.owner == "p";
  };
  if (const auto axes = find_axes(names, coordinates, is_plain)) return axes;
  if (const auto axes = find_axes(names, coordinates, has_no_owner)) return axes;
  const auto points = names.size() == 3 ? find_points(names) : std::vector<NamedPoint>();
  return points.empty() ? std::nullopt : std::optional(points.front().axes);
}

bool name_coordinates(const std::vector<std::string>& names) {
  const Coordinates coordinates = coordinates_of(names);
  const auto owners = owners_of(coordinates);
  return std::any_of(owners.begin(), owners.end(), [&](const std::string& owner) {
    std::set<Axis> axes;
    for (const auto& coordinate : coordinates) {
      if (coordinate && coordinate->owner == owner) axes.insert(coordinate->axis);
    }
    return axes.count(Axis::X) + axes.count(Axis::Y) + axes.count(Axis::Z) > 1 ||
           axes.count(Axis::East) + axes.count(Axis::North) > 1;
  });
}

bool is_coordinate(const std::string& name) { return coordinate_of(name).has_value(); }

std::optional<NamedMatch> find_match(const std::vector<NamedPoint>& points) {
  std::optional<NamedMatch> match;
  for (const NamedPoint& source : points) {
    for (const NamedPoint& target : points) {
      if (!is_match(source.owner, target.owner) || is_match(target.owner, source.owner)) continue;
      if (match) throw std::invalid_argument("several pairs of columns may be source and target");
      match = {source.axes, target.axes};
    }
  }
  if (match || points.size() != 2) return match;
  // the words of one side are enough where the other has none
  const auto is_of = [](const NamedPoint& point, const auto& side) {
    const auto words = split_words(point.owner);
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return holds(side, word); });
  };
  const bool is_swapped = points[1].owner.empty()
                              ? is_of(points[0], kTargets)
                              : points[0].owner.empty() && is_of(points[1], kSources);
  if (is_swapped) return NamedMatch{points[1].axes, points[0].axes};
  return match;
}

}  // namespace gmcr::io
