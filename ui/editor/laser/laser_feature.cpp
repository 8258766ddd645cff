#include "ui/editor/laser/laser_feature.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/json.h"
#include "core/mesh/files/mesh_format.h"
#include "ui/editor/laser/resolution_chart.h"
#include "ui/editor/laser/stroke_recut.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/gizmo.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/view/camera.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr double kUnseenSeconds = 0.3;  // s, before work is shown
}

CutProgress::Work CutProgress::work_of(const Document& document) {
  if (document.waiting() == 0) return Work::kNone;
  const CommandQueue& queue = document.queue();
  if (queue.pending().holds_beam()) return queue.pending().holds_moves() ? Work::kCut : Work::kEnd;
  return queue.next_searches() ? Work::kSearch : Work::kNone;
}

void CutProgress::follow(const Document& document, bool held_back, double seconds) {
  const Work work = held_back ? Work::kNone : work_of(document);
  if (work == Work::kNone) {
    *this = CutProgress();
    return;
  }
  const bool begins = work_ == Work::kNone;
  const size_t waits = document.waiting();
  if (!begins) {
    done_ += waits_ - std::min(waits, waits_);
    seconds_ += seconds;
  }
  work_ = work;
  waits_ = waits;
}

bool CutProgress::lasts() const { return seconds_ >= kUnseenSeconds; }

std::string CutProgress::text() const {
  if (!lasts()) return "";
  switch (work_) {
    case Work::kNone:
      break;
    case Work::kCut: {
      const auto done = static_cast<double>(done_), all = static_cast<double>(done_ + waits_);
      const std::string percent = progress_text(done / all);
      return "Cutting, " + (percent.empty() ? "0 %" : percent) + ", Esc to stop";
    }
    case Work::kEnd:
      return "Smoothing the rim";
    case Work::kSearch:
      return "Searching for separated pieces";
  }
  return "";
}

