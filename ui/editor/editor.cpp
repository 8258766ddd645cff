#include "ui/editor/editor.h"

#include <imgui.h>

#include <chrono>
#include <thread>

#include "ui/editor/actions.h"
#include "ui/editor/changes/change_world.h"
#include "ui/editor/changes/recut.h"
#include "ui/editor/editor_report.h"
#include "ui/editor/editor_state.h"
#include "ui/editor/frame/busy_window.h"
#include "ui/editor/panels/panels.h"
#include "ui/editor/tools/light_handle.h"
#include "ui/editor/tools/piece_set.h"
#include "ui/editor/tools/viewport_input.h"
#include "ui/editor/work/file_opener.h"
#include "ui/editor/work/save_work.h"
#include "ui/editor/work/settings.h"
#include "ui/editor/work/unsaved_work.h"
#include "ui/editor/work/work_keeper.h"
#include "ui/gl/debug_output.h"
#include "ui/screen/live_picture.h"
#include "ui/window/gui.h"
#include "ui/window/landmarks.h"
#include "ui/window/screenshot.h"
#include "ui/window/stop_signals.h"
#include "ui/window/window.h"

namespace kerf {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFrameSeconds = 1.0 / 60;  // no frame begins sooner after the last one
constexpr double kStepSeconds =
    0.020;  // of cutting in one frame, or as long as drawing takes if that is more
constexpr size_t kMovesOfStep = 16;
constexpr uint32_t kFacesSent = 50'000;  // of a scene that is shown anew, in one frame
constexpr double kFigureSeconds = 0.25;
constexpr double kLongestEaseStep = 0.05;
constexpr double kSettleSeconds = 1.0;  // after the last event the panels are still drawn (tooltips appear)
constexpr double kSettleWait = 0.12, kIdleWait = 0.5;
constexpr double kMissable = 0.05;  // for so long nobody misses a frame

double seconds_since(Clock::time_point t) { return std::chrono::duration<double>(Clock::now() - t).count(); }

// The running editor. One frame is: hear, move, cut, draw, show.
class Editor {
 public:
  Editor(Window window, Renderer renderer, LoadedSettings loaded, const EditorOptions& options);

  Status open(const EditorOptions& options);
  void run();
  // A fault that is shown when nothing worse happened.
  void tell(const std::string& fault) {
    if (!fault.empty() && !state_.message_is_error) state_.say(fault, true);
  }
  const EditorState& state() const { return state_; }

 private:
  void frame();
  void wait();
  void begin_long_change();
  void show_long_work();
  void finish_long_work();
  void hear();
  void hear_key(const InputEvent& event);
  void fulfil();  // what panels, menus and keys asked for
  void decide();
  void leave(const Requests& wanted);
  void show_title();
  void move_camera();
  void cut();
  bool cut_first(Clock::time_point began, double budget);  // whether anything was cut
  bool cut_twin(Clock::time_point began, double budget);
  void send();  // to the graphics card
  bool draw();  // whether the picture is a new one
  void show_landmarks();
  void note_time(double seconds, double without_picture, bool new_picture);
  void update_figures();
  void look_at_tree();
  void lay_out_window();
  void dress();
  void save_settings();
  void take_picture(Requests::Screenshot what);
  // Whether something moves that has to be drawn at once.
  bool moving() const {
    return easing_ || state_.document.waiting() > 0 || state_.split.twin.waiting() > 0 ||
           state_.picture_old || picture_.busy() || state_.loader.busy();
  }

