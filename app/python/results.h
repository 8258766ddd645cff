#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/kerf.h"

// Converts values of the library to objects of Python, and runs calls without the lock of the interpreter.
namespace kerf::python {

namespace py = pybind11;

// Thrown for a path without a file.
struct MissingFile {
  std::string path;
};

// Runs work with the GIL released.
template <typename Work>
auto unlocked(Work work) {
  const py::gil_scoped_release released;
  return work();
}

// Likewise for work on a file. Throws MissingFile if the work fails because `needed`, the file or the folder
// to write in, does not exist.
template <typename Work>
auto on_file(const std::string& path, const std::filesystem::path& needed, Work work) {
  const py::gil_scoped_release released;
  try {
    return work();
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {
    std::error_code error;
    if (std::filesystem::status(needed, error).type() != std::filesystem::file_type::not_found) throw;
    throw MissingFile{path};
  }
}

// Returns a text whose bytes that are no UTF-8 are replaced: names of files and parts may have some.
inline py::str text(std::string_view bytes) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<py::ssize_t>(bytes.size()), "replace"));
}
inline py::list texts(const std::vector<std::string>& all) {
  py::list list;
  for (const std::string& bytes : all) list.append(text(bytes));
  return list;
}

// Returns a count for a repr: "1 face", "2 faces".
inline std::string counted(size_t count, const char* one, const char* several) {
  return std::to_string(count) + " " + (count == 1 ? one : several);
}

// Returns the folder that contains a file.
inline std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : ".";
}

// Returns a copy of shape (n,).
template <typename T>
py::array_t<T> array_copy(std::span<const T> numbers) {
  return py::array_t<T>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}
template <typename T>
py::array_t<T> array_copy(const std::vector<T>& numbers) {
  return array_copy(std::span<const T>(numbers));
}

// Returns a copy of shape (n, 3).
inline py::array_t<double> vectors_copy(const std::vector<double>& numbers) {
  return py::array_t<double>({static_cast<py::ssize_t>(numbers.size() / 3), py::ssize_t{3}}, numbers.data());
}

template <size_t kCount>
py::array_t<double> numbers(const double (&values)[kCount]) {
  return py::array_t<double>(static_cast<py::ssize_t>(kCount), values);
}

using WorldClass = py::class_<World>;

// Add the classes and functions of each file.
WorldClass add_world(py::module_& m);
void add_queries(py::module_& m, WorldClass& world);
void add_bodies(py::module_& m, WorldClass& world);
void add_changes(py::module_& m, WorldClass& world);

}  // namespace kerf::python
