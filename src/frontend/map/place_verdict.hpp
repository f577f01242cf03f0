#pragma once

#include "gmcr/frontend.hpp"

namespace gmcr::frontend {

/// Judges a scan in a map: makes the verdict of its surfaces worse, never better, where too little
/// of the scan is covered or another place fits nearly as well.
/// @param runner_up  as in `PlacedScan`.
void judge_place(CloudResult& result, double runner_up);

}  // namespace gmcr::frontend
