#include "ui/game/scorches.h"

#include <algorithm>

namespace kerf {

namespace {

constexpr double kRadius = 3.2;  // over that of the beam
constexpr double kScorchSpacing = 0.6;   // radii between two of them
constexpr double kCoolSeconds = 1.4;
constexpr size_t kLooked = 24;  // of the latest ones, for one that is there already

}  // namespace

void Scorches::burn(const Match& match, const BeamPicture& beam, const Sight& sight) {
  const double length = glm::length(beam.to - beam.from);
  if (!(length > 0)) return;
  const auto hit = sight.nearest({beam.from, (beam.to - beam.from) / length}, length * 1.001 + 1e-3,
                                 [&](BodyId id) { return match.is_wall(id); });
  if (!hit) return;
  const double radius = kRadius * beam.radius;
  const size_t from = places_.size() - std::min(places_.size(), kLooked);
  for (size_t i = from; i < places_.size(); ++i) {
    if (glm::length(places_[i].at - beam.to) > kScorchSpacing * radius) continue;
    places_[i].heat = 1;
    return;
  }
  places_.push_back({beam.to, hit->normal, radius, 1});
  if (places_.size() > kMost) places_.pop_front();
}

void Scorches::advance(double seconds) {
  for (Scorch& s : places_) s.heat = std::max(0.0, s.heat - seconds / kCoolSeconds);
}

}  // namespace kerf
