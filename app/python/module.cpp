// The Python module: kerf.h with NumPy arrays. Calls release the interpreter lock while Kerf works, and
// Ctrl-C ends them.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "app/python/arguments.h"
#include "core/kerf.h"

namespace py = pybind11;

namespace {

using namespace kerf::python;

// Thrown for a path without a file.
struct MissingFile {
  std::string path;
};

// Runs work on a file with the interpreter lock released. Throws MissingFile if the work fails because
// `needed`, the file or the folder to write in, does not exist.
template <typename Work>
auto on_file(const std::string& path, const std::filesystem::path& needed, Work work) {
  const py::gil_scoped_release unlocked;
  try {
    return work();
  } catch (const kerf::Cancelled&) {
    throw;
  } catch (const kerf::Failure&) {
    std::error_code error;
    if (std::filesystem::status(needed, error).type() != std::filesystem::file_type::not_found) throw;
    throw MissingFile{path};
  }
}

// Returns the folder that contains a file.
std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : ".";
}

// Parses a JSON text, which is made with the interpreter lock released.
template <typename Make>
py::object object_of(Make make) {
  std::string text;
  {
    const py::gil_scoped_release unlocked;
    text = make();
  }
  return py::module_::import("json").attr("loads")(text);
}

// Returns a read-only array of shape (n, 3) that refers to memory of a mesh and keeps it alive.
template <typename T>
py::array_t<T> look_at(std::span<const T> numbers, const kerf::Mesh& mesh) {
  auto keeper = std::make_unique<kerf::Mesh>(mesh);
  const py::capsule owner(keeper.get(), [](void* m) { delete static_cast<kerf::Mesh*>(m); });
  (void)keeper.release();
  py::array_t<T> array({static_cast<py::ssize_t>(numbers.size() / 3), py::ssize_t{3}}, numbers.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

// Returns the same of shape (n,).
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

kerf::Stroke make_stroke(const py::object& keys, const py::object& radius, const py::object& range,
                         const py::object& power) {
  kerf::Stroke stroke;
  stroke.keys = keys_argument(keys);
  const auto positive = [](const py::object& given, const char* name, const char* unit) {
    const double number = number_argument(given, name);
    if (number > 0) return number;
    throw py::value_error(std::string(name) + ": must be a number of " + unit + " greater than zero");
  };
  if (!radius.is_none()) stroke.radius = positive(radius, "radius", "metres");
  if (!range.is_none()) stroke.range = range_argument(range);
  if (!power.is_none()) stroke.power = positive(power, "power", "watts");
  return stroke;
}

kerf::CutSettings settings_of(const py::object& target_edge, const py::object& tolerance,
                              const py::object& levels, const py::object& rim, const py::object& scheme,
                              const py::object& model, const py::object& material) {
  kerf::CutSettings settings;
  settings.rim =
      choice_argument<kerf_rim>(rim, "rim", {{"faces", KERF_RIM_FACES}, {"smooth", KERF_RIM_SMOOTH}});
  settings.scheme = choice_argument<kerf_scheme>(
      scheme, "scheme",
      {{"longest-edge", KERF_SCHEME_LONGEST_EDGE}, {"one-to-four", KERF_SCHEME_ONE_TO_FOUR}});
  settings.model = choice_argument<kerf_model>(
      model, "model", {{"geometric", KERF_MODEL_GEOMETRIC}, {"thermal", KERF_MODEL_THERMAL}});
  settings.target_edge = optional_argument(target_edge, number_argument, "target_edge");
  settings.tolerance = optional_argument(tolerance, number_argument, "tolerance");
  settings.levels = optional_argument(levels, whole_argument, "levels");
  if (!material.is_none()) settings.material = text_argument(material, "material");
  return settings;
}

py::dict cut(kerf::World& world, const py::object& strokes, const py::object& target_edge,
             const py::object& tolerance, const py::object& levels, const py::object& rim,
             const py::object& scheme, const py::object& model, const py::object& material,
             const py::object& progress, const py::object& threads) {
  const std::vector<kerf::Stroke> list = strokes_argument(strokes);
  const kerf::CutSettings settings =
      settings_of(target_edge, tolerance, levels, rim, scheme, model, material);
  const kerf::Control control =
      control_argument(progress, static_cast<unsigned>(whole_argument(threads, "threads")));
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

// Crossings of rays as NumPy arrays.
struct HitArrays {
  py::array first, distance, body, face;
};

HitArrays arrays_of(const kerf::Hits& hits) {
  return {copied(hits.first), copied(hits.distances), copied(hits.bodies), copied(hits.faces)};
}

template <typename Ask>
HitArrays ask_rays(const py::object& origins, const py::object& directions, const py::object& range,
                   Ask ask) {
  const std::vector<double> from = triples_argument(origins, "origins"),
                            along = triples_argument(directions, "directions");
  std::array<double, 2> within{0, std::numeric_limits<double>::max()};
  if (!range.is_none()) within = range_argument(range);
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
  py::class_<kerf::Mesh>(m, "Mesh", "A triangle mesh, or a piece of one; immutable.")
      .def(py::init([](const py::object& vertices, const py::object& faces) {
             const std::vector<double> positions = triples_argument(vertices, "vertices");
             const std::vector<uint32_t> corners = faces_argument(faces);
             return kerf::Mesh(positions, corners);
           }),
           py::arg("vertices"), py::arg("faces"),
           "Creates a mesh from arrays, which are copied: vertices, positions of shape (n, 3) in metres, and "
           "faces, integers of shape (m, 3), counter-clockwise seen from outside.")
      .def_property_readonly(
          "vertices", [](const kerf::Mesh& mesh) { return look_at(mesh.vertices(), mesh); },
          "Positions, float64 of shape (n, 3), metres. Read-only.")
      .def_property_readonly(
          "faces", [](const kerf::Mesh& mesh) { return look_at(mesh.faces(), mesh); },
          "Vertex indices, uint32 of shape (m, 3). Read-only.")
      .def_property_readonly(
          "temperatures", [](const kerf::Mesh& mesh) { return look_along(mesh.temperatures(), mesh); },
          "Face temperatures of a piece, float64 of shape (m,), kelvin; empty for any other mesh. Read-only.")
      .def_property_readonly("area", &kerf::Mesh::area, "Area, m^2.")
      .def_property_readonly("name", &kerf::Mesh::name,
                             "Name of the piece; empty for a mesh that was read or created.")
      .def_property_readonly(
          "mass", [](const kerf::Mesh& mesh) { return mesh.info().mass; },
          "Mass in kg, of the sheet, or of the solid if its body is one and the piece is closed; 0 unless "
          "the mesh is a piece of a world.")
      .def_property_readonly(
          "centroid", [](const kerf::Mesh& mesh) { return numbers(mesh.info().centroid); },
          "Centroid of the area, or of the volume of a solid, shape (3,), metres.")
      .def_property_readonly(
          "inertia", [](const kerf::Mesh& mesh) { return numbers(mesh.info().inertia); },
          "Inertia, kg m^2 about the centroid in world axes: xx, yy, zz, xy, xz, yz.")
      .def_property_readonly("boundary_edges",
                             [](const kerf::Mesh& mesh) { return mesh.info().boundary_edges; })
      .def_property_readonly(
          "placement",
          [](const kerf::Mesh& mesh) {
            const kerf_mesh_info info = mesh.info();
            return py::make_tuple(numbers(info.position), numbers(info.orientation));
          },
          "(position, orientation) of the body: metres, and a quaternion w, x, y, z. The vertices are "
          "already in world coordinates.")
      .def(
          "write",
          [](const kerf::Mesh& mesh, const py::object& path) {
            const std::string file = path_argument(path);
            on_file(file, folder_of(file), [&] { mesh.write(file); });
          },
          py::arg("path"), "Writes the mesh as .obj, .ply, .stl, .off, .glb or .gltf, whole or not at all.")
      .def("__repr__", [](const kerf::Mesh& mesh) {
        return "<kerf.Mesh of " + std::to_string(mesh.faces().size() / 3) + " faces>";
      });
  m.def(
      "read",
      [](const py::object& path) {
        const std::string file = path_argument(path);
        const kerf::Control control = control_argument(py::none(), 0);
        return on_file(file, file, [&] { return kerf::Mesh::read(file, control); });
      },
      py::arg("path"), "Reads an OBJ, PLY, STL, OFF or glTF file and returns a Mesh.");
}

void add_stroke(py::module_& m) {
  py::class_<kerf::Stroke>(m, "Stroke", "A stroke of the laser.")
      .def(py::init(&make_stroke), py::arg("keys"), py::arg("radius") = py::none(),
           py::arg("range") = py::none(), py::arg("power") = py::none(),
           "keys: (time in s, origin in m, direction of any non-zero length). Defaults: radius (m) is 1/400 "
           "of the diagonal of the world, range (m along the beam) reaches ten diagonals, power is 2000 W.");
}

void add_world(py::module_& m) {
  py::class_<HitArrays>(m, "Hits", "Crossings of rays with surfaces.")
      .def_readonly("first", &HitArrays::first, "all_hits: hits of ray i are first[i] to first[i + 1] - 1.")
      .def_readonly("distance", &HitArrays::distance, "float64, metres; inf on a miss.")
      .def_readonly("body", &HitArrays::body, "uint32, in the order of adding; 2^32 - 1 on a miss.")
      .def_readonly("face", &HitArrays::face, "uint32, the slot of the face in its body.");
  py::class_<kerf::World>(m, "World", "The bodies that a laser cuts.")
      .def(py::init<>())
      .def_static(
          "open",
          [](const py::object& path) {
            const std::string file = path_argument(path);
            const kerf::Control control = control_argument(py::none(), 0);
            return on_file(file, file, [&] { return std::make_unique<kerf::World>(file, control); });
          },
          py::arg("path"),
          "Opens a scene (.json), a journal (.kerf), whose commands are replayed, or a mesh.")
      .def(
          "add",
          [](kerf::World& world, const py::object& mesh, const py::object& name) {
            const kerf::Mesh added = instance_argument<kerf::Mesh>(mesh, "mesh", "kerf.Mesh");
            const std::string text = text_argument(name, "name");
            const kerf::Control control = control_argument(py::none(), 0);
            const py::gil_scoped_release unlocked;
            world.add(added, text, control);
          },
          py::arg("mesh"), py::arg("name") = "mesh",
          "Adds a copy of a mesh as a new body, a sheet of mild steel 1 mm thick.")
      .def("cut", &cut, py::arg("strokes"), py::kw_only(), py::arg("target_edge") = py::none(),
           py::arg("tolerance") = py::none(), py::arg("levels") = py::none(), py::arg("rim") = "faces",
           py::arg("scheme") = "longest-edge", py::arg("model") = "geometric",
           py::arg("material") = py::none(), py::arg("progress") = py::none(), py::arg("threads") = 0,
           "Cuts all bodies with a Stroke or a list of them, all or nothing. Set at most one of target_edge "
           "(m), tolerance (m) and levels. progress(share) is called at most fifty times a second and may "
           "return False to stop. Returns removed_faces, removed_area (m^2) and seconds.")
      .def_property_readonly(
          "pieces",
          [](const kerf::World& world) {
            const kerf::Control control = control_argument(py::none(), 0);
            const py::gil_scoped_release unlocked;
            return world.pieces(control);
          },
          "The pieces of all bodies as meshes in world coordinates, largest area first.")
      .def(
          "nearest_hits",
          [](const kerf::World& world, const py::object& origins, const py::object& directions,
             const py::object& range) {
            const kerf::Control control = control_argument(py::none(), 0);
            return ask_rays(origins, directions, range,
                            [&](const auto& from, const auto& along, const auto& within) {
                              return world.nearest_hits(from, along, within, control);
                            });
          },
          py::arg("origins"), py::arg("directions"), py::kw_only(), py::arg("range") = py::none(),
          "Finds the first surface that each of n rays crosses: takes arrays of shape (n, 3), returns Hits.")
      .def(
          "all_hits",
          [](const kerf::World& world, const py::object& origins, const py::object& directions,
             const py::object& range) {
            const kerf::Control control = control_argument(py::none(), 0);
            return ask_rays(origins, directions, range,
                            [&](const auto& from, const auto& along, const auto& within) {
                              return world.all_hits(from, along, within, control);
                            });
          },
          py::arg("origins"), py::arg("directions"), py::kw_only(), py::arg("range") = py::none(),
          "Finds all surfaces that each ray crosses, nearest first.")
      .def(
          "save_scene",
          [](const kerf::World& world, const py::object& folder) {
            const std::string to = path_argument(folder);
            const py::gil_scoped_release unlocked;
            world.save_scene(to);
          },
          py::arg("folder"), "Writes the bodies as OBJ files and a scene.json that the editor opens.")
      .def(
          "save_journal",
          [](const kerf::World& world, const py::object& path) {
            const std::string file = path_argument(path);
            on_file(file, folder_of(file), [&] { world.save_journal(file); });
          },
          py::arg("path"), "Writes the journal (.kerf) of the cuts, and the added meshes next to it.")
      .def(
          "report", [](const kerf::World& world) { return object_of([&] { return world.report(); }); },
          "Returns the report of all cuts so far, with the keys of the report.json of `kerf cut`.")
      .def(
          "graph", [](const kerf::World& world) { return object_of([&] { return world.graph(); }); },
          "Returns the component graph of the faces, as written by `kerf inspect --graph`.")
      .def_property_readonly(
          "hash",
          [](const kerf::World& world) {
            const py::gil_scoped_release unlocked;
            return world.hash();
          },
          "Hash of the state, 16 hexadecimal digits; equal to that of `kerf cut` for the same meshes and "
          "strokes.");
}

// Exception classes of the module; they live as long as the interpreter.
struct Exceptions {
  PyObject *error, *cancelled, *busy, *file_not_found;
};

// Adds an exception class to the module; `bases` is one class or a tuple of them.
PyObject* add_exception(py::module_& m, const char* name, const char* meaning, const py::handle& bases) {
  PyObject* made =
      PyErr_NewExceptionWithDoc(("kerf." + std::string(name)).c_str(), meaning, bases.ptr(), nullptr);
  if (made == nullptr) throw py::error_already_set();
  m.attr(name) = py::handle(made);
  return made;
}

void add_exceptions(py::module_& m) {
  static Exceptions classes{};
  classes.error =
      add_exception(m, "Error", "A call that failed; it has changed nothing.", PyExc_RuntimeError);
  classes.cancelled =
      add_exception(m, "Cancelled", "A call that its progress callback cancelled.", classes.error);
  classes.busy =
      add_exception(m, "Busy", "A call that cannot run while another one uses the world.", classes.error);
  const py::tuple bases = py::make_tuple(py::handle(PyExc_FileNotFoundError), py::handle(PyExc_ValueError));
  classes.file_not_found = add_exception(m, "FileNotFound", "A path without a file.", bases);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const MissingFile& missing) {
      const auto path = py::reinterpret_steal<py::object>(PyUnicode_DecodeFSDefault(missing.path.c_str()));
      const py::tuple values = py::make_tuple(ENOENT, std::strerror(ENOENT), path);
      PyErr_SetObject(classes.file_not_found, values.ptr());
    } catch (const kerf::BadInput& fault) {
      PyErr_SetString(PyExc_ValueError, fault.what());
    } catch (const kerf::Cancelled& fault) {
      PyErr_SetString(classes.cancelled, fault.what());
    } catch (const kerf::Busy& fault) {
      PyErr_SetString(classes.busy, fault.what());
    } catch (const kerf::Failure& fault) {
      PyErr_SetString(classes.error, fault.what());
    }
  });
}

}  // namespace

PYBIND11_MODULE(_kerf, m) {
  m.doc() = "Kerf: cuts triangle meshes with a laser.";
  m.attr("__version__") = kerf_version();
  m.attr("__name__") = "kerf";  // the module that exports the classes, for their names
  add_exceptions(m);
  add_mesh(m);
  add_stroke(m);
  add_world(m);
  m.attr("__name__") = "kerf._kerf";
}
