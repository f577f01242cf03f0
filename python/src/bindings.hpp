#pragma once

#include <nanobind/nanobind.h>

namespace gmcr::python {

/// One function a theme; later ones use the classes of earlier ones.
void bind_similarity(nanobind::module_& module);
void bind_options(nanobind::module_& module);
void bind_results(nanobind::module_& module);
void bind_registration(nanobind::module_& module);
void bind_clouds(nanobind::module_& module);
void bind_cliques(nanobind::module_& module);
void bind_prepared(nanobind::module_& module);
void bind_maps(nanobind::module_& module);
void bind_descriptors(nanobind::module_& module);
void bind_files(nanobind::module_& module);
void bind_synthetic(nanobind::module_& module);

}  // namespace gmcr::python
