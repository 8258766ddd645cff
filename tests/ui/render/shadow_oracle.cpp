#include "tests/ui/render/shadow_oracle.h"

namespace kerf::test {

namespace {

// A pixel and its eight neighbours, those beyond the border left out.
template <typename Visit>
void around(int x, int y, int width, int height, const Visit& visit) {
  for (int j = std::max(0, y - 1); j <= std::min(height - 1, y + 1); ++j) {
    for (int i = std::max(0, x - 1); i <= std::min(width - 1, x + 1); ++i) {
      visit(static_cast<size_t>(j) * static_cast<size_t>(width) + static_cast<size_t>(i));
    }
  }
}

}  // namespace

ShadowVerdict judge(const ShadowCounts& drawn, const ShadowReference& traced) {
  ShadowVerdict v;
  for (int y = 0; y < drawn.height; ++y) {
    for (int x = 0; x < drawn.width; ++x) {
      const size_t here = static_cast<size_t>(y) * static_cast<size_t>(drawn.width) + static_cast<size_t>(x);
      if (traced.faces()[here] == 0) continue;
      ++v.hit;
      const bool shadow = traced.occluders()[here] > 0;
      v.in_shadow += shadow;
      const bool same_face = traced.faces()[here] == drawn.faces[here];
      v.same_face += same_face;
      bool inner = true, one_count = true;
      around(x, y, drawn.width, drawn.height, [&](size_t i) {
        inner = inner && traced.faces()[i] != 0 && (traced.occluders()[i] > 0) == shadow;
        one_count = one_count && traced.faces()[i] != 0 && traced.occluders()[i] == traced.occluders()[here];
      });
      const bool off = (drawn.stencil[here] != 0) != shadow;
      v.left_out += !inner;
      v.wrong_at_all += off && same_face;
      v.wrong += off && same_face && inner;
      v.miscounted += one_count && same_face && drawn.stencil[here] != traced.occluders()[here] % 256;
      v.multiples_of_256 += inner && same_face && shadow && traced.occluders()[here] % 256 == 0;
    }
  }
  return v;
}

std::string ShadowVerdict::summary() const {
  const auto of = [](const char* name, size_t n) {
    return std::string(name) + " " + std::to_string(n) + ", ";
  };
  return of("hit", hit) + of("other face", hit - same_face) + of("in shadow", in_shadow) +
         of("left out", left_out) + of("wrong", wrong) + of("with boundaries", wrong_at_all) + "miscounted " +
         std::to_string(miscounted);
}

ShadowTrial::ShadowTrial(Stage& stage, const Light& light, const CameraView& view, int width, int height)
    : stage_(stage), view_(view), width_(width), height_(height) {
  options_.lights = {light};
}

void ShadowTrial::cut_with(const SectionPlane& plane) {
  options_.section = plane;
  options_.show.section = true;
}

ShadowVerdict ShadowTrial::verdict(ShadowMethod method) {
  Renderer& renderer = stage_.renderer();
  const World& world = stage_.world();
  if (!traced_) {
    traced_ = renderer.shadow_reference(world, view_, options_, 0, ground_, width_, height_);
    traced_->trace(static_cast<size_t>(width_) * static_cast<size_t>(height_));
  }
  return judge(renderer.shadow_counts(world, view_, options_, 0, method, ground_, width_, height_), *traced_);
}

}  // namespace kerf::test