namespace {

constexpr size_t kMaxWaiting = 8;
constexpr double kWaitingStrength = 0.35;  // relative to a beam that is on
constexpr double kShownAfter = 0.3;        // s, of waiting for another stroke
constexpr double kWaitingLength = 3;       // diagonals of the world, of a beam that hits nothing

// Returns the history entries of the waiting strokes, in order.
std::vector<size_t> waiting_steps(const Document& document, bool held_back) {
  const BeamQueue& pending = document.queue().pending();
  std::vector<size_t> steps;
  if (!pending.holds_beam()) return steps;
  const UndoStack& history = document.history();
  const size_t first = held_back ? pending.front_step() : pending.front_step() + 1;
  for (size_t i = first; i < history.position() && steps.size() < kMaxWaiting; ++i) {
    if (history.cuts(i) && history.step(i).waiting() && pending.holds(i)) steps.push_back(i);
  }
  return steps;
}

// "Cut 2" of "Cut 2: roof, radius 4 mm".
std::string short_name(const UndoStack& history, size_t step, FileUnit unit) {
  const std::string words = step_words(history, step, unit);
  return words.substr(0, words.find(':'));
}

BeamPicture beam_of(const Document& document, size_t step) {
  const UndoStack& history = document.history();
  const World& world = document.world();
  const std::vector<Command> commands = history.commands_of(step);
  const auto* begin = std::get_if<BeginStroke>(&commands.front());
  KERF_ASSERT(begin != nullptr);
  const CutSettings& settings = history.settings_of(step);
  const double length =
      std::min(settings.laser.range.high, kWaitingLength * world.loaded_bounds().diagonal());
  BeamPicture beam = picture_of_beam(world, settings, begin->pose, length);
  beam.strength = kWaitingStrength;
  return beam;
}

constexpr const char* kCompareTip =
    "Cuts the last stroke at five edge lengths and charts faces against the error of the rim.";
constexpr double kCar = 4.5;  // m, diagonal of a world with particles of the default size

// Returns the hints of the first launch, without one for a key that is not bound.
std::vector<std::string> first_hints(const ViewState& view) {
  std::vector<std::string> hints{"Left-drag to cut", "Middle-drag to orbit, scroll to zoom"};
  const std::string key = shortcut_of(view, "help.shortcuts");
  if (!key.empty()) hints.push_back(key + " shows all shortcuts");
  return hints;
}

std::array<Vec2, 4> corners_of(const Area& a) {
  return {a.at, a.at + Vec2(a.size.x, 0), a.at + Vec2(0, a.size.y), a.at + a.size};
}

// Returns true if a line perpendicular to `axis` separates two sets of points.
bool apart_along(const Vec2& axis, std::span<const Vec2> a, std::span<const Vec2> b) {
  const auto less = [&](const Vec2& p, const Vec2& q) { return glm::dot(axis, p) < glm::dot(axis, q); };
  const auto [low_a, high_a] = std::minmax_element(a.begin(), a.end(), less);
  const auto [low_b, high_b] = std::minmax_element(b.begin(), b.end(), less);
  return less(*high_a, *low_b) || less(*high_b, *low_a);
}

bool hides_axes(const ViewState& view, const Area& area) {
  const std::vector<AxisEnd> ends = axis_ends(view);
  return std::any_of(ends.begin(), ends.end(), [&](const AxisEnd& end) { return area.contains(end.at); });
}

Vec2 size_of_hints(const std::vector<std::string>& hints) {
  const double em = ImGui::GetFontSize(), line = ImGui::GetTextLineHeightWithSpacing();
  double widest = 0;
  for (const std::string& hint : hints)
    widest = std::max<double>(widest, ImGui::CalcTextSize(hint.c_str()).x);
  return {widest + 2 * em, static_cast<double>(hints.size()) * line + em};
}

void draw_hints(const std::vector<std::string>& hints, const Area& box) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float em = ImGui::GetFontSize();
  const auto left = static_cast<float>(box.at.x), top = static_cast<float>(box.at.y);
  const auto width = static_cast<float>(box.size.x), height = static_cast<float>(box.size.y);
  list.AddRectFilled({left, top}, {left + width, top + height}, colours::shade(), 3);
  float y = top + 0.65f * em;
  for (size_t i = 0; i < hints.size(); ++i) {
    const float x = left + 0.5f * (width - ImGui::CalcTextSize(hints[i].c_str()).x);
    list.AddText({x, y}, i == 0 ? colours::text() : colours::secondary(), hints[i].c_str());
    y += ImGui::GetTextLineHeightWithSpacing();
  }
}

bool radius_row(LaserControls& laser, FileUnit file_unit) {
  property("Radius");
  const double before = laser.radius;
  const LengthUnit unit = label_unit(laser.default_radius, file_unit);
  double shown = laser.radius / unit.metres;
  const double low = laser.default_radius / LaserControls::kRadiusSpan / unit.metres;
  const double high = laser.default_radius * LaserControls::kRadiusSpan / unit.metres;
  constexpr const char* kMeaning =
      "Half the width of the cut. Double-click to type a number, right-click for the default.";
  if (real_slider({"Radius", "##radius", kMeaning, true}, shown, low, high, "%.3g ", length_unit(unit.name)))
    laser.radius = shown * unit.metres;
  mark_last_item("radius");
  reset_item(laser.radius, laser.default_radius);
  return laser.radius != before;
}

void pattern_row(LaserControls& laser) {
  choice_row(
      "Pattern", "##pattern", laser.pattern, "Volume\0Four Rays\0", "pattern",
      "Volume removes all faces in the beam, Four Rays only those hit by four parallel rays on its rim.");
}

// Draws radius and pattern of the beam. Returns true if the radius was changed.
bool draw_laser_panel(LaserControls& laser, FileUnit unit) {
  if (!begin_properties("laser")) return false;
  const bool changed = radius_row(laser, unit);
  pattern_row(laser);
  end_properties();
  return changed;
}

constexpr int kRingPoints = 48;
constexpr double kChartSeconds = 0.02;  // of a frame, for the chart of resolutions
constexpr double kMinIncidence = 0.2;  // cosine of the angle of incidence from which the ring grows no longer
constexpr double kRadiusStep = 1.25;
constexpr double kMinRing = 3, kMaxRing = 400;  // pixels

