#include <gtest/gtest.h>

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <string>

#include "core/kerf.h"
#include "tests/api/sheets.h"

namespace {

// Marks memory of this program, as an engine with an allocator of its own may.
constexpr size_t kMark = 0x6b657266, kMarkBytes = 16;

void free_marked(void* memory) {
  if (memory == nullptr) return;
  char* whole = static_cast<char*>(memory) - kMarkBytes;
  size_t mark = 0;
  std::memcpy(&mark, whole, sizeof mark);
  if (mark != kMark) std::abort();
  std::free(whole);
}

}  // namespace

// The library must use these, or neither of them: all tests of this program check it.
void* operator new(size_t bytes, const std::nothrow_t&) noexcept {
  auto* whole = static_cast<char*>(std::malloc(bytes + kMarkBytes));
  if (whole == nullptr) return nullptr;
  std::memcpy(whole, &kMark, sizeof kMark);
  return whole + kMarkBytes;
}
void* operator new(size_t bytes) {
  void* memory = operator new(bytes, std::nothrow);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept { free_marked(memory); }
void operator delete(void* memory, size_t) noexcept { free_marked(memory); }

namespace kerf::test {
namespace {

bool are_equal(const Mesh& a, const Mesh& b) {
  return std::ranges::equal(a.vertices(), b.vertices()) && std::ranges::equal(a.faces(), b.faces());
}

TEST(Memory, buffers_of_every_layout_hold_a_mesh) {
  const Mesh mesh = sheet(4);  // whose coordinates are floats
  const size_t vertices = mesh.vertices().size() / 3, faces = mesh.faces().size() / 3;
  for (int variant = 0; variant < 16; ++variant) {
    kerf_layout layout = KERF_LAYOUT_INIT;
    layout.is_float = variant & 1;
    layout.is_16_bit = variant >> 1 & 1;
    const size_t position = layout.is_float ? 12 : 24, face = layout.is_16_bit ? 6 : 12;
    if (variant & 4) layout.vertex_stride = position + 5;
    if (variant & 8) layout.face_stride = face + 3;
    const size_t row = variant & 4 ? position + 5 : position, line = variant & 8 ? face + 3 : face;
    std::string positions(vertices * row, 'x'), indices(faces * line, 'x');
    mesh.copy_to(layout, positions.data(), indices.data());
    EXPECT_EQ(positions.substr(position, 5) == "xxxxx", (variant & 4) != 0);
    EXPECT_TRUE(
        are_equal(Mesh::from_buffers(positions.data(), vertices, indices.data(), faces, layout), mesh));
    mesh.copy_to(layout, nullptr, nullptr);
  }
  kerf_layout layout = KERF_LAYOUT_INIT;
  layout.vertex_stride = 23;
  const auto& [v, f] = std::pair(mesh.vertices(), mesh.faces());
  EXPECT_THROW(Mesh::from_buffers(v.data(), vertices, f.data(), faces, layout), InvalidArgument);
  layout = KERF_LAYOUT_INIT;
  layout.is_16_bit = 1;
  std::vector<uint16_t> shorts(6 * 256 * 256);
  EXPECT_THROW(sheet(256).copy_to(layout, nullptr, shorts.data()), InvalidArgument);
  shorts = {0, 1, 25};
  EXPECT_THROW(Mesh::from_buffers(v.data(), vertices, shorts.data(), 1, layout), InvalidArgument);
  layout.is_float = 1;
  const float bad[] = {0, 0, 0, 1, 0, NAN, 1, 1, 1};
  shorts = {0, 1, 2};
  EXPECT_THROW(Mesh::from_buffers(bad, 3, shorts.data(), 1, layout), InvalidArgument);
}

TEST(Memory, bytes_of_each_format_are_those_of_a_file) {
  const Mesh mesh = box(3);
  for (const std::string format : {"obj", "ply", "stl", "off", "glb", "gltf", "3mf"}) {
    SCOPED_TRACE(format);
    const std::string bytes = mesh.encode(format), file = testing::TempDir() + "kerf-memory." + format;
    mesh.write(file);
    std::ifstream in(file, std::ios::binary);
    EXPECT_EQ(bytes, std::string(std::istreambuf_iterator<char>(in), {}));
    EXPECT_TRUE(are_equal(Mesh::decode(bytes), Mesh::read(file)));
    EXPECT_TRUE(are_equal(Mesh::decode(bytes, format), Mesh::read(file)));
    std::filesystem::remove(file);
    for (const size_t kept : {size_t{0}, size_t{1}, bytes.size() / 2})
      EXPECT_THROW(Mesh::decode(std::span(bytes).first(kept), format), InvalidArgument) << kept;
  }
  EXPECT_THROW((void)mesh.encode("fbx"), InvalidArgument);
  EXPECT_THROW(Mesh::decode(mesh.encode("obj"), "fbx"), InvalidArgument);
  const std::vector<double> far{1e39, 0, 0, 1e39, 1, 0, 1e39, 0, 1};
  EXPECT_THROW((void)Mesh(far, std::vector<uint32_t>{0, 1, 2}).encode("stl"), Error);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // whose shadow memory needs more
// Returns the error of opening a file in this much address space; "" if it is opened.
std::string error_of_opening(const std::string& file, rlim_t bytes) {
  rlimit limit{};
  ::getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = std::min(limit.rlim_max, bytes);
  ::setrlimit(RLIMIT_AS, &limit);
  try {
    CallOptions options;
    options.threads = 1;
    const World world(file, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Memory, strokes_of_a_scene_beyond_the_memory_fail_like_those_of_the_command_line) {
  const std::string mesh = testing::TempDir() + "kerf-budget.obj",
                    scene = testing::TempDir() + "kerf-budget.json";
  sheet(1).write(mesh);
  std::ofstream(scene) << R"({"bodies": [{"mesh": "kerf-budget.obj"}], "strokes": [{
    "laser": {"radius": 0.00003, "range": [0, 2]},
    "keys": [{"t": 0, "origin": [0.5, 1, -0.1], "direction": [0, -1, 0]},
             {"t": 1, "origin": [0.5, 1, 1.1], "direction": [0, -1, 0]}]}]})";
  // A process of its own, without the threads and the memory of other tests.
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        std::fputs(error_of_opening(scene, 400'000'000).c_str(), stderr);
        std::exit(0);
      },
      testing::ExitedWithCode(0), "use a coarser resolution");
}
#endif

TEST(Memory, warnings_of_reading_are_values) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 nan 0\nf 1 2 3\nf 1 2 2\nf 1 2 4\nf 1 2 9\nf 1 2\nl 1 2\n";
  const std::vector<std::string> warnings = Mesh::decode(text).warnings();
  ASSERT_EQ(warnings.size(), 5u);
  EXPECT_EQ(warnings[0], "1 triangle refers to a missing vertex and was dropped.");
  EXPECT_EQ(warnings[1], "1 triangle has a corner that is not a finite number and was dropped.");
  EXPECT_EQ(warnings[2], "1 triangle has two corners at the same position and was dropped.");
  EXPECT_EQ(warnings[3], "1 face has fewer than three corners and was dropped.");
  EXPECT_TRUE(sheet(1).warnings().empty());
}

}  // namespace
}  // namespace kerf::test
