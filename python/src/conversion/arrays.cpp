#include "conversion/arrays.hpp"

namespace gmcr::python {
namespace {

/// @param kinds  of numpy dtypes that are read without loss of meaning.
nb::object asarray(nb::handle value, const char* name, const char* kinds, const char* dtype) {
  const nb::module_ numpy = nb::module_::import_("numpy");
  const nb::object array = numpy.attr("asarray")(value);
  const nb::object type = array.attr("dtype");
  const auto kind = nb::cast<std::string>(type.attr("kind"));
  const bool is_empty = nb::cast<std::size_t>(array.attr("size")) == 0;
  if (!is_empty && std::string(kinds).find(kind) == std::string::npos) {
    throw std::invalid_argument(std::string(name) + ": expected numbers, but the dtype is " +
                                nb::cast<std::string>(nb::str(type)));
  }
  return numpy.attr("ascontiguousarray")(array, nb::arg("dtype") = dtype);
}

}  // namespace

nb::ndarray<const double, nb::numpy, nb::c_contig> doubles_of(nb::handle value, const char* name) {
  return nb::cast<nb::ndarray<const double, nb::numpy, nb::c_contig>>(
      asarray(value, name, "fiu", "float64"));
}

nb::ndarray<const Index, nb::numpy, nb::c_contig> indices_of(nb::handle value, const char* name) {
  return nb::cast<nb::ndarray<const Index, nb::numpy, nb::c_contig>>(
      asarray(value, name, "iub", "int64"));
}

}  // namespace gmcr::python
