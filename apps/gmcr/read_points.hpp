#pragma once

#include <string>
#include <vector>

#include "gmcr/io.hpp"
#include "input_file.hpp"

namespace gmcr::cli {

/// Reads a cloud; what the reader notes, such as points that it dropped, is said on stderr.
Points read_points(const InputFile& file, const CloudOptions& options);

/// Says what a reader noted of a file, on stderr.
void say_notes(const InputFile& file, const std::vector<std::string>& notes);

}  // namespace gmcr::cli
