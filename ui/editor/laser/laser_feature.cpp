#include "ui/editor/shared/features.h"

#include <imgui.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/deterministic_math.h"
#include "core/document/document.h"
#include "core/mesh/files/mesh_format.h"
#include "ui/editor/laser/laser_overlay.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/gizmo.h"
#include "ui/editor/shared/laser_controls.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/render/bodies/pick.h"
#include "ui/window/number_text.h"
#include "ui/window/property_rows.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

bool radius_row(LaserControls& laser, FileUnit file_unit) {
  property("Radius");
  const double before = laser.radius;
  const LengthUnit unit = label_unit(laser.default_radius, file_unit);
  double shown = laser.radius / unit.metres;
  const double low = laser.default_radius / LaserControls::kRadiusSpan / unit.metres;
  const double high = laser.default_radius * LaserControls::kRadiusSpan / unit.metres;
  constexpr const char* kMeaning =
      "Half the width of the cut. Ctrl+click to type a number, right click for the default. The last stroke "
      "follows while \"as the slider moves\" is on in the Resolution panel.";
  if (real_slider({"Radius", "##radius", kMeaning, true}, shown, low, high, "%.3g ", length_unit(unit.name)))
    laser.radius = shown * unit.metres;
  mark_last_item("radius");
  reset_item(laser.radius, laser.default_radius);
  return laser.radius != before;
}

void pattern_row(LaserControls& laser) {
  choice_row(
      "Pattern", "##pattern", laser.pattern, "Volume\0Four rays\0", "pattern",
      "Volume burns everything in the beam. Four rays burns only what four parallel rays on its rim meet.");
}

// Draws the radius and the pattern of the beam. Returns whether the radius was changed.
bool draw_laser_panel(LaserControls& laser, FileUnit unit) {
  if (!begin_properties("laser")) return false;
  const bool changed = radius_row(laser, unit);
  pattern_row(laser);
  end_properties();
  return changed;
}

constexpr const char* kLaserTool = "Laser";
constexpr double kRadiusStep = 1.25;
constexpr double kLeastRing = 3, kMostRing = 400;  // pixels

// The stroke that is drawn by hand.
class DrawnStroke : public Interaction {
 public:
  DrawnStroke(Workspace& on, double heard) : on_(on) {
    on.beam.press(on.work.document, on.view.seen(), on.view.in_picture(on.pointer), on.laser, heard);
  }

  void move(const InputEvent& event) override {
    on_.beam.move(on_.work.document, on_.view.seen(), on_.view.in_picture(on_.pointer),
                  2 / on_.view.pane().size.y, event.seconds);
  }
  void release(const InputEvent& event) override {
    if (event.button == GLFW_MOUSE_BUTTON_LEFT) cancel_stroke(on_);
  }
  bool over() const override { return !on_.beam.cutting(); }
  bool cuts() const override { return true; }
  const char* words() const override { return "Cutting: release to end, Esc ends"; }

 private:
  Workspace& on_;
};

const char* why_no_recut(const Document& document) {
  if (!document.history().last_cut()) return "Nothing is cut yet.";
  if (document.execution().in_stroke()) return "A stroke is being cut.";
  return document.can_recut() ? nullptr : "What was before the last stroke is no longer remembered.";
}

std::string smallest_angle_text(double largest_cosine) {
  if (largest_cosine < 0) return "no face is left of them";
  return text_of("%.1f degrees", std::acos(largest_cosine) * 180 / kPi);
}

void stroke_rows(const std::optional<ShownStatistics::Stroke>& stroke, FileUnit unit) {
  const std::string none = "nothing is cut";
  figure_row("Made", stroke ? grouped(stroke->statistics.faces_made) : none,
             "Faces that splitting made in the last stroke.");
  figure_row("Least angle", stroke ? smallest_angle_text(stroke->statistics.largest_cosine) : none,
             "Smallest angle of all faces that the last stroke made and left.");
  figure_row("Removed", stroke ? area_label(stroke->removed_area, unit) : none,
             "Area that the last stroke has taken away.");
}

