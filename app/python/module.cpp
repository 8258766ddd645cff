// The Python module: kerf.h with NumPy arrays. Calls release the GIL, and Ctrl-C ends them.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cerrno>
#include <cstring>

#include "app/python/arguments.h"
#include "app/python/results.h"
#include "core/kerf.h"

namespace py = pybind11;

namespace {

using namespace kerf::python;

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
  if (!object.is_none() && stroke.range[1] == 0)
    throw py::value_error("range: the maximum must be greater than 0; None stands for the default");
}
void set_power(kerf::Stroke& stroke, const py::object& object) {
  const double power = number_argument(object, "power");
  if (!(power >= 0)) throw py::value_error("power: must be a number of watts, at least 0");
  stroke.power = power;
}

void set_wavelength(kerf::Stroke& stroke, const py::object& object) {
  stroke.wavelength = object.is_none() ? 0 : positive_argument(object, "wavelength", "metres");
}
void set_focus(kerf::Stroke& stroke, const py::object& object) {
  stroke.focus.reset();
  if (!object.is_none()) stroke.focus = positive_argument(object, "focus", "metres");
}
void set_pulse_rate(kerf::Stroke& stroke, const py::object& object) {
  stroke.pulse_rate = object.is_none() ? 0 : positive_argument(object, "pulse_rate", "hertz");
}
void set_duty(kerf::Stroke& stroke, const py::object& object) {
  const double duty = number_argument(object, "duty");
  if (!(duty > 0 && duty <= 1)) throw py::value_error("duty: must be greater than 0 and at most 1");
  stroke.duty = duty;
}
void set_assist(kerf::Stroke& stroke, const py::object& object) {
  stroke.assist = choice_argument<kerf_assist>(object, "assist",
                                               {{"none", KERF_ASSIST_NONE}, {"oxygen", KERF_ASSIST_OXYGEN}});
}

