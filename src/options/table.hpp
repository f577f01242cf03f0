#pragma once

/// The one table of options, a part for each of those who take them. `validate` and its messages,
/// the flags of the tool and their help, the options in JSON, and the fields and keywords of Python
/// with their docstrings are made from it; defaults are those of the structs.
#include "options/tables/cliques.hpp"
#include "options/tables/clouds.hpp"
#include "options/tables/registration.hpp"
#include "options/tables/synthetic.hpp"
