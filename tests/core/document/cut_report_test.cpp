#include "core/document/cut_report.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "core/base/random.h"
#include "core/document/text/fields.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

double smallest_angle_of(const Triangle& t) {
  double smallest = 180;
  for (size_t i = 0; i < 3; ++i) {
    const Vec3 a = glm::normalize(t[(i + 1) % 3] - t[i]), b = glm::normalize(t[(i + 2) % 3] - t[i]);
    smallest = std::min(smallest, std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)) * 180 / std::numbers::pi);
  }
  return smallest;
}

// One face anywhere among more than are measured at once is the sharpest.
TEST(SmallestAngle, is_the_angle_of_the_sharpest_face) {
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    World world = world_of(grid(140, 1));
    Mesh& mesh = only_body(world).mesh;
    const FaceId sharp(static_cast<uint32_t>(random.below(mesh.face_slots())));
    const VertexId corner = mesh.corners(sharp)[0];
    mesh.move_vertex(corner, mesh.position(corner) + Vec3(0.0047, 0, 0.0021));
    double smallest = 180;
    for (uint32_t f = 0; f < mesh.face_slots(); ++f)
      smallest = std::min(smallest, smallest_angle_of(mesh.triangle(FaceId(f))));
    EXPECT_LT(smallest, 40);
    EXPECT_NEAR(smallest_angle(world), smallest, 1e-6);
  }
}

PieceId part(uint32_t label) { return {{0, 0}, label}; }

// Frees a part in each of some strokes, and keeps a copy after each.
std::vector<FreedParts> copies_after_each(uint32_t strokes) {
  std::vector<FreedParts> copies;
  FreedParts parts;
  for (uint32_t stroke = 0; stroke < strokes; ++stroke) {
    parts.add(part(stroke), stroke);
    parts.add(part(stroke / 2), stroke);  // freed before, unless it is the first
    parts.share();
    copies.push_back(parts);
  }
  return copies;
}

TEST(FreedParts, of_a_copy_are_those_freed_before_it) {
  const std::vector<FreedParts> copies = copies_after_each(100);
  for (uint32_t copy = 0; copy < 100; ++copy) {
    for (uint32_t label = 0; label < 100; ++label)
      EXPECT_EQ(copies[copy].find(part(label)), label <= copy ? std::optional<size_t>(label) : std::nullopt);
  }
  FreedParts other = copies[10];
  other.add(part(11), 500);
  EXPECT_EQ(other.find(part(11)), 500u);
  EXPECT_EQ(copies[11].find(part(11)), 11u);
}

TEST(FreedParts, share_their_memory_between_copies) {
  const auto bytes = [](uint32_t strokes) {
    const size_t before = ::mallinfo2().uordblks;
    const std::vector<FreedParts> copies = copies_after_each(strokes);
    return ::mallinfo2().uordblks - before;
  };
  EXPECT_LE(bytes(4000), 3 * bytes(2000));  // four times as much if each had its own
}

StepResult step_of_solid(double volume, BodyId left_open) {
  StepResult step;
  step.delta.solid = {10, 0.5, volume};
  step.delta.left_open = {{left_open, "the rim crosses itself near (1, 2, 3)"}};
  return step;
}

TEST(CutReport, sums_the_removed_volume_of_closed_solids) {
  World world = world_of(brick({1, 1, 1}));
  only_body(world).solid = true;
  CutJob job;
  for (const double volume : {0.125, 0.25}) {
    StepResult step = step_of_solid(volume, world.ids().front());
    step.delta.left_open.clear();
    job.record_step(step, world, 0);
  }
  EXPECT_EQ(cut_report(job, world, {}, {})["removed"]["volume"], 0.375);
}

TEST(CutReport, sums_walls_and_lists_each_reason_once) {
  World world = world_of(brick({1, 1, 1}));
  Body& body = only_body(world);
  body.name = "box";
  body.solid = true;
  CutJob job;
  for (const double volume : {0.125, 0.25})
    job.record_step(step_of_solid(volume, world.ids().front()), world, 0);
  const auto report = cut_report(job, world, {}, {});
  EXPECT_FALSE(report["removed"].contains("volume")) << "which is not known of what stays open";
  EXPECT_EQ(report["walls"]["faces"], 20);
  EXPECT_EQ(report["walls"]["area"], 1.0);
  EXPECT_EQ(report["notes"].dump(), R"(["box: the rim crosses itself near (1, 2, 3) m"])");
  const LeftOpen open = step_of_solid(0, world.ids().front()).delta.left_open[0];
  EXPECT_EQ(left_open_text(open, world, FileUnit::kMillimetre),
            "box: the rim crosses itself near (1, 2, 3) mm");
  body.placement.position.x = 5;
  EXPECT_EQ(left_open_text(open, world, FileUnit::kMetre),
            "box: the rim crosses itself near (1, 2, 3) m in the frame of the body");
}