  Window window_;
  const EditorOptions& options_;
  std::optional<Landmarks> landmarks_;
  Gui gui_;
  LivePicture picture_;
  EditorState state_;
  Settings saved_;  // as they are in the file
  WorkKeeper keeper_;
  FileOpener opener_{state_, picture_.first(), keeper_};
  std::string title_;  // of the window
  StopSignals stop_;
  BusyWindow busy_;  // while long work is done
  Clock::time_point frame_began_ = Clock::now(), last_event_ = Clock::now(), figures_at_{};
  bool easing_ = false;                           // the camera
  double cut_seconds_ = 0, picture_seconds_ = 0;  // of the last frame
};

Editor::Editor(Window window, Renderer renderer, LoadedSettings loaded, const EditorOptions& options)
    : window_(std::move(window)),
      options_(options),
      gui_(window_),
      picture_(std::move(renderer)),
      saved_(loaded.settings) {
  state_.settings = std::move(loaded.settings);
  state_.look.antialias = state_.settings.antialias;
  state_.look.show.shadows = true;
  dress();
  if (options.landmarks) keep_landmarks(&landmarks_.emplace(*options.landmarks));
}

Status Editor::open(const EditorOptions& options) {
  lay_out_window();
  picture_.first().limit_sending(kFacesSent);
  std::vector<std::string> faults;
  state_.left_work = find_left_work(state_folder(), faults);
  ask_about_left_work(state_);
  const Status opened = opener_.open_first(options.default_scene, options.files);
  if (opened && !faults.empty()) tell("Work was left that cannot be read: " + faults.front());
  return opened;
}

void Editor::run() {
  while (!state_.quit && !stop_.came()) {
    if (state_.long_work.busy()) {
      show_long_work();
    } else {
      frame();
    }
  }
  if (state_.long_work.busy()) {
    state_.long_work.stop();
    finish_long_work();
  }
  state_.tool.release(state_.document);
  keeper_.follow(state_);
  if (!stop_.came()) keeper_.drop();
  save_settings();
}

void Editor::frame() {
  wait();
  const Clock::time_point began = Clock::now();
  dress();
  gui_.begin_frame();
  lay_out_window();
  hear();
  fulfil();
  keeper_.follow(state_);
  move_camera();
  cut();
  send();
  const bool new_picture = draw();
  show_title();
  const double without_picture = seconds_since(began) - picture_seconds_;
  begin_long_change();
  window_.swap();
  note_time(seconds_since(began), without_picture, new_picture);
  show_landmarks();
}

// Long work
// ---------------------------------------------------------------------------------------------------

// At the end of a frame: it is what is seen until the work is done.
void Editor::begin_long_change() {
  if (!state_.long_change) return;
  busy_.keep(window_.pixel_size());
  state_.long_work.start(state_.document, *std::exchange(state_.long_change, {}));
  if (state_.long_work.is_over(kMissable)) finish_long_work();
}

// In place of a frame.
void Editor::show_long_work() {
  window_.wait(kFrameSeconds);
  const Clock::time_point began = Clock::now();
  if (state_.long_work.is_over(0)) {
    finish_long_work();
  } else {
    dress();
    busy_.show(state_, window_, gui_);
  }
  state_.frames.add(1000 * seconds_since(began));
  state_.between_pictures.add(1000 * seconds_since(began));
}

void Editor::finish_long_work() {
  state_.long_work.finish();
  frame_began_ = last_event_ = Clock::now();
  state_.picture_old = true;
}

// Frames
// ------------------------------------------------------------------------------------------------------

// Until there is something to draw: at once while something moves, at an event otherwise.
void Editor::wait() {
  const double left = kFrameSeconds - seconds_since(frame_began_);
  if (left > 0) std::this_thread::sleep_for(std::chrono::duration<double>(left));
  window_.wait(0);
  while (!moving() && !window_.take_activity() && !stop_.came()) {
    keeper_.flush();
    const bool settling = seconds_since(last_event_) < kSettleSeconds;
    window_.wait(settling ? kSettleWait : kIdleWait);
    if (settling) {
      frame_began_ = Clock::now();
      return;
    }
  }
  last_event_ = Clock::now();
  frame_began_ = Clock::now();
}

void Editor::hear() {
  const ImGuiIO& io = ImGui::GetIO();
  const bool popup = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  const bool mouse_free = !io.WantCaptureMouse && !popup;
  std::vector<InputEvent> events = busy_.take_heard();
  for (const InputEvent& event : window_.take_events()) events.push_back(event);
  for (const InputEvent& event : events) {
    if (event.kind != InputEvent::Kind::kKey) {
      handle_mouse(state_, event, mouse_free);
    } else {
      hear_key(event);
    }
  }
  if (auto dropped = window_.take_drops(); !dropped.empty()) state_.requests.open = std::move(dropped);
  if (window_.take_close()) state_.requests.quit = true;
  if (state_.tool.cutting()) state_.picture_old = true;
}

void Editor::hear_key(const InputEvent& event) {
  if (state_.question.open()) {
    if (!event.again) question_key(state_.question, event.button);
  } else if (state_.browser.open) {
    browser_key(state_.browser, event.button);
  } else if (!ImGui::GetIO().WantTextInput && !event.again) {
    run_shortcut(state_, event.button, event.mods);
  }
}

void Editor::fulfil() {
  decide();
  const Requests wanted = std::exchange(state_.requests, {});
  state_.requests.screenshot = wanted.screenshot;  // waits for the picture
  if (!wanted.save_to.empty()) {
    cancel_stroke(state_);
    const bool saved = save_work(state_, wanted.save_to);
    keeper_.begin(state_);
    if (saved && state_.leaving) leave(*std::exchange(state_.leaving, {}));
  } else if (state_.leaving && !state_.question.open() && !state_.browser.open) {
    state_.leaving.reset();  // the user did not choose where to save
  }
  if (wanted.leaves_work() && !state_.question.open()) {
    cancel_stroke(state_);
    if (may_leave(state_, wanted)) leave(wanted);
  }
  opener_.take_loaded();
  if (state_.loader.busy()) return;  // what is open is about to go
  Renderer& renderer = picture_.first();
  if (wanted.undo || wanted.redo) step_through_history(state_, renderer, wanted.undo);
  if (wanted.travel && !state_.long_change) travel_to(state_, renderer, *wanted.travel);
  for (const Command& command : wanted.commands) {
    if (state_.long_change) break;
    change_world(state_, renderer, command);
  }
  if (wanted.hide_chosen) hide_chosen(state_, renderer);
  if (wanted.delete_chosen) delete_chosen(state_, renderer);
  if (wanted.show_hidden && !state_.long_change) show_hidden(state_, renderer);
  if (wanted.recut && !state_.long_change) recut_last_stroke(state_, renderer);
}

void Editor::decide() {
  switch (take_decision(state_)) {
    case Decision::kNone:
      break;
    case Decision::kLeave:
      leave(*std::exchange(state_.leaving, {}));
      break;
    case Decision::kSaveFirst:
      if (state_.work.file.empty()) {
        browse(state_, FileBrowser::Purpose::kSave);
      } else {
        state_.requests.save_to = state_.work.file;
      }
      break;
    case Decision::kGoOn:
      opener_.open_left_work();
      break;
  }
}

// The open work is saved, or not wanted any more.
void Editor::leave(const Requests& wanted) {
  state_.loader.cancel();
  if (!wanted.quit) return opener_.open(wanted);
  state_.quit = true;
  state_.work.saved_commands = state_.document.journal().size();
  state_.work.saved_lights = state_.look.lights;
}

void Editor::show_title() {
  const std::string title = window_title(state_);
  if (title == title_) return;
  title_ = title;
  window_.set_title(title);
}

void Editor::move_camera() {
  const double step = std::min<double>(ImGui::GetIO().DeltaTime, kLongestEaseStep);
  easing_ = state_.camera.advance(step);
  if (easing_) state_.picture_old = true;
}

void Editor::cut() {
  cut_seconds_ = 0;
  const Clock::time_point began = Clock::now();
  const double budget = std::max(kStepSeconds, picture_.seconds());
  const bool first = cut_first(began, budget), twin = cut_twin(began, budget);
  if (!first && !twin) return;
  if (first && state_.spread > 0) spread_pieces(state_.document.world(), state_.spread, state_.look.pieces);
  cut_seconds_ = seconds_since(began);
  state_.picture_old = state_.world_changed = true;
}

bool Editor::cut_first(Clock::time_point began, double budget) {
  if (state_.document.waiting() == 0) return false;
  Renderer& renderer = picture_.first();
  state_.tool.find_strike(state_.document);
  while (state_.document.waiting() > 0 && seconds_since(began) < budget) {
    if (close_rim_beside(state_, renderer)) break;
    const size_t faces = state_.document.world().live_faces();
    const Result<StepResult> step = state_.document.step(kMovesOfStep);
    if (!step) {
      show_failed_step(state_, renderer, step.error());
      break;
    }
    follow_step(state_, renderer, *step);
    state_.faces_before_step = faces;
  }
  return true;
}

bool Editor::cut_twin(Clock::time_point began, double budget) {
  SplitView& split = state_.split;
  if (!split.shown) return false;
  const Result<Renderer*> half = picture_.second();
  if (!half) {
    split.shown = false;
    state_.say(half.error().message, true);
    return false;
  }
  const bool anew = split.twin.follow(state_.document, split.resolution);
  if (anew) show_world(state_, split.twin.world(), **half);
  const bool waited = split.twin.waiting() > 0;
  while (split.twin.waiting() > 0 && seconds_since(began) < budget) {
    const Result<StepResult> step = split.twin.step(kMovesOfStep);
    if (!step) {
      (*half)->resend(split.twin.world());
      state_.say("In the right half: " + step.error().message, true);
      break;
    }
    (*half)->follow(split.twin.world(), step->delta);
    if (state_.look.ghost || state_.look.show.face_numbers) (*half)->catch_up(split.twin.world());
  }
  return anew || waited;
}

void Editor::send() {
  if (!state_.picture_old) return;
  Renderer& renderer = picture_.first();
  const size_t before = renderer.uploaded_bytes();
  renderer.catch_up(state_.document.world());
  if (renderer.uploaded_bytes() > before) state_.history.note_sent(renderer.uploaded_bytes() - before);
}

bool Editor::draw() {
  update_figures();
  if (landmarks_) landmarks_->begin_frame();
  draw_panels(state_);
  const Clock::time_point began = Clock::now();
  const bool anew = picture_.draw(state_, window_);
  picture_seconds_ = seconds_since(began);
  const auto screenshot = std::exchange(state_.requests.screenshot, Requests::Screenshot::kNone);
  if (screenshot == Requests::Screenshot::kPicture) take_picture(screenshot);
  gui_.end_frame();
  if (screenshot == Requests::Screenshot::kWindow) take_picture(screenshot);
  return anew;
}

void Editor::show_landmarks() {
  if (!landmarks_) return;
  const ImVec2 at = ImGui::GetIO().MousePos;
  landmarks_->mark(state_.layout);
  for (size_t i = 0; i < state_.look.lights.size(); ++i)
    if (const auto handle = light_handle(state_, i))
      landmarks_->mark("light " + std::to_string(i), {*handle, Vec2(0)});
  if (const Status written = landmarks_->write(moving() || state_.long_work.busy(), {at.x, at.y}); !written)
    state_.say(written.error().message, true);
}

void Editor::note_time(double seconds, double without_picture, bool new_picture) {
  if (picture_.first().is_sending()) state_.picture_old = true;
  state_.frames.add(1000 * seconds);
  state_.between_pictures.add(1000 * without_picture);
  if (cut_seconds_ > 0) {
    state_.cutting_frames.add(1000 * seconds);
    state_.between_cutting_pictures.add(1000 * without_picture);
  }
  if (new_picture) picture_.took(seconds - cut_seconds_);
}

void Editor::update_figures() {
  if (seconds_since(figures_at_) < kFigureSeconds) return;
  figures_at_ = Clock::now();
  save_settings();
  state_.shown.frame_ms = 1000 * picture_.seconds();
  state_.shown.memory = memory_figures(state_, picture_.memory());
  if (!state_.world_changed) return;
  state_.world_changed = false;
  const World& world = state_.document.world();
  state_.shown.faces = world.live_faces();
  state_.shown.pieces = world.live_pieces();
  state_.shown.twin_faces = state_.split.twin.world().live_faces();
  state_.shown.faces_tested = state_.last_step.tested.faces;
  state_.shown.faces_of_step = state_.faces_before_step;
  look_at_tree();
}

void Editor::look_at_tree() {
  const World& world = state_.document.world();
  ShownFigures& shown = state_.shown;
  shown.tree_nodes = 0;
  shown.tree_depth = 0;
  const auto panel = state_.settings.panels.find("Tree");
  const bool depth_shown = panel != state_.settings.panels.end() && panel->second;
  for (const BodyId id : world.ids()) {
    const AabbTree& tree = world.body(id).tree;
    shown.tree_nodes += tree.box_count();
    if (!depth_shown) continue;  // it takes a walk over the whole tree
    tree.for_each_box(
        [&](const AabbTree::Box& box) { shown.tree_depth = std::max(shown.tree_depth, box.depth); });
  }
}

void Editor::lay_out_window() {
  const double em = ImGui::GetFontSize(), bar = ImGui::GetFrameHeight();
  const double side = state_.settings.side_shown ? state_.settings.side_ems : 0;
  Layout layout = lay_out(window_.size(), em, bar, bar, side);
  if (state_.split.shown) layout = split_in_two(layout, state_.settings.split_share);
  const Layout& before = state_.layout;
  if (layout.first.size != before.first.size || layout.second.size != before.second.size)
    state_.picture_old = true;
  state_.layout = layout;
}

void Editor::dress() {
  const Settings& s = state_.settings;
  gui_.dress({s.theme, s.palette, window_.scale() * static_cast<float>(s.ui_scale), options_.own_font});
}

void Editor::save_settings() {
  Settings& now = state_.settings;
  now.antialias = state_.look.antialias;
  now.width = static_cast<int>(window_.size().x);
  now.height = static_cast<int>(window_.size().y);
  if (now == saved_) return;
  saved_ = now;
  if (const Status written = write_settings(now, settings_file()); !written)
    state_.say(written.error().message, true);
}

void Editor::take_picture(Requests::Screenshot what) {
  const bool window = what == Requests::Screenshot::kWindow;
  const Vec2 pixels = window_.pixel_size();
  const auto file =
      take_screenshot(pixels, window ? Area{Vec2(0), pixels} : pixels_of(state_.layout.viewport, window_));
  state_.say(file ? "Saved: " + file->string() : file.error().message, !file.ok());
}

}  // namespace

Status run_editor(const EditorOptions& options) {
  LoadedSettings loaded = read_settings(settings_file());
  const std::string fault = loaded.fault;
  const int width = options.width > 0 ? options.width : loaded.settings.width;
  const int height = options.height > 0 ? options.height : loaded.settings.height;
  auto window = Window::open(width, height, "Kerf");
  if (!window) return window.error();
  gl::report_gl_errors();
  auto renderer = Renderer::create();
  if (!renderer) return renderer.error();
  Editor editor(std::move(*window), std::move(*renderer), std::move(loaded), options);
  if (const Status opened = editor.open(options); !opened) return opened;
  editor.tell(fault);
  editor.run();
  if (!options.report) return Done{};
  return write_editor_report(editor.state(), *options.report);
}

}  // namespace kerf
