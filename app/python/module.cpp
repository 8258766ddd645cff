// The Python module: kerf.h with NumPy arrays. Calls release the GIL, and Ctrl-C ends them.
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

// Runs work on a file with the GIL released. Throws MissingFile if the work fails because
// `needed`, the file or the folder to write in, does not exist.
template <typename Work>
auto on_file(const std::string& path, const std::filesystem::path& needed, Work work) {
  const py::gil_scoped_release unlocked;
  try {
    return work();
  } catch (const kerf::Cancelled&) {
    throw;
  } catch (const kerf::Error&) {
    std::error_code error;
    if (std::filesystem::status(needed, error).type() != std::filesystem::file_type::not_found) throw;
    throw MissingFile{path};
  }
}

// Returns the folder that contains a file.
std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : ".";
}

// Parses the JSON text that `make` returns; it runs with the GIL released.
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
py::array_t<T> array_view(std::span<const T> numbers, const kerf::Mesh& mesh) {
  auto keeper = std::make_unique<kerf::Mesh>(mesh);
  const py::capsule owner(keeper.get(), [](void* m) { delete static_cast<kerf::Mesh*>(m); });
  (void)keeper.release();
  py::array_t<T> array({static_cast<py::ssize_t>(numbers.size() / 3), py::ssize_t{3}}, numbers.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

// Like array_view(), of shape (n,).
template <typename T>
py::array_t<T> scalar_view(std::span<const T> numbers, const kerf::Mesh& mesh) {
  auto keeper = std::make_unique<kerf::Mesh>(mesh);
  const py::capsule owner(keeper.get(), [](void* m) { delete static_cast<kerf::Mesh*>(m); });
  (void)keeper.release();
  py::array_t<T> array({static_cast<py::ssize_t>(numbers.size())}, numbers.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

template <typename T>
py::array_t<T> array_copy(const std::vector<T>& numbers) {
  return py::array_t<T>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

double positive_argument(const py::object& object, const char* name, const char* unit) {
  const double number = number_argument(object, name);
  if (number > 0) return number;
  throw py::value_error(std::string(name) + ": must be a number of " + unit + " greater than zero");
}

// Set an attribute of a stroke; None means the default.
void set_radius(kerf::Stroke& stroke, const py::object& object) {
  stroke.radius = object.is_none() ? 0 : positive_argument(object, "radius", "metres");
}
void set_range(kerf::Stroke& stroke, const py::object& object) {
  stroke.range = object.is_none() ? std::array<double, 2>{} : range_argument(object);
}
void set_power(kerf::Stroke& stroke, const py::object& object) {
  const double power = number_argument(object, "power");
  if (!(power >= 0)) throw py::value_error("power: must be a number of watts, at least 0");
  stroke.power = power;
}

kerf::Stroke make_stroke(const py::object& keys, const py::object& radius, const py::object& range,
                         const py::object& power) {
  kerf::Stroke stroke;
  stroke.keys = keys_argument(keys);
  set_radius(stroke, radius);
  set_range(stroke, range);
  set_power(stroke, power);
  return stroke;
}

// Return an attribute of a stroke; None for the default.
py::object number_or_none(double number) {
  if (number == 0) return py::none();
  return py::float_(number);
}
py::object range_of(const kerf::Stroke& stroke) {
  if (stroke.range == std::array<double, 2>{}) return py::none();
  return py::make_tuple(stroke.range[0], stroke.range[1]);
}
py::list keys_of(const kerf::Stroke& stroke) {
  py::list keys;
  for (const kerf::Keyframe& key : stroke.keys) {
    const auto vector = [](const double(&v)[3]) { return py::make_tuple(v[0], v[1], v[2]); };
    keys.append(py::make_tuple(key.time, vector(key.origin), vector(key.direction)));
  }
  return keys;
}

py::tuple state_of(const kerf::Stroke& stroke) {
  return py::make_tuple(keys_of(stroke), number_or_none(stroke.radius), range_of(stroke), stroke.power);
}

// Returns an expression that creates the stroke.
std::string text_of(const kerf::Stroke& stroke) {
  const py::tuple state = state_of(stroke);
  std::string text = "kerf.Stroke(" + py::repr(state[0]).cast<std::string>();
  const char* const names[] = {"keys", "radius", "range", "power"};
  const py::object defaults[] = {py::none(), py::none(), py::none(), py::float_(kerf::Stroke().power)};
  for (size_t i = 1; i < state.size(); ++i) {
    const py::object value = state[i];
    if (!value.equal(defaults[i]))
      text += ", " + std::string(names[i]) + "=" + py::repr(value).cast<std::string>();
  }
  return text + ")";
}

kerf::CutSettings settings_of(const py::object& target_edge, const py::object& tolerance,
                              const py::object& max_level, const py::object& rim, const py::object& scheme,
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
  settings.max_level = optional_argument(max_level, int_argument, "max_level");
  if (!material.is_none()) settings.material = text_argument(material, "material");
  return settings;
}

py::dict cut(kerf::World& world, const py::object& strokes, const py::object& target_edge,
             const py::object& tolerance, const py::object& max_level, const py::object& rim,
             const py::object& scheme, const py::object& model, const py::object& material,
             const py::object& progress, const py::object& threads) {
  const std::vector<kerf::Stroke> list = strokes_argument(strokes);
  const kerf::CutSettings settings =
      settings_of(target_edge, tolerance, max_level, rim, scheme, model, material);
  const kerf::CallOptions options =
      options_argument(progress, static_cast<unsigned>(int_argument(threads, "threads")));
  kerf::CutResult result = KERF_CUT_RESULT_INIT;
  {
    const py::gil_scoped_release unlocked;
    result = world.cut(list, settings, options);
  }
  py::dict dict;
  dict["removed_faces"] = result.removed_faces;
  dict["removed_area"] = result.removed_area;
  dict["seconds"] = result.seconds;
  return dict;
}

// Crossings of rays as NumPy arrays.
struct HitArrays {
  py::array offsets, distance, body, face, piece;
};

HitArrays arrays_of(const kerf::Hits& hits) {
  return {array_copy(hits.offsets), array_copy(hits.distances), array_copy(hits.bodies),
          array_copy(hits.faces), array_copy(hits.pieces)};
}

template <typename Trace>
HitArrays trace_rays(const py::object& origins, const py::object& directions, const py::object& range,
                     Trace trace) {
  const std::vector<double> from = triples_argument(origins, "origins"),
                            along = triples_argument(directions, "directions");
  std::array<double, 2> within{0, std::numeric_limits<double>::max()};
  if (!range.is_none()) within = range_argument(range);
  kerf::Hits hits;
  {
    const py::gil_scoped_release unlocked;
    hits = trace(from, along, within);
  }
  return arrays_of(hits);
}

template <size_t kCount>
py::array_t<double> numbers(const double (&values)[kCount]) {
  return py::array_t<double>(static_cast<py::ssize_t>(kCount), values);
}

py::dict attributes_of(const kerf::Mesh& mesh) {
  py::dict all;
  for (const kerf::Mesh::Attribute& attribute : mesh.attributes()) {
    const auto size = static_cast<py::ssize_t>(attribute.size);
    const auto faces = static_cast<py::ssize_t>(mesh.faces().size() / 3);
    all[py::str(attribute.name)] = py::array_t<float>({faces, py::ssize_t{3}, size}, attribute.values.data());
  }
  return all;
}

void add_mesh(py::module_& m) {
  py::class_<kerf::Mesh>(m, "Mesh", "A triangle mesh, or a piece of one; immutable.")
      .def(py::init([](const py::object& vertices, const py::object& faces) {
             const std::vector<double> positions = triples_argument(vertices, "vertices");
             const std::vector<uint32_t> corners = faces_argument(faces);
             return kerf::Mesh(positions, corners);
           }),
           py::arg("vertices"), py::arg("faces"),
           "Creates a mesh from arrays, which are copied.\n\n"
           "vertices: positions of shape (n, 3), metres, finite.\n"
           "faces: integers of shape (m, 3), counter-clockwise seen from outside.\n\n"
           "Raises ValueError for arrays of another shape or kind, numbers that are not finite, and indices "
           "out of range.")
      .def(py::init([](const py::object& mesh) { return mesh_argument(mesh, "mesh"); }), py::arg("mesh"),
           "Creates a mesh from an object with the attributes vertices and faces, or vertices and triangles, "
           "such as a mesh of Trimesh or Open3D.\n\n"
           "Raises TypeError for an object without them, otherwise like Mesh(vertices, faces).")
      .def_property_readonly(
          "vertices", [](const kerf::Mesh& mesh) { return array_view(mesh.vertices(), mesh); },
          "Positions, float64 of shape (n, 3), metres. Read-only.")
      .def_property_readonly(
          "faces", [](const kerf::Mesh& mesh) { return array_view(mesh.faces(), mesh); },
          "Vertex indices, uint32 of shape (m, 3). Read-only.")
      .def_property_readonly(
          "face_temperatures",
          [](const kerf::Mesh& mesh) { return scalar_view(mesh.face_temperatures(), mesh); },
          "Face temperatures of a piece, float64 of shape (m,), kelvin; empty for any other mesh. Read-only.")
      .def_property_readonly("attributes", attributes_of,
                             "Values at the corners of the faces, copies: a dict of float32 arrays of shape "
                             "(m, 3, k) by their names in glTF, such as TEXCOORD_0, NORMAL, TANGENT and "
                             "_NAME. NaN if a face has none.")
      .def_property_readonly(
          "face_materials", [](const kerf::Mesh& mesh) { return scalar_view(mesh.face_materials(), mesh); },
          "Indices of the materials of faces, uint16 of shape (m,); empty without materials. Read-only.")
      .def_property_readonly("material_names", &kerf::Mesh::material_names,
                             "Names of materials by index, some empty.")
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
          "Inertia about the centroid in world axes, shape (6,), kg m^2: xx, yy, zz, xy, xz, yz.")
      .def_property_readonly(
          "boundary_edges", [](const kerf::Mesh& mesh) { return mesh.info().boundary_edges; },
          "Number of edges with one face; 0 unless the mesh is a piece of a world.")
      .def_property_readonly(
          "placement",
          [](const kerf::Mesh& mesh) {
            const kerf_mesh_info info = mesh.info();
            return py::make_tuple(numbers(info.position), numbers(info.orientation));
          },
          "Placement of the body: (position in metres, unit quaternion w, x, y, z). The vertices are in "
          "world coordinates.")
      .def(
          "write",
          [](const kerf::Mesh& mesh, const py::object& path) {
            const std::string file = path_argument(path);
            on_file(file, folder_of(file), [&] { mesh.write(file); });
          },
          py::arg("path"),
          "Writes the mesh, whole or not at all. The extension decides the format: .obj, .ply, .stl, .off, "
          ".glb, .gltf or .3mf.\n\n"
          "Raises ValueError for another extension, FileNotFoundError if the folder is missing, and Error if "
          "the file cannot be written.")
      .def("__copy__", [](const kerf::Mesh& mesh) { return mesh; })
      .def(
          "__deepcopy__", [](const kerf::Mesh& mesh, const py::object&) { return mesh; }, py::arg("memo"))
      .def(py::pickle(
          [](const kerf::Mesh& mesh) { return py::make_tuple(py::bytes(mesh.bytes())); },
          [](const py::tuple& state) { return kerf::Mesh::from_bytes(state[0].cast<std::string>()); }))
      .def("__repr__", [](const kerf::Mesh& mesh) {
        const std::string name = mesh.name();
        return "<kerf.Mesh " + (name.empty() ? "" : "\"" + name + "\" ") + "of " +
               std::to_string(mesh.faces().size() / 3) + " faces>";
      });
  m.def(
      "read",
      [](const py::object& path, const py::object& progress) {
        const std::string file = path_argument(path);
        const kerf::CallOptions options = options_argument(progress, 0);
        return on_file(file, file, [&] { return kerf::Mesh::read(file, options); });
      },
      py::arg("path"), py::kw_only(), py::arg("progress") = py::none(),
      "Reads an OBJ, PLY, STL, OFF, glTF or 3MF file and returns a Mesh.\n\n"
      "progress: as in World.cut.\n\n"
      "Raises FileNotFoundError for a missing file, ValueError for one that cannot be parsed or has no "
      "usable face, and Cancelled.");
}

void add_stroke(py::module_& m) {
  py::class_<kerf::Stroke>(m, "Stroke", "A stroke of the laser.")
      .def(py::init(&make_stroke), py::arg("keys"), py::arg("radius") = py::none(),
           py::arg("range") = py::none(), py::arg("power") = kerf::Stroke().power,
           "keys: poses of the beam, (time in s, origin in m, direction of any non-zero length) each.\n"
           "radius: metres, > 0; None: 1/400 of the diagonal of the world.\n"
           "range: (min, max) along the beam in metres; None: from 0 to ten diagonals.\n"
           "power: watts, >= 0, for the thermal model.\n\n"
           "Raises TypeError for an argument of another type and ValueError for a number out of range. "
           "World.cut checks the keys.")
      .def_property(
          "keys", &keys_of,
          [](kerf::Stroke& stroke, const py::object& keys) { stroke.keys = keys_argument(keys); },
          "Poses of the beam, a copy: a list of (time in s, origin in m, direction).")
      .def_property(
          "radius", [](const kerf::Stroke& stroke) { return number_or_none(stroke.radius); }, &set_radius,
          "Beam radius in metres, > 0; None: 1/400 of the diagonal of the world.")
      .def_property("range", &range_of, &set_range,
                    "(min, max) along the beam in metres; None: from 0 to ten diagonals.")
      .def_property(
          "power", [](const kerf::Stroke& stroke) { return stroke.power; }, &set_power,
          "Watts, >= 0, for the thermal model.")
      .def("__eq__",
           [](const kerf::Stroke& stroke, const py::object& other) {
             return py::isinstance<kerf::Stroke>(other) &&
                    state_of(stroke).equal(state_of(other.cast<const kerf::Stroke&>()));
           })
      .def(py::pickle(
          &state_of,
          [](const py::tuple& state) { return make_stroke(state[0], state[1], state[2], state[3]); }))
      .def("__repr__", &text_of);
}

void add_world(py::module_& m) {
  py::class_<HitArrays>(m, "Hits", "Crossings of k rays with surfaces, n in total.")
      .def_readonly("offsets", &HitArrays::offsets,
                    "all_hits: uint64 of shape (k + 1,); hits of ray i are offsets[i] to offsets[i + 1] - 1. "
                    "nearest_hits: empty.")
      .def_readonly("distance", &HitArrays::distance, "float64 of shape (n,), metres; inf on a miss.")
      .def_readonly("body", &HitArrays::body, "uint64 of shape (n,), ids of bodies; 2^64 - 1 on a miss.")
      .def_readonly("face", &HitArrays::face,
                    "uint32 of shape (n,), face indices in their bodies; 2^32 - 1 on a miss.")
      .def_readonly("piece", &HitArrays::piece, "uint32 of shape (n,), labels of pieces in their bodies.")
      .def(py::pickle(
          [](const HitArrays& hits) {
            return py::make_tuple(hits.offsets, hits.distance, hits.body, hits.face, hits.piece);
          },
          [](const py::tuple& state) {
            return HitArrays{state[0], state[1], state[2], state[3], state[4]};
          }))
      .def("__repr__", [](const HitArrays& hits) {
        return "<kerf.Hits, " + std::to_string(hits.distance.size()) + " distances>";
      });
  py::class_<kerf::World>(m, "World", "The bodies that a laser cuts.")
      .def(py::init<>(), "Creates an empty world.")
      .def_static(
          "open",
          [](const py::object& path, const py::object& progress) {
            const std::string file = path_argument(path);
            const kerf::CallOptions options = options_argument(progress, 0);
            return on_file(file, file, [&] { return std::make_unique<kerf::World>(file, options); });
          },
          py::arg("path"), py::kw_only(), py::arg("progress") = py::none(),
          "Opens a scene (.json), a journal (.kerf), whose commands are replayed, or a mesh.\n\n"
          "progress: as in cut.\n\n"
          "Raises FileNotFoundError for a missing file, ValueError for a wrong one, and Cancelled.")
      .def(
          "add",
          [](kerf::World& world, const py::object& mesh, const py::object& name) {
            const kerf::Mesh added = mesh_argument(mesh, "mesh");
            const std::string text = text_argument(name, "name");
            const kerf::CallOptions options = options_argument(py::none(), 0);
            const py::gil_scoped_release unlocked;
            world.add(added, text, options);
          },
          py::arg("mesh"), py::arg("name") = "mesh",
          "Adds a copy of a mesh as a new body, a sheet of mild steel 1 mm thick.\n\n"
          "mesh: a Mesh, or an object with the attributes vertices and faces, or vertices and triangles.\n"
          "name: without null characters.\n\n"
          "Raises TypeError for another object, ValueError for bad arrays or a bad name, and Busy.")
      .def("cut", &cut, py::arg("strokes"), py::kw_only(), py::arg("target_edge") = py::none(),
           py::arg("tolerance") = py::none(), py::arg("max_level") = py::none(), py::arg("rim") = "faces",
           py::arg("scheme") = "longest-edge", py::arg("model") = "geometric",
           py::arg("material") = py::none(), py::arg("progress") = py::none(), py::arg("threads") = 0,
           "Cuts all bodies with strokes, in order, all or nothing.\n\n"
           "strokes: a Stroke or an iterable of them.\n"
           "target_edge: longest edge under the beam in metres; None: a quarter of the radius.\n"
           "tolerance: instead, how far the removed area may reach beyond the beam, in metres.\n"
           "max_level: instead, the maximum refinement level, 0 to 24.\n"
           "rim: \"faces\" removes every face that the beam touches, \"smooth\" cuts faces along the beam.\n"
           "scheme: \"longest-edge\" or \"one-to-four\", the subdivision of faces.\n"
           "model: \"geometric\" removes faces immediately, \"thermal\" when they have absorbed enough "
           "energy.\n"
           "material: new material of all bodies, a name from `kerf materials`; None: unchanged.\n"
           "progress: called with the completed fraction, 0 to 1, at most fifty times a second; returns "
           "False to stop.\n"
           "threads: maximum number of threads, 0 to 1024; 0: one per processor.\n\n"
           "Returns a dict of removed_faces, removed_area (m^2) and seconds.\n\n"
           "Raises TypeError or ValueError for a wrong argument, ValueError if the world has no mesh, "
           "Cancelled, Busy, and Error if a body would get too many faces. A failed cut changes nothing.")
      .def_property_readonly(
          "pieces",
          [](const kerf::World& world) {
            const kerf::CallOptions options = options_argument(py::none(), 0);
            const py::gil_scoped_release unlocked;
            return world.pieces(options);
          },
          "The pieces of all bodies as meshes in world coordinates, largest area first. Raises Busy.")
      .def(
          "nearest_hits",
          [](const kerf::World& world, const py::object& origins, const py::object& directions,
             const py::object& range) {
            const kerf::CallOptions options = options_argument(py::none(), 0);
            return trace_rays(origins, directions, range,
                              [&](const auto& from, const auto& along, const auto& within) {
                                return world.nearest_hits(from, along, within, options);
                              });
          },
          py::arg("origins"), py::arg("directions"), py::kw_only(), py::arg("range") = py::none(),
          "Finds the first surface that each of n rays crosses and returns Hits of shape (n,).\n\n"
          "origins, directions: finite, of shape (n, 3), metres; directions of any non-zero length.\n"
          "range: (min, max) distance in metres; None: from 0 to infinity.\n\n"
          "Raises ValueError for arrays or a range that violate the above, and Busy.")
      .def(
          "all_hits",
          [](const kerf::World& world, const py::object& origins, const py::object& directions,
             const py::object& range) {
            const kerf::CallOptions options = options_argument(py::none(), 0);
            return trace_rays(origins, directions, range,
                              [&](const auto& from, const auto& along, const auto& within) {
                                return world.all_hits(from, along, within, options);
                              });
          },
          py::arg("origins"), py::arg("directions"), py::kw_only(), py::arg("range") = py::none(),
          "Finds all surfaces that each of n rays crosses, nearest first, and returns Hits. Arguments and "
          "errors are those of nearest_hits.")
      .def(
          "save_scene",
          [](const kerf::World& world, const py::object& folder) {
            const std::string to = path_argument(folder);
            const py::gil_scoped_release unlocked;
            world.save_scene(to);
          },
          py::arg("folder"),
          "Writes the bodies and a scene.json that the editor opens: OBJ files, or Kerf meshes (.kmesh) for "
          "bodies with attributes or described materials. The folder is created if missing.\n\n"
          "Raises ValueError if the world has no face, and Error if a file cannot be written.")
      .def(
          "save_journal",
          [](const kerf::World& world, const py::object& path) {
            const std::string file = path_argument(path);
            on_file(file, folder_of(file), [&] { world.save_journal(file); });
          },
          py::arg("path"),
          "Writes the journal (.kerf) of the cuts, and the added meshes next to it.\n\n"
          "Raises FileNotFoundError if the folder is missing, ValueError if a body was added or the material "
          "changed after a cut, and Error if a file cannot be written.")
      .def(
          "report", [](const kerf::World& world) { return object_of([&] { return world.report(); }); },
          "Returns a report of all cuts, with the keys of the report.json of `kerf cut`.")
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
PyObject* add_exception(py::module_& m, const char* name, const char* doc, const py::handle& bases) {
  PyObject* created =
      PyErr_NewExceptionWithDoc(("kerf." + std::string(name)).c_str(), doc, bases.ptr(), nullptr);
  if (created == nullptr) throw py::error_already_set();
  m.attr(name) = py::handle(created);
  return created;
}

void add_exceptions(py::module_& m) {
  static Exceptions classes{};
  classes.error = add_exception(m, "Error", "A failed call; it has changed nothing.", PyExc_RuntimeError);
  classes.cancelled =
      add_exception(m, "Cancelled", "A call that its progress callback cancelled.", classes.error);
  classes.busy = add_exception(m, "Busy", "A call on a world that another call uses.", classes.error);
  const py::tuple bases = py::make_tuple(py::handle(PyExc_FileNotFoundError), py::handle(PyExc_ValueError));
  classes.file_not_found = add_exception(m, "FileNotFound", "A path without a file.", bases);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const MissingFile& missing) {
      const auto path = py::reinterpret_steal<py::object>(PyUnicode_DecodeFSDefault(missing.path.c_str()));
      const py::tuple values = py::make_tuple(ENOENT, std::strerror(ENOENT), path);
      PyErr_SetObject(classes.file_not_found, values.ptr());
    } catch (const kerf::InvalidArgument& fault) {
      PyErr_SetString(PyExc_ValueError, fault.what());
    } catch (const kerf::Cancelled& fault) {
      PyErr_SetString(classes.cancelled, fault.what());
    } catch (const kerf::Busy& fault) {
      PyErr_SetString(classes.busy, fault.what());
    } catch (const kerf::Error& fault) {
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
