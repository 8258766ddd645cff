#include "app/pieces_folder.h"

#include <algorithm>
#include <cstdio>
#include <optional>

#include "app/progress_line.h"
#include "core/base/atomic_file.h"
#include "core/base/parallel.h"
#include "core/cut/stopwatch.h"
#include "core/mesh/write_mesh.h"

namespace kerf {

namespace {

struct Part {
  Extract extract;
  const Body* body = nullptr;
};

// The pieces of a world, largest area first. They are copied on several threads.
std::vector<Part> parts_of(const World& world, bool split_all) {
  struct Group {
    const Body* body;
    std::vector<FaceId> faces;
  };
  std::vector<Group> groups;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    for (auto& faces : faces_by_piece(body, split_all)) groups.push_back({&body, std::move(faces)});
  }
  std::vector<Part> parts(groups.size());
  for_each_range(groups.size(), 1, [&](size_t i, size_t) {
    parts[i] = {extract_faces(*groups[i].body, groups[i].faces), groups[i].body};
  });
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Part& a, const Part& b) { return a.extract.area > b.extract.area; });
  return parts;
}

bool any_has_moved(const World& world) {
  return std::ranges::any_of(world.ids(), [&](BodyId id) { return world.body(id).motion != Motion{}; });
}

// Whether nothing moves the body any more. What is pinned, or has no mass, never moves.
bool rests(const Body& body, const MassProperties& mass) {
  return body.motion.asleep || body.pinned || !(mass.mass > 0);
}

Result<WrittenPiece> write_piece(const Part& part, size_t number, const PiecesFolder& folder, bool moved) {
  char name[40];
  std::snprintf(name, sizeof name, "piece-%04zu.%s", number, folder.format.c_str());
  const Extract& e = part.extract;
  const auto file = std::filesystem::path(folder.path) / name;
  const std::string stem = file.stem().string();
  const MeshView view{e.positions, e.triangles, e.materials, part.body->material_names, {}, stem, e.colours};
  if (const auto s = write_mesh(view, file, *mesh_format(folder.format)); !s) return s.error();
  WrittenPiece piece;
  piece.file = name;
  piece.faces = e.triangles.size();
  piece.vertices = e.positions.size();
  piece.boundary_edges = e.boundary_edges;
  piece.area = e.area;
  piece.centroid = e.centroid;
  piece.volume = e.volume;
  piece.mass = mass_of(e, part.body->sheet);
  piece.placement = part.body->placement;
  if (moved) piece.asleep = rests(*part.body, piece.mass);
  return piece;
}

// Writes several pieces at a time.
Result<std::vector<WrittenPiece>> write_pieces(const World& world, const PiecesFolder& folder) {
  const std::vector<Part> parts = parts_of(world, folder.split_all);
  const bool moved = any_has_moved(world);
  std::vector<std::optional<Result<WrittenPiece>>> results(parts.size());
  ProgressLine line("writing");
  const Progress progress = line.progress();
  for_each_range(parts.size(), 1, &progress,
                 [&](size_t i, size_t) { results[i] = write_piece(parts[i], i, folder, moved); });
  std::vector<WrittenPiece> written;
  for (const auto& result : results) {
    if (result && !*result) return result->error();
    if (result) written.push_back(**result);
  }
  if (written.size() == parts.size()) return written;
  return failed("stopped; of " + std::to_string(parts.size()) + " pieces " + std::to_string(written.size()) +
                " are written, and no report");
}

}  // namespace

Status PiecesFolder::make() const {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) return failed(path + ": the folder cannot be made: " + error.message());
  return Done{};
}

Result<std::vector<WrittenPiece>> PiecesFolder::write(CutJob& job, const World& world,
                                                      const CutSettings& settings) const {
  auto written = [&] {
    const Stopwatch watch(job.save_s);
    return write_pieces(world, *this);
  }();
  if (!written) return written.error();
  nlohmann::ordered_json how = settings_json(settings, format, split_all);
  if (solid) how["solid"] = true;
  const auto report = cut_report(job, world, how, *written);
  const auto file = std::filesystem::path(path) / "report.json";
  if (const auto s = write_file_atomically(file, report.dump(2) + "\n"); !s) return s.error();
  return written;
}

}  // namespace kerf