class DrawnStroke : public Interaction {
 public:
  DrawnStroke(Workspace& workspace, double time) : workspace_(workspace) {
    workspace.beam.press(workspace.session.document, workspace.view.seen(),
                         workspace.view.in_picture(workspace.input.pointer), workspace.laser, time);
  }

  void move(const InputEvent& event) override {
    const bool shift = (event.mods & GLFW_MOD_SHIFT) != 0;
    workspace_.beam.move(workspace_.session.document, workspace_.view.seen(),
                         workspace_.view.in_picture(line_.follow(workspace_.input.pointer, shift)),
                         2 / workspace_.view.pane().size.y, event.seconds);
  }
  void release(const InputEvent&) override { cancel_stroke(workspace_); }
  bool over() const override { return !workspace_.beam.cutting(); }
  bool cuts() const override { return true; }
  const char* words() const override { return "Cutting... release to finish, Esc to stop, Shift for a line"; }
  void draw(ImDrawList& list) const override {
    const auto degrees = line_.degrees();
    if (!degrees) return;
    const float em = ImGui::GetFontSize();
    const ImVec2 at = to_im(workspace_.input.pointer + Vec2(1.5 * em, -1.5 * em));
    list.AddText(at, colours::kPictureText, text_of("%.0f\u00b0", *degrees).c_str());
  }

 private:
  Workspace& workspace_;
  StraightLine line_;
};

std::string smallest_angle_text(double largest_cosine) {
  if (largest_cosine < 0) return "none remain";
  return text_of("%.1f\u00b0", std::acos(largest_cosine) * 180 / kPi);
}

void stroke_rows(const std::optional<ShownStatistics::Stroke>& stroke, FileUnit unit) {
  const std::string none = "-";
  figure_row("Faces Created", stroke ? grouped(stroke->statistics.faces_made) : none,
             "Faces that the last cut created by splitting.");
  figure_row("Min. Angle", stroke ? smallest_angle_text(stroke->statistics.largest_cosine) : none,
             "Smallest angle of the remaining faces that the last cut created.");
  figure_row("Area Removed", stroke ? area_label(stroke->removed_area, unit) : none,
             "Area that the last cut removed.");
}

class LaserFeature : public Feature {
 public:
  explicit LaserFeature(Workspace& workspace) : workspace_(workspace) {}

  std::vector<PanelPart> panel_parts() override {
    return {{"laser.beam",
             [this] {
               if (draw_laser_panel(workspace_.laser, workspace_.view.frame.unit)) recut_.request_live(true);
             }},
            {"resolution.cut", [this] { draw_resolution(); }}};
  }
  std::vector<ToolOption> tool_options() override {
    return {{"laser.radius", 9,
             [this] {
               if (radius_row(workspace_.laser, workspace_.view.frame.unit)) recut_.request_live(true);
             }},
            {"laser.size", 9,
             [this] {
               const ShownRadius radius{workspace_.laser.radius, workspace_.view.frame.unit};
               if (resolution_size_row(workspace_.laser.resolution, radius)) recut_.request_live(false);
             }},
            {"laser.rim", 6, [this] {
               if (rim_row(workspace_.laser.resolution)) recut_.request_live(false);
             }}};
  }
  std::vector<UserAction> actions() override {
    return joined({{tool_action(workspace_, kLaserTool, "Laser", "L",
                                "Cuts the mesh where you drag with the left button."),
                    recut_action(), compare_action()},
                   laser_actions()});
  }
  std::vector<Gesture> gestures() const override { return {{"cut", "Left drag", "Cut under the pointer"}}; }

