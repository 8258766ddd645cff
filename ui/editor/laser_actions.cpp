#include "ui/editor/actions.h"
#include "ui/editor/changes/world_changes.h"

namespace kerf {

namespace {

constexpr double kRadiusStep = 1.25, kRadiusSpan = 20;

// As moving a slider of the panel does.
void cut_again_live(EditorState& s, bool radius) {
  if (!s.settings.live_recut || why_no_recut(s.work.document) != nullptr) return;
  (radius ? s.requests.recut_radius : s.requests.recut) = true;
}

UserAction radius_action(EditorState& s, const char* name, double factor) {
  return {.menu = "Laser",
          .name = name,
          .tip = "By a quarter. The last stroke follows while that is on in the Resolution panel.",
          .run =
              [&s, factor] {
                LaserControls& laser = s.hand.laser;
                laser.radius = std::clamp(laser.radius * factor, laser.default_radius / kRadiusSpan,
                                          laser.default_radius * kRadiusSpan);
                cut_again_live(s, true);
              },
          .in_menu = false};
}

UserAction finer_action(EditorState& s, const char* name, int steps) {
  return {.menu = "Resolution",
          .name = name,
          .tip = "Halves or doubles the size of the faces along the cut, or splits once more or less.",
          .run =
              [&s, steps] {
                make_finer(s.hand.laser.resolution, steps);
                cut_again_live(s, false);
              },
          .in_menu = false};
}

// Sets one of the choices of the resolution.
template <typename Choice>
UserAction choice_action(EditorState& s, const char* name, Choice ResolutionControls::*member, Choice value,
                         const char* tip) {
  return {.menu = "Resolution",
          .name = name,
          .tip = tip,
          .run =
              [&s, member, value] {
                s.hand.laser.resolution.*member = value;
                cut_again_live(s, false);
              },
          .checked = [&s, member, value] { return s.hand.laser.resolution.*member == value; },
          .in_menu = false};
}

UserAction pattern_action(EditorState& s, const char* name, Pattern value, const char* tip) {
  return {.menu = "Laser",
          .name = name,
          .tip = tip,
          .run = [&s, value] { s.hand.laser.pattern = value; },
          .checked = [&s, value] { return s.hand.laser.pattern == value; },
          .in_menu = false};
}

}  // namespace

std::vector<UserAction> laser_actions(EditorState& s) {
  using Controls = ResolutionControls;
  using Rule = Resolution::Rule;
  return {
      radius_action(s, "Wider beam", kRadiusStep),
      radius_action(s, "Narrower beam", 1 / kRadiusStep),
      pattern_action(s, "Pattern: volume", Pattern::kVolume, "Burns everything in the beam."),
      pattern_action(s, "Pattern: four rays", Pattern::kRays4,
                     "Burns only what four parallel rays on the rim of the beam meet."),
      finer_action(s, "Finer cut", 1),
      finer_action(s, "Coarser cut", -1),
      choice_action(s, "Split to edge length", &Controls::rule, Rule::kTargetEdge,
                    "Faces are small enough when their edges are."),
      choice_action(s, "Split to tolerance", &Controls::rule, Rule::kTolerance,
                    "Faces are small enough when what is removed overshoots the beam by no more than that."),
      choice_action(s, "Split to depth", &Controls::rule, Rule::kDepth, "Faces are split so many times."),
      choice_action(s, "Scheme: one to four", &Controls::scheme, Scheme::kOneToFour,
                    "A face is split in four, as in the paper."),
      choice_action(s, "Scheme: longest edge", &Controls::scheme, Scheme::kLongestEdge,
                    "A face is split in two at its longest edge."),
      choice_action(s, "Rim: faces", &Controls::rim, Rim::kFaces,
                    "All that the beam touches goes, so the rim is a saw."),
      choice_action(s, "Rim: smooth", &Controls::rim, Rim::kSmooth,
                    "When the stroke ends, faces across the boundary of the beam are cut along it."),
      UserAction{.menu = "Resolution",
                 .name = "Cut again as the slider moves",
                 .tip = "A change of the resolution or the radius cuts the last stroke again.",
                 .run = [&s] { s.settings.live_recut = !s.settings.live_recut; },
                 .checked = [&s] { return s.settings.live_recut; },
                 .in_menu = false},
  };
}

}  // namespace kerf
