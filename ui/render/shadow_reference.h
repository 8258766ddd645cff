#pragma once

#include "core/shadow/shadow_rays.h"
#include "ui/render/shadow_probe.h"
#include "ui/render/subject.h"

namespace kerf {

// Rays through what a picture draws: all bodies in the order of their ids, pieces where their looks have
// them.
ShadowRays rays_through(const Subject& subject);

// Shadows by rays, pixel by pixel in rows from below, a part of the picture at a time.
class ShadowReference {
 public:
  // `near`: where the near plane lies along the view's forward axis, m; `ground`: its height (m), where it is
  // seen and receives shadows.
  ShadowReference(ShadowRays rays, const CameraView& view, double near, const Light& light,
                  std::optional<double> ground, int width, int height);

  // Traces whole rows until that many pixels or all are done.
  void trace(size_t pixels);
  bool done() const { return row_ == height_; }
  double share_done() const { return static_cast<double>(row_) / height_; }

  int width() const { return width_; }
  int height() const { return height_; }
  // What each pixel shows, as ShadowCounts::faces, and by how many surfaces the light is kept from it; 0 in
  // rows that are not traced yet.
  const std::vector<uint32_t>& faces() const { return faces_; }
  const std::vector<int>& occluders() const { return occluders_; }

 private:
  void trace_pixel(int x, int y);

  ShadowRays rays_;
  CameraView view_;
  double near_;
  Light light_;
  std::optional<double> ground_;
  int width_, height_, row_ = 0;
  std::vector<uint32_t> faces_;
  std::vector<int> occluders_;
};

// Pixels that show the same in both and are lit in one alone. Rows that are not traced yet do not count.
size_t differing_pixels(const ShadowCounts& drawn, const ShadowReference& traced);

}  // namespace kerf