class LaserFeature : public Feature {
 public:
  explicit LaserFeature(Workspace& on) : on_(on) {}

  std::vector<Panel> panels() override {
    return {{"Laser", Tab::kCut, 100, true,
             [this] {
               if (draw_laser_panel(on_.laser, on_.view.frame.unit)) cut_again_live(true);
             }},
            {"Resolution", Tab::kCut, 400, true, [this] { draw_resolution(); }}};
  }
  std::vector<ActionGroup> actions() override {
    return {{300, "Tool", {tool_action(on_, kLaserTool, "L", "Left drag cuts.")}},
            {304, "Tool", {recut_action()}},
            {1000, "Laser", laser_actions()}};
  }
  std::vector<Gesture> gestures() const override { return {{10, "Left drag", "Cut where the pointer goes"}}; }

  std::unique_ptr<Interaction> claim(const Press& press) override;
  bool stop() override {
    const bool at_work = can_stop();
    if (at_work) on_.changes.ask("Stop cutting", [this] { stop_cutting(); });
    return cancel_stroke(on_) || at_work;
  }
  const char* hint() const override {
    return on_.cut_once ? "Laser: left drag cuts, Ctrl+click picks"
                        : "Laser: left drag cuts, F1 shows all shortcuts";
  }

  void advance(double) override {
    if (on_.beam.cutting()) on_.view.picture_old = true;
    if (on_.changes.is_pending()) return;
    on_.beam.follow_time(on_.work.document, on_.plays);
    on_.beam.go_on(on_.work.document, on_.clock->seconds());
  }
  void follow_queue(double seconds) override;
  void report(nlohmann::ordered_json& report) const override {
    report["laser"] = {{"radius", on_.laser.radius}, {"power", on_.laser.power}};
  }
  bool moving() const override { return sparks_.moving() || on_.changes.can_cut() || on_.beam.emits(); }
  void forget() override {
    on_.beam = LaserTool();
    on_.cut_once = false;
    on_.laser.fit(on_.world().loaded_bounds().diagonal());
  }

  void draw_marks(ImDrawList& list) override {
    draw_ring(list);
    waiting_.draw(on_.view, list);
    const bool knows_how = on_.cut_once || on_.work.document.history().last_cut();
    if (!on_.view.look.stage && !knows_how && on_.tool == kLaserTool && !on_.opening.loader.busy())
      draw_hint_box(on_.world(), on_.view, on_.view.legends);
  }

 private:
  bool can_stop() const;
  void draw_resolution();
  void draw_ring(ImDrawList& list) const;
  UserAction recut_action();
  std::vector<UserAction> laser_actions();
  UserAction radius_action(const char* name, double factor);
  UserAction finer_action(const char* name, int steps);

  void cut_again_live(bool radius) {
    if (on_.settings.live_recut && why_no_recut(on_.work.document) == nullptr) ask_for_recut(radius);
  }
  void ask_for_recut(bool radius);
  void recut(bool radius);
  void stop_cutting();

  Workspace& on_;
  CutProgress progress_;
  BeamSparks sparks_;
  WaitingStrokes waiting_;
  bool recut_radius_ = false;  // the recut that was asked for is with the radius that is set now, too
};

// Input
// --------------------------------------------------------------------------------------------------------

std::unique_ptr<Interaction> LaserFeature::claim(const Press& press) {
  if (on_.opening.loader.busy()) {
    on_.message.say("The laser waits until " + on_.opening.loader.order().name() + " is open.");
    return nullptr;
  }
  stand_together(on_);
  cancel_stroke(on_);
  on_.view.camera.finish();
  auto stroke = std::make_unique<DrawnStroke>(on_, press.event.seconds);
  on_.cut_once = true;
  on_.message.say("");
  return stroke;
}

// A stroke that was drawn to its end stops at once, one that is being drawn when its cut lags behind.
bool LaserFeature::can_stop() const {
  const Execution& execution = on_.work.document.execution();
  if (on_.beam.cutting()) return progress_.can_stop();
  return !on_.holds_back() && execution.beam_waits() && execution.moves_wait();
}

