#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/game/match/match.h"
#include "ui/game/game.h"
#include "ui/game/game_camera.h"
#include "ui/game/game_menu.h"
#include "ui/game/game_settings.h"
#include "ui/game/hud.h"
#include "ui/game/match_picture.h"
#include "ui/game/player_input.h"
#include "ui/game/sounds.h"
#include "ui/screen/frame_loop.h"
#include "ui/window/layout.h"

namespace kerf {

// A match in the window: the view from the player's vehicle, the HUD and the menus. The pointer is captured
// while the match runs.
class GameScreen : public Screen {
 public:
  enum class Leave { kStay, kAway, kInspect, kClose };

  // The window must outlive it. Precondition: an ImGui context is current.
  GameScreen(Window& window, MatchPicture picture, GameOptions options);
  ~GameScreen() override;
  GameScreen(const GameScreen&) = delete;
  GameScreen& operator=(const GameScreen&) = delete;

  Leave leave() const { return leave_; }
  // Must be called before the screen is shown, and again after it was left.
  void resume();
  View view() const;
  const Match& match() const { return *match_; }
  // The controls of every tick since the match began.
  const std::vector<Controls>& played() const { return played_; }
  const std::vector<double>& frame_seconds() const { return frame_seconds_; }

  GuiLook look() const override { return options_.look; }
  void set_look(const GuiLook& look) { options_.look = look; }
  void handle_input(const Input& input) override;
  void advance() override;
  void draw() override;
  void drawn() override;
  void took(const FrameTime& time) override;
  bool moving() const override { return state_ != State::kPaused || frames_due_ > 0 || has_gamepad_; }
  void rest() override;
  bool over() const override { return leave_ != Leave::kStay; }
  std::optional<std::string> answer(const std::string& what) const override;

 private:
  enum class State { kStart, kPlaying, kPaused, kOver };
  static constexpr size_t kNavigation = 8;  // up to ImGuiNavInput_DpadDown

  void start();
  void begin_match();
  void go_to_start();
  void show_choice();
  void begin_selected();
  void begin_lesson();
  void end_lesson();
  void load(Result<std::shared_ptr<const Rules>> rules);
  LeavingWays ways() const { return {options_.from_editor, options_.starts}; }
  void enter(State state);
  void keep_settings();
  void handle_key(const InputEvent& event);
  void handle_action(GameAction action);
  void handle_gamepad();
  bool can_upgrade() const;
  void outline_loot();
  void navigate(int key, int mods);
  bool loses_progress(MenuChoice choice) const;
  void tick();
  void follow_event(const Event& event);
  void advance_playing(double seconds);
  void follow_player();
  void go_on_after_the_end(double seconds);
  void finish();
  void escape();
  void begin_replay();
  // Returns nullopt if there is no replay.
  std::optional<MatchReplay::State> replay_state() const;
  void advance_replay(double seconds);
  // The match on the screen: the current one, or the replay of its best moment.
  const Match& shown() const;
  void take(MenuChoice choice);
  void draw_menu();
  CameraView camera_view() const;
  void outline_sighted(const std::optional<SightedPart>& part);
  std::string words_on_speed() const;
  const Vehicle& own_vehicle() const;
  const Body& own_chassis() const;
  Vec3 aim() const;

  Window& window_;
  MatchPicture picture_;
  GameOptions options_;
  GameSettings settings_, saved_;
  std::optional<Difficulty> asked_difficulty_;  // see settings_to_keep
  PresetChoice presets_;
  ResolutionChoice resolution_;
  std::unique_ptr<Match> match_;
  ScoreLog score_log_;
  std::unique_ptr<MatchReplay> replay_;  // null: none
  bool replay_shown_ = false;
  std::optional<BotPlayer> bot_;
  std::optional<Lesson> lesson_;
  double start_shown_ = 0;         // s
  std::vector<HighScore> scores_;  // of the selected mode and level
  MatchClock clock_;
  PlayerInput input_;
  GameCamera camera_;
  HudState hud_;
  MatchSounds sounds_;
  std::optional<MatchResult> result_;
  MenuChoice asked_ = MenuChoice::kNone;         // waits for confirmation
  std::optional<GameAction> rebound_;            // waits for its new key
  std::array<float, kNavigation> navigation_{};  // inputs of ImGui for the next frame
  int frames_due_ = 0;                           // of a menu at rest
  GamepadState pad_;                             // at the last frame
  bool has_gamepad_ = false;
  std::optional<Landmarks> landmarks_;
  std::vector<Controls> played_;
  std::vector<double> frame_seconds_;
  State state_ = State::kPlaying;
  Leave leave_ = Leave::kStay;
  SteadyAim steady_;
  size_t killer_ = Event::kNobody;  // whose beam wrecked the player's car
  std::optional<ReplayCamera> killcam_;
  double killcam_left_ = 0;  // s
  double after_end_ = 0;     // s in real time since the end of the match
  bool guide_ = true;
  double played_seconds_ = 0;
  double frame_s_ = 0;  // average; 0 before the first frame
};

}  // namespace kerf
