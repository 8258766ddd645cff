#include "app/python/arguments.h"

#include <algorithm>
#include <chrono>
#include <climits>
#include <string_view>

namespace kerf::python {

namespace {

std::string type_of(const py::handle& object) { return Py_TYPE(object.ptr())->tp_name; }

// Throws the pending error of the interpreter, if any.
void throw_if_raised() {
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
}

// Returns a sequence of exactly `members` members, or an empty object.
py::sequence sequence_of(const py::handle& object, size_t members) {
  const bool is_one = py::isinstance<py::sequence>(object) && !py::isinstance<py::str>(object);
  if (!is_one || py::len(object) != members) return py::reinterpret_steal<py::sequence>(py::handle());
  return py::reinterpret_borrow<py::sequence>(object);
}

}  // namespace

std::string path_argument(const py::handle& object) {
  PyObject* bytes = nullptr;
  if (PyUnicode_FSConverter(object.ptr(), &bytes) == 0) throw py::error_already_set();
  return py::reinterpret_steal<py::bytes>(bytes);
}

std::string text_argument(const py::handle& object, const char* name) {
  if (!py::isinstance<py::str>(object))
    throw py::type_error(std::string(name) + ": must be a str, not " + type_of(object));
  Py_ssize_t size = 0;
  const char* text = PyUnicode_AsUTF8AndSize(object.ptr(), &size);
  throw_if_raised();
  const std::string copy(text, static_cast<size_t>(size));
  if (copy.find('\0') != std::string::npos)
    throw py::value_error(std::string(name) + ": must not contain a null character");
  return copy;
}

double number_argument(const py::handle& object, const std::string& name) {
  const double number = PyFloat_AsDouble(object.ptr());
  if (number != -1 || PyErr_Occurred() == nullptr) return number;
  const bool is_too_large = PyErr_ExceptionMatches(PyExc_OverflowError) != 0;
  PyErr_Clear();
  if (is_too_large) throw py::value_error(name + ": is too large for a float");
  throw py::type_error(name + ": must be a number, not " + type_of(object));
}

int int_argument(const py::handle& object, const char* name) {
  const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(object.ptr()));
  if (!index) {
    PyErr_Clear();
    throw py::type_error(std::string(name) + ": must be an int, not " + type_of(object));
  }
  int overflow = 0;
  const long number = PyLong_AsLongAndOverflow(index.ptr(), &overflow);
  if (overflow != 0) return overflow < 0 ? INT_MIN : INT_MAX;
  return static_cast<int>(std::clamp<long>(number, INT_MIN, INT_MAX));
}

uint64_t index_argument(const py::handle& object, const char* name) {
  const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(object.ptr()));
  if (!index) {
    PyErr_Clear();
    throw py::type_error(std::string(name) + ": must be an int, not " + type_of(object));
  }
  const unsigned long long number = PyLong_AsUnsignedLongLong(index.ptr());
  if (PyErr_Occurred() == nullptr) return number;
  PyErr_Clear();
  throw py::value_error(std::string(name) + ": must not be negative or beyond 64 bits");
}

uint32_t piece_argument(const py::handle& object) {
  const uint64_t label = index_argument(object, "piece");
  if (label < KERF_NO_PIECE) return static_cast<uint32_t>(label);
  throw py::value_error("piece: " + std::to_string(label) + " does not exist");
}

Doubles doubles_argument(const py::handle& object) {
  constexpr std::string_view kRealNumbers = "biufO";  // kinds of NumPy; O: objects with __float__
  Doubles doubles = py::reinterpret_steal<Doubles>(py::handle());
  auto any = py::array::ensure(object);
  // The members decide, because NumPy converts objects that are texts, too.
  if (any && any.dtype().kind() == 'O' && any.size() > 0) any = py::array::ensure(any.attr("tolist")());
  if (any && kRealNumbers.find(any.dtype().kind()) != std::string_view::npos) doubles = Doubles::ensure(any);
  if (!doubles) PyErr_Clear();
  return doubles;
}

std::vector<double> triples_argument(const py::handle& object, const char* name) {
  const Doubles array = doubles_argument(object);
  if (!array) throw py::value_error(std::string(name) + ": must be an array of numbers of shape (n, 3)");
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw py::value_error(std::string(name) + ": must have the shape (n, 3)");
  return {array.data(), array.data() + array.size()};
}

