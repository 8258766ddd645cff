#include <gtest/gtest.h>
#include <unistd.h>
#include <xmmintrin.h>

#include <algorithm>
#include <cfenv>
#include <clocale>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <thread>

#include "core/kerf.h"
#include "tests/api/sheets.h"

namespace kerf::test {
namespace {

std::string hash_of_cut(const kerf::Mesh& mesh, unsigned threads = 0) {
  kerf::World world;
  world.add(mesh, "sheet", {{}, threads});
  world.cut(through_the_middle(), {}, {{}, threads});
  return world.hash();
}

TEST(Api, cutting_a_sheet_in_two_gives_pieces_of_the_expected_mass) {
  kerf::World world;
  world.add(sheet(20), "sheet");
  const kerf::CutResult cut = world.cut(through_the_middle(), {.rim = KERF_RIM_SMOOTH});
  EXPECT_NEAR(cut.removed_area, 0.02, 1e-9);
  const std::vector<kerf::Mesh> pieces = world.pieces();
  ASSERT_EQ(pieces.size(), 2u);
  for (const kerf::Mesh& piece : pieces) {
    EXPECT_NEAR(piece.area(), 0.49, 1e-9);
    EXPECT_NEAR(piece.info().mass, 0.49 * 0.001 * 7850, 1e-6);
    EXPECT_NEAR(piece.info().centroid[2], 0.5, 1e-9);
  }
  EXPECT_EQ(pieces[0].name(), "sheet");
  EXPECT_NE(pieces[1].name(), "sheet");
}

TEST(Api, a_world_saved_as_a_scene_reopens) {
  kerf::World world;
  world.add(sheet(20), "sheet");
  world.cut(through_the_middle());
  const std::string folder = testing::TempDir() + "kerf-face-scene";
  world.save_scene(folder);
  const kerf::World again(folder + "/scene.json");
  double area = 0;
  for (const kerf::Mesh& piece : again.pieces()) area += piece.area();
  EXPECT_NEAR(area, world.pieces()[0].area() + world.pieces()[1].area(), 1e-12);
  EXPECT_THROW(world.save_scene("/proc/no-such/folder"), kerf::Error);
}

TEST(Api, a_saved_journal_reproduces_the_state_and_the_report_balances) {
  kerf::World world;
  world.add(sheet(20), "sheet");
  world.add(kerf::Mesh(std::vector<double>{0, 0.5, 0, 1, 0.5, 0, 1, 0.5, 1}, std::vector<uint32_t>{0, 1, 2}),
            "above");
  world.cut(through_the_middle());
  kerf::CutSettings copper;
  copper.material = "copper";
  const std::string file = testing::TempDir() + "kerf-face-journal.kerf";
  world.save_journal(file);
  EXPECT_EQ(kerf::World(file).hash(), world.hash());
  kerf::World opened(file);
  opened.cut(through_the_middle());
  opened.save_journal(file);
  EXPECT_EQ(kerf::World(file).hash(), opened.hash());
  const std::string report = world.report();
  for (const char* key : {"\"input\"", "\"removed\"", "\"pieces\"", "\"state_hash\"", "\"timing_ms\""})
    EXPECT_NE(report.find(key), std::string::npos) << key;
  EXPECT_NE(report.find(world.hash()), std::string::npos);
  world.cut(through_the_middle(), copper);
  world.add(sheet(3), "later");
  world.cut(through_the_middle());
  world.save_journal(file);
  EXPECT_EQ(kerf::World(file).hash(), world.hash());
  EXPECT_THROW(opened.save_journal("/proc/no-such/journal.kerf"), kerf::Error);
  const std::filesystem::path folder = testing::TempDir() + "kerf-face-no-journal";
  std::filesystem::create_directories(folder);
  std::filesystem::create_directories(folder / "folder.kerf");
  for (const char* name : {"", "folder.kerf"}) {
    EXPECT_THROW(opened.save_journal((folder / name).string()), kerf::InvalidArgument);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1) << name;
  }
  EXPECT_THROW(opened.save_journal(""), kerf::InvalidArgument);
  EXPECT_THROW(opened.save_journal("/dev/null"), kerf::InvalidArgument);
}

TEST(Api, the_material_of_the_first_cut_is_stored_in_the_journal) {
  kerf::World world;
  world.add(sheet(20), "sheet");
  kerf::CutSettings copper;
  copper.material = "copper";
  world.cut(through_the_middle(), copper);
  world.cut(through_the_middle(), copper);
  const std::string file = testing::TempDir() + "kerf-face-copper.kerf";
  world.save_journal(file);
  kerf::World again(file);
  EXPECT_EQ(again.hash(), world.hash());
  EXPECT_EQ(again.pieces()[0].info().mass, world.pieces()[0].info().mass);
}

TEST(Api, rays_hit_the_sheet_and_miss_the_slot) {
  kerf::World world;
  world.add(sheet(20));
  world.cut(through_the_middle());
  const std::vector<double> from{0.25, 1, 0.3, 0.5, 1, 0.3, 0.75, -2, 0.3},
      along{0, -2, 0, 0, -1, 0, 0, 1, 0};
  const kerf::Hits first = world.nearest_hits(from, along);
  EXPECT_EQ(first.distances[0], 1);
  EXPECT_EQ(first.distances[1], std::numeric_limits<double>::infinity());
  EXPECT_EQ(first.faces[1], 0xffffffffu);
  EXPECT_EQ(first.distances[2], 2);
  EXPECT_EQ(world.nearest_hits(from, along, {0, 1.5}).bodies,
            (std::vector<kerf::BodyId>{first.bodies[0], KERF_NO_BODY, KERF_NO_BODY}));
  const kerf::Hits all = world.all_hits(from, along);
  EXPECT_EQ(all.offsets, (std::vector<size_t>{0, 1, 1, 2}));
  EXPECT_EQ(all.distances, (std::vector<double>{1, 2}));
}

TEST(Api, rays_from_any_distance_terminate) {
  kerf::World world;
  world.add(sheet(4));
  kerf::Stroke hole = through_the_middle();
  hole.keys = {{0, {0.9, 1, 0.9}, {0, -1, 0}}};
  world.cut(hole);
  const double max = std::numeric_limits<double>::max();
  for (const double far : {1e18, 1e40, 1e150, 1e200, 1e300, max}) {
    for (const double sign : {-1.0, 1.0}) {
      const std::vector<double> from{sign * far, 1, 0.3, 0.3, sign * far, 0.3, 0.3, 1, sign * far},
          along{0, -1, 0, 0, -sign, 0, 0, 0, -sign};
      const kerf::Hits nearest = world.nearest_hits(from, along), all = world.all_hits(from, along);
      EXPECT_EQ(nearest.distances[0], std::numeric_limits<double>::infinity()) << far;
      EXPECT_EQ(nearest.distances[2], std::numeric_limits<double>::infinity()) << far;
      EXPECT_EQ(all.offsets[1], 0u) << far;
    }
  }
}

TEST(Api, results_do_not_depend_on_threads_locale_or_rounding_mode) {
  const kerf::Mesh mesh = sheet(20);
  const std::string wanted = hash_of_cut(mesh);
  for (const unsigned threads : {1u, 2u, 5u}) EXPECT_EQ(hash_of_cut(mesh, threads), wanted);
  const unsigned before = _mm_getcsr();
  std::fesetround(FE_UPWARD);
  _mm_setcsr(_mm_getcsr() | 0x8040);  // flush to zero, take denormals for zero, as -ffast-math has it
  const unsigned set = _mm_getcsr();
  EXPECT_EQ(hash_of_cut(mesh), wanted);
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
  EXPECT_EQ(_mm_getcsr() & 0xe040u, set & 0xe040u);
  std::fesetround(FE_TONEAREST);
  _mm_setcsr(before);
  const std::string locale = std::setlocale(LC_ALL, nullptr);
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr) {
    EXPECT_EQ(hash_of_cut(mesh), wanted);
  }
  std::setlocale(LC_ALL, locale.c_str());
}

