#pragma once

#include <nanobind/nanobind.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "conversion/convert.hpp"
#include "gmcr/invalid_option.hpp"
#include "gmcr/io.hpp"

namespace gmcr::python {

/// Content of the file of something prepared.
template <class Kind>
nb::bytes bytes_of(const Kind& prepared) {
  const std::string bytes = [&] {
    const nb::gil_scoped_release no_gil;
    return prepared.to_bytes();
  }();
  return nb::bytes(bytes.data(), bytes.size());
}

/// What `from_bytes` makes of the content of a file.
/// @throws IoError naming the file, whatever is wrong with it.
template <class FromBytes>
auto load_prepared(const std::filesystem::path& path, const FromBytes& from_bytes) {
  const nb::gil_scoped_release no_gil;
  try {
    return from_bytes(read_bytes(path));
  } catch (const InvalidOption&) {
    throw;  // of the caller, not of the file
  } catch (const std::invalid_argument& error) {
    throw IoError(path, 0, error.what());
  }
}

template <class Kind>
void save_prepared(const Kind& prepared, const std::filesystem::path& path) {
  const nb::gil_scoped_release no_gil;
  write_text(path, prepared.to_bytes());
}

}  // namespace gmcr::python
