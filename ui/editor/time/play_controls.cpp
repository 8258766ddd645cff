#include "ui/editor/time/play_controls.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include "core/base/assert.h"
#include "core/base/json.h"
#include "core/document/text/json.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/user_input.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/editor/shared/world_changes.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/bodies/overlay_marks.h"
#include "ui/render/view/camera.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr double kMeasured = 0.5;  // s, of one measurement
}

void ReachedSpeed::follow(bool playing, Ticks clock, double seconds) {
  if (!playing || !playing_ || clock < from_) {
    *this = ReachedSpeed();
    playing_ = playing;
    from_ = clock;
    return;
  }
  seconds_ += seconds;
  if (seconds_ < kMeasured) return;
  reached_ = seconds_of_ticks(clock - from_) / seconds_;
  from_ = clock;
  seconds_ = 0;
}

namespace {

constexpr double kMaxLag = 0.1;  // s, max. lag to catch up with
constexpr double kMaxTicks = kMaxLag * kTicksPerSecond;
constexpr double kMaxFrame = 0.1, kRest = 1;  // s, max. time to catch up with, visible and not visible
constexpr double kTintedFrom = 500;           // K; below, there is neither tint nor glow
constexpr double kSeenOnScale = 8;            // K above ambient, a step of the temperature view

UserAction speed_action(Workspace& workspace, PlayState& play, bool faster) {
  return {.id = faster ? "physics.faster" : "physics.slower",
          .name = faster ? "Faster" : "Slower",
          .shortcut = faster ? "=" : "-",
          .also = {faster ? GLFW_KEY_KP_ADD : GLFW_KEY_KP_SUBTRACT},
          .tip = "Changes the speed between 1/8 of real time and real time.",
          .run =
              [&play, &message = workspace.message, faster] {
                KERF_ASSERT(faster ? play.can_go_faster() : play.can_go_slower());
                faster ? ++play.speed_index : --play.speed_index;
                message.info(std::string("Speed: ") + play.speed().name);
              },
          .disabled_reason = [&play, faster]() -> const char* {
            if (faster) return play.can_go_faster() ? nullptr : "Already at maximum speed: real time.";
            return play.can_go_slower() ? nullptr : "Already at minimum speed: 1/8 of real time.";
          }};
}

std::vector<UserAction> time_actions(Workspace& workspace, PlayState& play) {
  const auto play_disabled_reason = [&workspace] { return workspace.time_disabled_reason(); };
  return {
      make_action(
          "physics.play", "Play", "Space",
          "Plays or pauses the simulation, in which separated pieces fall. One undo covers all of it.",
          [&play] { play.play_or_pause(); },
          {.disabled_reason =
               [&play, play_disabled_reason] { return play.playing ? nullptr : play_disabled_reason(); },
           .checked = [&play] { return play.playing; }}),
      make_action("physics.step", "Step Physics", ".", "Advances the simulation by one tick (1/120 s).",
                  [&play] { play.request_tick(); }, {.disabled_reason = play_disabled_reason}),
      speed_action(workspace, play, false),
      speed_action(workspace, play, true),
  };
}

constexpr int kCoils = 9;
constexpr float kMinCoiled = 2;  // text sizes; a shorter spring is a line

constexpr double kAsFast = 0.9;  // of the selected speed; below, the actual speed is shown

std::string words_of(const PlayState& play, const ReachedSpeed& reached, const World& world) {
  const double seconds = seconds_of_ticks(world.clock());
  if (!play.playing) return text_of("Paused  %.2f s", seconds);
  return "Playing " + speed_text(play, reached) + text_of("  %.1f s", seconds);
}

// Draws a zigzag between two places, over a dark line.
void draw_coil(Vec2 from, Vec2 to, float em, ImDrawList& list) {
  const Vec2 way = to - from;
  const double length = glm::length(way);
  const Vec2 aside = length > 0 ? Vec2(-way.y, way.x) / length * (0.3 * em) : Vec2(0);
  std::vector<ImVec2> points{to_im(from)};
  const int coils = length > kMinCoiled * em ? kCoils : 0;
  for (int i = 0; i < coils; ++i) {
    const double along = 0.12 + 0.76 * (i + 0.5) / coils;
    points.push_back(to_im(from + along * way + (i % 2 == 0 ? aside : -aside)));
  }
  points.push_back(to_im(to));
  const int count = static_cast<int>(points.size());
  list.AddPolyline(points.data(), count, IM_COL32(10, 12, 16, 170), 0, 4);
  list.AddPolyline(points.data(), count, colours::accent(), 0, 1.8f);
}

}  // namespace

