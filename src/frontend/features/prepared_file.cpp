#include "frontend/features/prepared_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>

namespace gmcr::frontend {
namespace {

constexpr std::string_view kStart =
    "ply\nformat binary_little_endian 1.0\ncomment gmcr prepared cloud ";
constexpr std::string_view kVersion = "1";
constexpr std::string_view kNumGiven = "comment made_of ";
constexpr std::string_view kChecksum = "comment checksum ";
constexpr std::string_view kEnd = "end_header\n";

[[noreturn]] void refuse(const std::string& reason) {
  throw std::invalid_argument("prepared cloud: " + reason);
}

std::string text_of(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string text_of(const Eigen::Vector3d& point) {
  return text_of(point.x()) + ' ' + text_of(point.y()) + ' ' + text_of(point.z());
}

/// FNV-1a, 64 bits, as 16 digits.
std::string checksum_of(std::string_view head, std::string_view body) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const std::string_view part : {head, body}) {
    for (const char c : part) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  }
  std::string digits(16, '0');
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, hash >>= 4) {
    *digit = "0123456789abcdef"[hash & 15];
  }
  return digits;
}

template <class Number>
void append(std::string& bytes, Number number) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

/// Takes the words of a header and the numbers of a body one after the other.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  std::string_view rest() const { return rest_; }

  /// Whether the next is that text, which is then taken.
  bool takes(std::string_view text) {
    if (!rest_.starts_with(text)) return false;
    rest_.remove_prefix(text.size());
    return true;
  }

  void expect(std::string_view text) {
    if (!takes(text)) refuse("the header does not say what it should: '" + line() + "'");
  }

  /// Up to the next space or end of line, which is taken too.
  std::string_view word() {
    const std::size_t end = std::min(rest_.find_first_of(" \n"), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return word;
  }

  template <class Number>
  Number number() {
    const std::string_view text = word();
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
      std::string reason(text);
      refuse(reason.append(": it is no number"));
    }
    return value;
  }

  Eigen::Vector3d point() {
    Eigen::Vector3d point;
    for (double& value : point) value = number<double>();
    return point;
  }

  template <class Number>
  Number binary() {
    std::array<char, sizeof(Number)> raw;
    std::memcpy(raw.data(), rest_.data(), raw.size());
    rest_.remove_prefix(raw.size());
    if (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<Number>(raw);
  }

 private:
  std::string line() const {
    return std::string(rest_.substr(0, std::min<std::size_t>(rest_.find('\n'), 80)));
  }

  std::string_view rest_;
};

constexpr std::string_view kVertexProperties =
    "property double x\nproperty double y\nproperty double z\n";

std::string surface_properties() {
  std::string lines(kVertexProperties);
  for (const char* axis : {"nx", "ny", "nz"}) {
    lines.append("property double ").append(axis).append("\n");
  }
  for (int bin = 0; bin < kFpfhBins; ++bin) {
    lines += "property float fpfh_" + std::to_string(bin) + '\n';
  }
  return lines;
}

constexpr std::size_t kVertexBytes = 3 * sizeof(double);
constexpr std::size_t kSurfaceBytes = 6 * sizeof(double) + kFpfhBins * sizeof(float);

/// The header, up to the checksum.
std::string head_of(const PreparedFile& file) {
  std::string head(kStart);
  head += std::string(kVersion) + '\n';
  head += "comment voxel_size " + text_of(file.voxel_size) + '\n';
  head +=
      "comment radii " + text_of(file.normal_radius) + ' ' + text_of(file.feature_radius) + '\n';
  head += "comment viewpoint " + text_of(file.viewpoint) + '\n';
  if (file.num_given != file.points.cols()) {
    head += std::string(kNumGiven) + std::to_string(file.num_given) + '\n';
  }
  head += "element vertex " + std::to_string(file.points.cols()) + '\n';
  head += kVertexProperties;
  for (std::size_t k = 0; k < file.surfaces.size(); ++k) {
    const KnownSurface& known = file.surfaces[k];
    const bool is_outward = known.side == NormalOrientation::Outward;
    head += "comment surface " + text_of(known.voxel_size) + ' ' + text_of(known.normal_radius) +
            ' ' + text_of(known.feature_radius) + (is_outward ? " outward " : " toward ") +
            text_of(known.viewpoint) + '\n';
    head += "element surface_" + std::to_string(k) + ' ' + std::to_string(known.voxels.cols()) +
            '\n' + surface_properties();
  }
  return head;
}

std::size_t body_size(const PreparedFile& file) {
  std::size_t size = kVertexBytes * static_cast<std::size_t>(file.points.cols());
  for (const KnownSurface& known : file.surfaces) {
    size += kSurfaceBytes * static_cast<std::size_t>(known.voxels.cols());
  }
  return size;
}

