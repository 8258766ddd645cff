#include "ui/editor/pieces/pieces_feature.h"

#include <gtest/gtest.h>

#include "core/mesh/mesh_file.h"
#include "tests/support/made_meshes.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

using Names = std::vector<std::string>;

World world_of(const Names& bodies) {
  World world;
  for (const std::string& name : bodies) {
    Soup soup = test::grid(2, 1);
    soup.material_names = {"paint", "tyre", "chrome"};
    soup.materials.assign(soup.triangles.size(), 0);
    soup.materials.back() = 2;
    world.add(make_body(name, test::build(soup)));
  }
  return world;
}

PieceMap all_selected(const World& world) {
  PieceMap looks;
  for (const BodyId id : world.ids()) looks[{id, 0}].selected = true;
  return looks;
}

Names names(const std::vector<PieceFile>& files) {
  Names all;
  for (const PieceFile& f : files) all.push_back(f.mesh.string());
  return all;
}

TEST(ExportPieces, creates_names_valid_on_every_file_system) {
  EXPECT_EQ(file_name_of("car 9"), "car-9");
  EXPECT_EQ(file_name_of("../a\\b:c*d\"<e>|\n"), "-.-a-b-c-d--e---");
  EXPECT_EQ(file_name_of(""), "piece");
  EXPECT_EQ(file_name_of("T\xc3\xbcr"), "T\xc3\xbcr");
}

TEST(ExportPieces, gives_files_unique_names_from_their_pieces) {
  const World world = world_of({"car", "door left", "car"});
  EXPECT_EQ(names(files_to_export(world, all_selected(world), "/x/*.ply")),
            (Names{"/x/car.ply", "/x/door-left.ply", "/x/car-2.ply"}));
  EXPECT_EQ(names(files_to_export(world, all_selected(world), "/x/old *.stl")),
            (Names{"/x/old car.stl", "/x/old door-left.stl", "/x/old car-2.stl"}));
  EXPECT_EQ(names(files_to_export(world, all_selected(world), "/x/part.off")),
            (Names{"/x/part-1.off", "/x/part-2.off", "/x/part-3.off"}));
  PieceMap one;
  one[{world.ids()[1], 0}].selected = true;
  EXPECT_EQ(names(files_to_export(world, one, "/x/part.off")), Names{"/x/part.off"});
  EXPECT_EQ(names(files_to_export(world, one, "/x/*.off")), Names{"/x/door-left.off"});
  EXPECT_TRUE(files_to_export(world, {}, "/x/*.off").empty());
}

TEST(ExportPieces, suggests_a_name_whose_files_do_not_exist) {
  const test::TemporaryFolder folder;
  const World world = world_of({"tube", "plate"});
  PieceMap one;
  one[{world.ids()[0], 0}].selected = true;
  EXPECT_EQ(unused_name(world, one, folder.path(), "tube.obj"), "tube.obj");
  for (const char* taken : {"tube.obj", "tube-2.obj"}) std::ofstream(folder.path() / taken) << '\n';
  EXPECT_EQ(unused_name(world, one, folder.path(), "tube.obj"), "tube-3.obj");
  EXPECT_EQ(unused_name(world, all_selected(world), folder.path(), "*.obj"), "*-3.obj");
  EXPECT_EQ(unused_name(world, all_selected(world), folder.path(), "*.glb", true), "*.glb");
  std::ofstream(folder.path() / "pieces.glb") << '\n';
  EXPECT_EQ(unused_name(world, all_selected(world), folder.path(), "*.glb", true), "*-2.glb");
  EXPECT_EQ(unused_name(world, all_selected(world), folder.path(), "*.glb"), "*.glb");
}

