#pragma once

#include <imgui.h>

#include <string>

namespace kerf {

// Seconds as "2:05"; less than none are none.
std::string clock_text(double seconds);

// Draws parts of the head-up display, in screen coordinates. Text and lines have a dark edge, so that they
// are legible on everything.
class HudPaint {
 public:
  enum class Align { kLeft, kMiddle, kRight };

  HudPaint();

  float em() const { return em_; }
  ImVec2 size() const { return size_; }
  ImDrawList& list() const { return list_; }

  void text(ImVec2 at, const std::string& text, ImU32 colour, float scale = 1,
            Align align = Align::kLeft) const;
  float width_of(const std::string& text, float scale) const;
  // A bar that is filled by a share, with a name before it.
  void bar(ImVec2 at, float width, const char* name, double share, ImU32 colour, bool striped) const;
  void line(ImVec2 from, ImVec2 to, ImU32 colour, float width) const;
  void circle(ImVec2 at, float radius, ImU32 colour, float width) const;
  void shade(ImVec2 from, ImVec2 to) const;

  // A colour with its opacity multiplied by a factor from 0 to 1.
  static ImU32 faded(ImU32 colour, double opacity);

 private:
  ImDrawList& list_;
  float em_;
  ImVec2 size_;
};

}  // namespace kerf