  std::unique_ptr<Interaction> begin_interaction(const Press& press) override {
    if (workspace_.input.tool != kLaserTool) return nullptr;
    if (workspace_.opening.loader.busy()) {
      workspace_.message.info("Cannot cut until " + workspace_.opening.loader.order().name() + " is open.");
      return nullptr;
    }
    end_exploded_view(workspace_.world(), workspace_.view);
    cancel_stroke(workspace_);
    workspace_.view.camera.finish();
    auto stroke = std::make_unique<DrawnStroke>(workspace_, press.event.seconds);
    workspace_.links.cut_once = true;
    workspace_.message.clear();
    return stroke;
  }
  bool cancel() override {
    const bool at_work = can_stop();
    if (at_work) workspace_.changes.enqueue("Stop cutting", [this] { stop_cutting(); });
    return cancel_stroke(workspace_) || at_work;
  }
  const char* status_hint() const override {
    if (workspace_.links.cut_once) return "Laser: drag to cut, Ctrl+click to select";
    const std::string key = shortcut_of(workspace_.view, "help.shortcuts");
    hint_ = "Laser: drag to cut" + (key.empty() ? "" : ", " + key + " for all shortcuts");
    return hint_.c_str();
  }

  void update(double) override {
    if (workspace_.beam.cutting()) workspace_.view.picture_old = true;
    if (workspace_.changes.is_pending()) return;
    recut_.update();
    workspace_.beam.follow_time(workspace_.session.document, workspace_.links.plays);
    workspace_.beam.hold_beam(workspace_.session.document, workspace_.screen.clock->seconds());
  }
  void after_queue(double seconds) override {
    workspace_.laser.metre = 1 / metres_per_unit(workspace_.view.frame.unit);
    if (!workspace_.changes.is_pending()) chart_.advance(workspace_.session.document, kChartSeconds);
    if (!workspace_.changes.is_pending()) {
      progress_.follow(workspace_.session.document, workspace_.links.holds_back(), seconds);
      workspace_.services.statistics.shown.work = progress_.text();
    }
    const bool changed = !workspace_.changes.is_pending() &&
                         waiting_.follow(workspace_.session.document, workspace_.view.frame.unit,
                                         workspace_.stroke_waits(), seconds);
    sparks_.advance(std::min(seconds, Workspace::kLongestStep), workspace_.beam, workspace_.session.document,
                    waiting_, changed, workspace_.view);
  }
  void write_session_log(nlohmann::ordered_json& report) const override {
    report["laser"] = {{"radius", workspace_.laser.radius}, {"power", workspace_.laser.power}};
  }
  bool needs_redraw() const override {
    return chart_.busy() || sparks_.moving() || workspace_.changes.can_cut() || workspace_.beam.emits() ||
           recut_.waits();
  }
  void on_document_opened() override {
    workspace_.beam = LaserTool();
    chart_.clear();
    sparks_.forget(workspace_.view);
    workspace_.links.cut_once = false;
    workspace_.laser.fit(workspace_.world().loaded_bounds().diagonal());
    if (const auto radius = radius_of_entry(head_entry(workspace_.session.scene, kEmitterKey)))
      workspace_.laser.radius = *radius;
  }

  void draw_overlay(ImDrawList& list) override {
    draw_ring(list);
    waiting_.draw(workspace_.view, list);
    const bool knows_how = workspace_.links.cut_once || workspace_.session.document.history().last_cut();
    if (!workspace_.view.look.stage && !knows_how && workspace_.input.tool == kLaserTool &&
        !workspace_.opening.loader.busy() && workspace_.view.frame_asked_for.empty())
      draw_hint_box(workspace_.world(), workspace_.view, workspace_.view.legends);
  }

