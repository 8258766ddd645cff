#pragma once

#include "ui/editor/actions.h"
#include "ui/editor/changes/cooling.h"
#include "ui/editor/changes/live_cut.h"
#include "ui/editor/changes/time_flow.h"
#include "ui/editor/editor.h"
#include "ui/editor/frame/busy_window.h"
#include "ui/editor/marks/beam_sparks.h"
#include "ui/editor/path/kept_path.h"
#include "ui/editor/request_desk.h"
#include "ui/editor/state.h"
#include "ui/editor/tools/held_press.h"
#include "ui/editor/tools/viewport_input.h"
#include "ui/editor/work/thread_setting.h"
#include "ui/screen/screen.h"
#include "ui/window/landmarks.h"

namespace kerf {

// The editor as a screen: the picture of the open world with menus, panels and dialogs. While a change runs
// on a background thread, it shows the last picture with a progress bar.
class EditorScreen : public Screen {
 public:
  // The window and the options must outlive it. Precondition: an ImGui context is current.
  EditorScreen(Window& window, LivePicture picture, LoadedSettings loaded, const EditorOptions& options);
  EditorScreen(const EditorScreen&) = delete;
  EditorScreen& operator=(const EditorScreen&) = delete;

  // Opens the files of the options. Fails if not even the default scene can be read.
  Status open();
  // Shows an error in the status bar unless a more important one is shown.
  void tell(const std::string& fault);
  // Ends background work and writes the settings. Unsaved work is kept for the next start unless the user has
  // closed the editor.
  void close(bool left_by_user);
  const EditorState& state() const { return state_; }

  GuiLook look() const override;
  void hear(const Input& input) override;
  void advance() override;
  void draw() override;
  void drawn() override;
  void took(const FrameTime& time) override;
  bool moving() const override;
  void rest() override;
  bool over() const override { return desk_.quit() || wants_game(); }
  std::optional<std::string> answer(const std::string& what) const override;

  // Whether the screen is over only until the player comes back from the game.
  bool wants_game() const { return state_.requests.play && !thread_.busy(); }
  // To be called when the game is over, with a scene that is to be opened, or an empty path.
  void come_back(const GuiLook& look, const std::filesystem::path& scene);

 private:
  void hear_mouse(const MouseParts& mouse, const InputEvent& event);
  bool hear_move(const InputEvent& event, bool in_picture);
  void bind_actions();
  void hear_key(const InputEvent& event);
  void move_camera();
  void follow_graph();
  void keep_path(bool now);
  void open_kept_path();
  void pass_time(double seconds);
  void follow_stages();
  void follow_bodies();
  void send();
  void lay_out_window();
  void draw_panels();
  void draw_picture();
  void update_figures();
  void save_settings();
  void take_picture(Requests::Screenshot what);
  void show_title();
  void show_landmarks();
  void mark_lasers();
  void begin_pending_change();
  void finish_change();

  Window& window_;
  const EditorOptions& options_;
  std::optional<Landmarks> landmarks_;
  LivePicture picture_;
  EditorState state_;
  Settings saved_;  // as they are in the file
  ThreadSetting threads_;
  Recovery recovery_;
  KeptPath kept_path_;
  WorldChanges changes_;
  StageCut stage_cut_;
  LiveCut cut_;
  StepGroups groups_;
  TimeFlow time_;
  Cooling cooling_;
  FileOpener opener_;
  BeamSparks sparks_;
  HeldPress held_press_;
  RequestDesk desk_;
  std::vector<Panel> panels_;
  std::vector<UserAction> usual_actions_;  // with their usual keys
  std::vector<UserAction> actions_;        // with those of the settings
  std::map<std::string, std::string> bound_;
  ChangeThread thread_;  // while it is busy the document is not touched
  BusyWindow busy_;
  std::string title_;           // of the window
  double figures_at_ = -1;      // s, when the figures were brought up to date
  bool easing_ = false;         // the camera
  bool busy_frame_ = false;     // the last frame showed the busy window
  bool new_picture_ = false;    // the last frame
  double picture_seconds_ = 0;  // of the last frame
};

}  // namespace kerf
