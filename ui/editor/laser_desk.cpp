#include "ui/editor/laser_desk.h"

#include "core/base/assert.h"
#include "core/cut/cuttable.h"
#include "ui/editor/path/surface_point.h"
#include "ui/render/spread.h"

namespace kerf {

namespace {

constexpr double kEmitterAway = 0.35;  // diagonals of the world

std::string count_text(size_t count, const char* what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

// The beam cuts pieces where they stand, so they are drawn there.
void begin_fire(EditorState& s, double now) {
  const World& world = s.work.document.world();
  cancel_stroke(s.hand, s.work.document);
  if (s.view.spread != 0) {
    s.view.spread = 0;
    spread_pieces(world, 0, s.view.look);
  }
  const Emitter& emitter = s.lasers.emitter;
  KERF_ASSERT(emitter.placed());
  const CutSettings settings = s.hand.laser.settings(world.bounds().diagonal());
  s.hand.beam.fire(s.work.document, emitter.pose(), emitter.distance(), settings, now);
  s.hand.cut_once = true;
}

// A shot waits until the last one is cut. One that meets nothing would be an empty step of the history.
void fire_shots(EditorState& s, double now) {
  Emitter& emitter = s.lasers.emitter;
  const Document& document = s.work.document;
  if (!emitter.firing) return emitter.pace.begin();
  if (s.hand.beam.cutting() || document.waiting() > 0 || !emitter.pace.is_due(now)) return;
  emitter.pace.take(now);
  const World& world = document.world();
  const Laser laser = s.hand.laser.settings(world.bounds().diagonal()).laser;
  if (!meets_anything(world, laser, emitter.pose())) return;
  begin_fire(s, now);
  s.hand.beam.release(s.work.document);
}

}  // namespace

std::string load_path(EditorState& state, const std::filesystem::path& file) {
  auto strokes = read_path_file(file);
  if (!strokes) return strokes.error().message;
  PathWork& path = state.lasers.path;
  path.begin_edit();
  path.load(std::move(*strokes), state.work.document.world());
  path.note_saved(file);
  state.hand.tool = Tool::kPath;
  state.settings.side_shown = state.settings.panels.at(PanelId::kPath) = true;
  state.message.say("Loaded: " + file.string() + ", " + count_text(path.strokes().size(), "stroke") + ", " +
                    count_text(path.points(), "point"));
  return "";
}

const char* why_no_run(const EditorState& state) {
  if (state.lasers.path.empty()) return "The path has no points: click on a surface with the tool Path.";
  return state.opening.loader.busy() ? "A file is being opened." : nullptr;
}

void place_emitter(EditorState& state) {
  const World& world = state.work.document.world();
  const double diagonal = world.bounds().diagonal();
  const CameraView view = state.view.seen_first();
  const auto surface = surface_point(world, state.view.look, view.ray(0, 0));
  place_in_view(state.lasers.emitter, view, surface ? surface->at : state.view.camera.pivot(),
                diagonal > 0 ? kEmitterAway * diagonal : 1);
}

void follow_emitter(EditorState& state, double now) {
  Emitter& emitter = state.lasers.emitter;
  LaserTool& beam = state.hand.beam;
  if (emitter.drawing && !beam.cutting()) emitter.firing = emitter.drawing = false;  // it was ended elsewhere
  if (state.opening.loader.busy()) emitter.firing = false;
  if (emitter.in_shots && !emitter.drawing) return fire_shots(state, now);
  const bool on = emitter.firing && !emitter.in_shots;
  if (on && !emitter.drawing) {
    begin_fire(state, now);
  } else if (on) {
    beam.carry_to(state.work.document, emitter.pose(), now);
  } else if (emitter.drawing) {
    beam.release(state.work.document);
  }
  emitter.drawing = on;
}

}  // namespace kerf