 private:
  // A finished stroke can be stopped immediately, one that is being drawn only if its cut lags behind.
  bool can_stop() const {
    const BeamQueue& pending = workspace_.session.document.queue().pending();
    if (workspace_.beam.cutting()) return progress_.can_stop();
    return !workspace_.links.holds_back() && pending.holds_beam() && pending.holds_moves();
  }
  void draw_resolution() {
    if (!begin_properties("resolution")) return;
    const bool changed =
        resolution_rows(workspace_.laser.resolution, {workspace_.laser.radius, workspace_.view.frame.unit});
    property("Last Cut");
    const char* disabled_reason = recut_.disabled_reason();
    ImGui::BeginDisabled(disabled_reason != nullptr);
    if (ImGui::Button("Recompute", {-1, 0})) recut_.request(false);
    ImGui::EndDisabled();
    const std::string meaning =
        with_shortcut(workspace_.view, "Recuts the last stroke at this resolution.", "laser.recut");
    tooltip(disabled_reason != nullptr ? disabled_reason : meaning.c_str());
    property("");
    ImGui::Checkbox("Live Update", &workspace_.settings.live_recut);
    tooltip("Recuts the last stroke while a slider above, or that of the radius, moves.");
    if (changed) recut_.request_live(false);
    figure_row("Faces", grouped(workspace_.services.statistics.shown.faces), "Current faces of all bodies.");
    stroke_rows(workspace_.services.statistics.shown.stroke, workspace_.view.frame.unit);
    end_properties();
    draw_chart(disabled_reason);
  }
  // Offers the last stroke at five resolutions; a click on one takes it.
  void draw_chart(const char* disabled_reason) {
    if (row_button(chart_.busy() ? "Cutting..." : "Compare Five Resolutions", 1, disabled_reason,
                   kCompareTip))
      chart_.begin(workspace_.session.document);
    const ResolutionControls& now = workspace_.laser.resolution;
    const auto current =
        now.rule == Resolution::Rule::kTargetEdge ? std::optional(now.edge_fraction) : std::nullopt;
    const auto fraction = chart_.draw(workspace_.view.frame.unit, current);
    if (!fraction) return;
    chart_.show(*fraction, workspace_.laser.resolution);
    recut_.request(false);
  }
  // Draws a ring with the width of the cut at the pointer.
  void draw_ring(ImDrawList& list) const {
    const bool cuts = dynamic_cast<const DrawnStroke*>(workspace_.input.held.get()) != nullptr;
    if (!cuts && (!workspace_.input.points() || workspace_.input.tool != kLaserTool ||
                  is_on_axes(workspace_.view, workspace_.input.pointer)))
      return;
    const ImU32 colour = cuts ? colours::accent() : colours::kPictureText;
    const std::vector<ImVec2> ring = ring_on_surface();
    if (!ring.empty()) {
      const auto count = static_cast<int>(ring.size());
      list.AddPolyline(ring.data(), count, IM_COL32(10, 12, 16, 150), ImDrawFlags_Closed, 3.0f);
      list.AddPolyline(ring.data(), count, colour, ImDrawFlags_Closed, 1.3f);
      return;
    }
    const ImVec2 at = to_im(workspace_.input.pointer);
    constexpr float kInner = 3, kOuter = 8;
    for (const ImVec2& way : {ImVec2(1, 0), ImVec2(-1, 0), ImVec2(0, 1), ImVec2(0, -1)})
      list.AddLine({at.x + kInner * way.x, at.y + kInner * way.y},
                   {at.x + kOuter * way.x, at.y + kOuter * way.y}, colour, 1.3f);
  }
  // The outline of the beam on the plane of the face under the pointer, in screen coordinates; a circle of
  // the smallest visible size if it is smaller. Empty next to the mesh.
  std::vector<ImVec2> ring_on_surface() const {
    const ViewState& view = workspace_.view;
    const Vec2 p = view.in_picture(workspace_.input.pointer);
    const Pose ray = view.seen().ray(p.x, p.y);
    const auto surface = surface_point(workspace_.world(), view.look, ray);
    if (!surface || view.in_second) return {};
    const double towards = -glm::dot(surface->normal, ray.direction);
    const Vec3 side =
        glm::normalize(std::abs(ray.direction.x) < 0.5 ? glm::cross(ray.direction, Vec3(1, 0, 0))
                                                       : glm::cross(ray.direction, Vec3(0, 1, 0)));
    const Vec3 up = glm::cross(side, ray.direction);
    const PrimaryViewport viewport(view);
    std::vector<ImVec2> ring;
    for (int i = 0; i < kRingPoints; ++i) {
      const double angle = 2 * kPi * i / kRingPoints;
      const Vec3 offset = workspace_.laser.radius * (std::cos(angle) * side + std::sin(angle) * up);
      // Along the beam onto the plane of the face, but not farther than at a steep angle.
      const double along = glm::dot(surface->normal, offset) / std::max(towards, kMinIncidence);
      const auto place = viewport.place_of(surface->at + offset + along * ray.direction);
      if (!place) return {};
      const Vec2 from = *place - workspace_.input.pointer;
      const double length = glm::length(from);
      const double shown = std::clamp(length, kMinRing, kMaxRing) / std::max(length, 1e-9);
      ring.push_back(to_im(workspace_.input.pointer + shown * from));
    }
    return ring;
  }
  UserAction compare_action() {
    return make_action("laser.compare_resolutions", "Compare Five Resolutions", "", kCompareTip,
                       [this] { chart_.begin(workspace_.session.document); },
                       {.disabled_reason = [this] { return recut_.disabled_reason(); }});
  }
  UserAction recut_action() {
    return make_action("laser.recut", "Recompute Last Cut", "R",
                       "Recuts the last stroke at the current resolution.", [this] { recut_.request(false); },
                       {.disabled_reason = [this] { return recut_.disabled_reason(); }});
  }
  std::vector<UserAction> laser_actions() {
    using Rule = Resolution::Rule;
    Pattern& pattern = workspace_.laser.pattern;
    ResolutionControls& resolution = workspace_.laser.resolution;
    bool& live = workspace_.settings.live_recut;
    const auto choice = [this](const char* id, const char* name, auto& value, auto set, const char* tip) {
      return setting_action(id, name, tip, value, set, [this] { recut_.request_live(false); });
    };
    return {
        radius_action("laser.wider", "Wider Beam", kRadiusStep),
        radius_action("laser.narrower", "Narrower Beam", 1 / kRadiusStep),
        setting_action("laser.pattern_volume", "Pattern: Volume", "Removes all faces in the beam.", pattern,
                       Pattern::kVolume),
        setting_action("laser.pattern_rays", "Pattern: Four Rays",
                       "Removes only faces hit by four parallel rays on the rim of the beam.", pattern,
                       Pattern::kRays4),
        finer_action("resolution.finer", "Finer Cut", 1),
        finer_action("resolution.coarser", "Coarser Cut", -1),
        choice("resolution.by_edge_length", "Refine by Edge Length", resolution.rule, Rule::kTargetEdge,
               "Splits faces until their edges are short enough."),
        choice("resolution.by_tolerance", "Refine by Tolerance", resolution.rule, Rule::kTolerance,
               "Splits faces until removed faces overshoot the beam by at most the tolerance."),
        choice("resolution.by_depth", "Refine by Depth", resolution.rule, Rule::kDepth,
               "Splits faces a fixed number of times."),
        choice("resolution.one_to_four", "Subdivision: One to Four", resolution.scheme, Scheme::kOneToFour,
               "Splits a face into four, as in the paper."),
        choice("resolution.longest_edge", "Subdivision: Longest Edge", resolution.scheme,
               Scheme::kLongestEdge, "Splits a face into two at its longest edge."),
        choice("resolution.rim_faces", "Rim: Faces", resolution.rim, Rim::kFaces,
               "Removes every face the beam touches; the edge is jagged."),
        choice("resolution.rim_smooth", "Rim: Smooth", resolution.rim, Rim::kSmooth,
               "Cuts faces along the boundary of the beam when the stroke ends."),
        make_action("resolution.live", "Live Update of Last Cut", "",
                    "Recuts the last stroke when the resolution or the radius changes.",
                    [&live] { live = !live; }, {.checked = [&live] { return live; }}),
    };
  }
  UserAction radius_action(const char* id, const char* name, double factor) {
    return make_action(
        id, name, "", "Changes the beam radius by a quarter; with live update, the last stroke is recut.",
        [this, factor] {
          LaserControls& laser = workspace_.laser;
          laser.radius = std::clamp(laser.radius * factor, laser.default_radius / LaserControls::kRadiusSpan,
                                    laser.default_radius * LaserControls::kRadiusSpan);
          recut_.request_live(true);
        });
  }
  UserAction finer_action(const char* id, const char* name, int steps) {
    return make_action(id, name, "",
                       "Halves or doubles the edge length along the cut, or changes the depth by one.",
                       [this, steps] {
                         make_finer(workspace_.laser.resolution, steps);
                         recut_.request_live(false);
                       });
  }

