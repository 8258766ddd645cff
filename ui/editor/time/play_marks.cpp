#include "ui/editor/time/play_marks.h"

#include <imgui.h>

#include <string>

#include "ui/editor/shared/picture/first_picture.h"
#include "ui/window/imgui_vector.h"
#include "ui/window/landmarks.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr int kCoils = 9;
constexpr float kLeastCoiled = 2;  // sizes of the text; a shorter spring is a line

constexpr double kAsFast = 0.9;  // of the chosen speed; a smaller one that is reached is told

std::string words_of(const PlayState& play, const ReachedSpeed& reached, const World& world) {
  const double seconds = seconds_of_ticks(world.clock());
  if (!play.playing) return text_of("Paused  %.2f s", seconds);
  return "Playing " + speed_text(play, reached) + text_of("  %.1f s", seconds);
}

// A zigzag between two places, with a dark line under it.
void draw_coil(Vec2 from, Vec2 to, float em, ImDrawList& list) {
  const Vec2 way = to - from;
  const double length = glm::length(way);
  const Vec2 aside = length > 0 ? Vec2(-way.y, way.x) / length * (0.3 * em) : Vec2(0);
  std::vector<ImVec2> points{to_im(from)};
  const int coils = length > kLeastCoiled * em ? kCoils : 0;
  for (int i = 0; i < coils; ++i) {
    const double along = 0.12 + 0.76 * (i + 0.5) / coils;
    points.push_back(to_im(from + along * way + (i % 2 == 0 ? aside : -aside)));
  }
  points.push_back(to_im(to));
  const int count = static_cast<int>(points.size());
  list.AddPolyline(points.data(), count, IM_COL32(10, 12, 16, 170), 0, 4);
  list.AddPolyline(points.data(), count, colours::accent(), 0, 1.8f);
}

}  // namespace

std::string speed_text(const PlayState& play, const ReachedSpeed& reached) {
  const double least = kAsFast * play.speed().of_real_time;
  if (!reached.of_real_time() || *reached.of_real_time() >= least) return play.speed().name;
  return text_of("%.2gx of %s", *reached.of_real_time(), play.speed().name);
}

// As wide as the longest time to come, so that it stands still.
void draw_play_badge(const PlayState& play, const ReachedSpeed& reached, const World& world,
                     const ViewState& view, Badges& badges) {
  constexpr float kLeastEms = 9.5f;
  badges.draw(view, play.playing ? Badges::Sign::kPlaying : Badges::Sign::kPaused,
              words_of(play, reached, world), "play badge", kLeastEms);
}

void draw_spring(const Spring& spring, const World& world, const ViewState& view) {
  if (!world.contains(spring.piece.body)) return;
  const Placement& placement = world.body(spring.piece.body).placement;
  const FirstPicture picture(view);
  const auto from = picture.place_of(placement.to_world(spring.at));
  const auto to = picture.place_of(spring.to);
  if (!from || !to) return;
  const float em = ImGui::GetFontSize();
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  draw_coil(*from, *to, em, list);
  for (const Vec2& end : {*from, *to}) {
    list.AddCircleFilled(to_im(end), 0.32f * em, IM_COL32(10, 12, 16, 170));
    list.AddCircleFilled(to_im(end), 0.22f * em, colours::accent());
  }
}

}  // namespace kerf
