#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <exception>
#include <iterator>
#include <limits>
#include <locale>
#include <sstream>

#include "core/api/api_internal.h"
#include "core/base/geometry.h"
#include "core/base/platform.h"
#include "core/document/command_queue.h"
#include "core/document/document.h"
#include "core/document/stroke_path.h"

namespace kerf {

namespace {

bool are_finite(const double* numbers, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    if (!std::isfinite(numbers[i])) return false;
  }
  return true;
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

}  // namespace

Status add_key(const kerf_keyframe& key, const std::string& where, StrokePath& path) {
  if (!are_finite(&key.time, 1) || !are_finite(key.origin, 3) || !are_finite(key.direction, 3))
    return bad_input(where + ": its numbers must be finite");
  const Vec3 direction(key.direction[0], key.direction[1], key.direction[2]);
  if (direction == Vec3(0)) return bad_input(where + ": the direction must not be zero");
  const Pose pose{{key.origin[0], key.origin[1], key.origin[2]}, beam_direction(direction)};
  if (!path.keys.empty() && key.time < path.times.back())
    return bad_input(where + ": the time must not be less than that of the previous key");
  if (!path.keys.empty() && !std::isfinite(key.time - path.times.front()))
    return bad_input(where + ": the time is too far from that of the first key");
  if (!path.keys.empty() && are_opposite(pose.direction, path.keys.back().direction))
    return bad_input(where +
                     ": the direction is opposite to that of the previous key; add a key between them");
  path.keys.push_back(pose);
  path.times.push_back(key.time);
  return Done{};
}

namespace {

Status check_laser(const kerf_stroke& stroke, const std::string& where) {
  const auto is_not_negative = [](double x) { return std::isfinite(x) && x >= 0; };
  if (!is_not_negative(stroke.radius))
    return bad_input(where + ": the radius must be a finite length in metres >= 0");
  if (!is_not_negative(stroke.range[0]) || !is_not_negative(stroke.range[1]) ||
      stroke.range[1] < stroke.range[0])
    return bad_input(where + ": the range must be two lengths in metres, 0 <= min <= max");
  if (!is_not_negative(stroke.power))
    return bad_input(where + ": the power must be a finite number of watts >= 0");
  if (!is_not_negative(stroke.wavelength))
    return bad_input(where + ": the wavelength must be a finite length in metres >= 0");
  if (!(stroke.focus > 0))
    return bad_input(where + ": the focus must be a length in metres greater than zero, or infinity");
  if (!is_not_negative(stroke.pulse_rate))
    return bad_input(where + ": the pulse rate must be a finite number of Hz >= 0");
  if (!(stroke.duty > 0 && stroke.duty <= 1))
    return bad_input(where + ": the duty must be greater than 0 and at most 1");
  if (!is_either(number_in(stroke.assist), KERF_ASSIST_NONE, KERF_ASSIST_OXYGEN))
    return bad_input(where + ": the assist gas must be none or oxygen");
  return Done{};
}

Result<StrokePath> path_of(const kerf_stroke& stroke, size_t number) {
  const std::string where = "strokes[" + std::to_string(number) + "]";
  if (stroke.keys == nullptr || stroke.key_count == 0) return bad_input(where + " has no key");
  StrokePath path;
  for (size_t i = 0; i < stroke.key_count; ++i) {
    const Status added = add_key(stroke.keys[i], where + ".keys[" + std::to_string(i) + "]", path);
    if (!added) return added.error();
  }
  if (const Status valid = check_laser(stroke, where); !valid) return valid.error();
  if (stroke.radius > 0) path.radius = stroke.radius;
  if (stroke.range[1] > 0) path.range = Interval{stroke.range[0], stroke.range[1]};
  path.power = positive(stroke.power);  // which a journal can store
  path.wavelength = stroke.wavelength;
  if (std::isfinite(stroke.focus)) path.focus = stroke.focus;
  path.pulse_rate = stroke.pulse_rate;
  path.duty = stroke.duty;
  return path;
}

Status check(const kerf_cut_settings& s) {
  const auto is_length = [](double x) { return std::isfinite(x) && x > 0; };
  const int rule = number_in(s.resolution);
  if (rule < KERF_RESOLUTION_DEFAULT || rule > KERF_RESOLUTION_LEVEL)
    return bad_input("resolution: must be default, edge, tolerance or level");
  if (rule == KERF_RESOLUTION_EDGE && !is_length(s.target_edge))
    return bad_input("target_edge: must be a length in metres greater than zero");
  if (rule == KERF_RESOLUTION_TOLERANCE && !is_length(s.tolerance))
    return bad_input("tolerance: must be a length in metres greater than zero");
  if (rule == KERF_RESOLUTION_LEVEL && (s.max_level < 0 || s.max_level > Resolution::kMaxDepth))
    return bad_input("max_level: must be from 0 to " + std::to_string(Resolution::kMaxDepth));
  if (!is_either(number_in(s.rim), KERF_RIM_FACES, KERF_RIM_SMOOTH))
    return bad_input("rim: must be faces or smooth");
  if (!is_either(number_in(s.scheme), KERF_SCHEME_LONGEST_EDGE, KERF_SCHEME_ONE_TO_FOUR))
    return bad_input("scheme: must be longest-edge or one-to-four");
  if (!is_either(number_in(s.model), KERF_MODEL_GEOMETRIC, KERF_MODEL_THERMAL))
    return bad_input("model: must be geometric or thermal");
  return Done{};
}

CutSettings settings_of(const kerf_cut_settings& s, const StrokePath& stroke, kerf_assist assist,
                        double diagonal) {
  CutSettings settings = default_settings(stroke, diagonal);
  for (size_t i = 0; i < s.body_count; ++i) settings.bodies.push_back(from_api(s.bodies[i]));
  if (assist == KERF_ASSIST_OXYGEN) settings.laser.assist = Assist::kOxygen;
  if (s.model == KERF_MODEL_THERMAL) settings.model = Model::kThermal;
  Resolution& resolution = settings.resolution;
  resolution.rim = s.rim == KERF_RIM_SMOOTH ? Rim::kSmooth : Rim::kFaces;
  resolution.scheme = s.scheme == KERF_SCHEME_ONE_TO_FOUR ? Scheme::kOneToFour : Scheme::kLongestEdge;
  const double radius = settings.laser.radius;
  resolution.target_edge = settings.model == Model::kThermal ? radius : radius / 4;
  resolution.tolerance = radius / 8;
  switch (s.resolution) {
    case KERF_RESOLUTION_DEFAULT:
      break;
    case KERF_RESOLUTION_EDGE:
      resolution.target_edge = s.target_edge;
      break;
    case KERF_RESOLUTION_TOLERANCE:
      resolution.tolerance = s.tolerance;
      resolution.rule = Resolution::Rule::kTolerance;
      break;
    case KERF_RESOLUTION_LEVEL:
      resolution.depth = s.max_level;
      resolution.rule = Resolution::Rule::kDepth;
      break;
  }
  return settings;
}

// Returns an error if lengths derived from the size of the world, or from the radius, are unusable.
Status check_usable(const CutSettings& s, size_t number, double diagonal) {
  const auto is_usable = [](double length) { return std::isfinite(length) && length > 0; };
  const std::string where = "strokes[" + std::to_string(number) + "]";
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

// Fails if a solid that would be cut with these settings would stay open.
Status check_walls(const World& world, const CutSettings& settings) {
  const WallNeed need = settings.unmet_wall_need();
  if (need == WallNeed::kNone) return Done{};
  for (const BodyId id : cuttable(world, settings)) {
    if (!world.body(id).solid) continue;
    const std::string where = need == WallNeed::kGeometricModel ? "model" : "rim";
    return bad_input(where + ": the body \"" + world.body(id).own_name() + "\" is solid, and its " +
                     label(need) + "; set that, or make the body a sheet");
  }
  return Done{};
}

}  // namespace

Result<std::vector<StrokeCommands>> stroke_commands_of(const kerf_world& world, const kerf_stroke* strokes,
                                                       size_t count, const kerf_cut_settings& settings) {
  const bool has_mesh = world.bounds && !world.document.world().ids().empty();
  if (!has_mesh && count > 0) return bad_input("the world has no mesh; add one before a cut");
  if (settings.bodies != nullptr && settings.body_count == 0)
    return bad_input("bodies: must not be an empty list; null cuts all visible bodies");
  for (size_t i = 0; i < settings.body_count; ++i) {
    const auto body = body_of(world.document.world(), settings.bodies[i]);
    if (!body) return body.error();
  }
  const double diagonal = world.bounds ? world.bounds->diagonal() : 0;
  std::vector<StrokeCommands> all;
  const auto* next = reinterpret_cast<const std::byte*>(strokes);
  for (size_t i = 0; i < count; ++i) {
    const auto* given = reinterpret_cast<const kerf_stroke*>(next);
    const auto stroke = read_struct(given, KERF_STROKE_INIT, "strokes");
    if (!stroke) return stroke.error();
    next += given->size;
    auto path = path_of(*stroke, i);
    if (!path) return path.error();
    const CutSettings own = settings_of(settings, *path, stroke->assist, diagonal);
    if (const Status usable = check_usable(own, i, diagonal); !usable) return usable.error();
    if (const Status walls = check_walls(world.document.world(), own); !walls) return walls.error();
    std::vector<Command> commands = stroke_commands(*path, own);
    all.push_back({std::move(*path), std::move(commands)});
  }
  return all;
}

Result<kerf_cut_settings> read_settings(const kerf_cut_settings* given) {
  auto settings = read_struct(given, KERF_CUT_SETTINGS_INIT, "settings");
  if (!settings) return settings;
  if (settings->bodies == nullptr) settings->body_count = 0;
  if (const Status valid = check(*settings); !valid) return valid.error();
  return settings;
}

void begin_job(kerf_world& world, const Command& first) {
  if (world.settings.is_null()) {
    world.job.input_min_angle = smallest_angle(world.document.world());
    world.settings = settings_json(std::get<BeginStroke>(first).settings, "", false);
  }
  world.job.thermal |= std::get<BeginStroke>(first).settings.model == Model::kThermal;
}

ThermalTotals::ThermalTotals(const kerf_world& world)
    : emitted_(world.document.world().energy().emitted),
      absorbed_(world.document.world().energy().absorbed),
      met_s_(world.job.statistics.met_s),
      depth_s_(world.job.statistics.depth_s) {}

namespace {

Status cut_one(kerf_world& world, std::span<const Command> stroke, const Progress& progress) {
  using Clock = std::chrono::steady_clock;
  Document& document = world.document;
  world.job.begin_stroke();
  for (const Command& command : stroke) {
    document.apply(command);
    world.job.steps += std::holds_alternative<MoveBeam>(command);
  }
  auto began = Clock::now();
  QueueRun how;
  how.progress = &progress;
  how.told = [&](const Result<StepResult>& step) -> Status {
    if (!step) return step.error();
    world.changes.record(document.world(), step->delta);
    world.job.record_step(*step, document.world(),
                          std::chrono::duration<double>(Clock::now() - began).count());
    began = Clock::now();
    return Done{};
  };
  const Status cut = run_queue(document, how);
  if (cut) world.job.end_stroke();
  if (cut) world.keep();
  return cut;
}

// Sets the material of all pieces. Returns the changes.
Result<Delta> set_material(kerf_world& world, const Substance& substance, const Progress& progress) {
  std::vector<SetSheetProperties> edits;
  for (const BodyId id : world.document.world().ids()) {
    const Body& body = world.document.world().body(id);
    if (body.sheet.substance == substance) continue;
    for (uint32_t label = 0; label < body.pieces.size(); ++label) {
      if (body.pieces[label].faces > 0)
        edits.push_back({{id, label}, {body.sheet.thickness, substance.density, substance}});
    }
  }
  Delta all;
  for (SetSheetProperties& edit : edits) {
    edit.piece = id_after(all, edit.piece);
    auto delta = apply_edit(world, edit, progress);
    if (!delta) return delta.error();
    all.append(std::move(*delta));
  }
  return all;
}

// Adds the bodies that pieces of the bodies of a stroke became.
void follow(const Delta& delta, std::vector<BodyId>& bodies) {
  for (const Detached& detached : delta.detached) {
    if (std::ranges::find(bodies, detached.from) != bodies.end()) bodies.push_back(detached.to);
  }
}

Status cut_each(kerf_world& world, std::span<StrokeCommands> strokes, const char* material,
                const Progress& progress) {
  if (material != nullptr) {
    const auto substance = substance_named(material);
    if (!substance) return substance.error();
    const auto set = set_material(world, *substance, progress);
    if (!set) return set.error();
    for (StrokeCommands& stroke : strokes)
      follow(*set, std::get<BeginStroke>(stroke.commands.front()).settings.bodies);
  }
  if (!strokes.empty()) begin_job(world, strokes.front().commands.front());
  const double share = 1 / static_cast<double>(std::max<size_t>(strokes.size(), 1));
  for (size_t i = 0; i < strokes.size(); ++i) {
    const double done = share * static_cast<double>(i);
    const Progress own = share_of(&progress, done, std::min(1.0, done + share));
    if (const Status cut = cut_one(world, strokes[i].commands, own); !cut) return cut;
  }
  return Done{};
}

// Executes all strokes or none, and keeps before-images for as long as they may be needed.
Status cut_all(kerf_world& world, std::span<StrokeCommands> strokes, const char* material,
               const Progress& progress) {
  Document& document = world.document;
  document.set_window(std::numeric_limits<size_t>::max());
  document.set_face_budget(usual_face_budget(machine_memory()));
  if (document.waiting() > 0) world.changes.lose();  // an opened journal may end within a stroke
  return document.all_or_nothing([&] { return cut_each(world, strokes, material, progress); });
}

// Executes all strokes or none. Returns the results, without the time.
Result<kerf_cut_result> cut(kerf_world& world, const kerf_stroke* strokes, size_t count,
                            const kerf_cut_settings* given, const Progress& progress) {
  const auto settings = read_settings(given);
  if (!settings) return settings.error();
  auto commands = stroke_commands_of(world, strokes, count, *settings);
  if (!commands) return commands.error();
  CutJob before = world.job;
  const ThermalTotals thermal(world);
  nlohmann::ordered_json settings_before = world.settings;
  const size_t window = world.document.history().window();
  const size_t position = world.document.history().position();
  world.kept.resize(world.document.history().size() + 1);
  const auto undone = world.kept.begin() + static_cast<std::ptrdiff_t>(position) + 1;
  std::vector kept(std::make_move_iterator(undone), std::make_move_iterator(world.kept.end()));
  world.kept.erase(undone, world.kept.end());
  Status done = Done{};
  std::exception_ptr thrown;
  try {
    done = cut_all(world, *commands, settings->material, progress);
  } catch (...) {
    thrown = std::current_exception();
  }
  world.document.set_window(window);
  if (done && !thrown) {
    const bool has_undone = world.document.history().size() > world.document.history().position();
    if (has_undone) std::ranges::move(kept, std::back_inserter(world.kept));
    kerf_cut_result result = KERF_CUT_RESULT_INIT;
    result.removed_faces = world.job.removed_faces - before.removed_faces;
    result.removed_area = world.job.removed_area - before.removed_area;
    thermal.set(world, result);
    return result;
  }
  world.changes.lose();
  world.job = std::move(before);
  world.settings = std::move(settings_before);
  world.kept.resize(position + 1);
  std::ranges::move(kept, std::back_inserter(world.kept));
  if (thrown) std::rethrow_exception(thrown);
  return done.error();
}

Status cut_plane(kerf_world& world, const KnifePlane& plane, const Progress& progress) {
  if (!is_finite(plane.normal) || plane.normal == Vec3(0) || !std::isfinite(plane.distance))
    return bad_input("normal and distance: must be finite, and the normal not zero");
  const Vec3 size = glm::abs(plane.normal);
  if (!std::isfinite(plane.distance / std::max({size.x, size.y, size.z})))
    return bad_input("normal and distance: the plane is too far from the origin");
  const auto cut = apply_edit(world, CutPlane{plane}, progress);
  return cut ? Status(Done{}) : cut.error();
}

}  // namespace
}  // namespace kerf

kerf_result kerf_world_cut(kerf_world* world, const kerf_stroke* strokes, size_t stroke_count,
                           const kerf_cut_settings* settings, const kerf_call_options* options,
                           kerf_cut_result* result) {
  if (strokes == nullptr && stroke_count > 0)
    return kerf::set_error(KERF_INVALID_ARGUMENT, "strokes: must not be null");
  const auto begin = std::chrono::steady_clock::now();
  return kerf::change_world(world, options, [&](const kerf::Progress& progress) -> kerf::Status {
    if (result != nullptr) {
      if (const kerf::Status valid = kerf::check_size(*result, "result"); !valid) return valid;
    }
    auto done = kerf::cut(*world, strokes, stroke_count, settings, progress);
    if (!done) return done.error();
    done->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (result != nullptr) kerf::write_struct(*done, *result);
    return kerf::Done{};
  });
}

kerf_result kerf_world_cut_plane(kerf_world* world, const double normal[3], double distance,
                                 const kerf_call_options* options) {
  if (normal == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "normal: must not be null");
  return kerf::change_world(world, options, [&](const kerf::Progress& progress) {
    return kerf::cut_plane(*world, {{normal[0], normal[1], normal[2]}, distance}, progress);
  });
}
