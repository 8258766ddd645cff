#pragma once

#include <vector>

#include "tests/ui/render/stage.h"

namespace kerf::test {

// A picture's shadows held against those that rays find. Pixels whose 3x3 neighbours are not all alike, lit
// or in shadow, hit or not, or that show another face than the ray met, are left out of `wrong`, by what the
// rays say alone; `miscounted` looks where all neighbours have one number of occluders, and compares modulo
// 256.
struct ShadowVerdict {
  size_t hit = 0;           // pixels that show a body
  size_t same_face = 0;     // of these, in both
  size_t left_out = 0;      // at a boundary
  size_t wrong = 0;         // lit in one and not in the other
  size_t wrong_at_all = 0;  // boundaries included
  size_t miscounted = 0;
  size_t in_shadow = 0;         // by rays
  size_t multiples_of_256 = 0;  // pixels with so many occluders, none of them at a boundary
  std::string summary() const;
};
ShadowVerdict judge(const ShadowCounts& drawn, const ShadowReference& traced);

// One view of one world under one light, drawn with any method and held against one tracing.
class ShadowTrial {
 public:
  // The stage must outlive it and stay as it is.
  ShadowTrial(Stage& stage, const Light& light, const CameraView& view, int width, int height);

  ShadowVerdict verdict(ShadowMethod method);
  // Draws the near caps of the robust method so from now on.
  void draw_near_caps(NearCaps how) { options_.shadow.near_caps = how; }
  // The ground is a part of the picture from now on. Precondition: no verdict was asked for.
  void stand_on_ground() { ground_ = true; }
  // Cuts the picture with a section plane. Precondition: no verdict was asked for.
  void cut_with(const SectionPlane& plane);
  ShadowVerdict robust() { return verdict(ShadowMethod::kRobust); }

 private:
  Stage& stage_;
  CameraView view_;
  ViewOptions options_;
  int width_, height_;
  bool ground_ = false;
  std::optional<ShadowReference> traced_;
};

}  // namespace kerf::test
