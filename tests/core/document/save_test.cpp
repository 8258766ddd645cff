#include "core/document/save.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/document/lost_looks.h"
#include "core/document/npz_file.h"
#include "core/document/scene.h"
#include "core/document/surface_files.h"
#include "core/edit/body_edit.h"
#include "core/edit/separation.h"
#include "core/mesh/files/bytes.h"
#include "core/mesh/files/readers.h"
#include "core/mesh/mesh_file.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

TEST(SaveFile, keeps_one_previous_version) {
  TemporaryFolder folder;
  const auto file = folder / "work.kerf";
  for (const char* text : {"first", "second", "third"}) ASSERT_TRUE(save_file(file, text).ok());
  EXPECT_EQ(read_text(file), "third");
  EXPECT_EQ(read_text(previous_version(file)), "second");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2);
}

TEST(SaveFile, keeps_the_previous_version_if_the_file_cannot_be_written) {
  TemporaryFolder folder;
  const auto file = folder / "work.kerf";
  for (const char* text : {"first", "second"}) ASSERT_TRUE(save_file(file, text).ok());
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit limit{3, before.rlim_max};
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  const Status saved = save_file(file, "third");
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, handler);
  EXPECT_FALSE(saved.ok());
  EXPECT_EQ(read_text(file), "second");
  EXPECT_EQ(read_text(previous_version(file)), "first");
}

TEST(SaveFile, writes_through_a_symlink_and_reports_failures) {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder / "real");
  write_text(folder.path() / "real" / "work.kerf", "old");
  std::filesystem::create_symlink("real/work.kerf", folder / "link.kerf");
  ASSERT_TRUE(save_file(folder / "link.kerf", "new").ok());
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.kerf"));
  EXPECT_EQ(read_text(folder.path() / "real" / "work.kerf"), "new");
  EXPECT_EQ(read_text(folder.path() / "real" / "work.kerf~"), "old");
  const Status nowhere = save_file(folder.path() / "no" / "folder", "x");
  ASSERT_FALSE(nowhere.ok());
  EXPECT_EQ(nowhere.error().code, ErrorCode::kFailed);
}

TEST(InputFiles, include_libraries_and_images_of_obj_files_in_any_spelling) {
  TemporaryFolder folder;
  write_text(folder / "look.mtl", "newmtl a\nmap_Kd look.png\n");
  write_text(folder / "look.png", "an image");
  write_text(folder / "plain.obj", "mtllib look.mtl\n");
  write_text(folder / "PART.OBJ", "mtllib look.mtl\n");
  write_text(folder / "marked.obj", "\xef\xbb\xbfmtllib look.mtl\n");
  for (const char* obj : {"plain.obj", "PART.OBJ", "marked.obj"}) {
    InputFiles inputs;
    inputs.add(folder / obj);
    for (const char* file : {"look.mtl", "look.png"})
      EXPECT_FALSE(inputs.check("--out", folder / file).ok()) << obj << ", " << file;
  }
}

TEST(InputFiles, include_at_most_64_different_libraries_of_an_obj_file) {
  TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 65; ++i) {
    const std::string name = std::to_string(i) + ".mtl";
    write_text(folder / name, "newmtl a\n");
    text += "mtllib " + name + "\nmtllib 0.mtl\n";
  }
  write_text(folder / "part.obj", text);
  InputFiles inputs;
  inputs.add(folder / "part.obj");
  EXPECT_FALSE(inputs.check("--out", folder / "63.mtl").ok());
  EXPECT_TRUE(inputs.check("--out", folder / "64.mtl").ok());
}

TEST(InputFiles, include_buffers_and_images_of_gltf_files) {
  TemporaryFolder folder;
  write_text(folder / "part.gltf",
             R"({"buffers":[{"byteLength":4},{"uri":"part%20one.bin"},{"uri":"a%5Cb.bin"}],)"
             R"("images":[{"bufferView":0},{"uri":"data:;base64,AA=="},{"uri":"look.png"},)"
             R"({"uri":"../maps/far.png"}]})");
  for (const char* file : {"part one.bin", "a\\b.bin", "look.png", "far.png", "other.png"})
    write_text(folder / file, file);
  InputFiles inputs;
  inputs.add(folder / "part.gltf");
  for (const char* file : {"part.gltf", "part one.bin", "a\\b.bin", "look.png", "far.png"})
    EXPECT_FALSE(inputs.check("--out", folder / file).ok()) << file;
  EXPECT_TRUE(inputs.check("--out", folder / "other.png").ok());
}

