#include "ui/game/game_screen.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/game/match/recording.h"
#include "ui/window/number_text.h"
#include "ui/window/window.h"

namespace kerf {

namespace {

constexpr double kMaxFrame = 0.25;   // s
constexpr double kSlowMotion = 0.5;  // s, when an enemy falls in two
constexpr double kHitStop = 0.05;    // s, when a part comes off
constexpr double kKillcam = 1.5;     // s
constexpr double kAfterEnd = 3;      // s, in slow motion, until the result
constexpr double kHardImpact = 9;    // m/s, of a crash with the maximum shake
constexpr double kGuideSeconds = 14;
constexpr double kNoticedSpeed = 0.9;  // of real time; shown if it is slower
constexpr double kFrameShare = 0.1;    // weight of the last frame in the average of the shown rate
constexpr double kReplayView = 50;     // degrees
constexpr int kMenuFrames = 4;         // until a menu has shown an input
constexpr double kSeenAhead = 8;       // m, distance of the point about which the editor orbits

// The other matches end with their time, or not at all.
bool has_difficulties(const Rules& rules) { return !rules.waves.empty() && !rules.description.targets; }

}  // namespace

GameScreen::GameScreen(Window& window, MatchPicture picture, GameOptions options)
    : window_(window),
      picture_(std::move(picture)),
      options_(std::move(options)),
      settings_(read_game_settings(game_settings_file())),
      saved_(settings_),
      presets_(draws_in_software()) {
  if (options_.selected_difficulty) asked_difficulty_ = settings_.difficulty = options_.setup.difficulty;
  if (options_.landmarks || window.script() != nullptr)
    keep_landmarks(&landmarks_.emplace(options_.landmarks));
  if (options_.starts) {
    go_to_start();
  } else {
    start();
  }
}

void GameScreen::resume() {
  leave_ = Leave::kStay;
  window_.set_title("Kerf");
  if (landmarks_) keep_landmarks(&*landmarks_);
}

View GameScreen::view() const {
  const CameraView view = camera_view();
  return {view.eye, view.eye + kSeenAhead * view.forward};
}

// The window may be closed, or the program be stopped, in a menu.
GameScreen::~GameScreen() {
  keep_settings();
  set_menu_navigation(false);
  window_.catch_pointer(false);
  if (landmarks_) keep_landmarks(nullptr);
}

void GameScreen::start() {
  begin_match();
  enter(State::kPlaying);
}

void GameScreen::begin_match() {
  options_.setup.difficulty = settings_.difficulty;
  match_ = std::make_unique<Match>(options_.setup);
  bot_.reset();
  if (options_.bot) bot_.emplace(*match_);
  picture_.show(*match_);
  input_.reset();
  camera_.cut();
  hud_.clear();
  result_.reset();
  killer_ = Event::kNobody;
  killcam_.reset();
  steady_.reset();
  replay_.reset();
  replay_shown_ = false;
  score_log_ = ScoreLog();
  clock_ = MatchClock();
  played_.clear();
  played_seconds_ = after_end_ = 0;
  guide_ = settings_.guide;
  follow_player();
}

void GameScreen::enter(State state) {
  KERF_ASSERT(state != State::kOver || result_);
  state_ = state;
  const bool caught = state == State::kPlaying;
  window_.catch_pointer(caught);
  if (!caught) sounds_.hush();
  input_.release_all();
  if (caught) input_.take_held_controls(window_, settings_.keys);
  asked_ = MenuChoice::kNone;
  rebound_.reset();
  frames_due_ = kMenuFrames;
  keep_settings();
}

void GameScreen::keep_settings() {
  const GameSettings keep = settings_to_keep(settings_, saved_, asked_difficulty_);
  if (keep == saved_) return;
  saved_ = keep;
  (void)write_game_settings(saved_, game_settings_file());
}

const Vehicle& GameScreen::own_vehicle() const { return match_->vehicles()[Match::kPlayer]; }

const Body& GameScreen::own_chassis() const { return match_->world().body(own_vehicle().chassis); }

// The bot's aim is that of its last controls.
Vec3 GameScreen::aim() const {
  return bot_ && !played_.empty() ? aim_of(played_.back()) : input_.direction(own_chassis().placement);
}

// Input

void GameScreen::handle_input(const Input& input) {
  if (input.close) leave_ = Leave::kClose;
  frames_due_ = input.events.empty() ? std::max(0, frames_due_ - 1) : kMenuFrames;
  // Keys before a change of the state are not for the new one.
  const State before = state_;
  for (const InputEvent& event : input.events) {
    if (event.kind == InputEvent::Kind::kKey && !event.again) handle_key(event);
  }
  handle_gamepad();
  if (state_ != State::kPlaying || before != State::kPlaying) return;
  GameSettings scaled = settings_;
  scaled.sensitivity *= steady_.aim_factor();
  input_.handle_events(input.events, scaled);
  if (!window_.has_focus()) enter(State::kPaused);
}

// In menus the buttons of a gamepad are keys, but none that replaces another one. An unplugged gamepad
// releases its buttons and sticks.
void GameScreen::handle_gamepad() {
  static constexpr std::pair<int, int> kMenuKeys[] = {{GLFW_GAMEPAD_BUTTON_DPAD_UP, GLFW_KEY_UP},
                                                      {GLFW_GAMEPAD_BUTTON_DPAD_DOWN, GLFW_KEY_DOWN},
                                                      {GLFW_GAMEPAD_BUTTON_DPAD_LEFT, GLFW_KEY_LEFT},
                                                      {GLFW_GAMEPAD_BUTTON_DPAD_RIGHT, GLFW_KEY_RIGHT},
                                                      {GLFW_GAMEPAD_BUTTON_A, GLFW_KEY_SPACE},
                                                      {GLFW_GAMEPAD_BUTTON_B, GLFW_KEY_ESCAPE},
                                                      {GLFW_GAMEPAD_BUTTON_X, GLFW_KEY_R},
                                                      {GLFW_GAMEPAD_BUTTON_Y, GLFW_KEY_B},
                                                      {GLFW_GAMEPAD_BUTTON_START, GLFW_KEY_P}};
  static constexpr int kUpgradeButtons[] = {GLFW_GAMEPAD_BUTTON_DPAD_LEFT, GLFW_GAMEPAD_BUTTON_DPAD_UP,
                                            GLFW_GAMEPAD_BUTTON_DPAD_RIGHT};
  const auto read = read_gamepad();
  const bool had_gamepad = std::exchange(has_gamepad_, read.has_value());
  if (!read && !had_gamepad) return;
  const GamepadState pad = read.value_or(GamepadState()), last = std::exchange(pad_, pad);
  const auto is_new = [&](int button) { return pad.is_pressed(button) && !last.is_pressed(button); };
  if (state_ == State::kPlaying) {
    const bool friction =
        settings_.aim_help && own_vehicle().alive && is_near_part(*match_, Sight(match_->world()), aim());
    const double seconds = ImGui::GetIO().DeltaTime * steady_.aim_factor();
    input_.apply_gamepad(pad, seconds, settings_, friction);
    for (uint8_t i = 0; i < Controls::kUpgrades; ++i) {
      if (can_upgrade() && is_new(kUpgradeButtons[i])) input_.select_upgrade(static_cast<uint8_t>(i + 1));
    }
    for (const auto action : {GameAction::kCamera, GameAction::kGuide, GameAction::kPause}) {
      if (is_new(action_keys(action).pad)) handle_action(action);
    }
    return;
  }
  for (const auto& [button, key] : kMenuKeys) {
    InputEvent event;
    event.button = key;
    event.place = menu_place(button, settings_.keys);
    if (!is_new(button)) continue;
    if (rebound_)
      rebound_.reset();
    else
      handle_key(event);
  }
}

// No event reports a gamepad that is connected while the pause menu waits.
void GameScreen::rest() { has_gamepad_ = has_gamepad_ || read_gamepad().has_value(); }

bool GameScreen::can_upgrade() const {
  return state_ == State::kPlaying && match_->standing().phase == Standing::Phase::kPause &&
         !match_->has_upgraded();
}

// Passes a key of a menu to the navigation of ImGui.
void GameScreen::navigate(int key, int mods) {
  const bool back = (mods & GLFW_MOD_SHIFT) != 0;
  const auto input = [&]() -> std::optional<int> {
    switch (key) {
      case GLFW_KEY_TAB:
        return back ? ImGuiNavInput_DpadUp : ImGuiNavInput_DpadDown;
      case GLFW_KEY_UP:
        return ImGuiNavInput_DpadUp;
      case GLFW_KEY_DOWN:
        return ImGuiNavInput_DpadDown;
      case GLFW_KEY_LEFT:
        return ImGuiNavInput_DpadLeft;
      case GLFW_KEY_RIGHT:
        return ImGuiNavInput_DpadRight;
      case GLFW_KEY_ENTER:
      case GLFW_KEY_KP_ENTER:
      case GLFW_KEY_SPACE:
        return ImGuiNavInput_Activate;
      default:
        return std::nullopt;
    }
  }();
  if (input) navigation_[static_cast<size_t>(*input)] = 1;
  frames_due_ = kMenuFrames;
}

void GameScreen::handle_key(const InputEvent& event) {
  const int key = event.button;
  if (rebound_) {
    if (key != GLFW_KEY_ESCAPE) bind(*rebound_, event.place, settings_.keys);
    return rebound_.reset();
  }
  if (can_upgrade() && key >= GLFW_KEY_1 && key < GLFW_KEY_1 + Controls::kUpgrades)
    return input_.select_upgrade(static_cast<uint8_t>(1 + key - GLFW_KEY_1));
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) {
    if (!settings_.debug_views || state_ == State::kOver || state_ == State::kStart) return;
    const std::string done = press_digit(static_cast<char>('0' + (key - GLFW_KEY_0)), picture_.look());
    if (!done.empty()) hud_.note(done);
    return;
  }
  if (state_ == State::kPlaying) {
    if (lesson_ && (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER)) return end_lesson();
    const auto action = action_of_key(event.place, settings_.keys);
    return action ? handle_action(*action) : void();
  }
  if (key == GLFW_KEY_ESCAPE) return escape();
  if (state_ == State::kPaused && action_of_key(event.place, settings_.keys) == GameAction::kPause)
    return escape();
  if (asked_ != MenuChoice::kNone) return navigate(key, event.mods);
  if (key == GLFW_KEY_R && state_ != State::kStart) return take(MenuChoice::kRestart);
  if (key == GLFW_KEY_B && state_ == State::kOver && replay_state() == MatchReplay::State::kOver)
    return begin_replay();
  if (state_ == State::kOver && action_of_key(event.place, settings_.keys) == GameAction::kPause)
    return escape();
  const bool is_enter = key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER || key == GLFW_KEY_P;
  if (is_enter && state_ == State::kStart && !is_menu_navigated()) return begin_selected();
  navigate(key, event.mods);
}