std::vector<uint32_t> faces_argument(const py::handle& object) {
  const auto any = py::array::ensure(object);
  if (!any) PyErr_Clear();
  if (!any || (any.dtype().kind() != 'i' && any.dtype().kind() != 'u'))
    throw py::value_error("faces: must be an integer array of shape (m, 3)");
  if (any.ndim() != 2 || any.shape(1) != 3) throw py::value_error("faces: must have the shape (m, 3)");
  const auto array = py::array_t<int64_t, py::array::c_style | py::array::forcecast>::ensure(any);
  std::vector<uint32_t> indices(static_cast<size_t>(array.size()));
  for (size_t i = 0; i < indices.size(); ++i) {
    const int64_t v = array.data()[i];
    if (v < 0 || v > int64_t{0xffffffff})
      throw py::value_error("faces[" + std::to_string(i / 3) + "]" + " references vertex " +
                            std::to_string(v));
    indices[i] = static_cast<uint32_t>(v);
  }
  return indices;
}

Mesh mesh_argument(const py::handle& object, const char* name) {
  if (py::isinstance<Mesh>(object)) return object.cast<const Mesh&>();
  const auto attribute = [&](const char* key) { return py::getattr(object, key, py::none()); };
  const py::object vertices = attribute("vertices");
  const py::object faces = py::hasattr(object, "faces") ? attribute("faces") : attribute("triangles");
  if (vertices.is_none() || faces.is_none())
    throw py::type_error(std::string(name) +
                         ": must be a kerf.Mesh or an object with vertices and faces (or triangles), not " +
                         type_of(object));
  const std::vector<double> positions = triples_argument(vertices, "vertices");
  return Mesh(positions, faces_argument(faces));
}

std::array<double, 2> range_argument(const py::handle& object, const std::string& name) {
  const py::sequence ends = sequence_of(object, 2);
  if (!ends) throw py::value_error(name + ": must be (min, max)");
  return {number_argument(ends[0], name), number_argument(ends[1], name)};
}

Keyframe key_argument(const py::handle& time, const py::handle& origin, const py::handle& direction,
                      const std::string& where) {
  Keyframe key{};
  key.time = PyFloat_AsDouble(time.ptr());
  if (PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    throw py::value_error(where + ": the time must be a number");
  }
  const auto from = vector_argument(origin, where + ": the origin");
  const auto along = vector_argument(direction, where + ": the direction");
  std::copy(from.begin(), from.end(), key.origin);
  std::copy(along.begin(), along.end(), key.direction);
  return key;
}

std::vector<Keyframe> keys_argument(const py::handle& object) {
  if (!py::isinstance<py::iterable>(object))
    throw py::type_error("keys: must be a sequence of (time, origin, direction), not " + type_of(object));
  std::vector<Keyframe> keys;
  for (const py::handle member : object) {
    const std::string where = "keys: number " + std::to_string(keys.size());
    const py::sequence parts = sequence_of(member, 3);
    if (!parts) throw py::value_error(where + " must be (time, origin, direction)");
    keys.push_back(key_argument(parts[0], parts[1], parts[2], where));
  }
  return keys;
}

std::vector<Stroke> strokes_argument(const py::handle& object) {
  if (py::isinstance<Stroke>(object)) return {object.cast<const Stroke&>()};
  if (!py::isinstance<py::iterable>(object))
    throw py::type_error("strokes: must be a kerf.Stroke or a sequence of them, not " + type_of(object));
  std::vector<Stroke> strokes;
  for (const py::handle stroke : object) {
    const std::string name = "strokes[" + std::to_string(strokes.size()) + "]";
    strokes.push_back(instance_argument<Stroke>(stroke, name.c_str(), "kerf.Stroke"));
  }
  return strokes;
}

CallOptions options_argument(const py::object& progress, unsigned threads) {
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kInterval{20};
  if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0)
    throw py::type_error("progress: must be callable, not " + type_of(progress));
  CallOptions options;
  options.threads = threads;
  options.progress = [progress, next = Clock::time_point::min()](double fraction) mutable {
    if (Clock::now() < next) return true;
    const py::gil_scoped_acquire lock;
    next = Clock::now() + kInterval;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (progress.is_none()) return true;
    const py::object result = progress(fraction);
    if (result.is_none()) return true;
    const int is_continued = PyObject_IsTrue(result.ptr());
    if (is_continued < 0) throw py::error_already_set();
    return is_continued != 0;
  };
  return options;
}

}  // namespace kerf::python