void TimeFlow::advance(double seconds) {
  if (!may_continue()) return end();
  const Document& document = workspace_.session.document;
  pace_.due += std::min(seconds, kMaxLag) * play_.speed().of_real_time * kTicksPerSecond;
  if (workspace_.changes.is_pending() || document.waiting() > 0) {
    pace_.slow_down();
    return pace_.limit_to(pace_.most);
  }
  pace_.speed_up(kMaxTicks);
  if (play_.one_tick && begun_) end();  // the playback before
  if (!begin()) return;
  const bool single = std::exchange(play_.one_tick, false);
  const auto ticks = single ? Ticks{1} : static_cast<Ticks>(pace_.due);
  if (ticks > 0) queue_ticks(ticks);
  if (single) begun_ = false;  // each single tick is a history entry
}

void TimeFlow::end() {
  pace_.due = 0;
  before_ground_.reset();
  if (!begun_ || workspace_.changes.is_pending() || workspace_.session.document.waiting() > 0) return;
  mark_state(workspace_.session.document, workspace_.session.marks, true);
  begun_ = false;
}

// Ends playback if required.
bool TimeFlow::may_continue() {
  const size_t position = workspace_.session.document.history().position();
  const bool undone = position < std::exchange(position_, position);
  if (!play_.playing && !play_.one_tick) return false;
  if (workspace_.changes.is_pending()) return true;
  const char* disabled_reason = workspace_.time_disabled_reason();
  if (disabled_reason != nullptr) workspace_.message.info(disabled_reason);
  if (disabled_reason != nullptr || (undone && begun_)) play_.stop();
  return play_.playing || play_.one_tick;
}

// Returns false while something else must be done first.
bool TimeFlow::begin() {
  if (begun_) return true;
  Document& document = workspace_.session.document;
  end_exploded_view(workspace_.world(), workspace_.view);
  const Environment fitting = fitting_environment(document.world(), workspace_.view.frame);
  if (fitting != document.world().environment()) {
    if (document.queue().in_stroke()) return false;
    before_ground_ = document.history().position();
    workspace_.changes.apply(SetEnvironment{fitting});
    return false;
  }
  if (!document.queue().in_stroke()) document.apply(Play{});
  position_ = document.history().position();
  // The user has done nothing in between, so one undo includes the ground.
  if (before_ground_ && position_ == *before_ground_ + 2)
    workspace_.changes.groups().add(*before_ground_, document, "Play");
  before_ground_.reset();
  return begun_ = true;
}

void TimeFlow::queue_spring() {
  Document& document = workspace_.session.document;
  if (!spring_ && document.world().spring()) document.apply(ReleaseBody{});
  if (spring_ && document.world().spring() != spring_)
    document.apply(DragBody{spring_->piece, spring_->at, spring_->to});
}

// Queues ticks up to a full minute at most.
void TimeFlow::queue_ticks(Ticks ticks) {
  DocumentSession& session = workspace_.session;
  const Ticks of_minute = session.world().clock() % CommandQueue::kTicksToForget;
  if (of_minute == 0) mark_state(session.document, session.marks, true);
  ticks = std::min(ticks, CommandQueue::kTicksToForget - of_minute);
  pace_.take(ticks);
  queue_spring();
  session.document.apply(AdvanceTime{ticks, true});
}

// Cooling
// --------------------------------------------------------------------------------------------------------

bool Cooling::flows() const {
  const UndoStack& history = workspace_.session.document.history();
  const bool stands = play_.playing || play_.one_tick || workspace_.settings.heat_held ||
                      workspace_.changes.is_pending() || workspace_.time_disabled_reason() != nullptr;
  return !stands && history.position() == history.size() && is_hot(workspace_.world());
}