TEST(Api, a_cancelled_or_failed_cut_changes_nothing) {
  kerf::World world;
  world.add(sheet(2));
  std::string before = world.hash();
  kerf::Stroke wide = through_the_middle(), drill = wide;
  wide.radius = 0.03;
  drill.keys = {{0, {0.9, 1, 0.9}, {0, -1, 0}}};
  const std::vector<kerf::Stroke> both{wide, drill};
  int calls = 0;
  for (int wanted = 0;; ++wanted) {  // stopped within and between steps
    calls = 0;
    try {
      world.cut(both, {}, {[&](double) { return calls++ < wanted; }, 0});
      break;
    } catch (const kerf::Cancelled&) {
      ASSERT_EQ(world.hash(), before) << "stopped at call " << wanted;
    }
  }
  EXPECT_GT(calls, 10);
  world = kerf::World();
  world.add(sheet(20));
  before = world.hash();
  kerf::Stroke bad = through_the_middle();
  bad.keys.back().direction[1] = 0;
  const std::vector<kerf::Stroke> strokes{through_the_middle(), bad};
  EXPECT_THROW(world.cut(strokes), kerf::InvalidArgument);
  EXPECT_EQ(world.hash(), before);
  world.cut(through_the_middle());
  EXPECT_EQ(world.hash(), hash_of_cut(sheet(20)));
}

