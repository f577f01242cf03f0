#pragma once

namespace gmcr::cli {

/// Whether a file descriptor is a terminal that obeys codes: it is one, and `$TERM` is not dumb.
bool obeys_codes(int descriptor);

/// Whether to colour what goes there: it obeys codes, and `$NO_COLOR` is not set, or empty.
bool takes_colours(int descriptor);

}  // namespace gmcr::cli