void GameScreen::handle_action(GameAction action) {
  switch (action) {
    case GameAction::kPause:
      return escape();
    case GameAction::kCamera:
      camera_.viewpoint = camera_.viewpoint == Viewpoint::kRoof ? Viewpoint::kChase : Viewpoint::kRoof;
      return camera_.cut();
    case GameAction::kGuide:
      guide_ = !guide_;
      return;
    default:
      return;
  }
}

// Skips the slow motion at the end and the replay.
void GameScreen::escape() {
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) {
    navigation_[ImGuiNavInput_Cancel] = 1;
    return;
  }
  if (asked_ != MenuChoice::kNone) {
    asked_ = MenuChoice::kNone;
    return;
  }
  if (state_ == State::kStart) {
    leave_ = Leave::kAway;
    return enter(state_);
  }
  if (state_ == State::kPaused) return enter(State::kPlaying);
  if (state_ == State::kPlaying) return match_->standing().over() ? finish() : enter(State::kPaused);
  if (replay_) replay_->skip();
}

// Update

void GameScreen::advance_playing(double seconds) {
  if (settings_.aim_help && !bot_) input_.help(*match_, Sight(match_->world()), seconds);
  steady_.advance(input_.is_steady_held() && own_vehicle().alive, seconds);
  clock_.set_pace(steady_.time_factor());
  const int ticks = clock_.advance(seconds);
  for (int i = 0; i < ticks && !match_->settled(); ++i) tick();
  hud_.advance(seconds);
  const bool is_beginning = played_seconds_ <= kGuideSeconds;
  played_seconds_ += seconds;
  killcam_left_ = std::max(0.0, killcam_left_ - seconds);
  if (killcam_ && killcam_left_ > 0) killcam_->follow(*match_, seconds);
  if (is_beginning && played_seconds_ > kGuideSeconds) guide_ = false;
  if (match_->standing().over()) go_on_after_the_end(seconds);
  if (lesson_ && lesson_->done()) end_lesson();
}