TEST(Api, exceptions_of_the_progress_callback_propagate) {
  kerf::World world;
  world.add(sheet(20));
  const auto progress = [](double) -> bool { throw std::runtime_error("enough"); };
  try {
    world.cut(through_the_middle(), {}, {progress, 0});
    FAIL();
  } catch (const std::runtime_error& fault) {
    EXPECT_STREQ(fault.what(), "enough");
  }
}

TEST(Api, a_busy_world_reports_it) {
  kerf::World world;
  world.add(sheet(20));
  std::string message;
  world.cut(through_the_middle(), {},
            {[&](double) {
               if (message.empty()) {
                 std::thread([&] {
                   try {
                     world.hash();
                   } catch (const kerf::Busy& fault) {
                     message = fault.what();
                   }
                 }).join();
               }
               return true;
             },
             0});
  EXPECT_NE(message.find("in use"), std::string::npos) << message;
}

// What the functions that read a world say of it, as one text.
std::string read_all(const kerf::World& world, const std::string& folder) {
  const std::vector<double> from{0.25, 1, 0.3, 0.75, -2, 0.3}, along{0, -2, 0, 0, 1, 0};
  std::string all = world.hash() + world.graph();
  for (const kerf::Mesh& piece : world.pieces()) all += piece.name() + std::to_string(piece.area());
  for (const double d : world.nearest_hits(from, along).distances) all += std::to_string(d);
  for (const double d : world.all_hits(from, along).distances) all += std::to_string(d);
  const std::string report = world.report();
  world.save_scene(folder);
  world.save_journal(folder + "/world.kerf");
  return all + report.substr(report.find("\"pieces\""));
}

TEST(Api, several_threads_read_one_world_concurrently) {
  kerf::World world;
  world.add(sheet(20));
  world.cut(through_the_middle());
  const std::string folder = testing::TempDir() + "kerf-face-readers";
  const std::string wanted = read_all(world, folder);
  std::vector<std::string> read(4);
  std::vector<std::thread> threads;
  for (size_t t = 0; t < read.size(); ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 5; ++i) {
        try {
          read[t] = read_all(world, folder + std::to_string(t));
        } catch (const kerf::Error& fault) {
          read[t] = fault.what();
        }
        if (read[t] != wanted) return;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::string& text : read) EXPECT_EQ(text, wanted);
}

TEST(Api, a_world_being_read_rejects_changes) {
  kerf::World world;
  world.add(sheet(60));
  const std::string hash = world.hash();
  int reports = 0;
  (void)world.pieces({[&](double) {
                        ++reports;
                        EXPECT_EQ(world.hash(), hash);
                        EXPECT_THROW(world.add(sheet(1)), kerf::Busy);
                        EXPECT_THROW(world.cut(through_the_middle()), kerf::Busy);
                        return true;
                      },
                      0});
  EXPECT_GT(reports, 0);
  world.cut(through_the_middle());
  EXPECT_NE(world.hash(), hash);
}

