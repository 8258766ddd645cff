#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "core/kerf.h"
#include "tests/api/sheets.h"

namespace kerf::test {
namespace {

// Returns the object of the report that a key begins, such as "removed".
std::string in_report(const World& world, const std::string& key) {
  const std::string report = world.report();
  const size_t at = report.find("\"" + key + "\"");
  return at == std::string::npos ? "" : report.substr(at, report.find('}', at) - at);
}

Stroke across(double x) {
  Stroke stroke = through_the_middle();
  for (kerf_keyframe& key : stroke.keys) key.origin[0] = x;
  return stroke;
}

TEST(History, a_cancelled_cut_keeps_what_was_undone) {
  World world;
  world.add(sheet(10));
  world.cut(across(0.3));
  const std::string cut = world.hash();
  EXPECT_TRUE(world.undo());
  const std::string whole = world.hash();
  (void)world.take_changes();
  EXPECT_THROW(world.cut(across(0.7), {}, {[](double) { return false; }, 0}), Cancelled);
  EXPECT_EQ(world.hash(), whole);
  EXPECT_TRUE(world.take_changes().everything);
  EXPECT_TRUE(world.redo());
  EXPECT_EQ(world.hash(), cut);
  EXPECT_FALSE(world.redo());
  EXPECT_GT(world.cut(across(0.7)).removed_faces, 0u);
}

TEST(History, a_cut_is_cancelled_at_any_point) {
  World world;
  world.add(sheet(10));
  Stroke wide = across(0.3), other = across(0.7);
  wide.radius = other.radius = 0.05;
  world.cut(wide);
  const std::string cut = world.hash();
  EXPECT_TRUE(world.undo());
  const std::string whole = world.hash();
  CutSettings settings;
  settings.material = "copper";
  int allowed = 0;
  for (bool cancelled = true; cancelled; ++allowed) {
    int left = allowed;
    try {
      world.cut(other, settings, {[&](double) { return left-- > 0; }, 0});
      cancelled = false;
    } catch (const Cancelled&) {
      ASSERT_EQ(world.hash(), whole) << allowed;
      ASSERT_TRUE(world.redo()) << allowed;
      ASSERT_EQ(world.hash(), cut) << allowed;
      ASSERT_TRUE(world.undo()) << allowed;
    }
  }
  EXPECT_GT(allowed, 3);
}

TEST(History, a_cut_without_an_effect_keeps_what_was_undone) {
  World world;
  world.add(sheet(10));
  const std::string none = in_report(world, "removed");
  world.cut(across(0.3));
  const std::string cut = world.hash(), one = in_report(world, "removed");
  EXPECT_TRUE(world.undo());
  world.cut(std::vector<Stroke>{});
  EXPECT_EQ(in_report(world, "removed"), none);
  EXPECT_TRUE(world.redo());
  EXPECT_EQ(world.hash(), cut);
  EXPECT_EQ(in_report(world, "removed"), one);
}

TEST(History, undo_restores_the_totals_of_the_report) {
  World world;
  world.add(sheet(10));
  const std::string none = in_report(world, "removed");
  world.cut(across(0.3));
  const std::string one = in_report(world, "removed");
  EXPECT_NE(one, none);
  EXPECT_TRUE(world.undo());
  EXPECT_EQ(in_report(world, "removed"), none);
  world.simulate(0);  // appends no step
  EXPECT_TRUE(world.redo());
  EXPECT_EQ(in_report(world, "removed"), one);

  const std::string file = testing::TempDir() + "kerf-history.kerf";
  world.save_journal(file);
  World opened(file);
  const std::string as_opened = in_report(opened, "removed");
  opened.cut(across(0.7));
  EXPECT_NE(in_report(opened, "removed"), as_opened);
  EXPECT_TRUE(opened.undo() && opened.undo());
  EXPECT_EQ(in_report(opened, "removed"), as_opened);
}

TEST(History, undo_and_redo_restore_the_strokes_that_hit_nothing) {
  World world;
  world.add(sheet(10));
  const auto missed = [&] {
    const std::string report = world.report();
    const size_t at = report.find("\"missed\"");
    return report.substr(at, report.find(']', at) - at);
  };
  const std::string none = missed();
  world.cut(across(5));
  const std::string first = missed();
  EXPECT_NE(first, none);
  world.cut(across(0.3));
  world.cut(across(5));
  const std::string first_and_third = missed();
  EXPECT_NE(first_and_third, first);
  EXPECT_TRUE(world.undo());
  EXPECT_EQ(missed(), first);
  EXPECT_TRUE(world.undo() && world.undo());
  EXPECT_EQ(missed(), none);
  EXPECT_TRUE(world.redo() && world.redo() && world.redo());
  EXPECT_EQ(missed(), first_and_third);
  EXPECT_TRUE(world.undo());
  world.cut(across(0.7));  // instead of the third
  EXPECT_EQ(missed(), first);
  EXPECT_TRUE(world.undo() && world.redo());
  EXPECT_EQ(missed(), first);
}

TEST(History, strokes_that_hit_nothing_need_memory_in_proportion_to_their_number) {
  const auto used = [] {
    const auto info = ::mallinfo2();
    return info.uordblks + info.hblkhd;
  };
  const auto bytes = [&](int strokes) {
    World world;
    world.add(sheet(1));
    Stroke beside = across(5);
    beside.radius = 1;
    const size_t before = used();
    for (int i = 0; i < strokes; ++i) world.cut(beside);
    return used() - before;
  };
  const size_t half = bytes(2000), whole = bytes(4000);
  EXPECT_LE(2 * whole, 5 * half);
}

TEST(History, undo_restores_the_size_from_which_defaults_follow) {
  const auto hash_of_default = [](World& world) {
    Stroke stroke = across(0.5);
    stroke.radius = 0;
    world.cut(stroke);
    return world.hash();
  };
  World plain;
  plain.add(sheet(10));
  World other;
  other.add(sheet(10));
  BodyDesc far;
  far.position[0] = 50;
  other.add(sheet(1), far);
  EXPECT_TRUE(other.undo());
  EXPECT_EQ(hash_of_default(other), hash_of_default(plain));

  World late;
  late.add(sheet(10));
  late.cut(across(0.2));
  late.add(sheet(1), far);
  const std::string file = testing::TempDir() + "kerf-late.kerf";
  late.save_journal(file);
  World opened(file);
  EXPECT_EQ(hash_of_default(opened), hash_of_default(late));

  World falling;
  BodyDesc fixed;
  fixed.is_fixed = true;
  falling.add(sheet(10), fixed);
  falling.cut(across(0.2));
  falling.add(sheet(1), far);
  falling.simulate(1);
  falling.save_journal(file);
  World fallen(file);
  EXPECT_EQ(hash_of_default(fallen), hash_of_default(falling)) << "the added sheet has fallen";
  World undone(file);
  while (undone.undo()) {
  }
  World first;
  first.add(sheet(10), fixed);
  EXPECT_TRUE(undone.redo());
  EXPECT_EQ(hash_of_default(undone), hash_of_default(first)) << "the second sheet is not there yet";
  World empty;
  empty.add(sheet(1));
  EXPECT_TRUE(empty.undo());
  EXPECT_THROW(empty.cut(across(0.5)), InvalidArgument);
}

TEST(History, undo_of_the_strokes_of_a_scene_keeps_its_size_and_totals) {
  const std::string mesh = testing::TempDir() + "kerf-cut.obj", scene = testing::TempDir() + "kerf-cut.json";
  sheet(10).write(mesh);
  std::ofstream(scene) << R"({"bodies": [{"mesh": "kerf-cut.obj"}], "strokes": [{
    "laser": {"radius": 0.01, "range": [0, 2]},
    "keys": [{"t": 0, "origin": [0.3, 1, -0.1], "direction": [0, -1, 0]},
             {"t": 1, "origin": [0.3, 1, 1.1], "direction": [0, -1, 0]}]}]})";
  World world(scene);
  const std::string none = in_report(world, "removed");
  EXPECT_EQ(world.pieces().size(), 2u);
  EXPECT_TRUE(world.undo());
  EXPECT_FALSE(world.undo());
  world.cut(across(0.7));
  EXPECT_NE(in_report(world, "removed"), none);
  EXPECT_TRUE(world.undo());
  EXPECT_EQ(in_report(world, "removed"), none);
}

