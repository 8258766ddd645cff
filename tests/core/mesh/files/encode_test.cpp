#include "core/mesh/files/encode.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/core/mesh/files/sample_files.h"

namespace kerf {
namespace {

// Random positions of any size and triangles between them.
struct RandomMesh {
  explicit RandomMesh(size_t count) {
    Random random(count);
    for (size_t i = 0; i < count; ++i)
      positions.emplace_back(random.uniform(-1, 1), 1e30 * random.uniform(-1, 1),
                             1e-30 * random.uniform(-1, 1));
    for (size_t i = 0; i < 2 * count; ++i) {
      const auto corner = [&] { return static_cast<uint32_t>(random.below(count)); };
      triangles.push_back({corner(), corner(), corner()});
    }
  }
  MeshView view() const { return {positions, triangles, {}, {}}; }

  std::vector<Vec3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
};

TEST(Encode, round_trips_exactly_and_in_order) {
  const RandomMesh mesh(40'000);  // more than readers give to one thread
  for (const MeshFormat format : {MeshFormat::kObj, MeshFormat::kPly, MeshFormat::kOff}) {
    const std::string bytes = encoded(mesh.view(), format);
    EXPECT_EQ(recognise_format(bytes, ""), format);
    const auto soup = test::reader_of(format)(bytes, "mesh", nullptr);
    ASSERT_TRUE(soup) << soup.error().message;
    EXPECT_EQ(soup->positions, mesh.positions) << format_row(format).ending;
    EXPECT_EQ(soup->triangles, mesh.triangles) << format_row(format).ending;
  }
}

TEST(Encode, stl_rounds_corners_to_single_precision) {
  const RandomMesh mesh(300);
  const auto soup =
      test::reader_of(MeshFormat::kStl)(encoded(mesh.view(), MeshFormat::kStl), "mesh", nullptr);
  ASSERT_TRUE(soup) << soup.error().message;
  ASSERT_EQ(soup->triangles.size(), mesh.triangles.size());
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (size_t i = 0; i < 3; ++i)
      ASSERT_EQ(soup->positions[soup->triangles[t][i]],
                Vec3(glm::vec3(mesh.positions[mesh.triangles[t][i]])));
  }
}

TEST(Encode, stops_when_the_sink_stops) {
  const RandomMesh mesh(20'000);
  for (const MeshFormat format : {MeshFormat::kObj, MeshFormat::kPly, MeshFormat::kStl, MeshFormat::kOff}) {
    size_t taken = 0;
    encode(mesh.view(), format, [&](std::string_view part) {
      taken += part.size();
      return false;
    });
    EXPECT_LT(taken, encoded(mesh.view(), format).size()) << format_row(format).ending;
  }
}

}  // namespace
}  // namespace kerf
