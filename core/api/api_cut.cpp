#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <locale>
#include <sstream>

#include "core/api/api_internal.h"
#include "core/base/geometry.h"
#include "core/base/platform.h"
#include "core/document/command_queue.h"
#include "core/document/document.h"
#include "core/document/material_table.h"
#include "core/document/stroke_path.h"

namespace kerf {

namespace {

bool are_finite(const double* numbers, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    if (!std::isfinite(numbers[i])) return false;
  }
  return true;
}

Status add_key(const kerf_keyframe& key, const std::string& where, StrokePath& path) {
  if (!are_finite(&key.time, 1) || !are_finite(key.origin, 3) || !are_finite(key.direction, 3))
    return bad_input(where + ": its numbers must be finite");
  const Vec3 direction(key.direction[0], key.direction[1], key.direction[2]);
  if (direction == Vec3(0)) return bad_input(where + ": the direction must not be zero");
  const Pose pose{{key.origin[0], key.origin[1], key.origin[2]}, beam_direction(direction)};
  if (!path.keys.empty() && key.time < path.times.back())
    return bad_input(where + ": the time must not be less than that of the previous key");
  if (!path.keys.empty() && are_opposite(pose.direction, path.keys.back().direction))
    return bad_input(where +
                     ": the direction is opposite to that of the previous key; add a key between them");
  path.keys.push_back(pose);
  path.times.push_back(key.time);
  return Done{};
}

Result<StrokePath> path_of(const kerf_stroke& stroke, size_t number) {
  const std::string where = "strokes: number " + std::to_string(number);
  if (stroke.keys == nullptr || stroke.key_count == 0) return bad_input(where + " has no key");
  StrokePath path;
  for (size_t i = 0; i < stroke.key_count; ++i) {
    const Status added = add_key(stroke.keys[i], where + ", key " + std::to_string(i), path);
    if (!added) return added.error();
  }
  if (!are_finite(&stroke.radius, 1) || stroke.radius < 0)
    return bad_input(where + ": the radius must be a length in metres, or 0");
  if (!are_finite(stroke.range, 2) || stroke.range[0] < 0 || stroke.range[1] < stroke.range[0])
    return bad_input(where + ": the range must be two lengths in metres, 0 <= min <= max");
  if (!are_finite(&stroke.power, 1) || stroke.power < 0)
    return bad_input(where + ": the power must be a number of watts, or 0");
  if (stroke.radius > 0) path.radius = stroke.radius;
  if (stroke.range[1] > 0) path.range = Interval{stroke.range[0], stroke.range[1]};
  if (stroke.power > 0) path.power = stroke.power;
  return path;
}

// Returns the integer value of an enumeration field; C callers may store any integer in it.
template <typename Enum>
int number_in(const Enum& field) {
  static_assert(sizeof(Enum) == sizeof(int));
  int number = 0;
  std::memcpy(&number, &field, sizeof number);
  return number;
}

bool is_either(int number, int first, int second) { return number == first || number == second; }

Status check(const kerf_cut_settings& s) {
  const auto is_length = [](double x) { return std::isfinite(x) && x >= 0; };
  if (!is_length(s.target_edge))
    return bad_input("target_edge: must be a length in metres greater than zero");
  if (!is_length(s.tolerance)) return bad_input("tolerance: must be a length in metres greater than zero");
  if (s.max_level < -1 || s.max_level > Resolution::kMaxDepth)
    return bad_input("max_level: must be from 0 to " + std::to_string(Resolution::kMaxDepth));
  if ((s.target_edge > 0) + (s.tolerance > 0) + (s.max_level != 0) > 1)
    return bad_input("target_edge, tolerance and max_level: set only one of them");
  if (!is_either(number_in(s.rim), KERF_RIM_FACES, KERF_RIM_SMOOTH))
    return bad_input("rim: must be faces or smooth");
  if (!is_either(number_in(s.scheme), KERF_SCHEME_LONGEST_EDGE, KERF_SCHEME_ONE_TO_FOUR))
    return bad_input("scheme: must be longest-edge or one-to-four");
  if (!is_either(number_in(s.model), KERF_MODEL_GEOMETRIC, KERF_MODEL_THERMAL))
    return bad_input("model: must be geometric or thermal");
  return Done{};
}

CutSettings settings_of(const kerf_cut_settings& s, const StrokePath& stroke, double diagonal) {
  CutSettings settings = default_settings(stroke, diagonal);
  if (s.model == KERF_MODEL_THERMAL) settings.model = Model::kThermal;
  Resolution& resolution = settings.resolution;
  resolution.rim = s.rim == KERF_RIM_SMOOTH ? Rim::kSmooth : Rim::kFaces;
  resolution.scheme = s.scheme == KERF_SCHEME_ONE_TO_FOUR ? Scheme::kOneToFour : Scheme::kLongestEdge;
  const double radius = settings.laser.radius;
  resolution.target_edge = settings.model == Model::kThermal ? radius : radius / 4;
  resolution.tolerance = radius / 8;
  if (s.target_edge > 0) resolution.target_edge = s.target_edge;
  if (s.tolerance > 0) resolution.tolerance = s.tolerance;
  if (s.tolerance > 0) resolution.rule = Resolution::Rule::kTolerance;
  if (s.max_level != 0) resolution.depth = std::max(s.max_level, 0);
  if (s.max_level != 0) resolution.rule = Resolution::Rule::kDepth;
  return settings;
}

Result<Substance> substance_named(const std::string& name) {
  const auto materials = load_materials(assets_folder() / "materials.json");
  if (!materials) return materials.error();
  if (const Material* material = find_material(*materials, name)) return material->substance;
  std::string names;
  for (const Material& material : *materials) names += (names.empty() ? "" : ", ") + material.name;
  return bad_input("material: \"" + name + "\" is unknown; use one of: " + names);
}

bool has_substance(const World& world, const Substance& substance) {
  return std::ranges::all_of(world.ids(),
                             [&](BodyId id) { return world.body(id).sheet.substance == substance; });
}

// Returns the same world with a new material of all bodies.
Document of_material(const Document& document, const Substance& substance) {
  World world = document.world();
  for (const BodyId id : world.ids()) {
    world.body(id).sheet.substance = substance;
    world.body(id).sheet.density = substance.density;
  }
  return Document(std::move(world));
}

// Returns an error if lengths derived from the size of the world, or from the radius, are unusable.
Status check_usable(const CutSettings& s, size_t number, double diagonal) {
  const auto is_usable = [](double length) { return std::isfinite(length) && length > 0; };
  const std::string where = "strokes: number " + std::to_string(number);
  if (!is_usable(s.laser.radius) || !std::isfinite(s.laser.range.high)) {
    std::ostringstream size;
    size.imbue(std::locale::classic());
    size << diagonal;
    return bad_input(where + ": the world is " + size.str() +
                     " m across, too small or large for the default radius and range; set both");
  }
  if (!is_usable(s.resolution.target_edge) || !is_usable(s.resolution.tolerance))
    return bad_input(where + ": the radius is too small");
  return Done{};
}

// Returns the commands of each stroke.
Result<std::vector<std::vector<Command>>> commands_of(std::span<const kerf_stroke> strokes,
                                                      const kerf_cut_settings& settings, double diagonal) {
  std::vector<std::vector<Command>> commands;
  for (size_t i = 0; i < strokes.size(); ++i) {
    const auto path = path_of(strokes[i], i);
    if (!path) return path.error();
    const CutSettings own = settings_of(settings, *path, diagonal);
    if (const Status usable = check_usable(own, i, diagonal); !usable) return usable.error();
    commands.push_back(stroke_commands(*path, own));
  }
  return commands;
}

Status cut_one(Document& document, std::span<const Command> stroke, const Progress& progress, CutJob& job) {
  using Clock = std::chrono::steady_clock;
  job.begin_stroke();
  for (const Command& command : stroke) {
    document.apply(command);
    job.steps += std::holds_alternative<MoveBeam>(command);
  }
  auto began = Clock::now();
  QueueRun how;
  how.progress = &progress;
  how.told = [&](const Result<StepResult>& step) -> Status {
    if (!step) return step.error();
    job.record_step(*step, document.world(), std::chrono::duration<double>(Clock::now() - began).count());
    began = Clock::now();
    return Done{};
  };
  const Status cut = run_queue(document, how);
  if (cut) job.end_stroke();
  return cut;
}

// Executes all strokes or none.
Status cut_each(Document& document, std::span<const std::vector<Command>> strokes, const Progress& progress,
                CutJob& job) {
  const size_t position = document.history().position();
  const double share = 1 / static_cast<double>(std::max<size_t>(strokes.size(), 1));
  for (size_t i = 0; i < strokes.size(); ++i) {
    const double done = share * static_cast<double>(i);
    const Progress own = share_of(&progress, done, std::min(1.0, done + share));
    const Status cut = cut_one(document, strokes[i], own, job);
    if (cut) continue;
    const Outcome back = document.travel(position);
    return back.ok() ? cut : back.error();
  }
  return Done{};
}

// Executes all strokes or none, and keeps before-images for as long as they may be needed.
Status cut_all(Document& document, std::span<const std::vector<Command>> strokes, const Progress& progress,
               CutJob& job) {
  document.set_window(std::numeric_limits<size_t>::max());
  document.set_face_budget(usual_face_budget(machine_memory()));
  const Status done = cut_each(document, strokes, progress, job);
  document.set_window(0);
  return done;
}

// Returns the job, with the properties of the input filled in before its first cut.
CutJob begun(const kerf_world& world, const kerf_cut_settings& settings) {
  CutJob job = world.job;
  if (world.settings.is_null()) job.input_min_angle = smallest_angle(world.document.world());
  job.thermal = job.thermal || settings.model == KERF_MODEL_THERMAL;
  return job;
}

nlohmann::ordered_json settings_of_first(const std::vector<std::vector<Command>>& commands) {
  for (const std::vector<Command>& stroke : commands) {
    if (const auto* begin = std::get_if<BeginStroke>(&stroke.front()))
      return settings_json(begin->settings, "", false);
  }
  return nullptr;
}

Status cut(kerf_world& world, std::span<const kerf_stroke> strokes, const kerf_cut_settings& settings,
           const Progress& progress, CutJob& job) {
  if (const Status valid = check(settings); !valid) return valid;
  Document& document = world.document;
  if (!world.bounds && !strokes.empty()) return bad_input("the world has no mesh; add one before a cut");
  const double diagonal = world.bounds ? world.bounds->diagonal() : 0;
  const auto commands = commands_of(strokes, settings, diagonal);
  if (!commands) return commands.error();
  job = begun(world, settings);
  std::optional<Document> other;
  std::optional<Substance> substance;
  if (settings.material != nullptr) {
    const auto named = substance_named(settings.material);
    if (!named) return named.error();
    if (!has_substance(document.world(), *named)) substance = *named;
    if (substance) other = of_material(document, *substance);
  }
  if (const Status done = cut_all(other ? *other : document, *commands, progress, job); !done) return done;
  if (world.settings.is_null()) world.settings = settings_of_first(*commands);
  if (!other) return Done{};
  if (!document.journal().empty()) world.initial_state.mark_unrecorded();
  world.initial_state.set_substance(*substance);
  document = std::move(*other);
  return Done{};
}

}  // namespace
}  // namespace kerf

kerf_result kerf_world_cut(kerf_world* world, const kerf_stroke* strokes, size_t stroke_count,
                           const kerf_cut_settings* settings, const kerf_call_options* options,
                           kerf_cut_result* result) {
  if (strokes == nullptr && stroke_count > 0)
    return kerf::set_error(KERF_INVALID_ARGUMENT, "strokes: must not be null");
  const auto begin = std::chrono::steady_clock::now();
  kerf_cut_result done{};
  const kerf_result how =
      kerf::change_world(world, options, [&](const kerf::Progress& progress) -> kerf::Status {
        kerf::CutJob job;
        const kerf::Status cut =
            kerf::cut(*world, {strokes, stroke_count}, settings == nullptr ? kerf_cut_settings{} : *settings,
                      progress, job);
        if (!cut) return cut;
        done = {job.removed_faces - world->job.removed_faces, job.removed_area - world->job.removed_area, 0};
        world->job = std::move(job);
        return cut;
      });
  if (how != KERF_OK || result == nullptr) return how;
  *result = done;
  result->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return how;
}
