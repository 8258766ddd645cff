#include "ui/editor/editor.h"

#include <imgui.h>

#include <chrono>
#include <thread>

#include "ui/editor/actions.h"
#include "ui/editor/editor_report.h"
#include "ui/editor/editor_state.h"
#include "ui/editor/gui.h"
#include "ui/editor/open_file.h"
#include "ui/editor/panels.h"
#include "ui/editor/stop_signals.h"
#include "ui/editor/viewport_input.h"
#include "ui/editor/window.h"
#include "ui/gl/debug_output.h"

namespace kerf {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFrameSeconds = 1.0 / 60;  // no frame begins sooner after the last one
constexpr double kStepSeconds =
    0.020;                            // of cutting in one frame, or as long as drawing takes if that is more
constexpr double kSlowFrame = 0.030;  // smooth pictures that take longer are left for when nothing moves
constexpr double kStillSeconds = 0.15;
constexpr size_t kMovesOfStep = 16;
constexpr double kFigureSeconds = 0.25;
constexpr double kLongestEaseStep = 0.05;
constexpr double kSettleSeconds = 1.0;  // after the last event the panels are still drawn (tooltips appear)
constexpr double kSettleWait = 0.12, kIdleWait = 0.5;

double seconds_since(Clock::time_point t) { return std::chrono::duration<double>(Clock::now() - t).count(); }

// The running editor. One frame is: hear, move, cut, draw, show.
class Editor {
 public:
  Editor(Window window, Renderer renderer)
      : window_(std::move(window)), gui_(window_), renderer_(std::move(renderer)) {}

  Status open(const EditorOptions& options);
  void run();
  const EditorState& state() const { return state_; }

 private:
  void wait();
  void hear();
  void move_camera();
  void cut();
  bool draw();  // whether the picture is a new one
  void note_time(double seconds, bool new_picture);
  void update_figures();
  void lay_out_window();
  // Whether something moves that has to be drawn at once.
  bool moving() const { return easing_ || state_.document.waiting() > 0 || state_.picture_old; }

