#include "core/mesh/mesh_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <csignal>
#include <new>
#include <tuple>

#include "core/base/platform.h"
#include "core/base/random.h"
#include "core/mesh/files/encode.h"
#include "core/mesh/files/readers.h"
#include "tests/core/mesh/files/sample_files.h"

namespace kerf {
namespace {

struct RandomMesh {
  std::vector<Vec3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<uint16_t> materials;
  std::vector<std::string> names{"steel", "blue paint", "glass"};

  MeshView view() const { return {positions, triangles, materials, names}; }
};

// An arbitrary finite double: random bits.
double any_double(Random& random) {
  for (;;) {
    const double x = std::bit_cast<double>(random.bits());
    if (std::isfinite(x)) return x;
  }
}

RandomMesh random_mesh(Random& random) {
  RandomMesh mesh;
  const uint64_t vertices = 3 + random.below(40), triangles = 3 + random.below(60);
  for (uint64_t i = 0; i < vertices; ++i) {
    mesh.positions.push_back({any_double(random), random.uniform(-1, 1), i % 2 ? -0.0 : 1e6 + random.unit()});
  }
  const auto corner = [&] { return static_cast<uint32_t>(random.below(vertices)); };
  for (uint64_t i = 0; i < triangles; ++i) {
    mesh.triangles.push_back({corner(), corner(), corner()});
    mesh.materials.push_back(static_cast<uint16_t>(i < 3 ? i : random.below(3)));
  }
  return mesh;
}

bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Vec3& p, const Vec3& q) {
    return std::bit_cast<std::array<uint64_t, 3>>(p) == std::bit_cast<std::array<uint64_t, 3>>(q);
  });
}

TEST(WriteMesh, round_trips_bit_for_bit) {
  const test::TemporaryFolder folder;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const RandomMesh mesh = random_mesh(random);
    for (const MeshFormat format : {MeshFormat::kObj, MeshFormat::kOff, MeshFormat::kPly}) {
      const auto path = folder / ("mesh." + std::string(format_row(format).ending));
      ASSERT_TRUE(write_mesh(mesh.view(), path, format));
      const Result<Soup> soup = read_mesh(path);
      ASSERT_TRUE(soup) << soup.error().message;
      EXPECT_TRUE(same_bits(soup->positions, mesh.positions))
          << format_row(format).ending << ", seed " << seed;
      EXPECT_EQ(soup->triangles, mesh.triangles) << format_row(format).ending << ", seed " << seed;
      EXPECT_TRUE(soup->warnings.empty());
      if (format != MeshFormat::kObj) continue;
      EXPECT_EQ(soup->materials, mesh.materials) << "seed " << seed;
      EXPECT_EQ(soup->material_names, mesh.names) << "seed " << seed;
    }
  }
}

TEST(WriteMesh, references_the_mtl_file_of_an_obj_and_describes_every_material) {
  Random random(16);
  const RandomMesh mesh = random_mesh(random);
  MeshView view = mesh.view();
  view.mtl = "part one.mtl";
  const std::string obj = encoded(view, MeshFormat::kObj);
  EXPECT_TRUE(obj.starts_with("mtllib part one.mtl\nv "));
  const Result<Soup> soup = read_obj(obj, "part.obj", nullptr);
  ASSERT_TRUE(soup);
  EXPECT_TRUE(soup->warnings.empty());
  EXPECT_EQ(soup->material_names, mesh.names);
  const std::vector<MaterialLook> looks{{"steel", {0.5, 0.25, 1}, 0}, {"", {0, 0, 0.1}, 1}};
  EXPECT_EQ(encode_mtl(looks),
            "newmtl steel\nKd 0.5 0.25 1\nKs 0 0 0\nNs 0\nd 1\nillum 2\n"
            "newmtl default\nKd 0 0 0.1\nKs 0.5 0.5 0.5\nNs 1000\nd 1\nillum 2\n");
}

TEST(WriteMesh, writes_stl_to_the_precision_of_float) {
  const test::TemporaryFolder folder;
  const std::vector<Vec3> positions{{0.1, 0, 0}, {1e10, 0, 0}, {0, 1e-30, 0.3}};
  const std::vector<std::array<uint32_t, 3>> triangles{{0, 1, 2}, {2, 1, 0}};
  ASSERT_TRUE(write_mesh({positions, triangles, {}, {}}, folder / "t.stl", MeshFormat::kStl));
  const Result<Soup> soup = read_mesh(folder / "t.stl");
  ASSERT_TRUE(soup);
  for (uint32_t i = 0; i < 6; ++i) {
    const Vec3& expected = positions[triangles[i / 3][i % 3]];
    for (int k = 0; k < 3; ++k) EXPECT_EQ(soup->positions[i][k], double{static_cast<float>(expected[k])});
  }
}