void GameScreen::advance() {
  const double seconds = std::min<double>(ImGui::GetIO().DeltaTime, kMaxFrame);
  if (state_ == State::kPlaying) advance_playing(seconds);
  if (state_ == State::kStart) {
    picture_.advance(*match_, seconds);
    start_shown_ += seconds;
  } else if (state_ == State::kOver && replay_) {
    advance_replay(seconds);
  } else if (state_ != State::kPaused) {
    picture_.advance(*match_, clock_.pace() * seconds);
    const Vec3 aim = this->aim();
    camera_.follow(*match_, aim, seconds);
    if (state_ == State::kPlaying) sounds_.advance(*match_, camera_.eye(), aim, settings_.volume, seconds);
  }
  if (options_.seconds > 0 && played_seconds_ >= options_.seconds) leave_ = Leave::kAway;
}

void GameScreen::go_on_after_the_end(double seconds) {
  if (after_end_ == 0) clock_.slow_down(kAfterEnd);
  after_end_ += seconds;
  if (after_end_ > kAfterEnd || match_->settled()) finish();
}

void GameScreen::tick() {
  played_.push_back(bot_ ? bot_->next(*match_) : input_.controls(own_chassis().placement));
  match_->tick(played_.back());
  bool new_wave = false;
  for (const Event& event : match_->events()) {
    follow_event(event);
    new_wave = new_wave || event.kind == Event::Kind::kWaveBegins;
  }
  score_log_.on_tick(*match_);
  hud_.on_tick(*match_);
  sounds_.on_tick(*match_);
  picture_.follow(*match_);
  if (new_wave) {
    follow_player();
    killcam_.reset();
  }
  if (lesson_ && lesson_->on_tick(*match_)) hud_.note("well done");
}

