#include "core/mesh/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/document/document.h"
#include "core/document/extract.h"
#include "core/mesh/files/readers.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/remesh/remeshed.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

// A colour that is linear in the position, from 0 to 1 over the box of the mesh.
class LinearColour {
 public:
  explicit LinearColour(const Soup& soup) : low_(soup.positions[0]), high_(low_) {
    for (const Vec3& p : soup.positions) low_ = glm::min(low_, p), high_ = glm::max(high_, p);
  }
  std::array<double, 4> at(const Vec3& p) const {
    const Vec3 size = glm::max(high_ - low_, Vec3(1e-300)), share = (p - low_) / size;
    return {share.x, share.y, share.z, 0.25 + 0.5 * share.x};
  }
  VertexColour rounded(const Vec3& p) const {
    VertexColour colour;
    for (size_t k = 0; k < 4; ++k) colour.part[k] = colour_part(at(p)[k]);
    return colour;
  }
  double error(const VertexColour& colour, const Vec3& p) const {
    double error = 0;
    for (size_t k = 0; k < 4; ++k)
      error = std::max(error, std::abs(fraction_of(colour.part[k]) - std::clamp(at(p)[k], 0.0, 1.0)));
    return error;
  }

 private:
  Vec3 low_, high_;
};

Soup coloured(Soup soup) {
  const LinearColour linear(soup);
  for (const Vec3& p : soup.positions) soup.colours.push_back(linear.rounded(p));
  return soup;
}

double largest_error(const World& world, const LinearColour& linear) {
  double error = 0;
  for (const BodyId id : world.ids()) {
    const Mesh& mesh = world.body(id).mesh;
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      if (!mesh.is_live(FaceId(f))) continue;
      for (const VertexId v : mesh.corners(FaceId(f)))
        error = std::max(error, linear.error(mesh.colours().get(v), mesh.position(v)));
    }
  }
  return error;
}

void draw(Document& document, const RandomStroke& stroke, const CutSettings& settings) {
  document.apply(BeginStroke{settings, stroke.moves.front().from});
  document.apply(MoveBeam{stroke.moves.back().to});
  document.apply(EndStroke{});
  ASSERT_TRUE(run_all(document).ok());
}

// A colour that is linear in the position stays so wherever edges are split, which checks every split up to
// accumulated rounding. A vertex that moves onto a smooth rim keeps its colour.
TEST(VertexColours, are_interpolated_in_cuts_and_restored_by_undo) {
  uint64_t seed = 0;
  for (const NamedSoup& made : mesh_classes()) {
    for (const Rim rim : {Rim::kFaces, Rim::kSmooth}) {
      for (const Scheme scheme : {Scheme::kOneToFour, Scheme::kLongestEdge}) {
        Random random(++seed);
        SCOPED_TRACE(made.name + ", seed " + std::to_string(seed));
        const Soup soup = coloured(made.soup);
        const LinearColour linear(soup);
        Document document(world_of(soup));
        const uint32_t loaded = document.world().body(document.world().ids()[0]).mesh.vertex_slots();
        const RandomStroke stroke = random_stroke(document.world(), random, 0.05, true);
        CutSettings settings = stroke.settings;
        settings.resolution.rim = rim;
        settings.resolution.scheme = scheme;
        settings.max_faces = 200'000;
        draw(document, stroke, settings);
        EXPECT_LT(largest_error(document.world(), linear), rim == Rim::kFaces ? 1e-3 : 0.1);
        document.apply(Undo{});
        ASSERT_TRUE(run_all(document).ok());
        EXPECT_EQ(document.world().body(document.world().ids()[0]).mesh.vertex_slots(), loaded);
        EXPECT_LT(largest_error(document.world(), linear), 1e-5);
        document.apply(Redo{});
        ASSERT_TRUE(run_all(document).ok());
        EXPECT_LT(largest_error(document.world(), linear), rim == Rim::kFaces ? 1e-3 : 0.1);
      }
    }
  }
}

TEST(VertexColours, do_not_affect_the_cut_or_its_hash) {
  Random random(3);
  const Soup plain = sphere(24, 32, 1);
  Document without(world_of(plain)), with(world_of(coloured(plain)));
  const RandomStroke stroke = random_stroke(without.world(), random, 0.1, false);
  for (Document* document : {&without, &with}) draw(*document, stroke, stroke.settings);
  EXPECT_EQ(state_hash(without.world()), state_hash(with.world()));
}

TEST(VertexColours, of_a_simplified_mesh_are_those_of_its_vertices) {
  const Soup soup = coloured(sphere(48, 64, 1));
  const LinearColour linear(soup);
  const BuiltMesh built = build(soup);
  const auto made = simplify(built.mesh, SimplifyTarget{.faces = 900}, {}, nullptr);
  ASSERT_TRUE(made.ok());
  const std::vector<VertexColour> colours = colours_of(*made, built.mesh);
  ASSERT_EQ(colours.size(), made->positions.size());
  for (size_t p = 0; p < colours.size(); ++p)
    EXPECT_EQ(colours[p], linear.rounded(made->positions[p])) << "position " << p;
  EXPECT_TRUE(colours_of(*made, build(sphere(4, 6, 1)).mesh).empty());
}

// A random colour of eight bits.
VertexColour any_colour(Random& random) {
  VertexColour colour;
  for (uint16_t& part : colour.part) part = static_cast<uint16_t>(257 * random.below(256));
  return colour;
}