TEST(WriteMesh, rejects_stl_beyond_the_range_of_float) {
  const test::TemporaryFolder folder;
  const std::vector<Vec3> positions{{1e39, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::array<uint32_t, 3>> triangles{{0, 1, 2}};
  const Status status = write_mesh({positions, triangles, {}, {}}, folder / "t.stl", MeshFormat::kStl);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kFailed);
  EXPECT_FALSE(std::filesystem::exists(folder / "t.stl"));
}

TEST(WriteMesh, finds_formats_by_name) {
  EXPECT_EQ(mesh_format("obj"), MeshFormat::kObj);
  EXPECT_EQ(mesh_format(".STL"), MeshFormat::kStl);
  EXPECT_EQ(mesh_format("om"), std::nullopt);
  EXPECT_EQ(mesh_format(""), std::nullopt);
}

size_t files_in(const std::filesystem::path& folder) {
  return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(WriteFileAtomically, replaces_a_file_and_keeps_its_permissions) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a", "old");
  std::filesystem::permissions(folder / "a", std::filesystem::perms(0640));
  ASSERT_TRUE(write_file_atomically(folder / "a", "new"));
  EXPECT_EQ(test::read_text(folder / "a"), "new");
  EXPECT_EQ(std::filesystem::status(folder / "a").permissions(), std::filesystem::perms(0640));
  EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(WriteFileAtomically, writes_through_a_symlink) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a", "old");
  std::filesystem::create_symlink("a", folder / "link");
  ASSERT_TRUE(write_file_atomically(folder / "link", "new"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(test::read_text(folder / "a"), "new");
}

TEST(WriteFileAtomically, reports_a_full_device_in_one_sentence) {
  const Status status = write_file_atomically("/dev/full", "bytes");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kFailed);
  EXPECT_EQ(status.error().message, "cannot write /dev/full: No space left on device.");
}

// A limit on the size of files simulates a full disk: the write fails half-way.
TEST(WriteFileAtomically, keeps_the_old_file_when_the_disk_is_full) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a", "old");
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit tiny{4096, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tiny), 0);
  const Status status = write_file_atomically(folder / "a", std::string(100'000, 'x'));
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(status);
  EXPECT_EQ(test::read_text(folder / "a"), "old");
  EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(WriteFileAtomically, writes_chunks_in_order) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_file_atomically(folder / "a", [](const ByteSink& sink) {
    for (const char* part : {"one, ", "", "two, ", "three"}) EXPECT_TRUE(sink(part));
  }));
  EXPECT_EQ(test::read_text(folder / "a"), "one, two, three");
  EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(WriteFileAtomically, stops_the_chunk_source_on_failure) {
  int parts = 0;
  const Status status = write_file_atomically("/dev/full", [&](const ByteSink& sink) {
    while (++parts < 10 && sink("bytes")) {
    }
  });
  EXPECT_EQ(parts, 1);
  EXPECT_FALSE(status);
}

TEST(WriteFileAtomically, keeps_the_old_file_if_the_source_throws) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a", "old");
  const auto produce = [](const ByteSink& sink) {
    sink("new");
    throw std::bad_alloc();
  };
  EXPECT_THROW(std::ignore = write_file_atomically(folder / "a", produce), std::bad_alloc);
  EXPECT_EQ(test::read_text(folder / "a"), "old");
  EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(WriteFileAtomically, fails_if_the_path_is_not_writable) {
  const test::TemporaryFolder folder;
  for (const auto& path :
       {folder / "missing/a", folder.path(), folder.path() / "", std::filesystem::path()}) {
    const Status status = write_file_atomically(path, "bytes");
    ASSERT_FALSE(status) << path;
    EXPECT_EQ(status.error().message.find('\n'), std::string::npos);
  }
  if (::geteuid() == 0) GTEST_SKIP() << "root may write into read-only folders";
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0500));
  EXPECT_FALSE(write_file_atomically(folder / "a", "bytes"));
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0700));
}

}  // namespace
}  // namespace kerf