TEST(Api, an_empty_or_zero_size_world_reports_an_error) {
  kerf::World empty;
  const std::string before = empty.hash();
  EXPECT_THROW(empty.cut(kerf::Stroke{{{0, {0, 1, 0}, {0, -1, 0}}}}), kerf::InvalidArgument);
  EXPECT_THROW(empty.cut(through_the_middle()), kerf::InvalidArgument);
  EXPECT_THROW(empty.save_scene(testing::TempDir() + "kerf-face-empty"), kerf::InvalidArgument);
  EXPECT_THROW(empty.save_journal(testing::TempDir() + "kerf-face-empty.kerf"), kerf::InvalidArgument);
  EXPECT_EQ(empty.hash(), before);
  EXPECT_EQ(empty.cut(std::span<const kerf::Stroke>{}).removed_faces, 0u);
  kerf::World emptied;
  emptied.remove(emptied.add(sheet(2)), 0);
  EXPECT_THROW(emptied.cut(through_the_middle()), kerf::InvalidArgument);
  emptied.undo();
  EXPECT_GT(emptied.cut(through_the_middle()).removed_faces, 0u);
  kerf::World small;
  small.add(
      kerf::Mesh(std::vector<double>{0, 0, 0, 1e-200, 0, 0, 0, 0, 1e-200}, std::vector<uint32_t>{0, 1, 2}));
  EXPECT_THROW(small.cut(kerf::Stroke{{{0, {0, 1, 0}, {0, -1, 0}}}}), kerf::InvalidArgument);
}

TEST(Api, stroke_defaults_derive_from_the_loaded_meshes) {
  kerf::Stroke all = through_the_middle();
  all.radius = 3;
  kerf::World world, twice;
  world.add(sheet(2));
  world.cut(all);
  EXPECT_TRUE(world.pieces().empty());
  EXPECT_THROW(world.save_scene(testing::TempDir() + "kerf-face-empty"), kerf::InvalidArgument);
  EXPECT_EQ(world.cut(kerf::Stroke{through_the_middle().keys}).removed_faces, 0u);
  // Strokes that are cut one by one are those that are cut together.
  kerf::Stroke half = through_the_middle();
  half.keys.front().origin[0] = half.keys.back().origin[0] = 1;
  half.radius = 0.6;
  const std::vector<kerf::Stroke> both{half, kerf::Stroke{through_the_middle().keys}};
  kerf::World one_by_one;
  one_by_one.add(sheet(2));
  for (const kerf::Stroke& stroke : both) one_by_one.cut(stroke);
  twice.add(sheet(2));
  twice.cut(both);
  EXPECT_EQ(one_by_one.hash(), twice.hash());
}

