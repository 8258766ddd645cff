#include "ui/game/game_screen.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/game/match/recording.h"
#include "ui/window/gui.h"
#include "ui/window/number_text.h"
#include "ui/window/window.h"

namespace kerf {

namespace {

constexpr double kMaxFrame = 0.25;   // s
constexpr double kSlowMotion = 0.5;  // s, when an enemy falls in two
constexpr double kAfterEnd = 3;      // s, in slow motion, until the result
constexpr double kHardImpact = 9;    // m/s, of a crash with the maximum shake
constexpr double kGuideSeconds = 14;
constexpr double kNoticedSpeed = 0.9;  // of real time; shown if it is slower
constexpr double kFrameShare = 0.1;    // weight of the last frame in the average of the shown rate
constexpr double kReplayView = 50;     // degrees
constexpr double kSeenAhead = 8;       // m, distance of the point about which the editor orbits

}  // namespace

GameScreen::GameScreen(Window& window, MatchPicture picture, GameOptions options, SuspendedMatch left)
    : window_(window),
      picture_(std::move(picture)),
      options_(std::move(options)),
      settings_(read_game_settings(game_settings_file())),
      saved_(settings_),
      presets_(draws_in_software()) {
  if (options_.selected_difficulty) asked_difficulty_ = settings_.difficulty = options_.setup.difficulty;
  if (options_.landmarks || window.script() != nullptr)
    keep_landmarks(&landmarks_.emplace(options_.landmarks));
  if (left.match) {
    go_on_with(std::move(left));
  } else if (options_.starts) {
    go_to_start();
  } else {
    start();
  }
}

void GameScreen::resume() {
  leave_ = Leave::kStay;
  if (landmarks_) keep_landmarks(&*landmarks_);
}

View GameScreen::view() const {
  const CameraView view = camera_view();
  return {view.eye, view.eye + kSeenAhead * view.forward};
}

GameScreen::~GameScreen() {
  window_.catch_pointer(false);
  if (landmarks_) keep_landmarks(nullptr);
}

void GameScreen::start() {
  begin_match();
  enter(State::kPlaying);
}

void GameScreen::go_on_with(SuspendedMatch left) {
  options_.setup = left.match->setup();
  match_ = std::move(left.match);
  played_ = std::move(left.played);
  picture_.show(*match_);
  guide_ = false;
  follow_player();
  camera_.follow(*match_, aim(), 0);
  enter(State::kPaused);
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
  replay_.reset();
  replay_shown_ = false;
  score_log_ = ScoreLog();
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
  if (input.close) leave_ = Leave::kAway;
  for (const InputEvent& event : input.events) {
    if (event.kind == InputEvent::Kind::kKey && !event.again) handle_key(event.button);
  }
  if (state_ != State::kPlaying) return;
  input_.handle_events(input.events, settings_);
  input_.poll(window_, ImGui::GetIO().DeltaTime, settings_);
  if (!window_.has_focus()) enter(State::kPaused);
}

void GameScreen::handle_key(int key) {
  switch (key) {
    case GLFW_KEY_ESCAPE:
    case GLFW_KEY_P:
      return escape();
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      if (state_ == State::kStart) return begin_selected();
      if (lesson_ && state_ == State::kPlaying) end_lesson();
      return;
    case GLFW_KEY_R:
      if (state_ != State::kPlaying && state_ != State::kStart) start();
      return;
    case GLFW_KEY_B:
      if (state_ == State::kOver) begin_replay();
      return;
    case GLFW_KEY_G:
      if (state_ != State::kPlaying || match_->standing().over() || !match_->is_disabled()) return;
      return input_.give_up();
    case GLFW_KEY_C:
      camera_.viewpoint = camera_.viewpoint == Viewpoint::kRoof ? Viewpoint::kChase : Viewpoint::kRoof;
      return camera_.cut();
    case GLFW_KEY_H:
      guide_ = !guide_;
      return;
    default:
      if (key < GLFW_KEY_0 || key > GLFW_KEY_9 || state_ == State::kOver || state_ == State::kStart) return;
      const std::string done = press_digit(static_cast<char>('0' + (key - GLFW_KEY_0)), picture_.look());
      if (!done.empty()) hud_.note(done);
  }
}

// Skips the slow motion at the end and the replay.
void GameScreen::escape() {
  if (state_ == State::kStart) {
    leave_ = Leave::kAway;
    return enter(state_);
  }
  if (state_ == State::kPaused) return enter(State::kPlaying);
  if (state_ == State::kPlaying) return match_->standing().over() ? finish() : enter(State::kPaused);
  if (replay_) replay_->skip();
}

// Update

void GameScreen::advance() {
  const double seconds = std::min<double>(ImGui::GetIO().DeltaTime, kMaxFrame);
  if (state_ == State::kPlaying) {
    if (settings_.aim_help && !bot_) input_.help(*match_, Sight(match_->world()), seconds);
    const int ticks = clock_.advance(seconds);
    for (int i = 0; i < ticks && !match_->settled(); ++i) tick();
    hud_.advance(seconds);
    played_seconds_ += seconds;
    if (played_seconds_ > kGuideSeconds) guide_ = false;
    if (match_->standing().over()) go_on_after_the_end(seconds);
    if (lesson_ && lesson_->done()) end_lesson();
  }
  if (state_ == State::kStart) {
    picture_.advance(*match_, seconds);
    start_shown_ += seconds;
  } else if (state_ == State::kOver && replay_) {
    advance_replay(seconds);
  } else if (state_ != State::kPaused) {
    picture_.advance(*match_, clock_.is_slow() ? 0.25 * seconds : seconds);
    const Vec3 aim = this->aim();
    camera_.follow(*match_, aim, seconds);
    if (state_ == State::kPlaying) sounds_.advance(*match_, camera_.eye(), aim, settings_.volume);
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
    const bool own = event.vehicle == Match::kPlayer;
    if (event.kind == Event::Kind::kInHalves && !own) clock_.slow_down(kSlowMotion);
    if (event.kind == Event::Kind::kImpact && own && settings_.shake) camera_.shake(event.size / kHardImpact);
    if (event.kind == Event::Kind::kKilled && own) killer_ = event.by;
    new_wave = new_wave || event.kind == Event::Kind::kWaveBegins;
  }
  score_log_.on_tick(*match_);
  hud_.on_tick(*match_);
  sounds_.on_tick(*match_);
  picture_.follow(*match_);
  if (new_wave) follow_player();
  if (lesson_ && lesson_->on_tick(*match_)) hud_.note("well done");
}

// The vehicle is another one, or repaired.
void GameScreen::follow_player() {
  const TurretDescription& turret = match_->vehicles()[Match::kPlayer].what().turret;
  input_.limit(turret.yaw, turret.barrel.pitch);
}

void GameScreen::finish() {
  const Standing& standing = match_->standing();
  MatchResult result;
  result.won = standing.phase == Standing::Phase::kWon;
  result.why = end_reason(*match_, killer_);
  result.wheels_lost = standing.wheels_lost;
  result.pieces = standing.pieces;
  result.score = {standing.score, match_->rules().description.name, name_of(match_->setup().difficulty),
                  result.won,     standing.enemies_destroyed,       seconds_of_ticks(standing.ticks)};
  result.ended = standing.phase == Standing::Phase::kEnded;
  if (!result.ended || match_->rules().description.targets) {
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
  if (!moment) return;
  replay_ = std::make_unique<MatchReplay>(match_->setup(), *moment, played_);
  if (replay_shown_) picture_.show(*match_);
  replay_shown_ = false;
}

void GameScreen::advance_replay(double seconds) {
  if (replay_->state() == MatchReplay::State::kPreparing) return picture_.advance(*match_, seconds);
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
  sounds_.advance(replay_->match(), replay_->camera().eye(), ahead, settings_.volume);
}

const Match& GameScreen::shown() const { return replay_shown_ ? replay_->match() : *match_; }

void GameScreen::take(MenuChoice choice) {
  switch (choice) {
    case MenuChoice::kNone:
      return;
    case MenuChoice::kResume:
      return enter(State::kPlaying);
    case MenuChoice::kRestart:
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
  return camera_.view(aspect, settings_.field_of_view);
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
  picture_.draw(shown(), view, whole, presets_.select(settings_.preset), resolution_.share());
  if (plays) {
    HudView hud{*match_, hud_, view, sight, aim()};
    hud.width = input_.width();
    hud.guide = guide_ && state_ == State::kPlaying;
    hud.machine = words_on_speed();
    hud.sighted = part;
    if (lesson_) hud.task = lesson_->task(*match_);
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
      return take(draw_pause_menu({settings_, options_.look, picture_.look(), ways()}));
    case State::kOver:
      if (!result_) return;
      return take(draw_result(*result_, replay_ ? replay_->state() : MatchReplay::State::kOver, ways()));
  }
}

void GameScreen::drawn() {
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
  frame_s_ += kFrameShare * (time.whole - frame_s_);
  frame_seconds_.push_back(time.whole);
}

// Before a match: the menu, the tutorial, and loading of the selected mode.

void GameScreen::go_to_start() {
  show_choice();
  enter(State::kStart);
}

// The yard with the selected car is behind the menu.
void GameScreen::show_choice() {
  load(load_mode(settings_.mode, settings_.vehicle));
  begin_match();
  scores_ =
      high_scores_of(match_->rules().description.name, name_of(settings_.difficulty), high_scores_file());
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
  load(load_mode(settings_.mode, settings_.vehicle));
  start();
}

WindowedGame::WindowedGame(std::unique_ptr<GameScreen> screen) : screen_(std::move(screen)) {}
WindowedGame::~WindowedGame() = default;
WindowedGame::WindowedGame(WindowedGame&&) noexcept = default;
WindowedGame& WindowedGame::operator=(WindowedGame&&) noexcept = default;

Result<WindowedGame> WindowedGame::begin(Window& window, const GameOptions& options, SuspendedMatch left) {
  auto picture = MatchPicture::create();
  if (!picture) return picture.error();
  return WindowedGame(std::make_unique<GameScreen>(window, std::move(*picture), options, std::move(left)));
}

void WindowedGame::play(FrameLoop& loop) {
  screen_->resume();
  loop.run(*screen_);
}

bool WindowedGame::wants_inspection() const { return screen_->leave() == GameScreen::Leave::kInspect; }
GuiLook WindowedGame::look() const { return screen_->look(); }
const Match& WindowedGame::match() const { return screen_->match(); }
View WindowedGame::view() const { return screen_->view(); }

GameOutcome WindowedGame::outcome() {
  GameOutcome outcome;
  outcome.inspect = wants_inspection();
  outcome.view = view();
  outcome.frame_seconds = screen_->frame_seconds();
  outcome.last.played = screen_->played();
  outcome.last.match = screen_->take_match();
  return outcome;
}

Result<GameOutcome> play(const GameOptions& options, const WindowOptions& wanted) {
  auto opened = open_window(wanted);
  if (!opened) return opened.error();
  Window& window = **opened;
  Gui gui(window);
  FrameLoop loop(window, gui);
  auto game = WindowedGame::begin(window, options);
  if (!game) return game.error();
  game->play(loop);
  if (!loop.fault().empty()) return bad_input(loop.fault());
  return game->outcome();
}

}  // namespace kerf
