#pragma once

#include <imgui.h>
#include <optional>
#include <string>
#include <vector>

#include "core/game/match/match.h"
#include "ui/game/game_actions.h"
#include "ui/game/hud_state.h"
#include "ui/game/player_input.h"
#include "ui/render/view/camera.h"

namespace kerf {

// Draws parts of the HUD, in screen coordinates. Text and lines have a dark edge, to be legible on any
// background.
class HudPaint {
 public:
  enum class Align { kLeft, kMiddle, kRight };

  HudPaint();

  float em() const { return em_; }
  ImVec2 size() const { return size_; }
  ImDrawList& list() const { return list_; }

  void text(ImVec2 at, const std::string& text, ImU32 colour, float scale = 1,
            Align align = Align::kLeft) const;
  // The same on a dark plate.
  void plate_text(ImVec2 at, const std::string& text, ImU32 colour, float scale = 1,
                  Align align = Align::kLeft) const;
  float width_of(const std::string& text, float scale) const;
  // A bar filled by a fraction, with a label before it.
  void bar(ImVec2 at, float width, const char* name, double share, ImU32 colour, bool striped) const;
  void line(ImVec2 from, ImVec2 to, ImU32 colour, float width) const;
  void circle(ImVec2 at, float radius, ImU32 colour, float width) const;
  void shade(ImVec2 from, ImVec2 to) const;

  // Returns a colour with its opacity multiplied by a factor from 0 to 1.
  static ImU32 faded(ImU32 colour, double opacity);

 private:
  ImDrawList& list_;
  float em_;
  ImVec2 size_;
};

struct HudView {
  const Match& match;
  const HudState& state;
  const CameraView& camera;
  const Sight& sight;                   // of the world of the match
  Vec3 aim;                             // the player's aim, unit
  double width = 0;                     // of the beam, 0 .. 1
  std::vector<std::string> guide = {};  // lines on the keys; empty: not shown
  KeyBindings keys = default_bindings();
  bool gamepad = false;               // name its buttons in place of keys
  const SteadyAim* steady = nullptr;  // null: not shown
  std::string machine = {};           // performance of the machine; empty: not shown
  std::optional<SightedPart> sighted = {};
  std::optional<Lesson::Task> task = {};
};

// Draws the HUD of a match over the window with ImGui: reticle, energy and heat, speed, the player's
// vehicle with its damage, score, clock, notices, directions to enemies, and the sighted enemy with its
// damage. Colour is never the only cue. Sizes follow the text size.
void draw_hud(const HudView& view);

}  // namespace kerf
