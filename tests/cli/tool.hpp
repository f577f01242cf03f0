#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "io/temporary_folder.hpp"

namespace gmcr::test {

struct Output {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs the tool with the words of `arguments`, which a shell splits.
inline Output run_tool(const std::string& arguments) {
  const TemporaryFolder folder;
  const char* binary = std::getenv("GMCR_BIN");
  const std::string command = "'" + std::string(binary ? binary : "gmcr") + "' " + arguments +
                              " >'" + (folder / "out").string() + "' 2>'" +
                              (folder / "err").string() + "'";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(folder / "out"),
          content_of(folder / "err")};
}

/// Runs the tool and parses its stdout, which has to be one JSON object and nothing else.
inline nlohmann::json run_json(const std::string& arguments, int exit_code = 0) {
  const Output output = run_tool(arguments + " --json");
  EXPECT_EQ(output.exit_code, exit_code) << arguments << "\n" << output.err;
  const auto json = nlohmann::json::parse(output.out, nullptr, false);
  EXPECT_TRUE(json.is_object()) << arguments << "\n" << output.out;
  return json.is_object() ? json : nlohmann::json::object();
}

/// Expects that the tool fails with one line on stderr that holds `words`, and nothing on stdout.
inline void expect_failure(const std::string& arguments, int exit_code, const std::string& words) {
  const Output output = run_tool(arguments);
  EXPECT_EQ(output.exit_code, exit_code) << arguments << "\n" << output.err;
  EXPECT_EQ(output.out, "") << arguments;
  EXPECT_EQ(std::count(output.err.begin(), output.err.end(), '\n'), 1) << output.err;
  EXPECT_NE(output.err.find(words), std::string::npos) << arguments << "\n" << output.err;
}

}  // namespace gmcr::test
