#include "ui/editor/view/section.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace kerf {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

ViewState view_of(const SectionPlane& plane, bool parallel = false) {
  ViewState view;
  view.layout = lay_out({1000, 700}, 16, 26, 26);
  view.camera.look({3, 2, 8}, {0, 0, 0});
  view.camera.set_parallel(parallel);
  view.camera.finish();
  view.look.section = plane;
  view.look.show.section = true;
  return view;
}

const SectionHandle& handle_of(const std::vector<SectionHandle>& handles, SectionDrag::Kind kind) {
  for (const SectionHandle& handle : handles) {
    if (handle.kind == kind) return handle;
  }
  throw std::out_of_range("no such handle");
}

Vec2 as_ray_takes_it(const ViewState& view, Vec2 at) {
  const Vec2 p = (at - view.layout.first.at) / view.layout.first.size;
  return {2 * p.x - 1, 1 - 2 * p.y};
}

const std::vector<SectionPlane>& planes() {
  static const std::vector<SectionPlane> all{
      {{0, 0, 0}, {1, 0, 0}},
      {{0.5, 0.2, 0}, {0, 1, 0}},
      SectionPlane::facing({0, 0.3, 0.4}, {0.9, 0.5, 0.1}),
      SectionPlane::facing({-0.3, 0, 0}, {0.6, -1, 0.4}),
  };
  return all;
}

TEST(SectionHandles, are_shown_while_the_plane_cuts_and_is_in_front_of_the_camera) {
  ViewState view = view_of({{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(section_handles(view).size(), 3u);
  view.look.show.section = false;
  EXPECT_TRUE(section_handles(view).empty());
  EXPECT_FALSE(section_drag_at(view, view.layout.first.at + view.layout.first.size * 0.5));
  view.look.show.section = true;
  view.look.section->point = {30, 20, 80};
  EXPECT_TRUE(section_handles(view).empty());
}

TEST(SectionHandles, dragging_the_arrow_moves_its_tip_along_the_normal) {
  for (const bool parallel : {false, true}) {
    for (const SectionPlane& plane : planes()) {
      ViewState view = view_of(plane, parallel);
      const std::vector<SectionHandle> handles = section_handles(view);
      const SectionHandle& arrow = handle_of(handles, SectionDrag::Kind::kMove);
      const auto drag = section_drag_at(view, arrow.places[arrow.grip]);
      ASSERT_TRUE(drag && drag->kind() == SectionDrag::Kind::kMove) << section_text(plane);
      const Vec3 goal = arrow.points[1] + plane.normal * 0.37;
      const Vec3 seen = view.seen_first().project(goal);
      const SectionPlane moved = drag->to({seen.x, seen.y});
      EXPECT_EQ(moved.normal, plane.normal);
      EXPECT_LT(glm::length(moved.point - (plane.point + plane.normal * 0.37)), 1e-6) << section_text(plane);
      EXPECT_EQ(drag->to(as_ray_takes_it(view, arrow.places[arrow.grip])).point, plane.point);
    }
  }
}

TEST(SectionHandles, dragging_a_ring_rotates_the_plane_with_the_pointer) {
  for (const bool parallel : {false, true}) {
    for (const SectionPlane& plane : planes()) {
      for (const auto kind : {SectionDrag::Kind::kTilt, SectionDrag::Kind::kSwing}) {
        ViewState view = view_of(plane, parallel);
        const std::vector<SectionHandle> handles = section_handles(view);
        const SectionHandle& ring = handle_of(handles, kind);
        const auto drag = section_drag_at(view, ring.places[ring.grip]);
        ASSERT_TRUE(drag && drag->kind() == kind) << section_text(plane);
        const PlaneAxes axes = axes_of(plane, UpAxis::kY);
        const Vec3 axis = kind == SectionDrag::Kind::kTilt ? axes.level : axes.steep;
        // The grip, turned by so little that its circle is a line.
        const Vec3 grip = ring.points[ring.points.size() / 4];
        const glm::dquat turn = glm::angleAxis(0.5 * kDegree, axis);
        const Vec3 seen = view.seen_first().project(plane.point + turn * (grip - plane.point));
        const SectionPlane turned = drag->to({seen.x, seen.y});
        EXPECT_EQ(turned.point, plane.point);
        EXPECT_NEAR(glm::length(turned.normal), 1, 1e-12);
        EXPECT_LT(glm::length(turned.normal - turn * plane.normal), 0.05 * kDegree) << section_text(plane);
      }
    }
  }
}

TEST(SectionHandles, the_axes_of_a_plane_are_perpendicular_and_one_is_horizontal) {
  for (const SectionPlane& plane : planes()) {
    for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
      const PlaneAxes axes = axes_of(plane, up);
      EXPECT_NEAR(glm::dot(axes.level, plane.normal), 0, 1e-12);
      EXPECT_NEAR(glm::dot(axes.steep, plane.normal), 0, 1e-12);
      EXPECT_NEAR(glm::dot(axes.steep, axes.level), 0, 1e-12);
      EXPECT_NEAR(height_of(axes.level, up), 0, 1e-12);
      EXPECT_NEAR(glm::length(axes.level) + glm::length(axes.steep), 2, 1e-12);
    }
  }
}

}  // namespace
}  // namespace kerf
