#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "gmcr/io.hpp"

namespace gmcr::test {

/// Expects that `read()` throws an IoError about `path`, at `line`, whose reason holds `words`.
template <typename Read>
void expect_io_error(Read read, const std::filesystem::path& path, std::size_t line,
                     const std::string& words) {
  try {
    read();
    ADD_FAILURE() << path << ": no IoError, expected '" << words << "'";
  } catch (const IoError& error) {
    EXPECT_EQ(error.path(), path);
    EXPECT_EQ(error.line(), line) << error.what();
    EXPECT_NE(error.reason().find(words), std::string::npos) << error.what();
    const std::string place = line > 0 ? ":" + std::to_string(line) : std::string();
    EXPECT_EQ(std::string(error.what()), path.string() + place + ": " + error.reason());
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "more than one line";
  }
}

}  // namespace gmcr::test