TEST(History, opening_a_scene_of_several_strokes_reports_progress_that_never_decreases) {
  const std::string mesh = testing::TempDir() + "kerf-two.obj", scene = testing::TempDir() + "kerf-two.json";
  sheet(10).write(mesh);
  std::ofstream file(scene);
  file << R"({"bodies": [{"mesh": "kerf-two.obj"}], "strokes": [)";
  for (const double x : {0.3, 0.7}) {
    file << (x < 0.5 ? "" : ", ") << R"({"laser": {"radius": 0.01, "range": [0, 2]}, "keys": [)";
    for (int i = 0; i <= 200; ++i) {
      file << (i > 0 ? ", " : "") << R"({"t": )" << i << R"(, "origin": [)" << x << ", 1, "
           << -0.1 + 1.2 * i / 200 << R"(], "direction": [0, -1, 0]})";
    }
    file << "]}";
  }
  file << "]}";
  file.close();
  std::vector<double> shares;
  const World world(scene, {[&](double share) {
                              shares.push_back(share);
                              return true;
                            },
                            0});
  EXPECT_EQ(world.pieces().size(), 3u);
  EXPECT_GT(shares.size(), 4u);
  EXPECT_TRUE(std::ranges::is_sorted(shares));
}

TEST(History, opening_a_journal_is_cancelled_at_any_point) {
  World world;
  world.add(sheet(10));
  world.cut_plane({1, 0, 0}, 0.51);
  const std::string file = testing::TempDir() + "kerf-cancelled.kerf";
  world.save_journal(file);
  int allowed = 0;
  for (bool cancelled = true; cancelled; ++allowed) {
    int left = allowed;
    try {
      const World opened(file, {[&](double) { return left-- > 0; }, 0});
      cancelled = false;
      EXPECT_EQ(opened.hash(), world.hash()) << allowed;
    } catch (const Cancelled&) {
    }
  }
  EXPECT_GT(allowed, 2);
}