bool Cooling::is_seen() const {
  const double least = workspace_.view.look.show.heat ? kAmbient + kSeenOnScale : kTintedFrom;
  return workspace_.screen.picture->first().warmest() > least;
}

bool Cooling::moving() const {
  return flows() && (is_seen() || workspace_.screen.clock->seconds() - passed_at_ >= kRest);
}

void Cooling::advance(double seconds) {
  Document& document = workspace_.session.document;
  if (!flows()) {
    pace_.due = 0;
    unseen_ = false;
    return;
  }
  if (document.waiting() > 0) return pace_.slow_down();
  const bool seen = is_seen();
  const double longest = (seen ? kMaxFrame : kRest) * kTicksPerSecond;
  pace_.due = std::min(longest, pace_.due + seconds * kTicksPerSecond);
  unseen_ = false;
  if (!seen && pace_.due < longest) return;
  if (seen) pace_.speed_up(longest);
  if (!seen) pace_.limit_to(longest);
  const auto ticks = static_cast<Ticks>(pace_.due);
  if (ticks == 0) return;
  pace_.take(ticks);
  document.apply(AdvanceTime{ticks, false, true});
  unseen_ = !seen;
  passed_at_ = workspace_.screen.clock->seconds();
}

const char* pin_disabled_reason(const ViewState& view) { return no_selection_reason(view.look.pieces); }

bool selected_are_pinned(const World& world, const ViewState& view) {
  bool any = false;
  for (const auto& [id, look] : view.look.pieces) {
    if (!look.selected || !world.contains(id.body)) continue;
    if (!world.body(id.body).pinned) return false;
    any = true;
  }
  return any;
}

SetEnvironment with_gravity(const World& world, const FileFrame& frame, bool on) {
  Environment around = default_environment(world, frame);
  if (!on) around.gravity = Vec3(0);
  if (!on && frame.up != UpAxis::kY) around.ground.reset();
  return {around};
}

void request_pin(Workspace& workspace, bool pinned) {
  const char* name = pinned ? "Pin pieces" : "Unpin pieces";
  const auto run = [&workspace, name, pinned] {
    cancel_stroke(workspace);
    workspace.changes.change(name, is_small(workspace.session.document),
                             edit_all(selected_ids(workspace.view.look.pieces), [pinned](const PieceId& p) {
                               return PinPiece{p, pinned};
                             }));
    return true;
  };
  workspace.changes.enqueue({.name = name, .run = run, .is_one = true});
}

std::vector<UserAction> body_actions(Workspace& workspace, PlayState& play) {
  std::vector<UserAction> actions = time_actions(workspace, play);
  const auto has_gravity = [&workspace] { return workspace.world().environment().gravity != Vec3(0); };
  const auto are_pinned = [&workspace] { return selected_are_pinned(workspace.world(), workspace.view); };
  actions.push_back(make_action(
      "physics.gravity", "Gravity", "", "Switches gravity on or off; the Bodies panel sets its value.",
      [&workspace, has_gravity] {
        workspace.changes.enqueue(with_gravity(workspace.world(), workspace.view.frame, !has_gravity()));
      },
      {.checked = has_gravity}));
  actions.push_back(
      make_action("pieces.pin", "Pin Selected", "Shift+P",
                  "Fixes the selected pieces in place while others move; repeat to release them.",
                  [&workspace, are_pinned] { request_pin(workspace, !are_pinned()); },
                  {.disabled_reason = [&workspace] { return pin_disabled_reason(workspace.view); },
                   .checked = are_pinned}));
  return actions;
}

std::string speed_text(const PlayState& play, const ReachedSpeed& reached) {
  const double least = kAsFast * play.speed().of_real_time;
  if (!reached.of_real_time() || *reached.of_real_time() >= least) return play.speed().name;
  return text_of("%.2gx of %s", *reached.of_real_time(), play.speed().name);
}

