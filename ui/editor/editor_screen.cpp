#include "ui/editor/editor_screen.h"

#include <imgui.h>

#include <GLFW/glfw3.h>

#include <nlohmann/json.hpp>

#include "core/base/assert.h"
#include "ui/editor/editor_report.h"
#include "ui/editor/file_choice.h"
#include "ui/editor/graph/graph_reading.h"
#include "ui/editor/keys/bindings.h"
#include "ui/editor/laser_desk.h"
#include "ui/editor/panel_list.h"
#include "ui/editor/section/section_edits.h"
#include "ui/editor/tools/moving.h"
#include "ui/editor/tools/popups.h"
#include "ui/render/body_marks.h"

namespace kerf {

namespace {

constexpr uint32_t kFacesSent = 50'000;  // of a scene that is shown anew, in one frame
constexpr double kLongestEaseStep = 0.05;
constexpr double kMissable = 0.05;  // s; for so long nobody misses a frame
constexpr double kLongest = 1e6;    // s; a script waits for what works in the background

}  // namespace

EditorScreen::EditorScreen(Window& window, LivePicture picture, LoadedSettings loaded,
                           const EditorOptions& options)
    : window_(window),
      options_(options),
      picture_(std::move(picture)),
      saved_(loaded.settings),
      kept_path_(state_folder()),
      changes_({state_.work, state_.view, state_.hand, state_.figures, state_.message, picture_.first()}),
      stage_cut_(
          {state_.work, state_.hand, state_.view, state_.figures, changes_, state_.stages, window.clock()}),
      cut_({state_.work, state_.view, state_.hand, state_.split, state_.figures, state_.message, changes_,
            stage_cut_, picture_, window.clock()}),
      time_({state_.work, state_.view, state_.hand, state_.split, state_.stages.wishes, state_.opening,
             state_.play, state_.message, changes_, groups_}),
      cooling_({state_.work, state_.view, state_.settings, state_.split, state_.stages.wishes, state_.opening,
                state_.play, changes_, picture_.first(), window.clock()}),
      opener_({state_.work, state_.view, state_.hand, state_.split, state_.stages.log, state_.figures,
               state_.opening, state_.settings, state_.message, recovery_, picture_.first()}),
      desk_(state_, changes_, groups_, opener_, recovery_),
      panels_(make_panels(state_)),
      usual_actions_(make_actions(state_, panels_)),
      actions_(usual_actions_) {
  state_.settings = std::move(loaded.settings);
  threads_.follow(state_.settings.threads);
  state_.view.look.antialias = state_.settings.antialias;
  state_.view.look.show = default_show();
  if (options.landmarks || window.script() != nullptr) keep_landmarks(&landmarks_.emplace(options.landmarks));
}

Status EditorScreen::open() {
  lay_out_window();
  picture_.first().limit_sending(kFacesSent);
  std::vector<std::string> faults;
  state_.opening.left_work = find_left_work(state_folder(), faults);
  ask_about_left_work(state_.decisions, state_.opening.left_work);
  std::vector<std::filesystem::path> files = options_.files;
  const auto paths = std::stable_partition(files.begin(), files.end(),
                                           [](const std::filesystem::path& f) { return !is_path_file(f); });
  const Status opened = opener_.open_first(options_.default_scene, std::vector(files.begin(), paths));
  std::for_each(paths, files.end(), [&](const std::filesystem::path& f) { tell(load_path(state_, f)); });
  open_kept_path();
  if (opened && !faults.empty()) tell("Work was left that cannot be read: " + faults.front());
  return opened;
}

// A path that was not saved is there again, unless another one was asked for.
void EditorScreen::open_kept_path() {
  if (!state_.lasers.path.empty()) return;
  auto left = kept_path_.adopt();
  if (!left) return;
  state_.lasers.path.begin_edit();
  state_.lasers.path.load(std::move(*left), state_.work.document.world());
  state_.message.say("The path that was not saved is in the Path panel again.");
}

void EditorScreen::keep_path(bool now) {
  const PathWork& path = state_.lasers.path;
  const Status kept = now ? kept_path_.follow(path) : kept_path_.follow(path, window_.clock().seconds());
  if (!kept) state_.message.say("The path cannot be kept: " + kept.error().message, true);
}

void EditorScreen::rest() {
  recovery_.flush();
  keep_path(false);
}

void EditorScreen::tell(const std::string& fault) {
  if (!fault.empty() && !state_.message.is_error) state_.message.say(fault, true);
}

void EditorScreen::come_back(const GuiLook& look, const std::filesystem::path& scene) {
  KERF_ASSERT(wants_game());
  state_.requests.play = false;
  state_.settings.palette = look.palette;
  state_.view.picture_old = true;
  title_.clear();
  if (landmarks_) keep_landmarks(&*landmarks_);
  if (!scene.empty()) state_.requests.open = {scene};
}

void EditorScreen::close(bool left_by_user) {
  if (thread_.busy()) {
    thread_.stop();
    finish_change();
  }
  state_.hand.beam.release(state_.work.document);
  recovery_.follow(state_.work, state_.view, state_.hand.drag == Drag::kLight, state_.message);
  if (left_by_user) recovery_.drop();
  keep_path(true);
  save_settings();
}

GuiLook EditorScreen::look() const {
  const Settings& s = state_.settings;
  return {s.theme, s.palette, window_.scale() * static_cast<float>(s.ui_scale), options_.own_font};
}

bool EditorScreen::moving() const {
  const Emitter& emitter = state_.lasers.emitter;
  return (emitter.firing && emitter.in_shots) || sparks_.moving() || thread_.busy() || easing_ ||
         stage_cut_.waits() || cut_.waits() || state_.view.picture_old || state_.view.heat_old ||
         picture_.busy() || cooling_.moving() || state_.hand.beam.emits() || state_.opening.loader.busy() ||
         state_.graph.playing() || state_.play.playing || state_.play.one_tick;
}

// Hearing
// --------------------------------------------------------------------------------------------------------

void EditorScreen::hear(const Input& input) {
  if (thread_.busy()) {
    if (busy_.hear(input, thread_)) state_.requests.quit = true;
    return;
  }
  lay_out_window();
  bind_actions();
  const MouseParts mouse{state_.hand,     state_.work,           state_.view,
                         state_.settings, state_.opening.loader, state_.requests,
                         state_.message,  state_.lasers,         state_.play};
  std::vector<InputEvent> events = busy_.take_heard();
  events.insert(events.end(), input.events.begin(), input.events.end());
  for (const InputEvent& event : events) {
    if (event.kind != InputEvent::Kind::kKey) {
      hear_mouse(mouse, event);
    } else {
      hear_key(event);
    }
  }
  if (!input.drops.empty()) state_.requests.open = input.drops;
  if (input.close) state_.requests.quit = true;
  if (state_.hand.beam.cutting()) state_.view.picture_old = true;
}

void EditorScreen::hear_mouse(const MouseParts& mouse, const InputEvent& event) {
  const bool in_picture = state_.view.layout.viewport.contains(event.at) && !pointer_is_over_panel();
  if (event.kind == InputEvent::Kind::kPress && is_popup_open() && in_picture) {
    close_popups();
    return held_press_.hold(event);
  }
  if (const auto press = held_press_.begun_by(event)) handle_mouse(mouse, *press, true);
  if (state_.hand.move && state_.hand.drag == Drag::kNone && hear_move(event, in_picture)) return;
  handle_mouse(mouse, event, !ImGui::GetIO().WantCaptureMouse && !is_popup_open());
}

// The mouse while a piece is moved by keys. Returns whether nothing else shall hear the event.
bool EditorScreen::hear_move(const InputEvent& event, bool in_picture) {
  Hand& hand = state_.hand;
  if (event.kind == InputEvent::Kind::kMove) {
    hand.pointer = event.at;
    follow_move(hand, state_.view);
    return false;
  }
  const bool left = event.button == GLFW_MOUSE_BUTTON_LEFT, right = event.button == GLFW_MOUSE_BUTTON_RIGHT;
  if (event.kind != InputEvent::Kind::kPress || (!left && !right)) return false;
  if (left && in_picture) {
    confirm_move(hand, state_.view, state_.requests);
  } else {
    cancel_move(hand, state_.view, state_.requests);
  }
  return in_picture;
}

void EditorScreen::bind_actions() {
  std::map<std::string, std::string>& shortcuts = state_.view.shortcuts;
  if (bound_ == state_.settings.bindings && !shortcuts.empty()) return;
  bound_ = state_.settings.bindings;
  actions_ = bind_keys(usual_actions_, bound_);
  shortcuts.clear();
  for (const UserAction& action : actions_) shortcuts.emplace(action.name, action.shortcut);
}

void EditorScreen::hear_key(const InputEvent& event) {
  if (state_.decisions.question.open()) {
    if (!event.again) question_key(state_.decisions.question, event.button);
  } else if (state_.browser.open) {
    browser_key(state_.browser, event.button);
  } else if (state_.palette.open) {
    palette_key(state_.palette, event.button);
  } else if (state_.settings_page.shown && !ImGui::GetIO().WantTextInput) {
    settings_page_key(state_.settings_page, state_.settings, usual_actions_, event.button, event.mods);
  } else if (state_.hand.move) {
    move_key(state_.hand, state_.view, state_.work.document.world(), state_.requests, event.button);
  } else if (!ImGui::GetIO().WantTextInput && !event.again) {
    if (event.button == GLFW_KEY_ESCAPE) return is_popup_open() ? close_popups() : escape(state_);
    run_shortcut(actions_, event.button, event.mods, state_.message);
  }
}

// Going on
// --------------------------------------------------------------------------------------------------------

void EditorScreen::advance() {
  threads_.follow(state_.settings.threads);
  if (window_.script() != nullptr && state_.opening.loader.busy()) state_.opening.loader.is_over(kLongest);
  if (thread_.busy() && !thread_.is_over(0)) return;
  if (thread_.busy()) finish_change();
  desk_.fulfil();
  drop_lost_move(state_.hand, state_.view, state_.work.document.world());
  if (!changes_.is_pending()) grab_copy(state_.hand, state_.view, state_.work.document.world());
  if (!changes_.is_pending()) follow_emitter(state_, window_.clock().seconds());
  recovery_.follow(state_.work, state_.view, state_.hand.drag == Drag::kLight, state_.message);
  keep_path(false);
  move_camera();
  stage_cut_.advance(std::min<double>(ImGui::GetIO().DeltaTime, kLongestEaseStep));
  place_section(state_.view, state_.work.document.world());
  pass_time(ImGui::GetIO().DeltaTime);
  sparks_.advance(std::min<double>(ImGui::GetIO().DeltaTime, kLongestEaseStep), state_.hand.beam,
                  state_.work.document, state_.view);
  follow_stages();
  follow_bodies();
  if (!changes_.is_pending()) state_.probe.follow(state_.work.document.world(), state_.view, state_.hand);
  follow_graph();
  send();
}

// Works on the queue of the document and lets time pass.
void EditorScreen::pass_time(double seconds) {
  if (!changes_.is_pending()) state_.hand.beam.go_on(state_.work.document, window_.clock().seconds());
  const bool old = state_.view.heat_old, unseen = cooling_.passes_unseen();
  cut_.advance();
  if (unseen) state_.view.heat_old = old;
  if (!changes_.is_pending()) {
    state_.cutting.follow(state_.work.document, stage_cut_.holds_back(), seconds);
    state_.figures.shown.work = state_.cutting.text();
    changes_.tell_done();
  }
  time_.advance(seconds);
  cooling_.advance(seconds);
}

std::optional<std::string> EditorScreen::answer(const std::string& what) const {
  if (what == "landmarks" && landmarks_) return landmarks_->text();
  if (what == "report")
    return editor_report(state_).dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  return std::nullopt;
}

void EditorScreen::move_camera() {
  easing_ = state_.view.camera.advance(std::min<double>(ImGui::GetIO().DeltaTime, kLongestEaseStep));
  if (easing_) state_.view.picture_old = true;
}

void EditorScreen::follow_stages() {
  if (changes_.is_pending()) return;
  ViewState& view = state_.view;
  std::shared_ptr<const StageMarks> marks;
  if (state_.stages.wishes.on) marks = state_.stages.log.marks(state_.work.document.world());
  if (view.look.stage == marks) return;
  view.look.stage = std::move(marks);
  view.picture_old = true;
}

// The picture is old wherever contacts may have changed.
void EditorScreen::follow_bodies() {
  ViewState& view = state_.view;
  if (changes_.is_pending() || !view.picture_old) return;
  const Document& document = state_.work.document;
  view.look.bodies = gather_body_marks(document.world(), document.physics(), view.look.show);
}

void EditorScreen::follow_graph() {
  ViewState& view = state_.view;
  const bool panel = state_.settings.shows(PanelId::kGraph);
  if (!panel && view.look.lit_face) {
    view.look.lit_face.reset();
    view.picture_old = true;
  }
  if (!panel && !view.look.show.graph) return state_.graph.play(false);
  state_.graph.follow(state_.work.document, stage_cut_.holds_back());
  state_.graph.advance(std::min<double>(ImGui::GetIO().DeltaTime, kLongestEaseStep));
  if (view.look.graph == state_.graph.drawn()) return;
  view.look.graph = state_.graph.drawn();
  if (view.look.show.graph) view.picture_old = true;
}

// To the graphics card. Where a script leaves frames undrawn, changes are sent with the next one that is drawn.
void EditorScreen::send() {
  if (!state_.view.picture_old && !state_.view.heat_old) return;
  Renderer& renderer = picture_.first();
  if (!window_.draws() && !renderer.is_sending() && !cooling_.flows()) return;
  const size_t before = renderer.uploaded_bytes();
  renderer.catch_up(state_.work.document.world());
  if (renderer.uploaded_bytes() > before) state_.figures.chart.note_sent(renderer.uploaded_bytes() - before);
}

// The last of a frame, for what the window shows is seen until the change is done.
void EditorScreen::begin_pending_change() {
  const Document& document = state_.work.document;
  const bool graph = state_.graph.is_asked_for() && !document.in_stroke() && document.waiting() == 0;
  if (!changes_.is_pending() && !graph) return;
  busy_.keep(window_.pixel_size());
  thread_.start(state_.work.document,
                changes_.is_pending() ? *changes_.take_pending() : graph_reading(state_.graph));
  if (thread_.is_over(window_.script() != nullptr ? kLongest : kMissable)) finish_change();
}

void EditorScreen::finish_change() {
  thread_.finish();
  desk_.end_group();
  state_.view.picture_old = true;
}

void EditorScreen::lay_out_window() {
  const double em = ImGui::GetFontSize(), bar = ImGui::GetFrameHeight();
  const Settings& settings = state_.settings;
  Layout layout = lay_out(window_.size(), em, bar, bar, settings.side_shown ? settings.side_ems : 0);
  if (state_.split.shown) layout = split_in_two(layout, settings.split_share);
  ViewState& view = state_.view;
  if (layout.first.size != view.layout.first.size || layout.second.size != view.layout.second.size)
    view.picture_old = true;
  view.layout = layout;
}

void EditorScreen::save_settings() {
  Settings& now = state_.settings;
  now.antialias = state_.view.look.antialias;
  if (options_.width == 0) {  // a size that was asked for this session alone is not kept
    now.width = static_cast<int>(window_.size().x);
    now.height = static_cast<int>(window_.size().y);
  }
  if (now == saved_) return;
  saved_ = now;
  if (const Status written = write_settings(now, settings_file()); !written)
    state_.message.say(written.error().message, true);
}

}  // namespace kerf
