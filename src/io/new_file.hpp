#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace gmcr::io {

/// A file that appears whole or not at all: it has no name while it is written, so that nothing
/// stays of it where the program is killed, and takes its own at the end. Where a file system knows
/// no files without a name, it has one that nobody can guess, in the same folder. What is no
/// regular file (a pipe, a device) is written as it is; a link stays one, what it leads to is
/// replaced; permissions stay.
class NewFile {
 public:
  /// @throws IoError where it cannot be written. The same holds for the others here.
  explicit NewFile(const std::filesystem::path& path);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  void write(std::string_view bytes);

  /// Gives the file its name. Without it, nothing stays.
  void commit();

 private:
  [[noreturn]] void fail() const;
  bool open_nameless();
  void open_aside();
  bool give_name();

  std::filesystem::path path_;    // as the caller named it, for messages
  std::filesystem::path target_;  // where it leads to
  std::filesystem::path aside_;   // name until the end, if it has one
  bool is_nameless_ = false;
  int file_ = -1;
};

}  // namespace gmcr::io