  // Ends the current stroke at the beam, and drops the strokes queued after it.
  void stop_cutting() {
    cancel_stroke(workspace_);
    workspace_.changes.change(
        "Stop cutting", true, [](Document& document, const Progress*) { return stop_strokes(document); },
        "Stopped: the stroke ends here. Undo restores the uncut state.");
  }

  Workspace& workspace_;
  CutProgress progress_;
  ResolutionChart chart_;
  BeamSparks sparks_;
  WaitingStrokes waiting_;
  StrokeRecut recut_{workspace_};
  mutable std::string hint_;  // returned by status_hint()
};

// Input
// --------------------------------------------------------------------------------------------------------

// Cutting
// --------------------------------------------------------------------------------------------------------

}  // namespace

Vec2 StraightLine::follow(Vec2 pointer, bool shift) {
  constexpr double kStep = kPi / 12, kFixedFrom = 8;  // radians; pixels
  if (!shift) from_.reset(), way_.reset();
  if (shift && !from_) from_ = last_.value_or(pointer);
  if (from_ && !way_ && glm::length(pointer - *from_) >= kFixedFrom) {
    const double angle = kStep * std::round(std::atan2(pointer.y - from_->y, pointer.x - from_->x) / kStep);
    way_ = Vec2(std::cos(angle), std::sin(angle));
  }
  if (from_) pointer = way_ ? *from_ + glm::dot(pointer - *from_, *way_) * *way_ : *from_;
  last_ = pointer;
  return pointer;
}