// Has a minimum width, so that its size stays the same as the time grows.
void draw_play_badge(const PlayState& play, const ReachedSpeed& reached, const World& world,
                     const ViewState& view, Badges& badges) {
  constexpr float kMinEms = 9.5f;
  badges.draw(view, play.playing ? Badges::Sign::kPlaying : Badges::Sign::kPaused,
              words_of(play, reached, world), "play badge", kMinEms);
}

void draw_spring(const Spring& spring, const World& world, const ViewState& view) {
  if (!world.contains(spring.piece.body)) return;
  const Placement& placement = world.body(spring.piece.body).placement;
  const PrimaryViewport picture(view);
  const auto from = picture.place_of(placement.to_world(spring.at));
  const auto to = picture.place_of(spring.to);
  if (!from || !to) return;
  const float em = ImGui::GetFontSize();
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  draw_coil(*from, *to, em, list);
  for (const Vec2& end : {*from, *to}) {
    list.AddCircleFilled(to_im(end), 0.32f * em, IM_COL32(10, 12, 16, 170));
    list.AddCircleFilled(to_im(end), 0.22f * em, colours::accent());
  }
}

namespace {

// Returns a relaxed spring at the point of a visible piece under a place in the first half (screen
// coordinates); nullopt on a miss, or if the body is pinned.
std::optional<Spring> spring_at(const World& world, const ViewState& view, Vec2 place) {
  const Pose ray = PrimaryViewport(view).ray(place);
  const std::optional<Pick> seen = pick(world, view.look, ray);
  if (!seen || world.body(seen->body).pinned) return std::nullopt;
  const Body& body = world.body(seen->body);
  const Vec3 held = ray.origin + ray.direction * seen->length;
  return Spring{{seen->body, body.mesh.data(seen->face).piece}, body.placement.to_body(held), held};
}

// Moves the far end of the spring under a place of the first half, in the plane through the end that faces
// the camera.
void stretch(Spring& spring, const ViewState& view, Vec2 place) {
  spring.to = PrimaryViewport(view).at_depth_of(spring.to, place);
}

// Panel for play, pause and speed, gravity and ground, pins, display of contacts, and numbers of the last
// tick.
class BodiesPanel {
 public:
  void draw(Workspace& workspace, PlayState& play);

 private:
  void draw_environment(Workspace& workspace);

