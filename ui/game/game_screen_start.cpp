#include "core/game/match/recording.h"
#include "ui/game/game_screen.h"

// What happens before a match: the menu, the lesson, and loading what was chosen.

namespace kerf {

void GameScreen::go_to_start() {
  show_choice();
  enter(State::kStart);
}

// The yard with the chosen car is behind the menu.
void GameScreen::show_choice() {
  load(load_mode(settings_.mode, settings_.vehicle));
  begin_match();
  scores_ =
      high_scores_of(match_->rules().description.name, name_of(settings_.difficulty), high_scores_file());
}

// Where a file of the game is missing or wrong, the player stays with what there was.
void GameScreen::load(Result<std::shared_ptr<const Rules>> rules) {
  if (rules) options_.setup.rules = std::move(*rules);
}

void GameScreen::begin_chosen() {
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

// The first match comes after it.
void GameScreen::end_lesson() {
  lesson_.reset();
  settings_.taught = true;
  load(load_mode(settings_.mode, settings_.vehicle));
  start();
}

}  // namespace kerf
