#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "output/scratch_folder.hpp"

namespace gmcr::cli {

/// What a text on stdin is taken for where its first bytes do not tell.
enum class TextKind { Table, Graph };

/// A file that a command reads: the one at a path, or what comes from stdin where the path is "-".
///
/// What comes from stdin, a pipe or a device can be read but once, so it goes into a file. Readers
/// tell formats by extensions: it has that of the pipe, or the one that its first bytes ask for,
/// .npy, .ply, .pcd, .mtx, .json, or else that of a table or a graph.
class InputFile {
 public:
  /// @throws IoError where stdin or a pipe is empty or cannot be kept.
  explicit InputFile(const std::string& path, TextKind kind = TextKind::Table);

  /// Where it can be read, as long as this object lives.
  const std::filesystem::path& path() const { return path_; }

  /// What to call it: the path as given, or "standard input".
  const std::string& name() const { return name_; }

  /// An error of a reader, with this name for the path of the file.
  IoError named(const IoError& error) const;

  /// What `read` of the path returns.
  /// @throws IoError of it, which calls the file by its name.
  template <class Read>
  auto read(Read&& read) const {
    try {
      return read(path_);
    } catch (const IoError& error) {
      throw named(error);
    }
  }

 private:
  std::optional<ScratchFolder> folder_;
  std::filesystem::path path_;
  std::string name_;
};

}  // namespace gmcr::cli