TEST(History, saving_an_opened_world_again_keeps_the_meshes_of_its_journal) {
  World world;
  world.add(sheet(10));
  world.cut(across(0.3));
  world.add(sheet(3));
  const std::string file = testing::TempDir() + "kerf-again.kerf";
  world.save_journal(file);
  World opened(file);
  opened.add(sheet(5));
  const std::string hash = opened.hash();
  for (int i = 0; i < 2; ++i) {
    opened.save_journal(file);
    EXPECT_EQ(World(file).hash(), hash);
  }
}

TEST(History, a_journal_does_not_open_with_another_mesh_than_its_world) {
  const std::string mesh = testing::TempDir() + "kerf-replaced.obj",
                    file = testing::TempDir() + "kerf-replaced.kerf";
  sheet(10).write(mesh);
  World world(mesh);
  world.cut(through_the_middle());
  world.pieces()[0].write(mesh);
  world.save_journal(file);
  EXPECT_THROW(World{file}, InvalidArgument);
  sheet(10).write(mesh);
  EXPECT_EQ(World(file).hash(), world.hash());
}

TEST(History, an_environment_set_before_the_first_mesh_is_kept_in_a_journal) {
  World world;
  world.set_environment({0, -1.62, 0}, 0.0);
  BodyDesc desc;
  desc.position[1] = 1;
  world.add(sheet(2), desc);
  const std::string file = testing::TempDir() + "kerf-moon.kerf";
  world.save_journal(file);
  World opened(file);
  world.simulate(0.1);
  opened.simulate(0.1);
  EXPECT_EQ(opened.hash(), world.hash());
  World late;
  late.simulate(0.1);
  late.add(sheet(2));
  try {
    late.save_journal(file);
    ADD_FAILURE() << "saved a journal whose scene has no body";
  } catch (const InvalidArgument& fault) {
    EXPECT_NE(std::string(fault.what()).find("simulated before its first mesh"), std::string::npos)
        << fault.what();
  }
}

TEST(History, a_journal_with_a_stroke_redone_after_a_stop_is_saved_completely) {
  World world;
  world.add(sheet(10));
  world.cut(across(0.3));
  world.cut(across(0.7));
  const std::string file = testing::TempDir() + "kerf-stopped.kerf";
  world.save_journal(file);
  std::ofstream(file, std::ios::app) << R"({"do":"undo"})" << '\n'
                                     << R"({"do":"stop-stroke","moves":1.5})" << '\n'
                                     << R"({"do":"redo"})" << '\n';
  World opened(file);
  EXPECT_EQ(opened.pieces().size(), 2u) << "the first stroke ends in the sheet, the second crosses it";
  for (const double x : {0.5, 0.9}) {
    opened.save_journal(file);
    EXPECT_EQ(World(file).hash(), opened.hash());
    opened.cut(across(x));
  }
  opened.save_journal(file);
  EXPECT_EQ(World(file).hash(), opened.hash());
}

