#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
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

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

// Returns an array of real numbers; null for texts, complex numbers, times and what is no array.
Doubles doubles_argument(const py::handle& object);
// Return copies of arrays, so that the caller may change them while Kerf works: numbers of shape (n, 3),
// and integers of shape (m, 3).
std::vector<double> triples_argument(const py::handle& object, const char* name);
std::vector<uint32_t> faces_argument(const py::handle& object);
// Returns exactly kCount numbers of shape (kCount,), or a vector.
template <size_t kCount>
std::array<double, kCount> numbers_argument(const py::handle& object, const std::string& name) {
  const Doubles array = doubles_argument(object);
  if (!array || array.ndim() != 1 || array.size() != kCount)
    throw py::value_error(name + (kCount == 3 ? ": must be three numbers" : ": must be four numbers"));
  std::array<double, kCount> numbers;
  std::copy_n(array.data(), kCount, numbers.begin());
  return numbers;
}
inline std::array<double, 3> vector_argument(const py::handle& object, const std::string& name) {
  return numbers_argument<3>(object, name);
}
// Return a number of an index, or ids or indices of shape (n,), at least 0.
uint64_t index_argument(const py::handle& object, const char* name);
template <typename Index>
std::vector<Index> indices_argument(const py::handle& object, const char* name) {
  if (!py::isinstance<py::iterable>(object) || py::isinstance<py::str>(object))
    throw py::type_error(std::string(name) + ": must be a sequence of ints");
  std::vector<Index> indices;
  for (const py::handle member : object) {
    const uint64_t index = index_argument(member, name);
    if (index > std::numeric_limits<Index>::max())
      throw py::value_error(std::string(name) + ": " + std::to_string(index) + " does not exist");
    indices.push_back(static_cast<Index>(index));
  }
  return indices;
}
inline BodyId body_argument(const py::handle& object) { return index_argument(object, "body"); }
// Returns the label of a piece.
uint32_t piece_argument(const py::handle& object);
// Returns a pair (min, max).
std::array<double, 2> range_argument(const py::handle& object, const std::string& name = "range");

// Returns a kerf.Mesh, or copies another object with the attributes vertices and faces, or vertices and
// triangles.
Mesh mesh_argument(const py::handle& object, const char* name);

// Returns a pose of a beam. `where`: begins the message of an error.
Keyframe key_argument(const py::handle& time, const py::handle& origin, const py::handle& direction,
                      const std::string& where);
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