  NumberFields fields_;
};

void draw_time(Workspace& workspace, PlayState& play) {
  const char* disabled_reason = workspace.time_disabled_reason();
  const auto told = [&](const char* meaning, const char* action) {
    return with_shortcut(workspace.view, meaning, action);
  };
  if (row_button(play.playing ? "Pause###play" : "Play###play", 2, play.playing ? nullptr : disabled_reason,
                 told("Plays or pauses the simulation.", "physics.play").c_str()))
    play.play_or_pause();
  mark_last_item("bodies play");
  ImGui::SameLine();
  if (row_button("Step Physics", 2, disabled_reason,
                 told("Advances the simulation by one tick (1/120 s).", "physics.step").c_str()))
    play.request_tick();
  mark_last_item("bodies tick");
}

void draw_speed(PlayState& play) {
  property("Speed");
  if (begin_fitted_combo("##speed", play.speed().name)) {
    for (size_t i = PlayState::kSpeeds.size(); i-- > 0;) {
      if (ImGui::Selectable(PlayState::kSpeeds.at(i).name, i == play.speed_index)) play.speed_index = i;
    }
    ImGui::EndCombo();
  } else {
    tooltip("Speed relative to real time. The simulation slows down if ticks take too long.");
  }
}

void draw_pin(Workspace& workspace) {
  const bool pinned = selected_are_pinned(workspace.world(), workspace.view);
  if (row_button(
          pinned ? "Unpin Selected###pin" : "Pin Selected###pin", 1, pin_disabled_reason(workspace.view),
          with_shortcut(workspace.view, "Fixes the selected pieces in place while others move.", "pieces.pin")
              .c_str()))
    request_pin(workspace, !pinned);
  mark_last_item("bodies pin");
}

void draw_statistics(const TickStatistics& statistics) {
  if (statistics.bodies == 0) return;
  const std::string text = grouped(statistics.bodies) + (statistics.bodies == 1 ? " body, " : " bodies, ") +
                           grouped(statistics.awake) + " awake, " +
                           count_text(statistics.contacts, "contact");
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  draw_fitted_text(text, "Counts in the last tick in which bodies moved.");
  ImGui::PopStyleColor();
}

void BodiesPanel::draw_environment(Workspace& workspace) {
  const World& world = workspace.world();
  const FileFrame& frame = workspace.view.frame;
  Environment around = fitting_environment(world, frame);
  const double metres = metres_per_unit(frame.unit);
  bool gravity = around.gravity != Vec3(0);
  property("Gravity");
  if (ImGui::Checkbox("##gravity", &gravity)) workspace.changes.enqueue(with_gravity(world, frame, gravity));
  mark_last_item("gravity on");
  tooltip("Switches gravity on or off.");
  double value = metres * glm::length(around.gravity);
  const Vec3 down = from_y_up({0, -1, 0}, frame.up);
  if (gravity &&
      fields_.number("Acceleration", value, "%.3g m/s\xc2\xb2",
                     "Acceleration of free fall: 9.81 on Earth, 1.62 on the Moon.", {}, kPositive)) {
    around.gravity = value / metres * down;
    workspace.changes.enqueue(SetEnvironment{around});
  }
  double height = around.ground.value_or(0);
  const LengthUnit unit = label_unit(0.1 * world.loaded_bounds().diagonal(), frame.unit);
  if (gravity &&
      length_field(fields_, "Ground", height, unit, "Height of the ground on which pieces rest.")) {
    around.ground = height;
    workspace.changes.enqueue(SetEnvironment{around});
  }
}

void BodiesPanel::draw(Workspace& workspace, PlayState& play) {
  draw_time(workspace, play);
  if (begin_properties("bodies")) {
    draw_speed(play);
    draw_environment(workspace);
    end_properties();
  }
  draw_pin(workspace);
  for (const SwitchId id : {SwitchId::kContacts, SwitchId::kColliders, SwitchId::kCentres, SwitchId::kJoints})
    draw_switch(workspace.view, id);
  draw_statistics(workspace.session.document.queue().physics().statistics());
}

// Returns true if the history up to its position contains playback.
bool has_played(const UndoStack& history) {
  for (size_t i = 0; i < history.position(); ++i) {
    const std::vector<Command>& commands = history.step(i).commands();
    if (!commands.empty() && std::holds_alternative<Play>(commands.front())) return true;
  }
  return false;
}

class TimeFeature : public Feature {
 public:
  explicit TimeFeature(Workspace& workspace) : workspace_(workspace) {}

  std::vector<PanelPart> panel_parts() override {
    return {{"bodies", [this] { panel_.draw(workspace_, play_); }}};
  }
  std::vector<UserAction> actions() override { return body_actions(workspace_, play_); }
  std::vector<Gesture> gestures() const override {
    return {{"pull_piece", "Ctrl+left drag on a piece", "Pull it by a spring, while bodies move"}};
  }

  std::unique_ptr<Interaction> begin_interaction(const Press& press) override {
    if (!picks(workspace_.input, press) || !play_.playing) return nullptr;
    end_exploded_view(workspace_.world(), workspace_.view);
    const auto spring = spring_at(workspace_.world(), workspace_.view, workspace_.input.pointer);
    return spring ? std::make_unique<Pull>(*this, *spring) : nullptr;
  }
  const char* status_hint() const override {
    return workspace_.input.picks() && play_.playing ? "Select: drag to pull a piece, click to select it"
                                                     : nullptr;
  }

  void update(double) override {
    if (dynamic_cast<const Pull*>(workspace_.input.held.get()) == nullptr) spring_.reset();
    workspace_.links.cools_unseen = cooling_.passes_unseen();
  }
  void after_queue(double seconds) override;
  bool needs_redraw() const override { return cooling_.moving() || play_.playing || play_.one_tick; }
  void on_world_changed(const Delta& delta) override {
    if (spring_) spring_->piece = named_after(delta, spring_->piece);
  }