TEST(InputFiles, include_images_of_binary_gltf_files) {
  TemporaryFolder folder;
  const std::string json = R"({"images":[{"uri":"look.png"}]})";
  std::string bytes = "glTF";
  for (const size_t word : {size_t{2}, 20 + json.size(), json.size(), size_t{0x4E4F534A}})
    append_little(static_cast<uint32_t>(word), bytes);
  write_text(folder / "part.glb", bytes + json);
  for (const char* file : {"look.png", "other.png"}) write_text(folder / file, file);
  InputFiles inputs;
  inputs.add(folder / "part.glb");
  EXPECT_FALSE(inputs.check("--out", folder / "look.png").ok());
  EXPECT_TRUE(inputs.check("--out", folder / "other.png").ok());
}

std::vector<std::string> loss_notes(const Soup& soup, MeshFormat format) {
  const Body body = make_body("part", build(soup));
  const std::vector<FaceId> faces = body.faces_of(0);
  LostLooks lost;
  lost.add(body, faces, extract_faces(body, faces), format);
  std::vector<std::string> notes;
  lost.add_notes(format, notes);
  return notes;
}

TEST(LostLooks, are_those_that_a_format_does_not_hold) {
  const Soup painted = *read_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 1\nf 1/1 2/1 3/1\n", "a.obj");
  for (const MeshFormatRow& row : kMeshFormats) {
    SCOPED_TRACE(row.title);
    EXPECT_EQ(loss_notes(grid(2, 1), row.format), std::vector<std::string>{});
    const std::string loss = std::string(row.title) + " holds no UVs: 1 face loses its";
    EXPECT_EQ(loss_notes(painted, row.format),
              row.uvs_and_normals ? std::vector<std::string>{} : std::vector<std::string>{loss});
  }
}

TEST(LostLooks, count_only_the_faces_that_have_them) {
  Soup soup = *read_obj(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv -1 1 0\nv -1 0 0\nvt 0 1\nvn 0 0 1\n"
      "f 1/1 2/1 3/1\nf 1//1 3//1 4//1\nf 1 4 5\nusemtl red\nf 1 5 6\n",
      "a.obj");
  ASSERT_EQ(soup.material_names, (std::vector<std::string>{"", "red"}));
  auto library = std::make_shared<SurfaceLibrary>();
  library->images = {{"paint.png", "", "image/png", "a"}};
  library->textures = {R"({"source":0})"};
  library->materials.resize(2);
  library->materials[1].gltf = R"({"normalTexture":{"index":0}})";
  soup.surfaces = library;
  const auto has_note = [&](MeshFormat format, const std::string& note) {
    const auto notes = loss_notes(soup, format);
    return !notes.empty() && notes[0] == note;
  };
  EXPECT_TRUE(
      has_note(MeshFormat::kStl, "STL holds no UVs, normals, materials or textures: 3 faces lose theirs"));
  EXPECT_TRUE(has_note(MeshFormat::k3mf, "3MF holds no UVs, normals or textures: 3 faces lose theirs"));
  EXPECT_TRUE(
      has_note(MeshFormat::kPly, "PLY as written by Kerf holds no materials or textures: 1 face loses its"));
}