TEST(History, a_damaged_journal_is_refused_and_an_incomplete_last_line_ignored) {
  World world;
  world.add(sheet(10));
  world.cut(across(0.3));
  const std::string file = testing::TempDir() + "kerf-damaged.kerf";
  world.save_journal(file);
  std::ifstream in(file);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  std::ofstream(file) << text << R"({"do":"un)";
  EXPECT_EQ(World(file).hash(), world.hash());
  const size_t second_line = text.find('\n') + 1;
  std::ofstream(file) << text.substr(0, second_line) << R"({"do":"explode"})" << '\n'
                      << text.substr(second_line);
  try {
    const World opened(file);
    ADD_FAILURE() << "opened with " << opened.pieces().size() << " pieces";
  } catch (const InvalidArgument& fault) {
    EXPECT_NE(std::string(fault.what()).find("kerf-damaged.kerf: line 2: "), std::string::npos)
        << fault.what();
  }
}

TEST(History, undo_restores_the_rest_of_a_tick) {
  World world;
  BodyDesc fixed;
  fixed.is_fixed = true;
  world.add(sheet(10), fixed);
  world.cut(across(0.5));
  world.simulate(0.0125);  // a tick and a half
  const std::string fallen = world.hash();
  EXPECT_TRUE(world.undo());
  world.simulate(0.0125);
  EXPECT_EQ(world.hash(), fallen);
}

TEST(History, pieces_that_a_new_material_detaches_are_cut_with_their_body) {
  World world;
  const BodyId body = world.add(sheet(10));
  world.cut(across(0.5));
  Stroke along = through_the_middle();
  along.keys = {{0, {-1, 1, 0.5}, {0, -1, 0}}, {1, {2, 1, 0.5}, {0, -1, 0}}};
  CutSettings settings;
  settings.bodies = {body};
  settings.material = "copper";
  world.cut(along, settings);
  EXPECT_EQ(world.pieces().size(), 4u);
}

TEST(History, placing_a_falling_piece_where_it_is_stops_it) {
  World world;
  const BodyId body = world.add(sheet(2));
  world.simulate(0.1);
  const kerf_body_info info = world.info(body);
  ASSERT_LT(info.velocity[1], 0);
  world.move(body, 0, {info.position[0], info.position[1], info.position[2]},
             {info.orientation[0], info.orientation[1], info.orientation[2], info.orientation[3]});
  EXPECT_EQ(world.info(body).velocity[1], 0);
}

TEST(History, numbers_beyond_doubles_are_refused) {
  World world;
  world.add(sheet(2));
  EXPECT_THROW(world.cut_plane({1e-200, 0, 0}, 1e150), InvalidArgument);
  Stroke stroke = through_the_middle();
  stroke.keys[0].time = -1e308;
  stroke.keys[1].time = 1e308;
  EXPECT_THROW(world.cut(stroke), InvalidArgument);
  Stroke begun = stroke;
  begun.keys.pop_back();
  world.begin_stroke(begun);
  kerf_keyframe key = stroke.keys[0];
  key.time = 0;
  key.origin[0] = 0.1;
  world.add_pose(key);
  key.time = 1e308;
  key.origin[0] = 0.2;
  EXPECT_THROW(world.add_pose(key), InvalidArgument);
  world.cancel_stroke();
}

TEST(History, boxes_find_faces_that_lie_in_one_of_their_sides) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> hundredths(-100, 100);
  for (int i = 0; i < 1000; ++i) {
    const double z = 0.01 * hundredths(random), other = z + 0.01 * (1 + std::abs(hundredths(random)));
    World world;
    world.add(Mesh(std::vector<double>{0, 0, z, 1, 0, z, 0, 1, z}, std::vector<uint32_t>{0, 1, 2}));
    ASSERT_EQ(world.faces_in_box({-0.1, -0.1, z}, {0.1, 0.1, other}).faces.size(), 1u) << z << ' ' << other;
    const double below = z - (other - z);
    ASSERT_EQ(world.faces_in_box({-0.1, -0.1, below}, {0.1, 0.1, z}).faces.size(), 1u) << z << ' ' << below;
  }
}

TEST(History, the_centroid_of_a_distant_mesh_keeps_its_digits) {
  constexpr double kFar = 4194304;  // m; a unit in the last place is 1e-9
  const Mesh near = sheet(30);
  std::vector<double> vertices(near.vertices().begin(), near.vertices().end());
  for (double& x : vertices) x += kFar;
  const Mesh far(vertices, {near.faces().begin(), near.faces().end()});
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(far.info().centroid[k], kFar + (k == 1 ? 0 : 0.5), 1.5e-9);
}

}  // namespace
}  // namespace kerf::test
