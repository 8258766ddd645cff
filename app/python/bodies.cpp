// Bodies and pieces of World: adding, inspecting and editing them, simulation, undo.
#include <algorithm>
#include <memory>

#include "app/python/arguments.h"
#include "app/python/results.h"

namespace kerf::python {

namespace {

// Longest simulation, and that between checks for Ctrl-C [s]; a whole number of ticks.
constexpr double kMaxSeconds = 3600, kSecondsAtOnce = 0.125;

// A copy of kerf_body_info.
struct BodyInfo {
  std::string name;
  py::object material;
  kerf_body_info values;

  // Calls of other threads that run without the GIL may change the world and free values.name at any time.
  BodyInfo(const World& world, BodyId body) : name(world.name(body)), values(world.info(body)) {
    values.name = nullptr;
    material = values.material == nullptr ? py::object(py::none()) : py::object(py::str(values.material));
  }
};

void add_info(py::module_& m) {
  const auto vector = [](auto member) {
    return [member](const BodyInfo& info) { return numbers(info.values.*member); };
  };
  const auto value = [](auto member) {
    return [member](const BodyInfo& info) { return info.values.*member; };
  };
  const auto flag = [](int kerf_body_info::*member) {
    return [member](const BodyInfo& info) { return info.values.*member != 0; };
  };
  py::class_<BodyInfo>(m, "BodyInfo", "Properties of a body when World.info was called.")
      .def_property_readonly(
          "name", [](const BodyInfo& info) { return text(info.name); }, "Name.")
      .def_readonly("material", &BodyInfo::material, "A name from `kerf materials`; None for any other.")
      .def_property_readonly("position", vector(&kerf_body_info::position), "Shape (3,), metres.")
      .def_property_readonly("orientation", vector(&kerf_body_info::orientation),
                             "Unit quaternion w, x, y, z.")
      .def_property_readonly("velocity", vector(&kerf_body_info::velocity),
                             "Of the point at `position`, shape (3,), m/s.")
      .def_property_readonly("spin", vector(&kerf_body_info::spin), "Shape (3,), rad/s in world axes.")
      .def_property_readonly("thickness", value(&kerf_body_info::thickness), "Of the sheet, metres.")
      .def_property_readonly("density", value(&kerf_body_info::density), "kg/m^3.")
      .def_property_readonly("face_count", value(&kerf_body_info::face_count), "Number of faces.")
      .def_property_readonly("piece_count", value(&kerf_body_info::piece_count), "Number of pieces.")
      .def_property_readonly("is_solid", flag(&kerf_body_info::is_solid), "The faces enclose a volume.")
      .def_property_readonly("is_hidden", flag(&kerf_body_info::is_hidden), "Neither cut nor hit by rays.")
      .def_property_readonly("is_fixed", flag(&kerf_body_info::is_fixed), "Does not move in a simulation.")
      .def_property_readonly("is_asleep", flag(&kerf_body_info::is_asleep),
                             "At rest until something touches it.")
      .def("__repr__", [](const BodyInfo& info) {
        return text("<kerf.BodyInfo \"" + info.name + "\" of " +
                    counted(info.values.face_count, "face", "faces") + ">");
      });
}

double density_argument(const py::object& object) {
  return optional_argument(object, number_argument, "density").value_or(0);
}
std::string material_argument(const py::object& object) {
  return optional_argument(object, text_argument, "material").value_or("");
}
std::array<double, 4> orientation_argument(const py::object& object) {
  if (object.is_none()) return {1, 0, 0, 0};
  return numbers_argument<4>(object, "orientation");
}

BodyId add(World& world, const py::object& mesh, const py::object& name, const py::object& position,
           const py::object& orientation, const py::object& material, const py::object& thickness,
           const py::object& density, bool is_solid, bool is_hidden, bool is_fixed) {
  const Mesh added = mesh_argument(mesh, "mesh");
  BodyDesc desc;
  desc.name = text_argument(name, "name");
  if (!position.is_none()) desc.position = vector_argument(position, "position");
  desc.orientation = orientation_argument(orientation);
  desc.material = material_argument(material);
  desc.thickness = number_argument(thickness, "thickness");
  desc.density = density_argument(density);
  desc.is_solid = is_solid;
  desc.is_hidden = is_hidden;
  desc.is_fixed = is_fixed;
  const CallOptions options = options_argument(py::none(), 0);
  return unlocked([&] { return world.add(added, desc, options); });
}

// A member of World that edits a piece.
template <typename... Values>
auto edit(BodyId (World::*change)(BodyId, uint32_t, Values...)) {
  return [change](World& world, const py::object& body, const py::object& piece, const Values&... values) {
    const BodyId of = body_argument(body);
    const uint32_t label = piece_argument(piece);
    return unlocked([&] { return (world.*change)(of, label, values...); });
  };
}

void join(World& world, const py::object& body, const py::object& kind, const py::object& part_a,
          const py::object& part_b, const py::object& anchor, const py::object& axis,
          const py::object& limits, const py::object& radius) {
  kerf_joint joint = KERF_JOINT_INIT;
  joint.kind = choice_argument<kerf_joint_kind>(
      kind, "kind", {{"weld", KERF_JOINT_WELD}, {"hinge", KERF_JOINT_HINGE}, {"hub", KERF_JOINT_HUB}});
  const auto read = [](const py::object& object, const char* name, double(&to)[3]) {
    std::ranges::copy(vector_argument(object, name), to);
  };
  read(part_a, "part_a", joint.part_a);
  read(part_b, "part_b", joint.part_b);
  read(anchor, "anchor", joint.anchor);
  if (!axis.is_none()) read(axis, "axis", joint.axis);
  if (!limits.is_none()) {
    joint.has_limits = 1;
    std::ranges::copy(range_argument(limits, "limits"), joint.limits);
  }
  if (!radius.is_none()) joint.radius = number_argument(radius, "radius");
  const BodyId of = body_argument(body);
  unlocked([&] { world.join(of, joint); });
}

void add_access(WorldClass& world) {
  world
      .def("add", &add, py::arg("mesh"), py::arg("name") = "mesh", py::kw_only(),
           py::arg("position") = py::none(), py::arg("orientation") = py::none(),
           py::arg("material") = py::none(), py::arg("thickness") = BodyDesc().thickness,
           py::arg("density") = py::none(), py::arg("is_solid") = false, py::arg("is_hidden") = false,
           py::arg("is_fixed") = false,
           "Adds a copy of a mesh as a new body and returns its id. A step of the history.\n\n"
           "mesh: a Mesh, or an object with the attributes vertices and faces, or vertices and triangles.\n"
           "name: without null characters.\n"
           "position: of shape (3,), metres; None: the origin.\n"
           "orientation: unit quaternion w, x, y, z; None: that of the mesh.\n"
           "material: a name from `kerf materials`; None: mild steel.\n"
           "thickness: of the sheet, metres, 1e-9 to 1000.\n"
           "density: kg/m^3, 1e-3 to 1e6; None: that of the material.\n"
           "is_solid: the faces enclose a volume; strokes need a smooth rim and close it by walls.\n"
           "is_hidden: neither cut nor hit by rays.\n"
           "is_fixed: does not move in a simulation.\n\n"
           "Raises TypeError for another object, ValueError for bad arrays or values, and Busy.")
      .def_property_readonly("bodies", &World::bodies, "Ids of all bodies, in the order of their creation.")
      .def(
          "info", [](const World& in, const py::object& body) { return BodyInfo(in, body_argument(body)); },
          py::arg("body"), "Returns the BodyInfo of a body. Raises ValueError if there is none.")
      .def(
          "faces",
          [](const World& in, const py::object& body) {
            const BodyId of = body_argument(body);
            return array_copy(unlocked([&] { return in.faces(of); }));
          },
          py::arg("body"),
          "Returns the indices of the faces of a body, uint32 of shape (n,), ascending. A face keeps its "
          "index until it is removed or its piece becomes another body. Raises ValueError if there is no "
          "such body.")
      .def(
          "corners",
          [](const World& in, const py::object& body, const py::object& faces) {
            const BodyId of = body_argument(body);
            const auto list = indices_argument<uint32_t>(faces, "faces");
            const std::vector<double> corners = unlocked([&] { return in.corners(of, list); });
            const auto n = static_cast<py::ssize_t>(list.size());
            return py::array_t<double>({n, py::ssize_t{3}, py::ssize_t{3}}, corners.data());
          },
          py::arg("body"), py::arg("faces"),
          "Returns the corners of faces in the frame of the body, float64 of shape (n, 3, 3), metres.\n\n"
          "faces: indices of shape (n,).\n\n"
          "Raises ValueError if there is no such body or face.")
      .def(
          "piece_labels",
          [](const World& in, const py::object& body, const py::object& faces) {
            const BodyId of = body_argument(body);
            const auto list = indices_argument<uint32_t>(faces, "faces");
            return array_copy(unlocked([&] { return in.piece_labels(of, list); }));
          },
          py::arg("body"), py::arg("faces"),
          "Returns the label of the piece of each face, uint32 of shape (n,). Arguments and errors are those "
          "of corners. Raises ValueError.")
      .def(
          "piece",
          [](const World& in, const py::object& body, const py::object& piece) {
            const BodyId of = body_argument(body);
            const uint32_t label = piece_argument(piece);
            return unlocked([&] { return in.piece(of, label); });
          },
          py::arg("body"), py::arg("piece"),
          "Returns a piece as a Mesh in world coordinates. Raises ValueError if there is none.");
}

void add_edits(WorldClass& world) {
  const auto body = py::arg("body"), piece = py::arg("piece");
  world
      .def(
          "move",
          [](World& in, const py::object& of, const py::object& label, const py::object& position,
             const py::object& orientation) {
            return edit(&World::move)(in, of, label, vector_argument(position, "position"),
                                      orientation_argument(orientation));
          },
          body, piece, py::arg("position"), py::arg("orientation") = py::none(),
          "Moves a piece and stops its motion. Like the other edits, it is a step of the history; a piece "
          "that is not the only one of its body first becomes a body of its own (see Changes.detached).\n\n"
          "piece: its label; 0 is that of a body that was not cut.\n"
          "position: of shape (3,), metres.\n"
          "orientation: unit quaternion w, x, y, z; None: no rotation.\n\n"
          "Returns the id of its body after the edit. Raises ValueError if there is no such piece or for a "
          "wrong value, and Busy.")
      .def(
          "set_sheet",
          [](World& in, const py::object& of, const py::object& label, const py::object& material,
             const py::object& thickness, const py::object& density) {
            return edit(&World::set_sheet)(in, of, label, material_argument(material),
                                           number_argument(thickness, "thickness"),
                                           density_argument(density));
          },
          body, piece, py::arg("material") = py::none(), py::arg("thickness") = BodyDesc().thickness,
          py::arg("density") = py::none(),
          "Sets material, thickness and density of a piece; arguments as in add, otherwise like move. Raises "
          "ValueError and Busy.")
      .def("set_solid", edit(&World::set_solid), body, piece, py::arg("is_solid"),
           "Sets whether the faces of a piece enclose a volume; otherwise like move. Raises ValueError.")
      .def("set_hidden", edit(&World::set_hidden), body, piece, py::arg("is_hidden"),
           "Hides or shows a piece; otherwise like move. Raises ValueError and Busy.")
      .def("set_fixed", edit(&World::set_fixed), body, piece, py::arg("is_fixed"),
           "Fixes or releases a piece for simulations; otherwise like move. Raises ValueError and Busy.")
      .def(
          "rename",
          [](World& in, const py::object& of, const py::object& label, const py::object& name) {
            in.rename(body_argument(of), piece_argument(label), text_argument(name, "name"));
          },
          body, piece, py::arg("name"), "Renames a piece. Raises ValueError if there is none, and Busy.")
      .def(
          "remove",
          [](World& in, const py::object& of, const py::object& label) {
            in.remove(body_argument(of), piece_argument(label));
          },
          body, piece, "Removes a piece from the world. Raises ValueError if there is none, and Busy.");
}

void add_time(WorldClass& world) {
  world
      .def(
          "join", &join, py::arg("body"), py::arg("kind"), py::arg("part_a"), py::arg("part_b"),
          py::kw_only(), py::arg("anchor"), py::arg("axis") = py::none(), py::arg("limits") = py::none(),
          py::arg("radius") = py::none(),
          "Joins two parts of a body that are not connected, before it is cut or falls apart. A step of the "
          "history.\n\n"
          "kind: \"weld\": the parts move as one; \"hinge\" or \"hub\": they turn about the axis.\n"
          "part_a, part_b: points of shape (3,), metres in the frame of the body; a part is the connected "
          "faces of which one is nearest to its point.\n"
          "anchor: a point of the axis, likewise.\n"
          "axis: direction of shape (3,), of any non-zero length; None: upwards. The first part turns about "
          "it relative to the second one, by the right-hand rule.\n"
          "limits: of a hinge, (lowest, highest) in degrees, -180 to 0 and 0 to 180; None: none.\n"
          "radius: metres; faces of a part carry the joint up to this distance from its point; None: all.\n\n"
          "Raises TypeError for another kind of object, ValueError if the parts cannot be joined, and Busy.")
      .def(
          "set_environment",
          [](World& in, const py::object& gravity, const py::object& ground) {
            std::array<double, 3> pull{0, -9.81, 0};
            if (!gravity.is_none()) pull = vector_argument(gravity, "gravity");
            in.set_environment(pull, optional_argument(ground, number_argument, "ground"));
          },
          py::arg("gravity") = py::none(), py::arg("ground") = py::none(),
          "Sets the environment of simulations.\n\n"
          "gravity: of shape (3,), m/s^2; None: (0, -9.81, 0).\n"
          "ground: height in metres of a plane on which bodies rest; None: there is none.\n\n"
          "Raises ValueError for numbers that are not finite, and Busy.")
      .def(
          "simulate",
          [](World& in, const py::object& seconds) {
            const double time = number_argument(seconds, "seconds");
            const double part = time >= 0 && time <= kMaxSeconds ? kSecondsAtOnce : time;
            for (double left = time;;) {
              unlocked([&] { in.simulate(std::min(left, part)); });
              if (PyErr_CheckSignals() != 0) throw py::error_already_set();
              if (!((left -= part) > 0)) break;
            }
          },
          py::arg("seconds"),
          "Simulates rigid bodies and cooling in ticks of 1/120 s; pieces that were cut off become "
          "bodies.\n\n"
          "seconds: 0 to 3600.\n\n"
          "Raises ValueError for another number, and Busy, also during the simulation. Ctrl-C ends it. In "
          "both "
          "cases the time that has passed remains.")
      .def(
          "undo", [](World& in) { return unlocked([&] { return in.undo(); }); },
          "Undoes the last step of the history: a stroke, an added body, an edit, or the simulation since "
          "the "
          "last other step. Returns False if there is none. Raises Error if it is no longer stored.")
      .def(
          "redo", [](World& in) { return unlocked([&] { return in.redo(); }); },
          "Redoes the step undone last. Returns False if there is none. Raises Busy.")
      .def(
          "set_undo_memory",
          [](World& in, const py::object& bytes) { in.set_undo_memory(index_argument(bytes, "bytes")); },
          py::arg("bytes"),
          "Limits the memory for undo, 256 MiB by default; the oldest steps are discarded first. Raises "
          "ValueError for a negative number.");
}

}  // namespace

void add_bodies(py::module_& m, WorldClass& world) {
  add_info(m);
  add_access(world);
  add_edits(world);
  add_time(world);
}

}  // namespace kerf::python