TEST(VertexColours, round_trip_through_files) {
  const TemporaryFolder folder;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    Soup soup = seed % 3 == 0 ? torus(6, 8, 1, 0.3) : grid(5, 2);
    for (size_t i = 0; i < soup.positions.size(); ++i) {
      soup.colours.push_back(any_colour(random));
      if (seed % 2 == 0) soup.colours.back().part[VertexColour::kOpacity] = VertexColour::kFull;
    }
    const std::vector<std::array<uint32_t, 3>> triangles(soup.triangles.begin(), soup.triangles.end());
    const MeshView view{soup.positions, triangles, {}, {}, {}, {}, soup.colours};
    for (const MeshFormat format :
         {MeshFormat::kObj, MeshFormat::kPly, MeshFormat::kOff, MeshFormat::kGlb, MeshFormat::kGltf}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::string(format_row(format).ending));
      const auto path = folder / ("mesh." + std::string(format_row(format).ending));
      ASSERT_TRUE(write_mesh(view, path, format));
      const Result<Soup> read = read_mesh(path);
      ASSERT_TRUE(read) << read.error().message;
      EXPECT_EQ(read->warnings.empty(),
                format != MeshFormat::kOff);  // colours may be bytes or fractions
      ASSERT_EQ(read->colours.size(), soup.colours.size());
      // glTF stores linear light in 16 bits, so that dark colours lose precision.
      const int most = format == MeshFormat::kGlb || format == MeshFormat::kGltf ? 8 : 0;
      for (size_t i = 0; i < soup.colours.size(); ++i) {
        for (size_t k = 0; k < 4; ++k)
          EXPECT_LE(std::abs(int{read->colours[i].part[k]} - int{soup.colours[i].part[k]}), most);
      }
    }
  }
}

TEST(VertexColours, of_a_piece_match_its_vertices) {
  const Soup soup = coloured(both(sphere(8, 12, 1), moved(grid(4, 1), {5, 0, 0}, 1)));
  const LinearColour linear(soup);
  World world = world_of(soup);
  const Body& body = only_body(world);
  for (const auto& faces : faces_by_piece(body, true)) {
    const Extract extract = extract_faces(body, faces);
    ASSERT_EQ(extract.colours.size(), extract.positions.size());
    for (size_t p = 0; p < extract.positions.size(); ++p)
      EXPECT_LT(linear.error(extract.colours[p], extract.positions[p]), 1e-5);
  }
}

const VertexColour kRed{{VertexColour::kFull, 0, 0, VertexColour::kFull}};
const VertexColour kWhite;

TEST(VertexColours, follow_coordinates_in_obj) {
  const auto soup =
      read_obj("v 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0 1 0 0 0.5\nv 0 1 0 0.5\nf 1 2 3 4\n", "a.obj", nullptr);
  ASSERT_TRUE(soup);
  VertexColour half = kRed;
  half.part[VertexColour::kOpacity] = colour_part(0.5);
  EXPECT_EQ(soup->colours, (std::vector<VertexColour>{kRed, kWhite, half, kWhite}));
  const auto plain = read_obj("v 0 0 0 1\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", "a.obj", nullptr);
  ASSERT_TRUE(plain);
  EXPECT_TRUE(plain->colours.empty());
}

std::string ply_with(const std::string& type, const std::string& prefix, const std::string& full) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty " + type + " " +
                     prefix + "red\nproperty " + type + " " + prefix + "green\nproperty float y\nproperty " +
                     type + " " + prefix +
                     "blue\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                     "end_header\n";
  for (const char* row : {"0 R 0 0 0 0", "1 R 0 0 0 0", "1 R 0 1 0 0"}) {
    std::string line = row;
    text += line.replace(line.find('R'), 1, full) + "\n";
  }
  return text + "3 0 1 2\n";
}

TEST(VertexColours, are_vertex_properties_of_any_type_in_ply) {
  for (const auto& [type, full] :
       {std::pair("uchar", "255"), {"ushort", "65535"}, {"float", "1"}, {"short", "32767"}}) {
    for (const char* prefix : {"", "diffuse_"}) {
      const auto soup = read_ply(ply_with(type, prefix, full), "a.ply", nullptr);
      ASSERT_TRUE(soup) << soup.error().message;
      EXPECT_EQ(soup->colours, std::vector<VertexColour>(3, kRed)) << type;
    }
  }
  const auto out_of_range = read_ply(ply_with("float", "", "nan"), "a.ply", nullptr);
  ASSERT_TRUE(out_of_range) << out_of_range.error().message;
  EXPECT_EQ(out_of_range->colours[0].part[0], 0);
}

TEST(VertexColours, of_welded_vertices_come_from_the_first_with_a_note) {
  const auto soup = read_obj("v 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0 0 1 0\nv 0 1 0\nf 1 2 3\nf 4 3 5\n",
                             "a.obj", nullptr);
  ASSERT_TRUE(soup);
  const BuiltMesh built = build(*soup);
  for (uint32_t v = 0; v < built.mesh.vertex_slots(); ++v) {
    if (built.mesh.position(VertexId(v)) == Vec3(0)) {
      EXPECT_EQ(built.mesh.colours().get(VertexId(v)), kRed);
    }
  }
  ASSERT_EQ(built.report.warnings.size(), 1u);
  EXPECT_EQ(built.report.warnings[0],
            "1 vertex has a different colour from an earlier one at its position, whose colour was kept.");
}

TEST(VertexColours, linear_light_conversion_round_trips) {
  for (uint32_t part = 0; part <= VertexColour::kFull; ++part)
    ASSERT_EQ(part_of_linear(linear_light(static_cast<uint16_t>(part))), part);
}

}  // namespace
}  // namespace kerf::test