kerf::Stroke make_stroke(const py::object& keys, const py::object& radius, const py::object& range,
                         const py::object& power, const py::object& wavelength, const py::object& focus,
                         const py::object& pulse_rate, const py::object& duty, const py::object& assist) {
  kerf::Stroke stroke;
  stroke.keys = keys_argument(keys);
  set_radius(stroke, radius);
  set_range(stroke, range);
  set_power(stroke, power);
  set_wavelength(stroke, wavelength);
  set_focus(stroke, focus);
  set_pulse_rate(stroke, pulse_rate);
  set_duty(stroke, duty);
  set_assist(stroke, assist);
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

const char* assist_of(const kerf::Stroke& stroke) {
  return stroke.assist == KERF_ASSIST_OXYGEN ? "oxygen" : "none";
}

py::tuple state_of(const kerf::Stroke& stroke) {
  return py::make_tuple(keys_of(stroke), number_or_none(stroke.radius), range_of(stroke), stroke.power,
                        number_or_none(stroke.wavelength), stroke.focus, number_or_none(stroke.pulse_rate),
                        stroke.duty, assist_of(stroke));
}

// Returns an expression that creates the stroke.
std::string text_of(const kerf::Stroke& stroke) {
  const py::tuple state = state_of(stroke);
  std::string text = "kerf.Stroke(" + py::repr(state[0]).cast<std::string>();
  const char* const names[] = {"keys",  "radius",     "range", "power", "wavelength",
                               "focus", "pulse_rate", "duty",  "assist"};
  const py::tuple defaults = state_of(kerf::Stroke());
  for (size_t i = 1; i < state.size(); ++i) {
    const py::object value = state[i];
    if (!value.equal(defaults[i]))
      text += ", " + std::string(names[i]) + "=" + py::repr(value).cast<std::string>();
  }
  return text + ")";
}

py::dict attributes_of(const kerf::Mesh& mesh) {
  py::dict all;
  for (const kerf::Mesh::Attribute& attribute : mesh.attributes()) {
    const auto size = static_cast<py::ssize_t>(attribute.size);
    const auto faces = static_cast<py::ssize_t>(mesh.faces().size() / 3);
    all[text(attribute.name)] = py::array_t<float>({faces, py::ssize_t{3}, size}, attribute.values.data());
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
      .def_property_readonly(
          "material_names", [](const kerf::Mesh& mesh) { return texts(mesh.material_names()); },
          "Names of materials by index, some empty.")
      .def_property_readonly(
          "parts",
          [](const kerf::Mesh& mesh) {
            py::list parts;
            for (const kerf::Mesh::Part& part : mesh.parts())
              parts.append(py::make_tuple(text(part.name), part.first, part.count));
            return parts;
          },
          "Parts that the file of the mesh names, as tuples (name, first face, number of faces); ranges may "
          "overlap.")
      .def_property_readonly("area", &kerf::Mesh::area, "Area, m^2.")
      .def_property_readonly(
          "name", [](const kerf::Mesh& mesh) { return text(mesh.name()); },
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
      .def_property_readonly(
          "volume", [](const kerf::Mesh& mesh) { return mesh.info().volume; },
          "Volume of a closed piece, m^3; 0 for an open one and any other mesh.")
      .def_property_readonly(
          "is_closed", [](const kerf::Mesh& mesh) { return mesh.info().is_closed != 0; },
          "True if the mesh is a piece of a world and uses each edge equally often in both directions.")
      .def_property_readonly("euler_number", &kerf::Mesh::euler_number,
                             "Vertices - edges + faces, over welded vertices if the mesh is a piece or was "
                             "read from a file.")
      .def_property_readonly(
          "warnings", [](const kerf::Mesh& mesh) { return texts(mesh.warnings()); },
          "Warnings of reading the mesh, such as dropped faces: a list of sentences.")
      .def_static(
          "decode",
          [](const py::bytes& bytes, const py::object& format, const py::object& progress) {
            const auto hint = optional_argument(format, text_argument, "format").value_or("");
            const kerf::CallOptions options = options_argument(progress, 0);
            const std::string_view view = bytes;
            return unlocked([&] { return kerf::Mesh::decode({view.data(), view.size()}, hint, options); });
          },
          py::arg("bytes"), py::arg("format") = py::none(), py::kw_only(), py::arg("progress") = py::none(),
          "Reads a mesh from the bytes of a file, without the files to which they refer.\n\n"
          "format: \"obj\", \"ply\", \"stl\", \"off\", \"glb\", \"gltf\" or \"3mf\", used if the bytes do "
          "not decide.\n"
          "progress: as in World.cut.\n\n"
          "Raises ValueError for bytes that cannot be parsed or have no usable face, or an unknown format, "
          "and Cancelled.")
      .def(
          "encode",
          [](const kerf::Mesh& mesh, const py::object& format) {
            const std::string name = text_argument(format, "format");
            return py::bytes(unlocked([&] { return mesh.encode(name); }));
          },
          py::arg("format"),
          "Returns the bytes that write() writes; format: an extension without the dot, such as \"ply\".\n\n"
          "Raises ValueError for another format, and Error if it cannot store the mesh.")
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
        return text("<kerf.Mesh " + (name.empty() ? "" : "\"" + name + "\" ") + "of " +
                    counted(mesh.faces().size() / 3, "face", "faces") + ">");
      });
  m.def(
      "read",
      [](const py::object& path, const py::object& progress) {
        const std::string file = path_argument(path);
        const kerf::CallOptions options = options_argument(progress, 0);
        return on_file(file, file, [&] { return kerf::Mesh::read(file, options); });
      },
      py::arg("path"), py::kw_only(), py::arg("progress") = py::none(),
      "Reads an OBJ, PLY, STL, OFF, glTF, 3MF or Kerf (.kmesh) file and returns a Mesh.\n\n"
      "progress: as in World.cut.\n\n"
      "Raises FileNotFoundError for a missing file, ValueError for one that cannot be parsed or has no "
      "usable face, and Cancelled.");
}

void add_stroke(py::module_& m) {
  py::class_<kerf::Stroke>(m, "Stroke", "A stroke of the laser.")
      .def(py::init(&make_stroke), py::arg("keys"), py::arg("radius") = py::none(),
           py::arg("range") = py::none(), py::arg("power") = kerf::Stroke().power, py::kw_only(),
           py::arg("wavelength") = py::none(), py::arg("focus") = py::none(),
           py::arg("pulse_rate") = py::none(), py::arg("duty") = kerf::Stroke().duty,
           py::arg("assist") = "none",
           "keys: poses of the beam, (time in s, origin in m, direction of any non-zero length) each.\n"
           "radius: metres, > 0; None: 1/400 of the diagonal of the world.\n"
           "range: (min, max) along the beam in metres; None: from 0 to ten diagonals.\n"
           "power: watts, >= 0, for the thermal model, as are the following arguments.\n"
           "wavelength: metres; None: that of the usual laser for the material.\n"
           "focus: metres along the beam to its waist, > 0; None: the radius is constant.\n"
           "pulse_rate: hertz, > 0; None: a continuous beam.\n"
           "duty: share of each pulse period with the beam on, 0 < duty <= 1.\n"
           "assist: \"none\" or \"oxygen\", the gas.\n\n"
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
      .def_property(
          "wavelength", [](const kerf::Stroke& stroke) { return number_or_none(stroke.wavelength); },
          &set_wavelength, "Metres, > 0; None: that of the usual laser for the material.")
      .def_property(
          "focus", [](const kerf::Stroke& stroke) { return stroke.focus; }, &set_focus,
          "Metres along the beam to its waist, > 0; None: the radius is constant.")
      .def_property(
          "pulse_rate", [](const kerf::Stroke& stroke) { return number_or_none(stroke.pulse_rate); },
          &set_pulse_rate, "Hertz, > 0; None: a continuous beam.")
      .def_property(
          "duty", [](const kerf::Stroke& stroke) { return stroke.duty; }, &set_duty,
          "Share of each pulse period with the beam on, 0 < duty <= 1.")
      .def_property("assist", &assist_of, &set_assist, "The gas, \"none\" or \"oxygen\".")
      .def("__eq__",
           [](const kerf::Stroke& stroke, const py::object& other) {
             return py::isinstance<kerf::Stroke>(other) &&
                    state_of(stroke).equal(state_of(other.cast<const kerf::Stroke&>()));
           })
      .def(py::pickle(&state_of,
                      [](const py::tuple& state) {
                        return make_stroke(state[0], state[1], state[2], state[3], state[4], state[5],
                                           state[6], state[7], state[8]);
                      }))
      .def("__repr__", &text_of);
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
  classes.error = add_exception(m, "Error", "A failed call. It changes nothing, unless stated otherwise.",
                                PyExc_RuntimeError);
  classes.cancelled =
      add_exception(m, "Cancelled", "A call that its progress callback cancelled.", classes.error);
  classes.busy = add_exception(m, "Busy", "A call on a world that another call or a stroke in steps uses.",
                               classes.error);
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
      PyErr_SetObject(PyExc_ValueError, text(fault.what()).ptr());
    } catch (const kerf::Cancelled& fault) {
      PyErr_SetObject(classes.cancelled, text(fault.what()).ptr());
    } catch (const kerf::Busy& fault) {
      PyErr_SetObject(classes.busy, text(fault.what()).ptr());
    } catch (const kerf::Error& fault) {
      PyErr_SetObject(classes.error, text(fault.what()).ptr());
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
  WorldClass world = add_world(m);
  add_queries(m, world);
  add_bodies(m, world);
  add_changes(m, world);
  m.attr("__name__") = "kerf._kerf";
}
