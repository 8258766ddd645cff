#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/kerf.h"

// Arguments of Python functions as values of the library. One of the wrong type raises TypeError and one with
// a wrong value ValueError, in a sentence that begins with its name.
namespace kerf::python {

namespace py = pybind11;

// A str, bytes or os.PathLike as the bytes of a path.
std::string path_argument(const py::handle& given);
// A str without a null character.
std::string text_argument(const py::handle& given, const char* name);
// A real number; a str is none.
double number_argument(const py::handle& given, const std::string& name);
// An integer, limited to what an int holds; the library checks its range.
int whole_argument(const py::handle& given, const char* name);
// None, or a value that `read` reads with the further arguments.
template <typename Read, typename... Arguments>
auto optional_argument(const py::handle& given, Read read, const Arguments&... arguments)
    -> std::optional<decltype(read(given, arguments...))> {
  if (given.is_none()) return std::nullopt;
  return read(given, arguments...);
}

// Copies of arrays, so that the caller may change them while Kerf works: of shape (n, 3), and whole numbers
// of shape (m, 3).
std::vector<double> triples_argument(const py::handle& given, const char* name);
std::vector<uint32_t> faces_argument(const py::handle& given);
// (min, max)
std::array<double, 2> range_argument(const py::handle& given);

// A sequence of (time, origin, direction).
std::vector<Key> keys_argument(const py::handle& given);
// A Stroke, or an iterable of them.
std::vector<Stroke> strokes_argument(const py::handle& given);
// An instance of a class of this module.
template <typename Class>
const Class& instance_argument(const py::handle& given, const char* name, const char* class_name) {
  if (py::isinstance<Class>(given)) return given.cast<const Class&>();
  throw py::type_error(std::string(name) + ": must be a " + class_name + ", not " +
                       Py_TYPE(given.ptr())->tp_name);
}

// The value of a name that is one of those offered.
template <typename Value>
Value choice_argument(const py::handle& given, const char* name,
                      std::initializer_list<std::pair<const char*, Value>> offered) {
  const std::string text = text_argument(given, name);
  std::string names;
  for (const auto& [known, value] : offered) {
    if (text == known) return value;
    names += (names.empty() ? "" : ", ") + std::string(known);
  }
  throw py::value_error(std::string(name) + ": \"" + text + "\" is not offered; there is: " + names);
}

// None or a callable, and a number of threads. At most fifty times a second a call takes the lock of the
// interpreter, ends at Ctrl-C, and reports its progress, which may end it.
Control control_argument(const py::object& progress, unsigned threads);

}  // namespace kerf::python
