#include "io/new_file.hpp"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>

#include "gmcr/io.hpp"
#include "io/file.hpp"

namespace gmcr {
namespace io {
namespace {

namespace fs = std::filesystem;

constexpr int kTries = 100;  // at names that nobody has

std::string random_name() {
  std::uint64_t number = 0;
  // a short read leaves fewer random bits; O_EXCL keeps the file ours in any case
  while (getrandom(&number, sizeof number, 0) < 0 && errno == EINTR) {
  }
  std::array<char, 16> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number, 16);
  return ".gmcr-" + std::string(digits.data(), end.ptr) + ".part";
}

/// Where a link leads to, also to nothing.
fs::path followed(const fs::path& path) {
  std::error_code ignored;
  const fs::path target = fs::weakly_canonical(path, ignored);
  return ignored || target.empty() ? path : target;
}

fs::path folder_of(const fs::path& path) {
  return path.parent_path().empty() ? fs::path(".") : path.parent_path();
}

/// The file behind a descriptor as a path, which gives names to what has none.
std::string path_of(int file) { return "/proc/self/fd/" + std::to_string(file); }

}  // namespace

NewFile::NewFile(const fs::path& path) : path_(path), target_(path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    file_ = ::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
    if (file_ < 0) fail();
    return;
  }
  // a rename would replace a file that its owner made read-only
  if (fs::exists(status) && ::access(path.c_str(), W_OK) != 0) fail();
  target_ = followed(path);
  if (!open_nameless()) open_aside();
  struct stat old = {};
  if (::stat(target_.c_str(), &old) == 0) (void)::fchmod(file_, old.st_mode & 07777);
}

bool NewFile::open_nameless() {
  file_ = ::open(folder_of(target_).c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
  is_nameless_ = file_ >= 0 && ::access(path_of(file_).c_str(), F_OK) == 0;
  if (file_ >= 0 && !is_nameless_) {  // without /proc it could never have a name
    ::close(file_);
    file_ = -1;
  }
  return is_nameless_;
}

void NewFile::open_aside() {
  for (int i = 0; i < kTries && file_ < 0; ++i) {
    aside_ = folder_of(target_) / random_name();
    file_ = ::open(aside_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file_ < 0 && errno != EEXIST) break;
  }
  if (file_ < 0) fail();
}

NewFile::~NewFile() {
  if (file_ >= 0) ::close(file_);
  if (!aside_.empty()) ::unlink(aside_.c_str());
}

void NewFile::fail() const {
  throw IoError(path_, 0, std::string("cannot be written: ") + std::strerror(errno));
}

void NewFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail();
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

/// Links what has no name under its own or, where that is taken, under another one, which then
/// replaces it.
bool NewFile::give_name() {
  const std::string nameless = path_of(file_);
  const auto link = [&](const fs::path& name) {
    return ::linkat(AT_FDCWD, nameless.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
  };
  if (link(target_)) return true;
  for (int i = 0; i < kTries && errno == EEXIST; ++i) {
    aside_ = folder_of(target_) / random_name();
    if (link(aside_)) return true;
  }
  aside_.clear();
  return false;
}

void NewFile::commit() {
  if (is_nameless_ && !give_name()) fail();
  const bool closed = ::close(file_) == 0;  // which can be what a full disk makes fail
  file_ = -1;
  if (!closed) fail();
  if (!aside_.empty() && ::rename(aside_.c_str(), target_.c_str()) != 0) fail();
  aside_.clear();
}

}  // namespace io

std::string read_bytes(const std::filesystem::path& path) { return io::read_file(path); }

void write_text(const std::filesystem::path& path, std::string_view text) {
  io::write_file(path, text);
}

void check_output(const std::filesystem::path& path) {
  const auto refuse = [&](const std::string& reason) {
    throw IoError(path, 0, "cannot be written: " + reason);
  };
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) refuse("is a directory");
  if (std::filesystem::exists(status)) {
    if (::access(path.c_str(), W_OK) != 0) refuse(std::strerror(errno));
    if (!std::filesystem::is_regular_file(status)) return;
  }
  const auto folder = io::folder_of(io::followed(path));
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    refuse("folder " + folder.string() + ": " + std::strerror(errno));
  }
}

}  // namespace gmcr
