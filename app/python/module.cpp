// The Python module: the C++ face of the core with arrays of NumPy. The lock of the interpreter is released
// while Kerf works, and Ctrl-C ends a call.
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>

#include "core/kerf.h"

namespace py = pybind11;

namespace {

using kerf::BadInput;
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

// The object that a JSON text describes; the text is made with the lock of the interpreter released.
template <typename Make>
py::object object_of(Make make) {
  std::string text;
  {
    const py::gil_scoped_release unlocked;
    text = make();
  }
  return py::module_::import("json").attr("loads")(text);
}

// A copy of an array of shape (n, 3), so that the caller may change it while Kerf works.
std::vector<double> triples(const py::object& from, const char* name) {
  const auto array = Doubles::ensure(from);
  if (!array) {
    PyErr_Clear();
    throw BadInput(std::string(name) + ": must be an array of numbers of shape (n, 3)");
  }
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw BadInput(std::string(name) + ": must have the shape (n, 3)");
  return {array.data(), array.data() + array.size()};
}

std::vector<uint32_t> corner_indices(const py::object& from) {
  const auto any = py::array::ensure(from);
  if (!any) PyErr_Clear();
  if (!any || (any.dtype().kind() != 'i' && any.dtype().kind() != 'u'))
    throw BadInput("faces: must be an array of whole numbers of shape (m, 3)");
  if (any.ndim() != 2 || any.shape(1) != 3) throw BadInput("faces: must have the shape (m, 3)");
  const auto array = py::array_t<int64_t, py::array::c_style | py::array::forcecast>::ensure(any);
  std::vector<uint32_t> indices(static_cast<size_t>(array.size()));
  for (size_t i = 0; i < indices.size(); ++i) {
    const int64_t v = array.data()[i];
    if (v < 0 || v > int64_t{0xffffffff})
      throw BadInput("faces: number " + std::to_string(i / 3) + " names vertex " + std::to_string(v));
    indices[i] = static_cast<uint32_t>(v);
  }
  return indices;
}

// A read-only array of shape (n, 3) that looks at memory of a mesh and keeps it alive.
template <typename T>
py::array_t<T> look_at(std::span<const T> numbers, const kerf::Mesh& mesh) {
  auto keeper = std::make_unique<kerf::Mesh>(mesh);
  const py::capsule owner(keeper.get(), [](void* m) { delete static_cast<kerf::Mesh*>(m); });
  (void)keeper.release();
  py::array_t<T> array({static_cast<py::ssize_t>(numbers.size() / 3), py::ssize_t{3}}, numbers.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

// The same of shape (n,).
py::array_t<double> look_along(std::span<const double> numbers, const kerf::Mesh& mesh) {
  auto keeper = std::make_unique<kerf::Mesh>(mesh);
  const py::capsule owner(keeper.get(), [](void* m) { delete static_cast<kerf::Mesh*>(m); });
  (void)keeper.release();
  py::array_t<double> array({static_cast<py::ssize_t>(numbers.size())}, numbers.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

template <typename T>
py::array_t<T> copied(const std::vector<T>& numbers) {
  return py::array_t<T>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

// Ends a call at Ctrl-C, and where the caller's function says so.
kerf::Control control_of(const py::object& progress, unsigned threads) {
  kerf::Control control;
  control.threads = threads;
  control.progress = [progress](double share) {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (progress.is_none()) return true;
    const py::object go_on = progress(share);
    return go_on.is_none() || py::cast<bool>(go_on);
  };
  return control;
}

std::array<double, 3> vector_of(const py::object& from, const char* what) {
  const auto array = Doubles::ensure(from);
  if (!array) PyErr_Clear();
  if (!array || array.size() != 3) throw BadInput(std::string(what) + ": must be three numbers");
  return {array.data()[0], array.data()[1], array.data()[2]};
}

double number_of(const py::handle& from, const char* what) {
  try {
    return py::cast<double>(py::float_(py::reinterpret_borrow<py::object>(from)));
  } catch (const py::error_already_set&) {
    throw BadInput(std::string(what) + ": must be a number");
  }
}

kerf::Stroke make_stroke(const py::sequence& keys, const py::object& radius, const py::object& range,
                         const py::object& power) {
  kerf::Stroke stroke;
  for (const py::handle key : keys) {
    if (!py::isinstance<py::sequence>(key) || py::len(key) != 3)
      throw BadInput("keys: each must be (time, origin, direction)");
    const auto parts = py::reinterpret_borrow<py::sequence>(key);
    kerf::Key k{};
    k.time = number_of(parts[0], "keys: a time");
    const auto origin = vector_of(parts[1], "keys: an origin"),
               direction = vector_of(parts[2], "keys: a direction");
    std::copy(origin.begin(), origin.end(), k.origin);
    std::copy(direction.begin(), direction.end(), k.direction);
    stroke.keys.push_back(k);
  }
  if (!radius.is_none()) {
    stroke.radius = number_of(radius, "radius");
    if (!(stroke.radius > 0)) throw BadInput("radius: must be a length in metres greater than zero");
  }
  if (!range.is_none()) {
    if (!py::isinstance<py::sequence>(range) || py::len(range) != 2)
      throw BadInput("range: must be (least, most)");
    const auto ends = py::reinterpret_borrow<py::sequence>(range);
    stroke.range = {number_of(ends[0], "range"), number_of(ends[1], "range")};
  }
  if (!power.is_none()) stroke.power = number_of(power, "power");
  return stroke;
}

template <typename Value>
Value choice(const std::string& given, const char* what,
             std::initializer_list<std::pair<const char*, Value>> offered) {
  std::string names;
  for (const auto& [name, value] : offered) {
    if (given == name) return value;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  throw BadInput(std::string(what) + ": \"" + given + "\" is not offered; there is: " + names);
}

py::dict cut(kerf::World& world, const py::object& strokes, std::optional<double> target_edge,
             std::optional<double> tolerance, std::optional<int> levels, const std::string& rim,
             const std::string& scheme, const std::string& model, const std::optional<std::string>& material,
             const py::object& progress, unsigned threads) {
  std::vector<kerf::Stroke> list;
  if (py::isinstance<kerf::Stroke>(strokes)) {
    list.push_back(py::cast<kerf::Stroke>(strokes));
  } else {
    for (const py::handle stroke : strokes) list.push_back(py::cast<kerf::Stroke>(stroke));
  }
  kerf::CutSettings settings;
  settings.rim = choice<kerf_rim>(rim, "rim", {{"faces", KERF_RIM_FACES}, {"smooth", KERF_RIM_SMOOTH}});
  settings.scheme = choice<kerf_scheme>(
      scheme, "scheme",
      {{"longest-edge", KERF_SCHEME_LONGEST_EDGE}, {"one-to-four", KERF_SCHEME_ONE_TO_FOUR}});
  settings.model = choice<kerf_model>(model, "model",
                                      {{"geometric", KERF_MODEL_GEOMETRIC}, {"thermal", KERF_MODEL_THERMAL}});
  settings.target_edge = target_edge;
  settings.tolerance = tolerance;
  settings.levels = levels;
  settings.material = material.value_or("");
  const kerf::Control control = control_of(progress, threads);
  kerf::CutResult result{};
  {
    const py::gil_scoped_release unlocked;
    result = world.cut(list, settings, control);
  }
  py::dict told;
  told["removed_faces"] = result.removed_faces;
  told["removed_area"] = result.removed_area;
  told["seconds"] = result.seconds;
  return told;
}

// What rays cross, as arrays.
struct HitArrays {
  py::array first, distance, body, face;
};

HitArrays arrays_of(const kerf::Hits& hits) {
  return {copied(hits.first), copied(hits.distances), copied(hits.bodies), copied(hits.faces)};
}

template <typename Ask>
HitArrays ask_rays(const py::object& origins, const py::object& directions, const py::object& range,
                   Ask ask) {
  const std::vector<double> from = triples(origins, "origins"), along = triples(directions, "directions");
  std::array<double, 2> within{0, std::numeric_limits<double>::max()};
  if (!range.is_none()) {
    if (!py::isinstance<py::sequence>(range) || py::len(range) != 2)
      throw BadInput("range: must be (least, most)");
    const auto ends = py::reinterpret_borrow<py::sequence>(range);
    within = {number_of(ends[0], "range"), number_of(ends[1], "range")};
  }
  kerf::Hits hits;
  {
    const py::gil_scoped_release unlocked;
    hits = ask(from, along, within);
  }
  return arrays_of(hits);
}

template <size_t kCount>
py::array_t<double> numbers(const double (&values)[kCount]) {
  return py::array_t<double>(static_cast<py::ssize_t>(kCount), values);
}

void add_mesh(py::module_& m) {
  py::class_<kerf::Mesh>(m, "Mesh", "A triangle mesh, or a piece of one, which never changes.")
      .def(py::init([](const py::object& vertices, const py::object& faces) {
             const std::vector<double> positions = triples(vertices, "vertices");
             const std::vector<uint32_t> corners = corner_indices(faces);
             return kerf::Mesh(positions, corners);
           }),
           py::arg("vertices"), py::arg("faces"),
           "Mesh(vertices, faces): positions of shape (n, 3) in metres, and whole numbers of shape (m, 3), "
           "counter-clockwise seen from outside. Both are copied.")
      .def_property_readonly(
          "vertices", [](const kerf::Mesh& mesh) { return look_at(mesh.vertices(), mesh); },
          "Positions, float64 of shape (n, 3), metres. Read-only.")
      .def_property_readonly(
          "faces", [](const kerf::Mesh& mesh) { return look_at(mesh.faces(), mesh); },
          "Indices of vertices, uint32 of shape (m, 3). Read-only.")
      .def_property_readonly(
          "temperatures", [](const kerf::Mesh& mesh) { return look_along(mesh.temperatures(), mesh); },
          "Of the faces of a piece, float64 of shape (m,), kelvin; empty for any other mesh. Read-only.")
      .def_property_readonly("area", &kerf::Mesh::area, "m^2.")
      .def_property_readonly("name", &kerf::Mesh::name,
                             "Of the piece; empty for a mesh that was read or made.")
      .def_property_readonly(
          "mass", [](const kerf::Mesh& mesh) { return mesh.info().mass; },
          "kg, as a sheet, or as a solid where its body is one and it is closed; 0 for a mesh that is no "
          "piece of a world.")
      .def_property_readonly(
          "centroid", [](const kerf::Mesh& mesh) { return numbers(mesh.info().centroid); },
          "Of the area, or of the volume of a solid, shape (3,), metres.")
      .def_property_readonly(
          "inertia", [](const kerf::Mesh& mesh) { return numbers(mesh.info().inertia); },
          "kg m^2 about the centroid in the axes of the world: xx, yy, zz, xy, xz, yz.")
      .def_property_readonly("boundary_edges",
                             [](const kerf::Mesh& mesh) { return mesh.info().boundary_edges; })
      .def_property_readonly(
          "placement",
          [](const kerf::Mesh& mesh) {
            const kerf_mesh_info info = mesh.info();
            return py::make_tuple(numbers(info.position), numbers(info.orientation));
          },
          "(position, orientation) of the body: metres, and a quaternion w, x, y, z. Vertices are in the "
          "world already.")
      .def("write", &kerf::Mesh::write, py::arg("path"), py::call_guard<py::gil_scoped_release>(),
           "Writes it as .obj, .ply, .stl, .off, .glb or .gltf, whole or not at all.")
      .def("__repr__", [](const kerf::Mesh& mesh) {
        return "<kerf.Mesh of " + std::to_string(mesh.faces().size() / 3) + " faces>";
      });
  m.def(
      "read",
      [](const std::string& path) {
        const kerf::Control control = control_of(py::none(), 0);
        const py::gil_scoped_release unlocked;
        return kerf::Mesh::read(path, control);
      },
      py::arg("path"), "Reads an OBJ, PLY, STL, OFF or glTF file.");
}

void add_stroke(py::module_& m) {
  py::class_<kerf::Stroke>(m, "Stroke", "A stroke of the laser.")
      .def(py::init(&make_stroke), py::arg("keys"), py::arg("radius") = py::none(),
           py::arg("range") = py::none(), py::arg("power") = py::none(),
           "Stroke(keys, radius, range, power): keys are (time in s, origin in m, direction of any length "
           "but 0). "
           "Without them the radius (m) is 1/400 of the diagonal of the world, the range (m along the beam) "
           "reaches ten "
           "diagonals, and the power is 2000 W.");
}

void add_world(py::module_& m) {
  py::class_<HitArrays>(m, "Hits", "Surfaces that rays cross.")
      .def_readonly("first", &HitArrays::first, "all_hits: hits of ray i are first[i] to first[i + 1] - 1.")
      .def_readonly("distance", &HitArrays::distance, "float64, metres; inf where nothing is hit.")
      .def_readonly("body", &HitArrays::body,
                    "uint32, in the order of adding; 2^32 - 1 where nothing is hit.")
      .def_readonly("face", &HitArrays::face, "uint32, the slot of the face in its body.");
  py::class_<kerf::World>(m, "World", "Meshes that a laser cuts.")
      .def(py::init<>())
      .def_static(
          "open",
          [](const std::string& path) {
            const kerf::Control control = control_of(py::none(), 0);
            const py::gil_scoped_release unlocked;
            return std::make_unique<kerf::World>(path, control);
          },
          py::arg("path"),
          "Opens a scene (.json), a journal (.kerf), whose commands are replayed, or a mesh.")
      .def(
          "add",
          [](kerf::World& world, const kerf::Mesh& mesh, const std::string& name) {
            const kerf::Control control = control_of(py::none(), 0);
            const py::gil_scoped_release unlocked;
            world.add(mesh, name, control);
          },
          py::arg("mesh"), py::arg("name") = "mesh",
          "Adds a copy of a mesh as a body, a sheet of 1 mm of mild steel.")
      .def("cut", &cut, py::arg("strokes"), py::kw_only(), py::arg("target_edge") = py::none(),
           py::arg("tolerance") = py::none(), py::arg("levels") = py::none(), py::arg("rim") = "faces",
           py::arg("scheme") = "longest-edge", py::arg("model") = "geometric",
           py::arg("material") = py::none(), py::arg("progress") = py::none(), py::arg("threads") = 0u,
           "Cuts all bodies with a Stroke or a list of them, all or nothing. The resolution is one of "
           "target_edge (m), "
           "tolerance (m) and levels. progress(share) may return False to stop. Returns removed_faces, "
           "removed_area "
           "(m^2) and seconds.")
      .def_property_readonly(
          "pieces",
          [](const kerf::World& world) {
            const kerf::Control control = control_of(py::none(), 0);
            const py::gil_scoped_release unlocked;
            return world.pieces(control);
          },
          "The pieces of all bodies as meshes in world coordinates, largest area first.")
      .def(
          "nearest_hits",
          [](const kerf::World& world, const py::object& origins, const py::object& directions,
             const py::object& range) {
            const kerf::Control control = control_of(py::none(), 0);
            return ask_rays(origins, directions, range,
                            [&](const auto& from, const auto& along, const auto& within) {
                              return world.nearest_hits(from, along, within, control);
                            });
          },
          py::arg("origins"), py::arg("directions"), py::kw_only(), py::arg("range") = py::none(),
          "The first surface that each of n rays crosses: arrays of shape (n, 3) in, Hits of n entries out.")
      .def(
          "all_hits",
          [](const kerf::World& world, const py::object& origins, const py::object& directions,
             const py::object& range) {
            const kerf::Control control = control_of(py::none(), 0);
            return ask_rays(origins, directions, range,
                            [&](const auto& from, const auto& along, const auto& within) {
                              return world.all_hits(from, along, within, control);
                            });
          },
          py::arg("origins"), py::arg("directions"), py::kw_only(), py::arg("range") = py::none(),
          "All surfaces that each ray crosses, nearest first.")
      .def("save_scene", &kerf::World::save_scene, py::arg("folder"),
           py::call_guard<py::gil_scoped_release>(),
           "Writes the bodies as they are, as OBJ files and a scene.json that the editor opens.")
      .def("save_journal", &kerf::World::save_journal, py::arg("path"),
           py::call_guard<py::gil_scoped_release>(),
           "Writes the journal (.kerf) of the cuts, and beside it the meshes that were added.")
      .def(
          "report", [](const kerf::World& world) { return object_of([&] { return world.report(); }); },
          "The report of all cuts so far, with the keys of the report.json of `kerf cut`.")
      .def(
          "graph", [](const kerf::World& world) { return object_of([&] { return world.graph(); }); },
          "The component graph of the faces, as `kerf inspect --graph` writes it.")
      .def_property_readonly(
          "hash", [](const kerf::World& world) { return world.hash(); },
          "Sixteen hexadecimal digits; those of `kerf cut` for the same meshes and strokes.");
}

}  // namespace

PYBIND11_MODULE(_kerf, m) {
  m.doc() = "Kerf: a laser drills through any triangle mesh.";
  m.attr("__version__") = kerf_version();
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const kerf::BadInput& fault) {
      PyErr_SetString(PyExc_ValueError, fault.what());
    } catch (const kerf::Failure& fault) {
      PyErr_SetString(PyExc_RuntimeError, fault.what());
    }
  });
  add_mesh(m);
  add_stroke(m);
  add_world(m);
}
