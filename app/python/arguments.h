#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/kerf.h"

// Converts arguments of Python functions to values of the library. A wrong type raises TypeError, a wrong
// value ValueError, with a sentence that begins with the name of the argument.
namespace kerf::python {

namespace py = pybind11;

// Returns the bytes of a path given as str, bytes or os.PathLike.
std::string path_argument(const py::handle& object);
// Returns a str without null characters.
std::string text_argument(const py::handle& object, const char* name);
// Returns a real number; rejects a str.
double number_argument(const py::handle& object, const std::string& name);
// Returns an integer, clamped to the range of int; the library checks its range.
int int_argument(const py::handle& object, const char* name);
// Returns nullopt for None, else the value that `read` returns for the arguments.
template <typename Read, typename... Arguments>
auto optional_argument(const py::handle& object, Read read, const Arguments&... arguments)
    -> std::optional<decltype(read(object, arguments...))> {
  if (object.is_none()) return std::nullopt;
  return read(object, arguments...);
}

// Return copies of arrays, so that the caller may change them while Kerf works: numbers of shape (n, 3),
// and integers of shape (m, 3).
std::vector<double> triples_argument(const py::handle& object, const char* name);
std::vector<uint32_t> faces_argument(const py::handle& object);
// Returns a pair (min, max).
std::array<double, 2> range_argument(const py::handle& object);

// Returns a kerf.Mesh, or copies another object with the attributes vertices and faces, or vertices and
// triangles.
Mesh mesh_argument(const py::handle& object, const char* name);

// Returns a sequence of (time, origin, direction).
std::vector<Keyframe> keys_argument(const py::handle& object);
// Returns the strokes of a Stroke, or of an iterable of them.
std::vector<Stroke> strokes_argument(const py::handle& object);
// Returns an instance of a class of this module.
template <typename Class>
const Class& instance_argument(const py::handle& object, const char* name, const char* class_name) {
  if (py::isinstance<Class>(object)) return object.cast<const Class&>();
  throw py::type_error(std::string(name) + ": must be a " + class_name + ", not " +
                       Py_TYPE(object.ptr())->tp_name);
}

// Returns the value that belongs to a name.
template <typename Value>
Value choice_argument(const py::handle& object, const char* name,
                      std::initializer_list<std::pair<const char*, Value>> choices) {
  const std::string text = text_argument(object, name);
  std::string names;
  for (const auto& [known, value] : choices) {
    if (text == known) return value;
    names += (names.empty() ? "" : ", ") + std::string(known);
  }
  throw py::value_error(std::string(name) + ": \"" + text + "\" is unknown; use one of: " + names);
}

// Returns a CallOptions from None or a callable, and a number of threads. At most fifty times a second the
// call acquires the GIL, ends on Ctrl-C, and calls `progress`, which returns False to cancel.
CallOptions options_argument(const py::object& progress, unsigned threads);

}  // namespace kerf::python
