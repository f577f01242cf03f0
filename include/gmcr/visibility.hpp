#pragma once

/// What a shared library of gmcr offers; all else is hidden in it. Stands between `namespace` and
/// its name: for all that the header declares there.
#if defined(__GNUC__)
#define GMCR_PUBLIC [[gnu::visibility("default")]]
#else
#define GMCR_PUBLIC
#endif