// All of this is a matter of the screen: the match runs on unchanged.
void GameScreen::follow_event(const Event& event) {
  using Kind = Event::Kind;
  const bool own = event.vehicle == Match::kPlayer;
  const bool is_off =
      event.kind == Kind::kPieceOff || event.kind == Kind::kWheelLost || event.kind == Kind::kTurretLost;
  if (is_off && event.points > 0) clock_.stop(kHitStop);
  if (event.kind == Kind::kInHalves && !own) clock_.slow_down(kSlowMotion);
  if (event.kind == Kind::kImpact && own && settings_.shake) camera_.shake(event.size / kHardImpact);
  if (event.kind != Kind::kKilled || !own) return;
  killer_ = event.by;
  if (killer_ == Match::kPlayer || killer_ >= match_->vehicles().size()) return;
  killcam_.emplace(killer_, 0);
  killcam_left_ = kKillcam;
}

// The vehicle is another one, or repaired.
void GameScreen::follow_player() {
  const TurretDescription& turret = match_->vehicles()[Match::kPlayer].what().turret;
  input_.limit(turret.yaw, turret.barrel.pitch);
}

void GameScreen::finish() {
  KERF_ASSERT(!result_);
  // The first tick after the end switches the beams off.
  if (match_->standing().aftermath == 0) tick();
  const Standing& standing = match_->standing();
  MatchResult result;
  result.won = standing.phase == Standing::Phase::kWon;
  result.why = end_reason(*match_, killer_);
  result.wheels_lost = standing.wheels_lost;
  result.pieces = standing.pieces_cut;
  const std::string difficulty = has_difficulties(match_->rules()) ? name_of(match_->setup().difficulty) : "";
  result.score = {standing.score, match_->rules().description.name, difficulty,
                  result.won,     standing.enemies_destroyed,       seconds_of_ticks(standing.ticks)};
  result.medals = match_->rules().description.scores.medals;
  result.ended = standing.phase == Standing::Phase::kEnded;
  // Neither bots nor the tutorial compete for high scores.
  const bool competes = !bot_ && !lesson_;
  const bool counts = !result.ended || (match_->rules().description.targets && standing.score > 0);
  if (competes && counts) {
    if (const auto rank = add_high_score(result.score, high_scores_file())) result.rank = *rank;
  }
  result.scores = high_scores_of(result.score.rules, result.score.difficulty, high_scores_file());
  result_ = std::move(result);
  enter(State::kOver);
  begin_replay();
}