  Window window_;
  Gui gui_;
  Renderer renderer_;
  EditorState state_;
  StopSignals stop_;
  Clock::time_point frame_began_ = Clock::now(), last_event_ = Clock::now(), figures_at_{};
  bool easing_ = false;         // the camera
  bool beam_shown_ = false;     // in the last picture
  bool rough_ = false;          // the last picture was drawn without smooth edges to be in time
  double smooth_seconds_ = 0;   // what the last smooth frame with a new picture took
  double cut_seconds_ = 0;      // of the last frame
  double picture_seconds_ = 0;  // what the last frame with a new picture took
  Clock::time_point moved_at_{};
};

Status Editor::open(const EditorOptions& options) {
  lay_out_window();
  if (options.file) {
    const Status opened = open_file(state_, renderer_, *options.file);
    if (opened) return opened;
    if (const Status fallback = open_file(state_, renderer_, options.default_scene); !fallback)
      return fallback;
    state_.say(opened.error().message, true);
    return Done{};
  }
  return open_file(state_, renderer_, options.default_scene);
}

void Editor::run() {
  while (!window_.wants_to_close() && !state_.quit && !stop_.came()) {
    wait();
    const Clock::time_point began = Clock::now();
    gui_.begin_frame();
    lay_out_window();
    hear();
    move_camera();
    cut();
    const bool new_picture = draw();
    window_.swap();
    note_time(seconds_since(began), new_picture);
  }
  state_.tool.release(state_.document);
}

// Until there is something to draw: at once while something moves, at an event otherwise.
void Editor::wait() {
  const double left = kFrameSeconds - seconds_since(frame_began_);
  if (left > 0) std::this_thread::sleep_for(std::chrono::duration<double>(left));
  window_.wait(0);
  while (!moving() && !window_.take_activity() && !window_.wants_to_close() && !stop_.came()) {
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
  for (const InputEvent& event : window_.take_events()) {
    if (event.kind != InputEvent::Kind::kKey) {
      handle_mouse(state_, event, mouse_free);
    } else if (!io.WantTextInput) {
      run_shortcut(state_, event.button, event.mods);
    }
  }
  if (state_.tool.cutting()) state_.picture_old = true;
}

void Editor::move_camera() {
  const double step = std::min<double>(ImGui::GetIO().DeltaTime, kLongestEaseStep);
  easing_ = state_.camera.advance(step);
  if (easing_) state_.picture_old = true;
}

void Editor::cut() {
  cut_seconds_ = 0;
  if (state_.document.waiting() == 0) return;
  state_.tool.find_strike(state_.document);
  const double budget = std::max(kStepSeconds, picture_seconds_);
  const Clock::time_point began = Clock::now();
  while (state_.document.waiting() > 0 && seconds_since(began) < budget) {
    const Result<StepResult> step = state_.document.step(kMovesOfStep);
    if (!step) {
      cancel_stroke(state_);
      renderer_.resend(state_.document.world());
      state_.say(step.error().message, true);
      break;
    }
    renderer_.follow(step->delta);
    state_.removed_faces += step->delta.removed_faces;
  }
  cut_seconds_ = seconds_since(began);
  state_.picture_old = true;
}

bool Editor::draw() {
  update_figures();
  draw_panels(state_);
  const Vec2 pixels = window_.pixel_size(), size = window_.size();
  const Area& area = state_.layout.viewport;
  const Vec2 scale = pixels / size;
  const Target target{0, static_cast<int>(area.at.x * scale.x),
                      static_cast<int>(pixels.y - (area.at.y + area.size.y) * scale.y),
                      std::max(1, static_cast<int>(area.size.x * scale.x)),
                      std::max(1, static_cast<int>(area.size.y * scale.y))};
  if (state_.picture_old) moved_at_ = Clock::now();
  const bool still = seconds_since(moved_at_) > kStillSeconds;
  const bool anew = state_.picture_old || (rough_ && still) || !renderer_.draw_again(target);
  if (anew) {
    ViewOptions look = state_.look;
    rough_ = look.antialias && !still && smooth_seconds_ > kSlowFrame;
    if (rough_) look.antialias = false;
    const std::optional<BeamPicture> beam = state_.tool.picture(state_.document);
    renderer_.draw(state_.document.world(), state_.view(), look, beam, target);
    beam_shown_ = beam.has_value();
  }
  // Once more without the beam when it is off.
  state_.picture_old = beam_shown_ && !state_.tool.picture(state_.document);
  gui_.end_frame();
  return anew;
}

void Editor::note_time(double seconds, bool new_picture) {
  state_.frames.add(1000 * seconds);
  if (!new_picture) return;
  picture_seconds_ = seconds - cut_seconds_;
  if (!rough_ && state_.look.antialias) smooth_seconds_ = picture_seconds_;
}

void Editor::update_figures() {
  if (seconds_since(figures_at_) < kFigureSeconds) return;
  figures_at_ = Clock::now();
  const World& world = state_.document.world();
  state_.shown = {world.live_faces(), world.live_pieces(), 1000 * picture_seconds_};
}

void Editor::lay_out_window() {
  const double em = ImGui::GetFontSize(), bar = ImGui::GetFrameHeight();
  const Layout layout = lay_out(window_.size(), em, bar, bar);
  if (layout.viewport.size != state_.layout.viewport.size) state_.picture_old = true;
  state_.layout = layout;
}

}  // namespace

Status run_editor(const EditorOptions& options) {
  auto window = Window::open(options.width, options.height, "Kerf");
  if (!window) return window.error();
  gl::report_gl_errors();
  auto renderer = Renderer::create();
  if (!renderer) return renderer.error();
  Editor editor(std::move(*window), std::move(*renderer));
  if (const Status opened = editor.open(options); !opened) return opened;
  editor.run();
  if (!options.report) return Done{};
  return write_editor_report(editor.state(), *options.report);
}

}  // namespace kerf