std::optional<double> StraightLine::degrees() const {
  if (!way_) return std::nullopt;
  const double angle = std::round(-std::atan2(way_->y, way_->x) * 180 / kPi);
  return angle < 0 ? angle + 180 : angle;
}

bool WaitingStrokes::follow(const Document& document, FileUnit unit, bool held_back, double seconds) {
  std::vector<size_t> steps = waiting_steps(document, held_back);
  behind_ = steps.empty() || held_back ? 0 : behind_ + seconds;
  if (!held_back && behind_ < kShownAfter) steps.clear();
  if (revision_ == document.revision() && held_back_ == held_back &&
      std::ranges::equal(steps, strokes_, {}, {}, &Stroke::step))
    return false;
  revision_ = document.revision();
  held_back_ = held_back;
  const bool had_any = !strokes_.empty();
  strokes_.clear();
  for (const size_t step : steps) {
    const size_t now = document.queue().pending().front_step();
    const std::string why = step == now ? "Waiting for its first stage"
                                        : "Waiting for " + short_name(document.history(), now, unit);
    strokes_.push_back({step, why, beam_of(document, step)});
  }
  return had_any || !strokes_.empty();
}

void WaitingStrokes::draw(const ViewState& view, ImDrawList& list) const {
  const float em = ImGui::GetFontSize();
  std::set<std::string> reasons;
  const Area& first = view.layout.first;
  list.PushClipRect(to_im(first.at), to_im(first.at + first.size), true);
  for (size_t i = 0; i < strokes_.size(); ++i) {
    const BeamPicture& beam = strokes_[i].beam;
    const auto at = PrimaryViewport(view).place_of(beam.strike.value_or(beam.to));
    if (!at) continue;
    list.AddCircle(to_im(*at), 0.35f * em, colours::kPictureText, 0, 1.3f);
    if (!reasons.insert(strokes_[i].waits_for).second) continue;
    const ImVec2 text = ImGui::CalcTextSize(strokes_[i].waits_for.c_str());
    const ImVec2 place{static_cast<float>(at->x) + em, static_cast<float>(at->y) - 0.5f * em};
    const ImVec2 low{place.x - 0.4f * em, place.y - 0.2f * em};
    list.AddRectFilled(low, {place.x + text.x + 0.4f * em, place.y + text.y + 0.2f * em},
                       colours::kPictureShade, 3);
    list.AddText(place, colours::kPictureText, strokes_[i].waits_for.c_str());
    mark_area(("waiting stroke " + std::to_string(i)).c_str(),
              {{low.x, low.y}, {text.x + 0.8 * em, text.y + 0.4 * em}});
  }
  list.PopClipRect();
}