// Replay

void GameScreen::begin_replay() {
  const auto moment = score_log_.best();
  if (!moment || (result_ && result_->ended && !(moment->points > 0))) return;
  replay_ = std::make_unique<MatchReplay>(match_->setup(), *moment, played_);
  if (replay_shown_) picture_.show(*match_);
  replay_shown_ = false;
}

std::optional<MatchReplay::State> GameScreen::replay_state() const {
  return replay_ ? std::optional(replay_->state()) : std::nullopt;
}

void GameScreen::advance_replay(double seconds) {
  if (replay_->state() == MatchReplay::State::kPreparing) return picture_.advance(*match_, seconds);
  if (replay_->is_skipped()) {
    if (replay_shown_) picture_.show(*match_);
    replay_shown_ = false;
    sounds_.hush();
    return picture_.advance(*match_, seconds);
  }
  if (!replay_shown_) picture_.show(replay_->match());
  replay_shown_ = true;
  const int due = replay_->due(seconds);
  for (int i = 0; i < due && replay_->state() == MatchReplay::State::kPlaying; ++i) {
    replay_->tick();
    picture_.follow(replay_->match());
    sounds_.on_tick(replay_->match());
  }
  if (replay_->state() == MatchReplay::State::kOver) return sounds_.hush();
  picture_.advance(replay_->match(), replay_->is_slow() ? 0.25 * seconds : seconds);
  replay_->move_camera(seconds);
  const Vec3 ahead = replay_->camera().view(1, settings_.field_of_view).forward;
  sounds_.advance(replay_->match(), replay_->camera().eye(), ahead, settings_.volume, seconds);
}

const Match& GameScreen::shown() const { return replay_shown_ ? replay_->match() : *match_; }

// A match that has begun in earnest is not thrown away by one press.
bool GameScreen::loses_progress(MenuChoice choice) const {
  const bool leaves =
      choice == MenuChoice::kRestart || choice == MenuChoice::kTitle || choice == MenuChoice::kLeave;
  const Standing& standing = match_->standing();
  return leaves && state_ == State::kPaused && !lesson_ && (standing.wave > 0 || standing.score > 0);
}

