#include "ui/game/hud_state.h"

#include <algorithm>

#include "ui/game/match_words.h"

namespace kerf {

namespace {

constexpr double kNoticeSeconds = 3.2, kLargeSeconds = 2.2;
constexpr double kAgain = 1.5;  // s, within which what happens again is told in the same line
constexpr size_t kMostNotices = 6;
constexpr double kHurtFade = 1.6, kBiteFade = 6;  // 1/s

using Kind = Event::Kind;

void begin_with_capital(std::string& text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
}

}  // namespace

void HudState::clear() {
  notices_.clear();
  hurt_ = biting_ = 0;
}

void HudState::say(std::string text, double points, bool good, bool large) {
  begin_with_capital(text);
  if (!notices_.empty() && notices_.front().text == text && notices_.front().age < kAgain) {
    Notice& same = notices_.front();
    ++same.times;
    same.points += points;
    same.age = 0;
    return;
  }
  notices_.push_front({std::move(text), points, 1, 0, good, large});
  if (notices_.size() > kMostNotices) notices_.pop_back();
}

void HudState::advance(double seconds) {
  for (Notice& n : notices_) n.age += seconds;
  std::erase_if(notices_, [](const Notice& n) { return n.age > (n.large ? kLargeSeconds : kNoticeSeconds); });
  hurt_ = std::max(0.0, hurt_ - kHurtFade * seconds);
  biting_ = std::max(0.0, biting_ - kBiteFade * seconds);
}

void HudState::hear(const Match& match) {
  for (const Event& event : match.events()) tell(match, event);
}

void HudState::tell(const Match& match, const Event& event) {
  // A wave that begins in the tick of the event puts other vehicles in the place of the last ones.
  const bool known = event.vehicle < match.vehicles().size();
  const bool own = event.vehicle == Match::kPlayer;
  const VehicleDescription* what = known ? &match.vehicles()[event.vehicle].what() : nullptr;
  const std::string whose = own ? "your " : what ? "the " + what->name + "'s " : "";
  switch (event.kind) {
    case Kind::kCut:
      if (own && event.by < match.vehicles().size()) {
        hurt_ = 1;
        hurt_from_ = match.world().body(match.vehicles()[event.by].chassis).placement.position;
      } else if (event.by == Match::kPlayer && known) {
        biting_ = 1;
      }
      return;
    case Kind::kPieceOff:
      if (event.points > 0) say("a piece is off", event.points, true);
      return;
    case Kind::kWheelLost:
      if (!what || event.part >= what->wheels.size()) return say("a wheel is off", event.points, !own);
      return say(whose + name_of_wheel(*what, event.part) + " is off", event.points, !own);
    case Kind::kTurretLost:
    case Kind::kBarrelLost:
      return say(whose + "laser is off", event.points, !own);
    case Kind::kVitalLost:
      if (!what || event.part >= what->vitals.size()) return say("a part is gone", event.points, !own);
      return say(whose + name_of_vital(*what, event.part) + " is gone", event.points, !own);
    case Kind::kInHalves:
      return say(own ? "you are cut in two" : "cut in two", event.points, !own, true);
    case Kind::kKilled:
      return say(own ? "you are out" : "the " + (what ? what->name : "enemy") + " is out", event.points, !own,
                 true);
    case Kind::kOverheated:
      if (own) say("the laser is too hot", 0, false);
      return;
    case Kind::kRighted:
      if (own) say("back on your wheels", 0, true);
      return;
    case Kind::kCleanPart:
      return say("a clean part", event.points, true);
    case Kind::kCarLost:
      return say(event.part == 0 ? "your last car comes" : "another car comes", 0, false, true);
    case Kind::kWaveBegins:
      if (match.rules().description.targets) return;
      return say("wave " + std::to_string(event.part + 1), 0, true, true);
    case Kind::kWaveCleared:
      return say("wave cleared", event.points, true, true);
    case Kind::kWon:
    case Kind::kLost:
      return say(why_it_ended(match), 0, event.kind == Kind::kWon, true);
    case Kind::kImpact:
      return;
  }
}

}  // namespace kerf