void BeamSparks::advance(double seconds, const LaserTool& beam, const Document& document,
                         const WaitingStrokes& waiting, bool waiting_changed, ViewState& view) {
  if (!view.look.sparks) particles_.clear();
  const UpAxis axis = view.camera.up_axis();
  const Vec3 up = axis == UpAxis::kZ ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
  const World& world = document.world();
  const double before = std::exchange(removed_, document.history().totals().removed_mass);
  const double mass = removed_ - before;
  const bool wanted = mass > 0 && view.look.sparks && !view.look.stage;
  const auto shown = wanted ? beam.picture(document) : std::nullopt;
  if (shown && shown->strike) {
    const Vec3 along = glm::normalize(shown->to - shown->from);
    particles_.add({*shown->strike, along, world.loaded_bounds().diagonal() / kCar, mass}, up);
  }
  if (particles_.empty() && !had_particles_ && !waiting_changed) return;
  particles_.advance(seconds, up, height_of_drawn_ground(world, axis));
  auto effects = std::make_shared<Effects>();
  particles_.append_to(*effects);
  for (const WaitingStrokes::Stroke& stroke : waiting.strokes()) effects->beams.push_back(stroke.beam);
  had_particles_ = !particles_.empty();
  view.look.effects = had_particles_ || !effects->beams.empty() ? std::move(effects) : nullptr;
  view.picture_old = true;
}

void BeamSparks::forget(ViewState& view) {
  *this = BeamSparks();
  view.look.effects = nullptr;
}

std::optional<std::array<Vec2, 8>> seen_corners(const World::Bounds& bounds, const CameraView& view,
                                                const Area& picture) {
  std::array<Vec2, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    const Vec3 seen = view.project({(i & 1u) != 0 ? bounds.max.x : bounds.min.x,
                                    (i & 2u) != 0 ? bounds.max.y : bounds.min.y,
                                    (i & 4u) != 0 ? bounds.max.z : bounds.min.z});
    if (seen.z <= 0) return std::nullopt;
    corners[i] = picture.at + Vec2(0.5 + 0.5 * seen.x, 0.5 - 0.5 * seen.y) * picture.size;
  }
  return corners;
}

bool meets_hull(const Area& area, std::span<const Vec2> points) {
  KERF_ASSERT(!points.empty());
  const std::array<Vec2, 4> corners = corners_of(area);
  if (apart_along({1, 0}, corners, points) || apart_along({0, 1}, corners, points)) return false;
  for (const Vec2& p : points) {
    for (const Vec2& q : points) {
      if (p != q && apart_along({q.y - p.y, p.x - q.x}, corners, points)) return false;
    }
  }
  return true;
}

std::optional<Area> free_place(const Area& picture, Vec2 size, double margin,
                               const std::function<bool(const Area&)>& is_free) {
  const Vec2 room = picture.size - size - Vec2(2 * margin);
  if (room.x < 0 || room.y < 0) return std::nullopt;
  for (const double down : {1.0, 0.0}) {
    for (const double along : {0.5, 0.0, 1.0}) {
      const Area place{picture.at + Vec2(margin) + room * Vec2(along, down), size};
      if (is_free(place)) return place;
    }
  }
  return std::nullopt;
}

void draw_hint_box(const World& world, const ViewState& view, const Area& taken) {
  const Area& picture = view.layout.first;
  const auto corners = seen_corners(world.bounds(), view.seen_first(), picture);
  if (!corners) return;
  const auto is_free = [&](const Area& area) {
    return !meets_hull(area, *corners) && !meets_hull(area, corners_of(taken)) &&
           !meets_hull(area, corners_of(view.header)) && !meets_hull(area, corners_of(view.toolbar)) &&
           !hides_axes(view, area);
  };
  const std::vector<std::string> hints = first_hints(view);
  const auto place = free_place(picture, size_of_hints(hints), 1.2 * ImGui::GetFontSize(), is_free);
  if (!place) return;
  draw_hints(hints, *place);
  mark_area("hints", *place);
}

std::unique_ptr<Feature> laser_feature(Workspace& workspace) {
  return std::make_unique<LaserFeature>(workspace);
}

}  // namespace kerf
