#include "ui/game/game.h"

#include "ui/game/game_screen.h"
#include "ui/screen/frame_loop.h"
#include "ui/window/gui.h"
#include "ui/window/window.h"

namespace kerf {

WindowedGame::WindowedGame(std::unique_ptr<GameScreen> screen) : screen_(std::move(screen)) {}
WindowedGame::~WindowedGame() = default;
WindowedGame::WindowedGame(WindowedGame&&) noexcept = default;
WindowedGame& WindowedGame::operator=(WindowedGame&&) noexcept = default;

Result<WindowedGame> WindowedGame::begin(Window& window, const GameOptions& options, LeftMatch left) {
  auto picture = MatchPicture::create();
  if (!picture) return picture.error();
  return WindowedGame(std::make_unique<GameScreen>(window, std::move(*picture), options, std::move(left)));
}

void WindowedGame::play(FrameLoop& loop) {
  screen_->go_on();
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