void GameScreen::take(MenuChoice choice) {
  if (asked_ == MenuChoice::kNone && loses_progress(choice)) {
    asked_ = choice;
    frames_due_ = kMenuFrames;
    return;
  }
  switch (choice) {
    case MenuChoice::kNone:
      return;
    case MenuChoice::kCancel:
      asked_ = MenuChoice::kNone;
      return;
    case MenuChoice::kResume:
      return enter(State::kPlaying);
    case MenuChoice::kRestart:
      if (lesson_) return begin_lesson();
      ++options_.setup.seed;
      return start();
    case MenuChoice::kTitle:
      lesson_.reset();
      return go_to_start();
    case MenuChoice::kStart:
      return begin_selected();
    case MenuChoice::kLesson:
      return begin_lesson();
    case MenuChoice::kOther:
      return show_choice();
    case MenuChoice::kReplay:
      return begin_replay();
    case MenuChoice::kInspect:
      leave_ = Leave::kInspect;
      return enter(state_);
    case MenuChoice::kLeave:
      leave_ = Leave::kAway;
      return enter(state_);
  }
}

// Draw

CameraView GameScreen::camera_view() const {
  const Vec2 size = window_.size();
  const double aspect = size.y > 0 ? size.x / size.y : 1;
  if (state_ == State::kStart) return start_view(*match_, start_shown_, aspect, kReplayView);
  if (replay_shown_) return replay_->camera().view(aspect, kReplayView);
  if (killcam_ && killcam_left_ > 0 && killcam_left_ < kKillcam) return killcam_->view(aspect, kReplayView);
  return camera_.view(aspect, settings_.field_of_view * steady_.view_factor());
}

void GameScreen::outline_sighted(const std::optional<SightedPart>& part) {
  auto& pieces = picture_.look().pieces;
  pieces.clear();
  if (!part) return;
  const Body& body = match_->world().body(part->body);
  for (uint32_t label = 0; label < body.pieces.size(); ++label) {
    if (body.pieces[label].faces > 0) pieces[{part->body, label}].selected = true;
  }
}

// Parts that the player can take glow like the sighted one.
void GameScreen::outline_loot() {
  auto& pieces = picture_.look().pieces;
  for (const Match::LootPart& part : match_->loot()) {
    const Body& body = match_->world().body(part.body);
    for (uint32_t label = 0; label < body.pieces.size(); ++label) {
      if (body.pieces[label].faces > 0) pieces[{part.body, label}].selected = true;
    }
  }
}

// The frames per second, if enabled, and the speed of time if below real time.
std::string GameScreen::words_on_speed() const {
  std::string words;
  if (settings_.show_speed && frame_s_ > 0) words = std::to_string(std::lround(1 / frame_s_)) + " frames/s";
  if (clock_.speed() > kNoticedSpeed) return words;
  return words + (words.empty() ? "" : ", ") + text_of("%.1fx speed", clock_.speed());
}

void GameScreen::draw() {
  const CameraView view = camera_view();
  if (landmarks_) landmarks_->begin_frame();
  picture_.look().tree.palette = options_.look.palette;
  const Vec2 pixels = window_.pixel_size();
  const Target whole{0, 0, 0, static_cast<int>(pixels.x), static_cast<int>(pixels.y)};
  const Sight sight(shown().world());
  const bool plays = state_ == State::kPlaying || state_ == State::kPaused;
  std::optional<SightedPart> part;
  if (plays && own_vehicle().alive) part = sighted_part(*match_, sight, aim());
  outline_sighted(part);
  if (plays) outline_loot();
  picture_.draw(shown(), view, whole, presets_.select(settings_.preset), resolution_.share());
  if (plays) {
    HudView hud{*match_, hud_, view, sight, aim()};
    hud.width = input_.width();
    hud.steady = &steady_;
    if (guide_ && state_ == State::kPlaying)
      hud.guide = guide_lines(settings_.keys, !match_->rules().spawns.empty(), has_gamepad_);
    hud.keys = settings_.keys;
    hud.gamepad = has_gamepad_;
    hud.machine = words_on_speed();
    hud.sighted = part;
    if (lesson_) hud.task = lesson_->task(*match_, hud.keys, hud.gamepad);
    draw_hud(hud);
  }
  draw_menu();
}

