// The class World: cuts, also in steps, pieces, files and reports.
#include <cmath>
#include <limits>
#include <memory>

#include "app/python/arguments.h"
#include "app/python/results.h"

namespace kerf::python {

namespace {

// Parses the JSON text that `make` returns; it runs with the GIL released.
template <typename Make>
py::object object_of(Make make) {
  return py::module_::import("json").attr("loads")(unlocked(make));
}

CutSettings settings_of(const py::object& target_edge, const py::object& tolerance,
                        const py::object& max_level, const py::object& rim, const py::object& scheme,
                        const py::object& model, const py::object& material, const py::object& bodies) {
  CutSettings settings;
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
  if (bodies.is_none()) return settings;
  settings.bodies = indices_argument<BodyId>(bodies, "bodies");
  if (settings.bodies.empty())
    throw py::value_error("bodies: must not be empty; None cuts all visible bodies");
  return settings;
}

// Adds the members that results of cuts and of steps have.
template <typename Result>
py::dict dict_of(const Result& result) {
  py::dict dict;
  dict["removed_faces"] = result.removed_faces;
  dict["removed_area"] = result.removed_area;
  dict["seconds"] = result.seconds;
  dict["emitted"] = result.emitted;
  dict["absorbed"] = result.absorbed;
  dict["depth"] = result.depth;
  return dict;
}

py::dict cut(World& world, const py::object& strokes, const py::object& target_edge,
             const py::object& tolerance, const py::object& max_level, const py::object& rim,
             const py::object& scheme, const py::object& model, const py::object& material,
             const py::object& bodies, const py::object& progress, const py::object& threads) {
  const std::vector<Stroke> list = strokes_argument(strokes);
  const CutSettings settings =
      settings_of(target_edge, tolerance, max_level, rim, scheme, model, material, bodies);
  const CallOptions options =
      options_argument(progress, static_cast<unsigned>(int_argument(threads, "threads")));
  return dict_of(unlocked([&] { return world.cut(list, settings, options); }));
}

void cut_plane(World& world, const py::object& normal, const py::object& offset, const py::object& progress,
               const py::object& threads) {
  const std::array<double, 3> vector = vector_argument(normal, "normal");
  const double distance = number_argument(offset, "offset");
  const CallOptions options =
      options_argument(progress, static_cast<unsigned>(int_argument(threads, "threads")));
  unlocked([&] { world.cut_plane(vector, distance, options); });
}

void begin_stroke(World& world, const py::object& stroke, const py::object& target_edge,
                  const py::object& tolerance, const py::object& max_level, const py::object& rim,
                  const py::object& scheme, const py::object& model, const py::object& bodies) {
  const Stroke begun = instance_argument<Stroke>(stroke, "stroke", "kerf.Stroke");
  const CutSettings settings =
      settings_of(target_edge, tolerance, max_level, rim, scheme, model, py::none(), bodies);
  unlocked([&] { world.begin_stroke(begun, settings); });
}

py::dict step_stroke(World& world, const py::object& max_faces, const py::object& max_seconds) {
  size_t faces = std::numeric_limits<size_t>::max();
  if (const auto limit = optional_argument(max_faces, int_argument, "max_faces")) {
    if (*limit < 0) throw py::value_error("max_faces: must not be negative");
    faces = static_cast<size_t>(*limit);
  }
  const double seconds = optional_argument(max_seconds, number_argument, "max_seconds").value_or(HUGE_VAL);
  const StrokeProgress progress = unlocked([&] { return world.step_stroke(faces, seconds); });
  py::dict dict = dict_of(progress);
  dict["faces"] = progress.faces;
  dict["waiting"] = progress.waiting;
  dict["is_idle"] = progress.is_idle != 0;
  dict["is_finished"] = progress.is_finished != 0;
  return dict;
}

void add_cuts(WorldClass& world) {
  world
      .def("cut", &cut, py::arg("strokes"), py::kw_only(), py::arg("target_edge") = py::none(),
           py::arg("tolerance") = py::none(), py::arg("max_level") = py::none(), py::arg("rim") = "faces",
           py::arg("scheme") = "longest-edge", py::arg("model") = "geometric",
           py::arg("material") = py::none(), py::arg("bodies") = py::none(), py::arg("progress") = py::none(),
           py::arg("threads") = 0,
           "Cuts bodies with strokes, in order, all or nothing.\n\n"
           "strokes: a Stroke or an iterable of them.\n"
           "target_edge: longest edge under the beam in metres; None: a quarter of the radius, or the radius "
           "with the thermal model.\n"
           "tolerance: instead, maximum overshoot of removed faces beyond the beam, in metres.\n"
           "max_level: instead, the maximum refinement level, 0 to 24.\n"
           "rim: \"faces\" removes every face that the beam touches, \"smooth\" cuts faces along the beam; "
           "solids need a smooth one and the geometric model.\n"
           "scheme: \"longest-edge\" or \"one-to-four\", the subdivision of faces.\n"
           "model: \"geometric\" removes faces immediately, \"thermal\" when they have absorbed enough "
           "energy.\n"
           "material: new material of all bodies, a name from `kerf materials`; None: unchanged.\n"
           "bodies: ids of the only bodies to cut; None: all visible ones.\n"
           "progress: called with the completed fraction, 0 to 1, at most fifty times a second; returns "
           "False to stop.\n"
           "threads: maximum number of threads, 0 to 1024; 0: one per processor.\n\n"
           "Returns a dict of removed_faces, removed_area (m^2) and seconds; and for the thermal model, else "
           "0, the energies emitted and absorbed (J) and depth, the mean depth under the beam, 0 to 1.\n\n"
           "Raises TypeError or ValueError for a wrong argument, ValueError if the world has no mesh or a "
           "solid would stay open, Cancelled, Busy, and Error if a body would get too many faces. A failed "
           "cut changes nothing.")
      .def("cut_plane", &cut_plane, py::arg("normal"), py::arg("offset"), py::kw_only(),
           py::arg("progress") = py::none(), py::arg("threads") = 0,
           "Cuts all visible bodies along a plane by a knife of no width, which removes nothing; both sides "
           "of solids are closed.\n\n"
           "normal: of any length but 0.\n"
           "offset: the plane contains the points x with normal . x = offset, in metres for a unit normal.\n"
           "progress, threads: as in cut.\n\n"
           "Raises TypeError or ValueError for a wrong argument, Cancelled, Busy, and Error if a body would "
           "get too many faces. A failed cut changes nothing.")
      .def("begin_stroke", &begin_stroke, py::arg("stroke"), py::kw_only(),
           py::arg("target_edge") = py::none(), py::arg("tolerance") = py::none(),
           py::arg("max_level") = py::none(), py::arg("rim") = "faces", py::arg("scheme") = "longest-edge",
           py::arg("model") = "geometric", py::arg("bodies") = py::none(),
           "Begins a stroke that is cut in steps: add_pose as the beam moves, step_stroke in each frame, "
           "end_stroke, and steps until it is finished. The result equals that of cut, however the work is "
           "divided. Between steps the world can be read; calls that change it otherwise raise Busy.\n\n"
           "stroke: its keys are the known part of the path. The other arguments are those of cut.\n\n"
           "Raises what cut raises, and Busy if another stroke is not finished.")
      .def(
          "add_pose",
          [](World& in, const py::object& time, const py::object& origin, const py::object& direction) {
            const Keyframe key = key_argument(time, origin, direction, "key");
            unlocked([&] { in.add_pose(key); });
          },
          py::arg("time"), py::arg("origin"), py::arg("direction"),
          "Appends a pose to the path of the stroke.\n\n"
          "time: seconds, at least that of the pose before.\n"
          "origin, direction: of shape (3,), metres; the direction of any non-zero length.\n\n"
          "Raises ValueError for a wrong pose, or if there is no stroke or it was ended.")
      .def(
          "step_stroke", &step_stroke, py::arg("max_faces") = py::none(), py::arg("max_seconds") = py::none(),
          "Executes a part of the stroke: at least one unit of work, mostly below 0.4 ms.\n\n"
          "max_faces: target for the faces created and removed; None: no limit.\n"
          "max_seconds: target for the duration in seconds; None: no limit.\n\n"
          "Returns a dict of is_idle (all work known so far is done), is_finished, faces and seconds of this "
          "step, waiting (moves to execute); and since the stroke began the other values that cut "
          "returns.\n\n"
          "Raises ValueError for a negative number, or if there is no stroke; Error, and cancels the "
          "stroke, if a body would get too many faces.")
      .def(
          "end_stroke", [](World& in) { in.end_stroke(); },
          "Ends the path of the stroke; the rest of its work remains for step_stroke. Raises ValueError if "
          "there is no stroke or it was ended.")
      .def(
          "cancel_stroke", [](World& in) { unlocked([&] { in.cancel_stroke(); }); },
          "Cancels the stroke: restores the world before it, to the bit. Steps that were undone before it "
          "can no longer be redone. Raises ValueError if there is none.");
}

void add_files(WorldClass& world) {
  world
      .def(
          "save_scene",
          [](const World& of, const py::object& folder) {
            const std::string to = path_argument(folder);
            unlocked([&] { of.save_scene(to); });
          },
          py::arg("folder"),
          "Writes the visible bodies and a scene.json that the editor opens: OBJ files, or Kerf meshes "
          "(.kmesh) for bodies with attributes or described materials. Does not write temperatures, joints, "
          "motion, the environment, whether bodies are fixed, and the names of pieces that share a body. The "
          "folder is created if missing.\n\n"
          "Raises ValueError if no face is visible, and Error if a file cannot be written.")
      .def(
          "save_journal",
          [](const World& of, const py::object& path) {
            const std::string file = path_argument(path);
            on_file(file, folder_of(file), [&] { of.save_journal(file); });
          },
          py::arg("path"),
          "Writes the journal (.kerf) of the cuts, and the added meshes next to it.\n\n"
          "Raises FileNotFoundError if the folder is missing, ValueError if the world has no mesh or was "
          "simulated before it had one, and Error if a file cannot be written.")
      .def(
          "report", [](const World& of) { return object_of([&] { return of.report(); }); },
          "Returns a report of all cuts, with the keys of the report.json of `kerf cut`.")
      .def(
          "graph", [](const World& of) { return object_of([&] { return of.graph(); }); },
          "Returns the component graph of the faces, as written by `kerf inspect --graph`.")
      .def_property_readonly(
          "hash", [](const World& of) { return unlocked([&] { return of.hash(); }); },
          "Hash of the state, 16 hexadecimal digits; equal to that of `kerf cut` for the same meshes and "
          "strokes.");
}

}  // namespace

WorldClass add_world(py::module_& m) {
  WorldClass world(m, "World", "The bodies that a laser cuts.");
  world.def(py::init<>(), "Creates an empty world.")
      .def_static(
          "open",
          [](const py::object& path, const py::object& progress) {
            const std::string file = path_argument(path);
            const CallOptions options = options_argument(progress, 0);
            return on_file(file, file, [&] { return std::make_unique<World>(file, options); });
          },
          py::arg("path"), py::kw_only(), py::arg("progress") = py::none(),
          "Opens a scene (.json), a journal (.kerf), whose commands are replayed, or a mesh.\n\n"
          "progress: as in cut.\n\n"
          "Raises FileNotFoundError for a missing file, ValueError for a wrong one, Cancelled, and Error if "
          "the strokes of a scene would make more faces than the memory holds.")
      .def_property_readonly(
          "pieces",
          [](const World& of) {
            const CallOptions options = options_argument(py::none(), 0);
            return unlocked([&] { return of.pieces(options); });
          },
          "The pieces of all bodies as meshes in world coordinates, largest area first. Raises Busy.");
  add_cuts(world);
  add_files(world);
  return world;
}

}  // namespace kerf::python