TEST(ExportPieces, writes_the_mtl_materials_of_a_piece_next_to_an_obj_file) {
  const test::TemporaryFolder folder;
  const World world = world_of({"car"});
  const std::map<std::string, Paint> paints = {{"paint", {{1, 0, 0.5}, 1}}, {"tyre", {{0, 0, 0}, 0}}};
  const auto written = export_selected(world, all_selected(world), paints, folder / "*.obj");
  ASSERT_TRUE(written.ok()) << written.error().message;
  ASSERT_EQ(written->files.size(), 1u);
  EXPECT_EQ(written->files.front().mtl, folder / "car.mtl");
  EXPECT_FALSE(written->note) << "OBJ loses nothing";
  EXPECT_TRUE(test::read_text(folder / "car.obj").starts_with("mtllib car.mtl\n"));
  const std::string materials = test::read_text(folder / "car.mtl");
  EXPECT_TRUE(materials.starts_with("newmtl paint\nKd 1 0 0.7")) << materials;
  EXPECT_NE(materials.find("newmtl chrome\n"), std::string::npos);
  EXPECT_EQ(materials.find("tyre"), std::string::npos) << "no face has it";
  const auto soup = read_mesh(folder / "car.obj");
  ASSERT_TRUE(soup.ok());
  EXPECT_EQ(soup->material_names, (Names{"paint", "chrome"}));
  ASSERT_TRUE(export_selected(world, all_selected(world), paints, folder / "*.stl").ok());
  EXPECT_TRUE(std::filesystem::exists(folder / "car.stl"));
}

TEST(ExportPieces, writes_all_pieces_to_a_single_file_of_formats_that_hold_them) {
  const test::TemporaryFolder folder;
  const World world = world_of({"car", "door left", "car"});
  const PieceMap all = all_selected(world);
  for (const char* const ending : {"glb", "gltf", "3mf"}) {
    const std::string file = std::string("pieces.") + ending;
    const auto written = export_selected(world, all, {}, folder / (std::string("*.") + ending), true);
    ASSERT_TRUE(written.ok()) << written.error().message;
    EXPECT_EQ(names(written->files), Names(3, (folder / file).string()));
    const auto soup = read_mesh(folder / file);
    ASSERT_TRUE(soup.ok()) << soup.error().message;
    EXPECT_EQ(soup->triangles.size(), 3 * test::grid(2, 1).triangles.size());
    EXPECT_EQ(soup->material_names, (Names{"paint", "chrome"})) << ending;
    Names parts;
    for (const MeshPart& part : soup->parts) parts.push_back(part.name);
    EXPECT_EQ(parts, (Names{"car", "door-left", "car-2"})) << ending;
  }
  const auto apart = export_selected(world, all, {}, folder / "*.obj", true);
  ASSERT_TRUE(apart.ok()) << "OBJ has a file for each piece";
  EXPECT_EQ(apart->files.size(), 3u);
  EXPECT_TRUE(std::filesystem::exists(folder / "car-2.obj"));
}

TEST(ExportPieces, reports_single_precision_loss_far_from_the_origin) {
  const test::TemporaryFolder folder;
  World world;
  world.add(make_body("far", test::build(test::moved(test::grid(2, 0.7), {4.5e5, 0, 5.4e6}, 1))));
  const auto near_middle = export_selected(world, all_selected(world), {}, folder / "*.glb");
  ASSERT_TRUE(near_middle.ok()) << near_middle.error().message;
  EXPECT_FALSE(near_middle->note) << *near_middle->note;
  const auto written = export_selected(world, all_selected(world), {}, folder / "*.stl");
  ASSERT_TRUE(written.ok()) << written.error().message;
  ASSERT_TRUE(written->note);
  EXPECT_NE(written->note->find("single precision"), std::string::npos) << *written->note;
}

TEST(ExportPieces, rejects_unknown_extensions_and_an_empty_selection) {
  const test::TemporaryFolder folder;
  const World world = world_of({"car"});
  EXPECT_FALSE(export_selected(world, all_selected(world), {}, folder / "car.txt").ok());
  EXPECT_FALSE(export_selected(world, {}, {}, folder / "car.obj").ok());
  EXPECT_TRUE(std::filesystem::is_empty(folder / "."));
}

}  // namespace
}  // namespace kerf
