#pragma once

#include <string>
#include <vector>

#include "core/shadow/shadow_volume.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "ui/render/view/camera.h"

namespace kerf::test {

// Something that casts a shadow, a light and an eye.
struct ShadowScene {
  std::string name;
  World world;
  Light light;
  CameraView view;
};

inline constexpr int kShadowWidth = 320, kShadowHeight = 240;

Light lamp_at(const Vec3& position);
Light sun_from(const Vec3& direction);
// `near`: m, where the near plane lies, or farther away where nothing is nearer.
CameraView shadow_view(const Vec3& eye, const Vec3& target, double near = 0.2);

// Soups made for shadows.
Soup box(const Vec3& middle, const Vec3& size);
Soup floor_at(double y, double size);
// A ball of which the faces in a cap around `direction` are gone: those whose middle lies less than `cosine`
// from it.
Soup opened_ball(const Vec3& direction, double cosine);
// A box of which a window in the middle of the front and of the back is gone.
Soup windowed_box();
// Upright wall of which one side ends in `count` vertices that its other side does not have, or has when
// `split`.
Soup wall_with_tees(int count, bool split);
// Horizontal square sheets over one another.
Soup stack(int sheets);
Soup triangles(int count, uint64_t seed);
Soup turned_at_random(Soup soup, uint64_t seed);
Soup mirrored(Soup soup);

World world_of_all(const std::vector<Soup>& soups);

}  // namespace kerf::test
