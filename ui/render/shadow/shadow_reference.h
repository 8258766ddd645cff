#pragma once

#include "core/shadow/shadow_rays.h"
#include "ui/render/bodies/subject.h"
#include "ui/render/shadow/shadow_probe.h"

namespace kerf {

// A ray tracer for what a picture shows: all bodies in the order of their ids, pieces at their drawn
// positions.
ShadowRays rays_through(const Subject& subject);

// Traces the shadows of a picture pixel by pixel, in rows from the bottom, in several calls.
class ShadowReference {
 public:
  // `near`: distance of the near plane along the view's forward axis, m; `ground`: its height (m) if it is
  // visible and receives shadows. What `section` takes away is not seen and casts shadows.
  // Precondition: the size is positive.
  ShadowReference(ShadowRays rays, const CameraView& view, double near,
                  const std::optional<SectionPlane>& section, const Light& light,
                  std::optional<double> ground, int width, int height);

  // Traces whole rows, at least `pixels` pixels or all that are left.
  void trace(size_t pixels);
  bool done() const { return row_ == height_; }
  double share_done() const { return static_cast<double>(row_) / height_; }

  int width() const { return width_; }
  int height() const { return height_; }
  // For each pixel the visible face as in ShadowCounts::faces and the number of surfaces that occlude the
  // light; 0 in rows that are not traced yet.
  const std::vector<uint32_t>& faces() const { return faces_; }
  const std::vector<int>& occluders() const { return occluders_; }

 private:
  std::optional<ShadowRays::Seen> look(const Pose& ray) const;
  void trace_pixel(int x, int y);

  ShadowRays rays_;
  CameraView view_;
  double near_;
  std::optional<SectionPlane> section_;
  Light light_;
  std::optional<double> ground_;
  int width_, height_, row_ = 0;
  std::vector<uint32_t> faces_;
  std::vector<int> occluders_;
};

// The number of pixels that show the same face in both and are lit in only one. Rows that are not traced yet
// do not count. Precondition: the pictures have the same size.
size_t differing_pixels(const ShadowCounts& drawn, const ShadowReference& traced);

}  // namespace kerf