void GameScreen::draw_menu() {
  switch (state_) {
    case State::kPlaying:
      return;
    case State::kStart:
      return take(draw_start_menu({settings_, scores_, options_.from_editor}));
    case State::kPaused:
      if (asked_ != MenuChoice::kNone) return take(draw_confirmation(asked_, *match_));
      return take(draw_pause_menu({settings_, options_.look, picture_.look(), ways(), rebound_}));
    case State::kOver:
      if (!result_) return;
      return take(draw_result(*result_, replay_state(), ways()));
  }
}

void GameScreen::drawn() {
  set_menu_navigation(state_ != State::kPlaying && leave_ == Leave::kStay);
  std::ranges::copy(navigation_, ImGui::GetIO().NavInputs);
  navigation_.fill(0);
  if (!landmarks_) return;
  const ImVec2 at = ImGui::GetIO().MousePos;
  (void)landmarks_->finish(state_ == State::kPlaying, {at.x, at.y});
}

std::optional<std::string> GameScreen::answer(const std::string& what) const {
  if (what != "landmarks" || !landmarks_) return std::nullopt;
  return landmarks_->text();
}

void GameScreen::took(const FrameTime& time) {
  presets_.took(time.whole);
  if (presets_.select(settings_.preset) == PicturePreset::kLow) resolution_.took(time.whole);
  frame_s_ += (frame_s_ > 0 ? kFrameShare : 1) * (time.whole - frame_s_);
  frame_seconds_.push_back(time.whole);
}

// Before a match: the menu, the tutorial, and loading of the selected mode.

void GameScreen::go_to_start() {
  show_choice();
  enter(State::kStart);
}

// The selected arena with the selected car is behind the menu.
void GameScreen::show_choice() {
  load(load_mode(settings_.mode, settings_.arena, settings_.vehicle));
  begin_match();
  const std::string difficulty = has_difficulties(match_->rules()) ? name_of(settings_.difficulty) : "";
  scores_ = high_scores_of(match_->rules().description.name, difficulty, high_scores_file());
}

// If a file of the game is missing or invalid, the current rules stay.
void GameScreen::load(Result<std::shared_ptr<const Rules>> rules) {
  if (rules) options_.setup.rules = std::move(*rules);
}

void GameScreen::begin_selected() {
  if (!settings_.taught) return begin_lesson();
  lesson_.reset();
  ++options_.setup.seed;
  start();
}

void GameScreen::begin_lesson() {
  load(load_lesson(settings_.vehicle));
  begin_match();
  lesson_.emplace(*match_);
  enter(State::kPlaying);
}

// The first match follows.
void GameScreen::end_lesson() {
  lesson_.reset();
  settings_.taught = true;
  load(load_mode(settings_.mode, settings_.arena, settings_.vehicle));
  start();
}

WindowedGame::WindowedGame(std::unique_ptr<GameScreen> screen) : screen_(std::move(screen)) {}
WindowedGame::~WindowedGame() = default;
WindowedGame::WindowedGame(WindowedGame&&) noexcept = default;
WindowedGame& WindowedGame::operator=(WindowedGame&&) noexcept = default;

Result<WindowedGame> WindowedGame::begin(Window& window, const GameOptions& options) {
  auto picture = MatchPicture::create();
  if (!picture) return picture.error();
  return WindowedGame(std::make_unique<GameScreen>(window, std::move(*picture), options));
}

void WindowedGame::play(FrameLoop& loop) {
  screen_->resume();
  loop.run(*screen_);
}

bool WindowedGame::wants_inspection() const { return screen_->leave() == GameScreen::Leave::kInspect; }
bool WindowedGame::wants_close() const { return screen_->leave() == GameScreen::Leave::kClose; }
GuiLook WindowedGame::look() const { return screen_->look(); }
void WindowedGame::set_look(const GuiLook& look) { screen_->set_look(look); }
const Match& WindowedGame::match() const { return screen_->match(); }
View WindowedGame::view() const { return screen_->view(); }

const std::vector<Controls>& WindowedGame::played() const { return screen_->played(); }
const std::vector<double>& WindowedGame::frame_seconds() const { return screen_->frame_seconds(); }

}  // namespace kerf