TEST(CutReport, places_the_cuts_of_freed_parts_in_the_world) {
  World world = world_of(brick({1, 1, 1}));
  only_body(world).placement.position = {5, 0, 0};
  CutJob job;
  StepResult step;
  BodyDelta& delta = step.delta.bodies.emplace_back();
  delta.body = world.ids().front();
  delta.new_pieces = {1};
  job.begin_stroke();
  job.record_step(step, world, 0);
  job.end_stroke();
  delta.new_pieces.clear();
  CutFace& cut = delta.removed.emplace_back();
  cut.piece = 1;
  cut.corners = {Vec3(0), Vec3(3, 0, 0), Vec3(0, 3, 0)};
  job.begin_stroke();
  job.record_step(step, world, 0);
  const auto report = cut_report(job, world, {}, {});
  ASSERT_EQ(report["scrap"].size(), 1u);
  EXPECT_EQ(report["scrap"][0]["at"].dump(), "[6.0,1.0,0.0]");
}

TEST(CutReport, sums_loaded_faces_and_changes_of_steps) {
  CutJob job;
  MeshReport mesh;
  mesh.faces = 12;
  mesh.vertices = 8;
  mesh.components = 1;
  mesh.area = 6;
  for (int i = 0; i < 2; ++i) job.record_loaded(mesh);
  const World world = world_of(brick({1, 1, 1}));
  // Steps of 1 to 100 ms in some order, and one that removed nothing.
  for (int i = 1; i <= 100; ++i) {
    StepResult step;
    step.delta.removed_faces = 2;
    step.delta.removed_area = 0.5;
    step.statistics.query_s = 0.25;
    step.statistics.refine_s = 0.5;
    step.statistics.remove_s = 1;
    step.statistics.update_tree_s = 2;
    step.statistics.separate_s = 4;
    job.record_step(step, world, i * 37 % 101 / 1000.0);
  }
  job.record_step({}, world, 7);
  const auto report = cut_report(job, world, {}, {});
  EXPECT_EQ(report["input"]["faces"], 24);
  EXPECT_EQ(report["input"]["vertices"], 16);
  EXPECT_EQ(report["input"]["components"], 2);
  EXPECT_EQ(report["input"]["area"], 12.0);
  EXPECT_EQ(report["removed"]["faces"], 200);
  EXPECT_EQ(report["removed"]["area"], 50.0);
  const auto& timing = report["timing_ms"];
  EXPECT_EQ(timing["query"], 25e3);
  EXPECT_EQ(timing["refine"], 50e3);
  EXPECT_EQ(timing["remove"], 100e3);
  EXPECT_EQ(timing["update_tree"], 200e3);
  EXPECT_EQ(timing["separate"], 400e3);
  EXPECT_DOUBLE_EQ(timing["step_p50"], 50);
  EXPECT_DOUBLE_EQ(timing["step_p99"], 99);
  EXPECT_DOUBLE_EQ(timing["step_max"], 100);
}

TEST(CutReport, has_no_times_of_steps_if_there_were_none) {
  const auto report = cut_report({}, world_of(brick({1, 1, 1})), {}, {});
  for (const char* key : {"step_p50", "step_p99", "step_max"})
    EXPECT_EQ(report["timing_ms"][key], 0.0) << key;
}

TEST(CutReport, omits_solids_if_there_are_none) {
  const World world = world_of(brick({1, 1, 1}));
  const auto report = cut_report({}, world, {}, {});
  EXPECT_FALSE(report.contains("walls") || report["removed"].contains("volume"));
  EXPECT_EQ(report["notes"], nlohmann::ordered_json::array());
}

TEST(CutReport, names_the_beam_pattern) {
  CutSettings settings;
  settings.laser.pattern = Pattern::kRays4;
  EXPECT_EQ(settings_json(settings, "obj", false)["pattern"], "rays4");
  settings.laser.pattern = Pattern::kVolume;
  EXPECT_EQ(settings_json(settings, "obj", false)["pattern"], "volume");
}

TEST(CutReport, names_the_rim_that_the_beam_leaves) {
  CutSettings settings;
  settings.resolution.rim = Rim::kSmooth;
  EXPECT_EQ(settings_json(settings, "obj", false)["rim"], "smooth");
  settings.laser.pattern = Pattern::kRays4;
  EXPECT_EQ(settings_json(settings, "obj", false)["rim"], "faces");
  settings.laser.pattern = Pattern::kVolume;
  settings.model = Model::kThermal;
  EXPECT_EQ(settings_json(settings, "obj", false)["rim"], "faces");
}

TEST(CutReport, reports_closed_pieces_and_their_volume) {
  WrittenPiece closed, open;
  closed.volume = 0.5;
  const auto report = cut_report({}, world_of(brick({1, 1, 1})), {}, {closed, open});
  EXPECT_EQ(report["pieces"][0]["closed"], true);
  EXPECT_EQ(report["pieces"][0]["volume"], 0.5);
  EXPECT_EQ(report["pieces"][1]["closed"], false);
  EXPECT_FALSE(report["pieces"][1].contains("volume"));
}

TEST(CutReport, lists_strokes_that_removed_nothing) {
  const World world = world_of(brick({1, 1, 1}));
  CutJob job;
  for (const size_t removed : {0u, 2u, 0u}) {
    job.begin_stroke();
    StepResult step;
    step.delta.removed_faces = removed;
    job.record_step(step, world, 0);
    job.end_stroke();
  }
  EXPECT_EQ(cut_report(job, world, {}, {})["missed"].dump(), "[0,2]");
}

}  // namespace
}  // namespace kerf::test