// The offsets are those of APPNOTE 6.3 and of the format 1.0 of .npy.
TEST(NpzFile, stores_arrays_with_aligned_data_and_a_fixed_time) {
  const std::vector<double> values{1, 2, 3, 4, 5, 6};
  const std::vector<size_t> shape{2, 3};
  for (const std::string name : {"a", "abcd", "a_longer_name"}) {
    NpzFile file;
    file.add(name, values, shape);
    const auto bytes = file.take();
    ASSERT_TRUE(bytes.ok());
    const auto at = [&](size_t place) { return load<uint16_t>(bytes->data() + place, std::endian::little); };
    EXPECT_EQ(at(10), 0) << "time";
    EXPECT_EQ(at(12), 0x21) << "1 January 1980";
    const std::string content = bytes->substr(30 + at(26));
    EXPECT_EQ(content.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    const size_t head = 10 + load<uint16_t>(content.data() + 8, std::endian::little);
    EXPECT_EQ(head % 64, 0u);
    EXPECT_NE(content.substr(0, head).find("'shape': (2, 3, )"), std::string::npos);
    for (size_t i = 0; i < values.size(); ++i)
      EXPECT_EQ(load<double>(content.data() + head + 8 * i, std::endian::little), values[i]);
  }
}

TEST(SurfaceFiles, give_images_the_extension_of_their_kind) {
  Soup soup = grid(1, 1);
  soup.material_names = {"paint"};
  auto library = std::make_shared<SurfaceLibrary>();
  library->images = {{"Material.001", "", "image/png", "a"},
                     {"Paint.JPEG", "", "image/jpeg", "b"},
                     {"photo.png", "", "image/jpeg", "c"},
                     {"sky", "", "image/webp", "d"},
                     {"map.tga", "", "", "e"},
                     {"plain", "", "", "f"}};
  library->materials.resize(1);
  for (uint32_t i = 0; i < library->images.size(); ++i) library->materials[0].mtl.push_back({"map_x ", i});
  soup.surfaces = library;
  const World world = world_of(soup);
  const TemporaryFolder folder;
  SurfaceFiles files(world);
  ASSERT_TRUE(files.write(folder.path()).ok());
  EXPECT_EQ(read_text(folder / "pieces.mtl"),
            "newmtl paint\nmap_x Material.001.png\nmap_x Paint.JPEG\nmap_x photo.png.jpg\nmap_x sky.webp\n"
            "map_x map.tga\nmap_x plain.image\n");
  EXPECT_EQ(read_text(folder / "Material.001.png"), "a");
}

TEST(SurfaceFiles, keep_the_texture_of_a_ply_file) {
  const TemporaryFolder folder;
  write_text(folder / "paint.png", "an image");
  write_text(folder / "a.ply",
             "ply\nformat ascii 1.0\ncomment TextureFile paint.png\nelement vertex 3\nproperty float x\n"
             "property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n"
             "end_header\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n");
  const auto soup = read_mesh(folder / "a.ply");
  ASSERT_TRUE(soup.ok()) << soup.error().message;
  const World world = world_of(*soup);
  SurfaceFiles files(world);
  ASSERT_TRUE(files.write(folder.path()).ok());
  EXPECT_EQ(read_text(folder / "pieces.mtl"), "newmtl paint.png\nmap_Kd paint.png\n");
  EXPECT_EQ(files.names(world.body(world.ids()[0])), std::vector<std::string>{"paint.png"});
}

// The faces stand in the files in their order, whatever pieces they belong to.
TEST(SaveWorldAsScene, keeps_the_face_order_of_several_pieces) {
  World world = world_of(sphere(14, 20, 1));
  Body& body = only_body(world);
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    const Triangle t = body.mesh.triangle(FaceId(f));
    if (std::abs(t[0].x + t[1].x + t[2].x) < 0.4) BodyEdit(body).remove(std::vector{FaceId(f)});
  }
  settle(body);
  ASSERT_EQ(world.live_pieces(), 2u);
  TemporaryFolder folder;
  SceneDescription description;
  description.bodies.push_back(body_of_file(folder / "what-was-opened.obj"));
  const auto saved = save_world_as_scene(world, description, folder.path());
  ASSERT_TRUE(saved.ok());
  const auto scene = read_scene(*saved);
  ASSERT_TRUE(scene.ok()) << "it has only the bodies of the world";
  const Mesh& back = scene->world.body(scene->world.ids().front()).mesh;
  uint32_t next = 0;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const Triangle a = body.mesh.triangle(FaceId(f)), b = back.triangle(FaceId(next++));
    EXPECT_NEAR(glm::distance((a[0] + a[1] + a[2]) / 3.0, (b[0] + b[1] + b[2]) / 3.0), 0, 1e-9) << f;
  }
  EXPECT_EQ(next, back.live_faces());
}

