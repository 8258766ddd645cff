#pragma once

#include <chrono>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "core/base/assert.h"
#include "core/base/parallel.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/workspace.h"
#include "ui/editor/shared/world_changes.h"
#include "ui/editor/shell/catalogue.h"
#include "ui/editor/shell/mouse_input.h"
#include "ui/gl/buffers.h"
#include "ui/screen/screen.h"
#include "ui/window/layout.h"

namespace kerf {

// Keeps the limit of threads that the settings ask for.
class ThreadSetting {
 public:
  // 0 is as many as the machine has. Precondition: threads >= 0.
  void follow(int threads) {
    KERF_ASSERT(threads >= 0);
    if (threads == threads_) return;
    threads_ = threads;
    limit_.reset();
    if (threads > 0) limit_.emplace(static_cast<size_t>(threads));
  }

 private:
  int threads_ = 0;
  std::optional<ThreadLimit> limit_;
};

// The window while a change is done on a thread of its own and nobody may look at the document: what it
// showed last, under a bar that says how far the change is.
class BusyWindow {
 public:
  // What was drawn to the window and is not swapped yet is shown from this call on; its size in pixels.
  void keep(const Vec2& pixels);
  // Escape and closing the window stop the change; what else the user does waits. Returns whether the window
  // is to be closed. Precondition of this and of draw(): a change is running.
  bool hear(const Input& input, ChangeThread& change);
  // Draws a frame over a window of this size; the bar is there when the change lasts, and its button stops
  // the change.
  void draw(const Vec2& window, const Area& picture, ChangeThread& change) const;
  // What the user did meanwhile, once. After more than a second without what was pressed in the picture: it
  // is another picture by then.
  std::vector<InputEvent> take_heard();

 private:
  using Clock = std::chrono::steady_clock;

  gl::Texture kept_;
  std::vector<InputEvent> heard_;
  Clock::time_point began_;
};

// The editor as a screen: the picture of the open world with menus, panels and dialogs, all of which come
// from its features. While a change runs on a background thread, it shows the last picture with a progress
// bar.
class EditorScreen : public Screen {
 public:
  // Makes the features of an editor; the catalogue of all of them is complete later.
  using MakeFeatures = Features (*)(Workspace&, const Catalogue&);

  // The window and the options must outlive it. Precondition: an ImGui context is current.
  EditorScreen(Window& window, LivePicture picture, LoadedSettings loaded, const EditorOptions& options,
               MakeFeatures make_features);
  EditorScreen(const EditorScreen&) = delete;
  EditorScreen& operator=(const EditorScreen&) = delete;

  // Opens the files of the options. Fails if not even the default scene can be read.
  Status open();
  // Shows an error in the status bar unless a more important one is shown.
  void tell(const std::string& fault);
  // Ends background work and writes the settings. Unsaved work is kept for the next start unless the user has
  // closed the editor.
  void close(bool left_by_user);
  // A report of the session. Tests of the window read it.
  nlohmann::ordered_json report() const;

  KeyboardHold keyboard_hold() const override;
  GuiLook look() const override;
  void hear(const Input& input) override;
  void advance() override;
  void draw() override;
  void drawn() override;
  void took(const FrameTime& time) override;
  bool moving() const override;
  double least_frame() const override;
  void rest() override;
  bool over() const override { return workspace_.leaves == Workspace::Leaves::kForGood || wants_game(); }
  std::optional<std::string> answer(const std::string& what) const override;

  // Whether the screen is over only until the player comes back from the game.
  bool wants_game() const { return workspace_.leaves == Workspace::Leaves::kForTheGame && !thread_.busy(); }
  // To be called when the game is over, with a scene that is to be opened, or an empty path.
  void come_back(const GuiLook& look, const std::filesystem::path& scene);

 private:
  void hear_event(const InputEvent& event);
  void hear_pointer(const InputEvent& event);
  void hear_key(const InputEvent& event);
  void escape();
  void lay_out_window();
  void draw_panels();
  void draw_picture();
  void save_settings();
  void finish_change();

  Window& window_;
  const EditorOptions& options_;
  Landmarks landmarks_;
  LivePicture picture_;
  Workspace workspace_;
  Catalogue catalogue_;
  Features features_;
  Settings saved_;  // as they are in the file
  ThreadSetting threads_;
  HeldPress held_press_;
  ChangeThread thread_;  // while it is busy the document is not touched
  BusyWindow busy_;
  std::string title_;           // of the window
  double statistics_at_ = -1;   // s, when the statistics were brought up to date
  bool easing_ = false;         // the camera
  bool busy_frame_ = false;     // the last frame showed the busy window
  bool new_picture_ = false;    // the last frame
  double picture_seconds_ = 0;  // of the last frame
};

}  // namespace kerf