TEST(Api, invalid_arguments_report_an_error) {
  const auto expect_error = [](auto call, const char* word) {
    try {
      call();
      ADD_FAILURE() << "taken: " << word;
    } catch (const kerf::InvalidArgument& fault) {
      EXPECT_NE(std::string(fault.what()).find(word), std::string::npos) << fault.what();
    }
  };
  const std::vector<double> square{0, 0, 0, 1, 0, 0, 1, 1, 0};
  const std::vector<uint32_t> face{0, 1, 2};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_error([&] { kerf::Mesh({}, face); }, "vertices");
  expect_error([&] { kerf::Mesh(square, {}); }, "faces");
  expect_error([&] { kerf::Mesh(square, std::vector<uint32_t>{0, 1, 3}); }, "references vertex 3");
  expect_error([&] { kerf::Mesh(std::vector<double>{0, nan, 0}, face); }, "not finite");
  expect_error([&] { kerf::Mesh::read("no-such.obj"); }, "no-such.obj");
  expect_error([&] { kerf::Mesh(square, face).write("a.xyz"); }, ".obj");
  expect_error([&] { kerf::World("no-such.kerf"); }, "no-such.kerf");
  kerf::World world;
  world.add(kerf::Mesh(square, face));
  const auto cut = [&](auto change) {
    return [&world, change] {
      kerf::Stroke stroke = through_the_middle();
      kerf::CutSettings settings;
      change(stroke, settings);
      world.cut(stroke, settings);
    };
  };
  expect_error(cut([](auto& s, auto&) { s.keys.clear(); }), "no key");
  expect_error(cut([](auto& s, auto&) { s.keys[1].time = -1; }), "time");
  expect_error(cut([](auto& s, auto&) { s.keys[1].direction[1] = 3; }), "opposite");
  expect_error(cut([&](auto& s, auto&) { s.keys[0].origin[0] = nan; }), "finite");
  expect_error(cut([](auto& s, auto&) { s.radius = -1; }), "radius");
  expect_error(cut([](auto& s, auto&) { s.range = {2, 1}; }), "range");
  expect_error(cut([](auto&, auto& c) { c.target_edge = 0; }), "target_edge");
  expect_error(cut([](auto&, auto& c) { c.target_edge = 1, c.max_level = 1; }), "set only one");
  expect_error(cut([](auto&, auto& c) { c.max_level = 99; }), "max_level: must be from 0 to 24");
  expect_error(cut([](auto&, auto& c) { c.max_level = std::numeric_limits<int>::max(); }), "max_level");
  expect_error(cut([](auto&, auto& c) { c.material = "cheese"; }), "mild-steel");
  expect_error([&] { (void)world.nearest_hits(square, std::vector<double>(9, 0)); }, "directions");
  expect_error([&] { world.cut(through_the_middle(), {}, {{}, 5000}); }, "1024");
  expect_error([&] { world.add(kerf::Mesh(square, face), "\xff"); }, "UTF-8");
  EXPECT_EQ(kerf_world_hash(nullptr, nullptr), KERF_INVALID_ARGUMENT);
  EXPECT_EQ(kerf_mesh_vertex_count(nullptr), 0u);
}

TEST(Api, header_has_the_version_of_the_library) {
  EXPECT_EQ(std::to_string(KERF_VERSION / 10000) + "." + std::to_string(KERF_VERSION / 100 % 100) + "." +
                std::to_string(KERF_VERSION % 100),
            kerf_version());
}

TEST(Api, a_smaller_struct_gets_the_defaults_and_a_larger_one_is_an_error) {
  kerf::World world;
  world.add(sheet(10));
  const std::vector<kerf_keyframe> keys = through_the_middle().keys;
  kerf_stroke stroke = KERF_STROKE_INIT;
  stroke.keys = keys.data();
  stroke.key_count = keys.size();
  stroke.radius = 0.01;
  stroke.duty = -1;
  const auto cut = [&](size_t size) {
    stroke.size = size;
    return kerf_world_cut(world.get(), &stroke, 1, nullptr, nullptr, nullptr);
  };
  EXPECT_EQ(cut(sizeof stroke), KERF_INVALID_ARGUMENT);  // the duty
  EXPECT_EQ(cut(sizeof stroke + 8), KERF_INVALID_ARGUMENT);
  EXPECT_EQ(cut(0), KERF_INVALID_ARGUMENT);
  EXPECT_EQ(cut(offsetof(kerf_stroke, duty)), KERF_OK);
  kerf_cut_result result = KERF_CUT_RESULT_INIT;
  result.size = offsetof(kerf_cut_result, removed_area);
  result.removed_area = result.seconds = 7;
  EXPECT_EQ(kerf_world_cut(world.get(), nullptr, 0, nullptr, nullptr, &result), KERF_OK);
  EXPECT_EQ(result.removed_faces, 0u);
  EXPECT_EQ(result.seconds, 7);
}

TEST(Api, a_power_of_zero_heats_nothing) {
  kerf::World world;
  world.add(sheet(10));
  kerf::Stroke stroke = through_the_middle();
  stroke.power = 0;
  EXPECT_EQ(world.cut(stroke, {.model = KERF_MODEL_THERMAL}).removed_faces, 0u);
  EXPECT_NEAR(world.pieces()[0].face_temperatures()[0], 293, 1e-9);
}

