#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "bindings.hpp"
#include "gmcr/isa.hpp"
#include "gmcr/version.hpp"

NB_MODULE(_gmcr, module) {
  using namespace gmcr;
  // objects that live until the interpreter ends, such as a default argument, are no leaks
  nanobind::set_leak_warnings(false);
  module.doc() = "Compiled part of gmcr.";
  module.def(
      "version", [] { return std::string(kVersion); }, "Version of the library.");
  module.def("instruction_set", &active_isa,
             "Name of the instruction set that the vectorised loops use on this machine, such as "
             "'AVX2'. Every one gives the same bits.");
  module.def("instruction_sets", &supported_isas,
             "Instruction sets that the library was built for and this machine has, best first.");
  module.def(
      "hardware_threads", [] { return hardware_threads(); },
      "Threads that num_threads=0 stands for: every core that this process may use.");
  python::bind_similarity(module);
  python::bind_options(module);
  python::bind_results(module);
  python::bind_registration(module);
  python::bind_clouds(module);
  python::bind_prepared(module);
  python::bind_maps(module);
  python::bind_descriptors(module);
  python::bind_cliques(module);
  python::bind_synthetic(module);
  python::bind_files(module);
}