  void draw_overlay(ImDrawList&) override {
    if (spring_) draw_spring(*spring_, workspace_.world(), workspace_.view);
    const bool stands =
        !play_.playing && !workspace_.links.cools && has_played(workspace_.session.document.history());
    if (play_.playing || stands)
      draw_play_badge(play_, reached_, workspace_.world(), workspace_.view, workspace_.services.badges);
    if (workspace_.settings.heat_held && is_hot(workspace_.world()))
      workspace_.services.badges.draw(workspace_.view, Badges::Sign::kMode, "Temperatures frozen",
                                      "heat badge");
  }
  void write_session_log(nlohmann::ordered_json& report) const override;

 private:
  // While time passes, a drag pulls the pressed piece and a click selects it.
  class Pull : public Interaction {
   public:
    Pull(TimeFeature& feature, const Spring& spring)
        : feature_(feature), pressed_at_(feature.workspace_.input.pointer), spring_(spring) {}

    void move(const InputEvent&) override;
    void release(const InputEvent& event) override {
      if (!pulls_) select_under_pointer(feature_.workspace_, (event.mods & GLFW_MOD_SHIFT) != 0);
    }
    bool cancel() override { return pulls_; }
    const char* words() const override { return pulls_ ? "Pulling: release to end" : nullptr; }

   private:
    TimeFeature& feature_;
    Vec2 pressed_at_;
    Spring spring_;
    bool pulls_ = false;
  };

  Workspace& workspace_;
  PlayState play_;
  std::optional<Spring> spring_;  // that pulls a piece
  TimeFlow flow_{workspace_, play_, spring_};
  Cooling cooling_{workspace_, play_};
  ReachedSpeed reached_;
  BodiesPanel panel_;
};

void TimeFeature::Pull::move(const InputEvent&) {
  if (!pulls_ && glm::length(feature_.workspace_.input.pointer - pressed_at_) > kClickReach) {
    pulls_ = true;
    feature_.spring_ = spring_;
  }
  if (feature_.spring_)
    stretch(*feature_.spring_, feature_.workspace_.view, feature_.workspace_.input.pointer);
}

void TimeFeature::after_queue(double seconds) {
  flow_.advance(seconds);
  cooling_.advance(seconds);
  workspace_.links.cools = cooling_.flows();
  workspace_.links.plays = play_.playing;
  reached_.follow(play_.playing, workspace_.world().clock(), seconds);
  workspace_.services.statistics.shown.time = play_.playing ? "playing " + speed_text(play_, reached_) : "";
  // The viewport is redrawn whenever contacts may have changed.
  if (workspace_.changes.is_pending() || !workspace_.view.picture_old) return;
  workspace_.view.look.bodies = gather_body_marks(
      workspace_.world(), workspace_.session.document.queue().physics(), workspace_.view.look.show);
}

nlohmann::ordered_json heat_of(const World& world) {
  double hottest = kAmbient;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    body.mesh.columns().for_each_set(body.heat.energy, [&](FaceId f) {
      const Sheet& sheet = body.sheet;
      hottest = std::max(hottest, body.heat.temperature(body.mesh, f, sheet.substance, sheet.thickness));
    });
  }
  return {{"hottest", hottest}, {"emitted", world.energy().emitted}, {"absorbed", world.energy().absorbed}};
}

void TimeFeature::write_session_log(nlohmann::ordered_json& report) const {
  const World& world = workspace_.world();
  report["time"] = {
      {"ticks", world.clock()},
      {"playing", play_.playing},
      {"speed", play_.speed().of_real_time},
      {"gravity", vector_json(world.environment().gravity)},
      {"ground", world.environment().ground ? nlohmann::ordered_json(*world.environment().ground)
                                            : nlohmann::ordered_json(nullptr)}};
  report["heat"] = heat_of(world);
}

}  // namespace

std::unique_ptr<Feature> time_feature(Workspace& workspace) {
  return std::make_unique<TimeFeature>(workspace);
}

}  // namespace kerf
