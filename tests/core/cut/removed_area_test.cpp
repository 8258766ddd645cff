#include <gtest/gtest.h>

#include "core/document/document.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

constexpr double kShare = 1e-9;  // of the area as loaded; the report promises 1e-6

double area_of_world(const World& world) {
  double area = 0;
  for (const BodyId id : world.ids()) {
    const Mesh& mesh = world.body(id).mesh;
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      if (mesh.is_live(FaceId(f))) area += triangle_area(mesh.triangle(FaceId(f)));
    }
  }
  return area;
}

double counted_area(const World& world) {
  double area = 0;
  for (const BodyId id : world.ids()) {
    const auto& pieces = world.body(id).pieces;
    for (uint32_t p = 0; p < pieces.size(); ++p) area += pieces[p].area;
  }
  return area;
}

CutSettings settings_of(const RandomStroke& stroke, Rim rim, Scheme scheme) {
  CutSettings settings = stroke.settings;
  settings.resolution.rim = rim;
  settings.resolution.scheme = scheme;
  settings.max_faces = 200'000;
  return settings;
}

// One stroke; what its steps say that they removed (m^2).
double draw(Document& document, const RandomStroke& stroke, const CutSettings& settings) {
  document.apply(BeginStroke{settings, stroke.moves.front().from});
  document.apply(MoveBeam{stroke.moves.back().to});
  document.apply(EndStroke{});
  const auto walked = run_all(document);
  EXPECT_TRUE(walked.ok());
  return walked ? walked->delta.removed_area : 0;
}

// Removed and left, by the history, by the faces that live and by the counts of pieces, are what was loaded.
void expect_balanced(const Document& document, double loaded, const char* when) {
  SCOPED_TRACE(when);
  const double left = area_of_world(document.world());
  EXPECT_NEAR(document.history().totals().removed_area + left, loaded, kShare * loaded);
  EXPECT_NEAR(counted_area(document.world()), left, kShare * loaded);
  const Sheet sheet;  // of all bodies
  const double weight = sheet.thickness * sheet.substance.density;
  EXPECT_NEAR(document.history().totals().removed_mass, weight * document.history().totals().removed_area,
              kShare * weight * loaded);
}

void expect_area_balanced(const Soup& soup, Random& random, Rim rim, Scheme scheme) {
  Document document(world_of(soup));
  const double loaded = area_of_world(document.world());
  double removed = 0;
  for (const double radius_share : {0.02, 0.03}) {
    const RandomStroke stroke = random_stroke(document.world(), random, radius_share, random.below(2) == 0);
    const double in_stroke = draw(document, stroke, settings_of(stroke, rim, scheme));
    EXPECT_NEAR(document.history().last().totals().removed_area, in_stroke, kShare * loaded);
    removed += in_stroke;
    EXPECT_NEAR(document.history().totals().removed_area, removed, kShare * loaded);
    expect_balanced(document, loaded, "after a stroke");
  }
  Recut finer{document.history().last_settings()};
  finer.settings.resolution.target_edge *= 0.6;
  ASSERT_TRUE(document.apply(finer).ok());
  ASSERT_TRUE(run_all(document).ok());
  expect_balanced(document, loaded, "after the recut of a stroke");
  for (const char* when : {"after the undo of a recut", "after the undo of a stroke", "after all undos"}) {
    ASSERT_TRUE(document.apply(Undo{}).ok());
    expect_balanced(document, loaded, when);
  }
  EXPECT_EQ(document.history().totals().removed_area, 0);
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(document.apply(Redo{}).ok());
    expect_balanced(document, loaded, "after a redo");
  }
}

TEST(RemovedArea, plus_remaining_area_equals_loaded_area_after_random_edits) {
  uint64_t seed = 0;
  for (const NamedSoup& made : mesh_classes()) {
    for (const Rim rim : {Rim::kFaces, Rim::kSmooth}) {
      for (const Scheme scheme : {Scheme::kOneToFour, Scheme::kLongestEdge}) {
        Random random(++seed);
        SCOPED_TRACE(made.name + ", seed " + std::to_string(seed) +
                     (rim == Rim::kSmooth ? ", smooth" : ", faces") +
                     (scheme == Scheme::kOneToFour ? ", one-to-four" : ", longest-edge"));
        expect_area_balanced(made.soup, random, rim, scheme);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

}  // namespace
}  // namespace kerf::test
