#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gmcr/io.hpp"
#include "gmcr/localisation.hpp"
#include "gmcr/prepared_cloud.hpp"
#include "input/input_file.hpp"

namespace gmcr::cli {

/// Reads a cloud; what the reader notes, such as points that it dropped, is said on stderr.
Points read_points(const InputFile& file, const CloudOptions& options);

/// Two clouds, of files that may be prepared.
class ReadPair {
 public:
  /// @throws IoError, also where a prepared cloud is of another version or was changed.
  ReadPair(const InputFile& source, const InputFile& target, const CloudOptions& options);

  const Points& source() const { return source_.points(); }
  const Points& target() const { return target_.points(); }

  /// Calls match(source, target) with the clouds: both prepared where one of them is.
  template <class Match>
  auto apply(const FrontendOptions& frontend, const Match& match) const {
    if (!source_.prepared && !target_.prepared) return match(source(), target());
    return match(source_.prepared_beside(target_, frontend.source_viewpoint),
                 target_.prepared_beside(source_, frontend.target_viewpoint));
  }

 private:
  struct Read {
    Points read;  ///< where it is not prepared
    std::optional<PreparedCloud> prepared;

    Read(const InputFile& file, const CloudOptions& options);
    const Points& points() const { return prepared ? prepared->points() : read; }
    PreparedCloud prepared_beside(const Read& other, const Eigen::Vector3d& viewpoint) const {
      return prepared ? *prepared : other.prepared->beside(read, viewpoint);
    }
  };

  Read source_, target_;
};

/// A map, of a file that may be prepared.
/// @throws IoError, also where a prepared one is of another version or was changed; InvalidOption
///   where it has another voxel size than the options ask for.
PreparedMap read_map(const InputFile& file, const CloudOptions& options,
                     const FrontendOptions& frontend, const Eigen::Vector3d& up, int num_threads);

/// Says what a reader noted of a file, on stderr.
void say_notes(const InputFile& file, const std::vector<std::string>& notes);

}  // namespace gmcr::cli