std::string body_of(const PreparedFile& file) {
  std::string body;
  body.reserve(body_size(file));
  for (const double value : file.points.reshaped()) append(body, value);
  for (const KnownSurface& known : file.surfaces) {
    for (Index i = 0; i < known.voxels.cols(); ++i) {
      for (const double value : known.voxels.col(i)) append(body, value);
      for (const double value : known.normals.col(i)) append(body, value);
      for (const float value : known.features.col(i)) append(body, value);
    }
  }
  return body;
}

/// @param most  that the rest of the file could hold.
Index count_of(Reader& reader, std::size_t most) {
  const auto count = reader.number<std::size_t>();
  if (count > most) refuse("it is cut");
  return static_cast<Index>(count);
}

KnownSurface read_surface_head(Reader& reader, std::size_t number) {
  KnownSurface known;
  known.voxel_size = reader.number<double>();
  known.normal_radius = reader.number<double>();
  known.feature_radius = reader.number<double>();
  known.side =
      reader.word() == "outward" ? NormalOrientation::Outward : NormalOrientation::TowardViewpoint;
  known.viewpoint = reader.point();
  for (const double size : {known.voxel_size, known.normal_radius, known.feature_radius}) {
    if (!(size > 0) || !std::isfinite(size)) refuse("a size of its voxels is not positive");
  }
  reader.expect("element surface_" + std::to_string(number) + ' ');
  const Index count = count_of(reader, reader.rest().size() / kSurfaceBytes);
  reader.expect(surface_properties());
  known.voxels.resize(3, count);
  known.normals.resize(3, count);
  known.features.resize(kFpfhBins, count);
  return known;
}

void read_surface(Reader& reader, KnownSurface& known) {
  for (Index i = 0; i < known.voxels.cols(); ++i) {
    for (double& value : known.voxels.col(i)) value = reader.binary<double>();
    for (double& value : known.normals.col(i)) value = reader.binary<double>();
    for (float& value : known.features.col(i)) value = reader.binary<float>();
  }
  if (!known.voxels.allFinite() || !known.normals.allFinite() || !known.features.allFinite()) {
    refuse("a number of its voxels is not finite");
  }
  constexpr float kMost = 1000;  // each third of a feature sums to 200 at most
  if (known.features.size() > 0 && !(known.features.cwiseAbs().maxCoeff() <= kMost)) {
    refuse("a feature of its voxels is none");
  }
}

}  // namespace

std::string write_prepared(const PreparedFile& file) {
  std::string bytes = head_of(file);
  const std::string body = body_of(file);
  bytes += std::string(kChecksum) + checksum_of(bytes, body) + '\n' + std::string(kEnd);
  return bytes + body;
}

bool is_prepared(std::string_view bytes) { return bytes.starts_with(kStart); }

PreparedFile read_prepared(std::string_view bytes) {
  Reader reader(bytes);
  if (!reader.takes(kStart)) refuse("it is none");
  const std::string_view version = reader.word();
  if (version != kVersion) {
    refuse("it is of version " + std::string(version) + ", and this is version " +
           std::string(kVersion) + ": prepare it anew");
  }
  PreparedFile file;
  reader.expect("comment voxel_size ");
  file.voxel_size = reader.number<double>();
  reader.expect("comment radii ");
  file.normal_radius = reader.number<double>();
  file.feature_radius = reader.number<double>();
  reader.expect("comment viewpoint ");
  file.viewpoint = reader.point();
  const bool is_reduced = reader.takes(kNumGiven);
  if (is_reduced) file.num_given = reader.number<Index>();
  reader.expect("element vertex ");
  file.points.resize(3, count_of(reader, reader.rest().size() / kVertexBytes));
  if (!is_reduced) file.num_given = file.points.cols();
  if (file.num_given < file.points.cols()) refuse("it is made of fewer points than it has");
  reader.expect(kVertexProperties);
  while (reader.takes("comment surface ")) {
    file.surfaces.push_back(read_surface_head(reader, file.surfaces.size()));
    if (body_size(file) > reader.rest().size()) refuse("it is cut");  // before more memory is taken
  }
  const std::string_view head = bytes.substr(0, bytes.size() - reader.rest().size());
  reader.expect(kChecksum);
  const std::string_view checksum = reader.word();
  reader.expect(kEnd);
  if (reader.rest().size() != body_size(file)) refuse("it is cut, or more follows");
  if (checksum != checksum_of(head, reader.rest())) refuse("it was changed: the checksum differs");
  for (double& value : file.points.reshaped()) value = reader.binary<double>();
  for (KnownSurface& known : file.surfaces) read_surface(reader, known);
  return file;
}

}  // namespace gmcr::frontend