class SceneFile : public testing::Test {
 protected:
  Result<SceneDescription> parse(const std::string& text) {
    json_ = nlohmann::json::parse(text);
    return parse_scene(JsonValue(json_, "scene.json"), folder_.path());
  }
  TemporaryFolder folder_;
  nlohmann::json json_;
};

constexpr const char* kScene = R"({
  "version": 1,
  "bodies": [{"mesh": "a.obj", "name": "one", "position": [1, 2, 3], "orientation": [0, 1, 0, 0]},
             {"mesh": "/whole/b.ply", "name": "two"}],
  "paints": {"tyre": {"colour": "#202224", "gloss": 0.1}},
  "view": {"eye": [1, 2, 3], "target": [0, 0, 0]},
  "lights": [{"position": [0, 5, 0], "colour": "#fff2d8", "intensity": 2.5}, {"direction": [0, 1, 0]}],
  "show": ["wire", "aabb"],
  "strokes": [{"laser": {"radius": 0.1}, "keys": [{"t": 0, "origin": [0, 1, 0], "direction": [0, -1, 0]}]}]
})";

TEST_F(SceneFile, round_trips) {
  const auto scene = parse(kScene);
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  ASSERT_TRUE(save_scene(folder_ / "saved.json", *scene).ok());
  const auto saved = nlohmann::json::parse(read_text(folder_ / "saved.json"));
  auto expected = nlohmann::json::parse(kScene);
  expected["lights"][1]["colour"] = colour_text(Light().colour);
  expected["lights"][1]["intensity"] = Light().intensity;
  EXPECT_EQ(saved, expected);
}

TEST_F(SceneFile, stores_a_substance_other_than_the_default) {
  auto scene = parse(kScene);
  ASSERT_TRUE(scene.ok());
  scene->bodies[0].sheet.substance.conductivity = 7;
  ASSERT_TRUE(save_scene(folder_ / "saved.json", *scene).ok());
  const auto again = parse(read_text(folder_ / "saved.json"));
  ASSERT_TRUE(again.ok()) << again.error().message;
  for (size_t i = 0; i < 2; ++i) EXPECT_EQ(again->bodies[i].sheet, scene->bodies[i].sheet) << i;
}

TEST_F(SceneFile, does_not_replace_its_meshes) {
  const auto scene = parse(kScene);
  ASSERT_TRUE(scene.ok());
  write_text(folder_ / "a.obj", "a mesh");
  EXPECT_FALSE(save_scene(folder_ / "a.obj", *scene).ok());
  EXPECT_EQ(read_text(folder_ / "a.obj"), "a mesh");
}

TEST_F(SceneFile, rejects_invalid_values_with_a_json_pointer) {
  const auto refused = [&](const std::string& key, const std::string& value, const std::string& pointer) {
    auto json = nlohmann::json::parse(kScene);
    json[nlohmann::json::json_pointer(key)] = nlohmann::json::parse(value);
    const auto scene = parse(json.dump());
    ASSERT_FALSE(scene.ok()) << key;
    EXPECT_EQ(scene.error().code, ErrorCode::kBadInput);
    EXPECT_NE(scene.error().message.find("scene.json: " + pointer), std::string::npos)
        << scene.error().message;
  };
  refused("/version", "2", "/version");
  refused("/version", "\"1\"", "/version");
  refused("/bodies", "[]", "/bodies");
  refused("/bodies/0/orientation", "[1, 1, 0, 0]", "/bodies/0/orientation");
  refused("/bodies/0/position", "[1, 2]", "/bodies/0/position");
  refused("/bodies/1/hash", "\"xyz\"", "/bodies/1/hash");
  refused("/paints/tyre/colour", "\"red\"", "/paints/tyre/colour");
  refused("/lights/0/intensity", "-1", "/lights/0/intensity");
  refused("/paints", R"({"a\u0000b": 7})", "/paints/a");
}

}  // namespace
}  // namespace kerf::test