TEST(Api, thermal_cuts_accept_a_material) {
  kerf::World world;
  world.add(sheet(10));
  kerf::Stroke stroke = through_the_middle();
  stroke.power = 4000;
  stroke.keys[1].time = 300;
  world.cut(stroke, {.model = KERF_MODEL_THERMAL, .material = "pmma"});
  const std::vector<kerf::Mesh> pieces = world.pieces();
  EXPECT_GT(pieces.size(), 1u);
  const std::span<const double> warm = pieces[0].face_temperatures();
  ASSERT_EQ(warm.size(), pieces[0].faces().size() / 3);
  EXPECT_GE(*std::min_element(warm.begin(), warm.end()), 293);
  EXPECT_GT(*std::max_element(warm.begin(), warm.end()), 300);
  EXPECT_LT(*std::max_element(warm.begin(), warm.end()), 2000);
  EXPECT_TRUE(sheet(2).face_temperatures().empty());
}

// Returns true if the middle of a face lies in the triangle with material "a", where x > z.
bool uses_a(const kerf::Mesh& mesh, size_t face) {
  double side = 0;
  for (size_t i = 0; i < 3; ++i) {
    const double* p = mesh.vertices().data() + 3 * mesh.faces()[3 * face + i];
    side += p[0] - p[2];
  }
  return side > 0;
}

TEST(Api, attributes_and_materials_survive_cuts) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("kerf_attributes_" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  const std::string file = folder / "plate.obj";
  std::ofstream(file)
      << "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nvt 0 0\nvt 3 0\nvt 3 1\nvt 0 1\nvn 0 -1 0\n"
         "usemtl a\nf 1/1/1 2/2/1 3/3/1\nf 1/1/1 1/1/1 2/2/1\nusemtl b\nf 1/1/1 3/3/1 4/4/1\n";
  const kerf::Mesh plate = kerf::Mesh::read(file);
  EXPECT_EQ(plate.material_names(), (std::vector<std::string>{"a", "b"}));
  kerf::World world;
  world.add(plate, "plate");
  kerf::Stroke stroke{.keys = {{0, {0.5, 1, -1}, {0, -1, 0}}, {1, {0.5, 1, 2}, {0, -1, 0}}}};
  stroke.radius = 0.05;
  world.cut(stroke, {.target_edge = 0.1});
  const std::vector<kerf::Mesh> pieces = world.pieces();
  EXPECT_EQ(pieces.size(), 2u);
  pieces[0].write(folder / "piece.glb");
  std::vector<kerf::Mesh> meshes{plate, kerf::Mesh::read(folder / "piece.glb")};
  meshes.insert(meshes.end(), pieces.begin(), pieces.end());
  for (const kerf::Mesh& mesh : meshes) {
    const auto attributes = mesh.attributes();
    ASSERT_EQ(attributes.size(), 2u);
    const kerf::Mesh::Attribute &uv = attributes[0], &normal = attributes[1];
    EXPECT_EQ(uv.name, "TEXCOORD_0");
    EXPECT_EQ(normal.name, "NORMAL");
    ASSERT_EQ(uv.size, 2u);
    ASSERT_EQ(normal.size, 3u);
    for (size_t c = 0; c < mesh.faces().size(); ++c) {
      const double* p = mesh.vertices().data() + 3 * mesh.faces()[c];
      EXPECT_NEAR(uv.values[2 * c], 3 * p[0], 1e-5);
      EXPECT_NEAR(uv.values[2 * c + 1], 1 - p[2], 1e-5);
      EXPECT_EQ(normal.values[3 * c + 1], -1);
      EXPECT_EQ(mesh.material_names()[mesh.face_materials()[c / 3]], uses_a(mesh, c / 3) ? "a" : "b");
    }
  }
  float value = 0;
  EXPECT_EQ(kerf_mesh_get_attribute(plate.get(), 2, &value), KERF_INVALID_ARGUMENT);
  EXPECT_EQ(kerf_mesh_attribute_name(plate.get(), 2), nullptr);
  EXPECT_EQ(kerf_mesh_attribute_size(plate.get(), 2), 0u);
  EXPECT_EQ(kerf_mesh_material_name(plate.get(), 2), nullptr);
  EXPECT_EQ(kerf_mesh_attribute_count(nullptr), 0u);
  EXPECT_TRUE(sheet(2).attributes().empty());
  EXPECT_TRUE(sheet(2).face_materials().empty());
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace kerf::test
