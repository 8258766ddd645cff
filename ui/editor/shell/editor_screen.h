#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "core/base/assert.h"
#include "core/base/parallel.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/workspace.h"
#include "ui/editor/shared/world_changes.h"
#include "ui/editor/shell/catalogue.h"
#include "ui/editor/shell/tool_header.h"
#include "ui/gl/buffers.h"
#include "ui/screen/frame_loop.h"
#include "ui/window/layout.h"
#include "ui/window/window.h"

namespace kerf {

// Returns true if a menu, the list of a combo or a context menu is open; modal windows do not count.
// Precondition of this and the next two: called within an ImGui frame.
bool is_popup_open();

// Closes all of them, including submenus: an open one would reopen its submenu under the pointer.
void close_popups();

// Returns true if the pointer is over a panel, a bar, a menu or a dialog.
bool pointer_is_over_panel();

// A press in the viewport that closed a popup. A following move makes it the start of a drag, so that a
// stroke begins where the button was pressed. A release without a move makes it a click that only closed the
// popup.
class DeferredPress {
 public:
  // Stores the press in place of an earlier one.
  void hold(const InputEvent& press) { held_ = press; }
  // Returns the press whose drag this event begins, once. Another press, or the release, drops it.
  std::optional<InputEvent> press_of(const InputEvent& event);

 private:
  std::optional<InputEvent> held_;
};

// Handles the mouse in the viewport: a press of the left button belongs to the first feature that claims it;
// middle or Alt+left drag orbits, Shift+middle or right drag pans, the wheel zooms to the pointer. A drag
// belongs to the place where it began, and continues across panels. `free`: no panel or menu uses the mouse.
void handle_mouse(Workspace& workspace, const Features& features, const InputEvent& event, bool free);

// Applies the thread limit of the settings.
class ThreadSetting {
 public:
  // 0: all threads of the machine. Precondition: threads >= 0.
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

// The window while a background change owns the document: its last frame under a progress bar.
class BusyWindow {
 public:
  // Stores the drawn, not yet swapped frame of this size in pixels, which is shown from now on.
  void keep(const Vec2& pixels);
  // Stops the change on Esc and when the window is closed; stores other events. Returns true if the window
  // is to be closed. Precondition of this and of draw(): a change is running.
  bool handle_input(const Input& input, ChangeThread& change);
  // Draws a frame in a window of this size. The bar appears if the change lasts; its button stops it.
  void draw(const Vec2& window, const Area& picture, ChangeThread& change) const;
  // Returns the stored events, once. After more than a second, drops presses in the viewport, whose content
  // has changed by then.
  std::vector<InputEvent> take_deferred_events();

 private:
  using Clock = std::chrono::steady_clock;

  gl::Texture kept_;
  std::vector<InputEvent> deferred_events_;
  Clock::time_point began_;
};

// The editor as a screen: the viewport of the open world with the menus, panels and dialogs of its features.
// During a background change it shows the last frame with a progress bar.
class EditorScreen : public Screen {
 public:
  // Creates the features of an editor; the catalogue is filled later.

  // The window and the options must outlive it. Precondition: an ImGui context is current.
  EditorScreen(Window& window, LivePicture picture, LoadedSettings loaded, const EditorOptions& options);
  EditorScreen(const EditorScreen&) = delete;
  EditorScreen& operator=(const EditorScreen&) = delete;

  // Opens the files of the options. Fails if not even the default scene can be read.
  Status open();
  // Shows an error in the status bar unless a more important one is shown.
  void report_error(const std::string& fault);
  // Ends background work and writes the settings. Unsaved work is kept unless the user closed the editor.
  void close(bool left_by_user);
  // Returns the report of the session, which tests read.
  nlohmann::ordered_json report() const;

  KeyboardHold keyboard_hold() const override;
  GuiLook look() const override;
  void handle_input(const Input& input) override;
  void advance() override;
  void draw() override;
  void drawn() override;
  void took(const FrameTime& time) override;
  bool moving() const override;
  double min_frame_seconds() const override;
  void rest() override;
  bool over() const override { return workspace_.links.leaves == Leaves::kForGood || wants_game(); }
  std::optional<std::string> answer(const std::string& what) const override;

  // Returns true if the screen is suspended for the game.
  bool wants_game() const { return workspace_.links.leaves == Leaves::kForTheGame && !thread_.busy(); }
  // Called after the game, with a scene to open or an empty path.
  void resume_from_game(const GuiLook& look, const std::filesystem::path& scene);
  // Ends the editor once the document is saved or may be discarded.
  void quit() { workspace_.links.quit(); }

 private:
  void handle_input_event(const InputEvent& event);
  void handle_pointer(const InputEvent& event);
  void handle_key(const InputEvent& event);
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
  ToolHeader header_;
  Features features_;
  Settings saved_;                // in the file, if the last attempt to write it succeeded
  bool settings_written_ = true;  // it did
  ThreadSetting threads_;
  DeferredPress deferred_press_;
  ChangeThread thread_;  // while it is busy the document is not accessed
  BusyWindow busy_;
  // The files of each drop while the thread is busy.
  std::vector<std::vector<std::filesystem::path>> deferred_drops_;
  std::string title_;                    // of the window
  std::optional<double> statistics_at_;  // s, last update of the statistics; nullopt: they are outdated
  bool easing_ = false;                  // of the camera
  bool busy_frame_ = false;              // the last frame showed the busy window
  bool new_picture_ = false;             // in the last frame
  double picture_seconds_ = 0;           // likewise
};

}  // namespace kerf
