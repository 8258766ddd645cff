#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <tuple>
#include <unordered_map>

#include "core/base/random.h"
#include "core/document/extract.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/remesh/remeshed.h"
#include "core/world/world.h"
#include "tests/bench/sections.h"
#include "tests/bench/timing.h"
#include "tests/support/openmesh_simplify.h"

namespace kerf::bench {

namespace {

namespace fs = std::filesystem;

constexpr double kFlatBar = 1.5;         // time per face, relative to the smallest mesh
constexpr double kMaxToSimplify = 10;    // seconds, for 1.1 million faces
constexpr size_t kMaxForPeer = 300'000;  // faces of meshes that OpenMesh simplifies, too

class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& ending)
      : path(fs::temp_directory_path() / ("kerf-bench-" + std::to_string(getpid()) + ending)) {}
  ~TemporaryFile() {
    std::error_code ignored;
    fs::remove(path, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const fs::path path;
};

std::vector<char> bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Reads a file as fast as the system gives it.
size_t read_through(const fs::path& file) {
  const auto size = static_cast<size_t>(fs::file_size(file));
  const auto buffer = std::make_unique_for_overwrite<char[]>(size);
  std::ifstream in(file, std::ios::binary);
  in.read(buffer.get(), static_cast<std::streamsize>(size));
  return static_cast<size_t>(in.gcount());
}

Body loaded_body(const fs::path& file) {
  auto built = load_mesh(file, nullptr);
  return make_body("mesh", std::move(*built));
}

std::vector<FaceId> all_faces(const Mesh& mesh) {
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_live(FaceId(f))) faces.push_back(FaceId(f));
  }
  return faces;
}

void save(const Body& body, const fs::path& file, MeshFormat format) {
  const Extract e = extract_faces(body, all_faces(body.mesh));
  if (!write_mesh({e.positions, e.triangles, e.materials, body.material_names}, file, format)) std::abort();
}

// Random keys, one a face, as a builder that orders faces along a curve would sort them.
std::vector<uint64_t> random_keys(size_t count) {
  Random random(1);
  std::vector<uint64_t> keys(count);
  for (uint64_t& key : keys) key = random.below(UINT64_MAX);
  return keys;
}

void load_rows(const Subject& s, const fs::path& file, int times, const Report& report) {
  const Pair load = in_turn(
      times, [&] { std::ignore = load_mesh(file, nullptr); }, [&] { std::ignore = read_through(file); },
      passed_seconds);
  report(
      {"load PLY / reading its bytes", s.name, "ms", load.ours * kMilli, load.peer * kMilli, std::nullopt});
  const std::vector<uint64_t> keys = random_keys(s.mesh.live_faces());
  const auto sort = [&] {
    std::vector<uint64_t> sorted = keys;
    std::sort(sorted.begin(), sorted.end());
  };
  const Pair tree = in_turn(
      times, [&] { const AabbTree built(s.mesh); }, sort, passed_seconds);
  report(
      {"tree / sorting one key a face", s.name, "ms", tree.ours * kMilli, tree.peer * kMilli, std::nullopt});
}

void save_row(const Subject& s, const Body& body, MeshFormat format, const std::string& name, int times,
              const Report& report) {
  const TemporaryFile file("." + name), copy("." + name + ".copy");
  save(body, file.path, format);
  const std::vector<char> bytes = bytes_of(file.path);
  std::vector<char> copied(bytes.size());
  const Pair saved = in_turn(
      times, [&] { save(body, file.path, format); },
      [&] { std::memcpy(copied.data(), bytes.data(), bytes.size()); }, passed_seconds);
  report({"save " + name + ", flushed / memcpy of it", s.name, "ms", saved.ours * kMilli, saved.peer * kMilli,
          std::nullopt});
}

// Every triangle in four, with one new position an edge.
Soup split_in_four(const Soup& soup) {
  Soup fine;
  fine.positions = soup.positions;
  std::unordered_map<uint64_t, uint32_t> middles;  // looked up, never walked
  const auto middle = [&](uint32_t a, uint32_t b) {
    const auto key = uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    const auto [at, is_new] = middles.try_emplace(key, static_cast<uint32_t>(fine.positions.size()));
    if (is_new) fine.positions.push_back(0.5 * soup.positions[a] + 0.5 * soup.positions[b]);
    return at->second;
  };
  for (const auto& [a, b, c] : soup.triangles) {
    const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const Soup::Triangle& t : {Soup::Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      fine.triangles.push_back(t);
  }
  return fine;
}

Soup soup_of(const Mesh& mesh) {
  Soup soup;
  for (uint32_t v = 0; v < mesh.vertex_slots(); ++v) soup.positions.push_back(mesh.position(VertexId(v)));
  for (const FaceId f : all_faces(mesh)) {
    const auto c = mesh.corners(f);
    soup.triangles.push_back({c[0].index, c[1].index, c[2].index});
  }
  return soup;
}

// Nanoseconds a face from the soup to the written file.
double whole_per_face(const Soup& soup, int times) {
  const TemporaryFile in(".ply"), out(".obj");
  if (!write_mesh({soup.positions, soup.triangles, {}, {}}, in.path, MeshFormat::kPly)) std::abort();
  std::vector<double> seconds;
  for (int i = 0; i < times; ++i)
    seconds.push_back(
        seconds_of([&] { save(loaded_body(in.path), out.path, MeshFormat::kObj); }, passed_seconds));
  return median(seconds) * kNano / static_cast<double>(soup.triangles.size());
}

// The cost of a face on meshes of four, 16 and 64 times as many faces.
void flat_rows(const Subject& s, int times, const Report& report) {
  Soup soup = soup_of(s.mesh);
  const double first = whole_per_face(soup, times);
  for (int splits = 1; splits <= 3; ++splits) {
    soup = split_in_four(soup);
    report({"load, tree and save a face, split in " + std::to_string(1 << 2 * splits) + " / whole", s.name,
            "ns", whole_per_face(soup, times), first, kFlatBar});
  }
}

// Processor time of one thread, to 7,000 faces; on the largest mesh OpenMesh takes half a minute or more.
void simplify_row(const Subject& s, const Report& report) {
  const SimplifyTarget target{.faces = std::min<size_t>(7000, s.mesh.live_faces() / 4)};
  const double ours = seconds_of([&] { std::ignore = simplify(s.mesh, target, {}, nullptr); });
  if (s.mesh.live_faces() > kMaxForPeer)
    return report({"simplify to 7,000 faces / limit", s.name, "s", ours, kMaxToSimplify, 1});
  const double theirs = seconds_of([&] { std::ignore = simplify_by_openmesh(s.mesh, target, {}, nullptr); });
  report({"simplify to 7,000 faces / OpenMesh", s.name, "s", ours, theirs, std::nullopt});
}

}  // namespace

void bench_files(const Subject& s, const Effort& effort, const Report& report) {
  const TemporaryFile file(".ply");
  const Soup soup = soup_of(s.mesh);
  if (!write_mesh({soup.positions, soup.triangles, {}, {}}, file.path, MeshFormat::kPly)) std::abort();
  const int times = effort.build_times;
  load_rows(s, file.path, times, report);
  const Body body = loaded_body(file.path);
  save_row(s, body, MeshFormat::kObj, "obj", times, report);
  save_row(s, body, MeshFormat::kPly, "ply", times, report);
  simplify_row(s, report);
  if (s.name == "bunny" || s.name == "tiny") flat_rows(s, times, report);
}

}  // namespace kerf::bench