UserAction LaserFeature::recut_action() {
  return {.name = "Cut the last stroke again",
          .shortcut = "R",
          .tip = "At the resolution that is set now.",
          .run = [this] { ask_for_recut(false); },
          .why_not = [this] { return why_no_recut(on_.work.document); },
          .ends_group = true};
}

UserAction LaserFeature::radius_action(const char* name, double factor) {
  return {.name = name,
          .tip = "By a quarter. The last stroke follows while that is on in the Resolution panel.",
          .run =
              [this, factor] {
                LaserControls& laser = on_.laser;
                laser.radius =
                    std::clamp(laser.radius * factor, laser.default_radius / LaserControls::kRadiusSpan,
                               laser.default_radius * LaserControls::kRadiusSpan);
                cut_again_live(true);
              },
          .in_menu = false};
}

UserAction LaserFeature::finer_action(const char* name, int steps) {
  return {.menu = "Resolution",
          .name = name,
          .tip = "Halves or doubles the size of the faces along the cut, or splits once more or less.",
          .run =
              [this, steps] {
                make_finer(on_.laser.resolution, steps);
                cut_again_live(false);
              },
          .in_menu = false};
}

std::vector<UserAction> LaserFeature::laser_actions() {
  using Rule = Resolution::Rule;
  Pattern& pattern = on_.laser.pattern;
  ResolutionControls& resolution = on_.laser.resolution;
  bool& live = on_.settings.live_recut;
  const auto choice = [this](const char* name, auto& value, auto set, const char* tip) {
    return setting_action("Resolution", name, tip, value, set, [this] { cut_again_live(false); });
  };
  return {
      radius_action("Wider beam", kRadiusStep),
      radius_action("Narrower beam", 1 / kRadiusStep),
      setting_action(nullptr, "Pattern: volume", "Burns everything in the beam.", pattern, Pattern::kVolume),
      setting_action(nullptr, "Pattern: four rays",
                     "Burns only what four parallel rays on the rim of the beam meet.", pattern,
                     Pattern::kRays4),
      finer_action("Finer cut", 1),
      finer_action("Coarser cut", -1),
      choice("Split to edge length", resolution.rule, Rule::kTargetEdge,
             "Faces are small enough when their edges are."),
      choice("Split to tolerance", resolution.rule, Rule::kTolerance,
             "Faces are small enough when what is removed overshoots the beam by no more than that."),
      choice("Split to depth", resolution.rule, Rule::kDepth, "Faces are split so many times."),
      choice("Scheme: one to four", resolution.scheme, Scheme::kOneToFour,
             "A face is split in four, as in the paper."),
      choice("Scheme: longest edge", resolution.scheme, Scheme::kLongestEdge,
             "A face is split in two at its longest edge."),
      choice("Rim: faces", resolution.rim, Rim::kFaces,
             "All that the beam touches goes, so the rim is a saw."),
      choice("Rim: smooth", resolution.rim, Rim::kSmooth,
             "When the stroke ends, faces across the boundary of the beam are cut along it."),
      UserAction{.menu = "Resolution",
                 .name = "Cut again as the slider moves",
                 .tip = "A change of the resolution or the radius cuts the last stroke again.",
                 .run = [&live] { live = !live; },
                 .checked = [&live] { return live; },
                 .in_menu = false},
  };
}

void LaserFeature::draw_resolution() {
  if (!begin_properties("resolution")) return;
  const bool changed = resolution_rows(on_.laser.resolution, {on_.laser.radius, on_.view.frame.unit});
  property("Last stroke");
  const char* why_not = why_no_recut(on_.work.document);
  ImGui::BeginDisabled(why_not != nullptr);
  if (ImGui::Button("Cut again", {-1, 0})) ask_for_recut(false);
  ImGui::EndDisabled();
  const std::string meaning = with_shortcut(
      on_.view, "Takes the last stroke back and cuts it at this resolution.", "Cut the last stroke again");
  tooltip(why_not != nullptr ? why_not : meaning.c_str());
  property("");
  ImGui::Checkbox("as the slider moves", &on_.settings.live_recut);
  tooltip(
      "Moving a slider above, or that of the radius, cuts the last stroke again: the same cut, just with "
      "different parameters.");
  if (changed) cut_again_live(false);
  figure_row("Faces", grouped(on_.statistics.shown.faces), "Faces of all bodies as they stand.");
  stroke_rows(on_.statistics.shown.stroke, on_.view.frame.unit);
  end_properties();
}

// Cutting
// --------------------------------------------------------------------------------------------------------

void LaserFeature::ask_for_recut(bool radius) {
  recut_radius_ = recut_radius_ || radius;
  on_.changes.ask("Cut again", [this] { recut(std::exchange(recut_radius_, false)); });
}

// Undoes the last stroke and queues it again at the resolution that is set now, and with `radius` with the
// radius, too; its other settings stay. Consecutive recuts are one step of the history.
void LaserFeature::recut(bool radius) {
  const Document& document = on_.work.document;
  if (why_no_recut(document) != nullptr) return;
  CutSettings settings = document.history().last_settings();
  if (radius) settings.laser.radius = on_.laser.radius;
  settings.resolution = on_.laser.resolution.of(settings.laser.radius);
  std::vector<Command> commands;
  const HistoryStep& last = document.history().last();
  const bool again = last.kind() == HistoryStep::Kind::kRecut;
  if (again) commands.emplace_back(Undo{});
  commands.emplace_back(Recut{settings});
  // The time that passed after the recut that is undone passes again.
  if (again) commands.insert(commands.end(), last.commands().begin() + 1, last.commands().end());
  on_.changes.change("Cut again", true, apply_all(std::move(commands)));
  ++on_.statistics.recuts;
}

// Ends the stroke that is being cut where it is, and takes back those that wait behind it.
void LaserFeature::stop_cutting() {
  cancel_stroke(on_);
  on_.changes.change(
      "Stop cutting", true, [](Document& document, const Progress*) { return stop_strokes(document); },
      "Stopped: the stroke ends here. Undo takes it back.");
}

void LaserFeature::follow_queue(double seconds) {
  if (!on_.changes.is_pending()) {
    progress_.follow(on_.work.document, on_.holds_back(), seconds);
    on_.statistics.shown.work = progress_.text();
  }
  const bool changed = !on_.changes.is_pending() &&
                       waiting_.follow(on_.work.document, on_.view.frame.unit, on_.stroke_waits(), seconds);
  sparks_.advance(std::min(seconds, Workspace::kLongestStep), on_.beam, on_.work.document, waiting_, changed,
                  on_.view);
}

// As large as the cut would be where the pointer is.
void LaserFeature::draw_ring(ImDrawList& list) const {
  const bool cuts = dynamic_cast<const DrawnStroke*>(on_.held.get()) != nullptr;
  if (!cuts && (!on_.points() || on_.tool != kLaserTool || is_on_axes(on_.view, on_.pointer))) return;
  const CameraView view = on_.view.seen();
  const Vec2 p = on_.view.in_picture(on_.pointer);
  const auto seen_face = pick(on_.world(), on_.view.look, view.ray(p.x, p.y));
  const double distance = seen_face ? seen_face->length : view.focus;
  const double seen = view.parallel ? view.half_height() : distance * view.tan_half_fov;
  const double pixels = on_.laser.radius / seen * 0.5 * on_.view.pane().size.y;
  const auto ring = static_cast<float>(std::clamp(pixels, kLeastRing, kMostRing));
  const ImVec2 at = to_im(on_.pointer);
  list.AddCircle(at, ring + 1.5f, IM_COL32(10, 12, 16, 150), 0, 3.0f);
  list.AddCircle(at, ring + 1.5f, cuts ? colours::accent() : colours::kPictureText, 0, 1.3f);
}

}  // namespace

std::unique_ptr<Feature> laser_feature(Workspace& on) { return std::make_unique<LaserFeature>(on); }

}  // namespace kerf
