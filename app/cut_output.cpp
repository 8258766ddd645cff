#include "app/cut_output.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>

#include "app/arguments.h"
#include "app/console.h"
#include "app/run_description.h"
#include "core/base/number_format.h"
#include "core/base/parallel.h"
#include "core/base/platform.h"
#include "core/cut/stopwatch.h"
#include "core/document/lost_looks.h"
#include "core/document/npz_file.h"
#include "core/document/piece_looks.h"
#include "core/document/piece_outline.h"
#include "core/document/save.h"
#include "core/document/surface_files.h"
#include "core/document/text/json.h"
#include "core/mesh/files/surface_conversion.h"
#include "core/mesh/looks.h"
#include "core/mesh/mesh_file.h"
#include "core/physics/convex_hull.h"
#include "core/world/body_mass.h"
#include "ui/window/number_text.h"

namespace kerf {

std::string cut_summary(const CutJob& job, size_t strokes, size_t planes, size_t pieces,
                        const std::string& folder) {
  const auto count = [](size_t number, const char* noun) {
    return grouped(number) + " " + noun + (number == 1 ? "" : "s");
  };
  std::string text;
  if (strokes == 0) {
    text = planes > 0 ? "cut along " + count(planes, "plane") : "no strokes given";
  } else if (job.removed_faces == 0 && job.thermal && job.statistics.met_s > 0) {
    text = count(strokes, "stroke") + " removed nothing: the beam reached only " +
           std::to_string(std::lround(100 * job.depth_fraction())) + " % of the thickness";
  } else if (job.removed_faces == 0) {
    text = count(strokes, "stroke") + (job.missed.size() < strokes ? " removed nothing" : " hit nothing");
  } else {
    text = count(strokes, "stroke") + " removed " + count(job.removed_faces, "face") + " (" +
           area_text(job.removed_area) + ")";
  }
  return text + "; " + count(pieces, "piece") + " and report.json are in " + folder;
}

std::string missed_text(const CutJob& job, const std::string& file) {
  constexpr size_t kMaxNamed = 8;
  const size_t count = job.missed.size(), named = count > kMaxNamed ? kMaxNamed - 1 : count;
  std::string text = file + ": ";
  for (size_t i = 0; i < named; ++i) {
    if (i > 0) text += i + 1 == count ? " and " : ", ";
    text += "/strokes/" + std::to_string(job.missed[i]);
  }
  if (named < count) text += " and " + std::to_string(count - named) + " more";
  return text + " hit nothing: no mesh is in the path of the beam";
}

namespace {

namespace fs = std::filesystem;

constexpr const char* kReport = "report.json";
const std::string kAllPieces = "pieces";  // name of a single file

// Returns true for the name of a file of pieces, piece-NNNN.EXTENSION or pieces.EXTENSION.
bool is_piece_name(std::string_view name) {
  constexpr std::string_view kStem = "piece-";
  for (const char* const ending : {".glb", ".gltf", ".3mf"}) {
    if (name == kAllPieces + ending) return true;
  }
  if (!name.starts_with(kStem)) return false;
  name.remove_prefix(kStem.size());
  const auto is_digit = [](char c) { return '0' <= c && c <= '9'; };
  const auto is_letter = [&](char c) { return ('a' <= c && c <= 'z') || is_digit(c); };
  const size_t digits =
      static_cast<size_t>(std::find_if_not(name.begin(), name.end(), is_digit) - name.begin());
  if (digits < 4 || digits + 1 >= name.size() || name[digits] != '.') return false;
  return std::all_of(name.begin() + static_cast<std::ptrdiff_t>(digits) + 1, name.end(), is_letter);
}

// Returns true for the name of a piece or report that a killed run had not finished, such as
// .piece-0000.obj.4711-0.tmp (see AtomicFile).
bool is_unfinished(std::string_view name) {
  if (!name.starts_with('.') || !name.ends_with(".tmp")) return false;
  name = name.substr(1, name.rfind('.') - 1);
  name = name.substr(0, name.rfind('.'));
  return name == kReport || is_piece_name(name);
}

// Returns the pieces that a report lists; none if it cannot be read.
std::set<std::string> listed_pieces(const fs::path& report) {
  std::set<std::string> names;
  const auto text = read_text_file(report);
  if (!text) return names;
  const auto json = parse_json(*text, report.string());
  if (!json || !json->is_object() || !json->contains("pieces")) return names;
  for (const nlohmann::json& piece : (*json)["pieces"]) {
    for (const char* const key : {"file", "outline"}) {
      if (!piece.is_object() || !piece.contains(key) || !piece[key].is_string()) continue;
      const auto name = piece[key].get<std::string>();
      if (is_piece_name(name)) names.insert(name);
    }
  }
  return names;
}

// Results of earlier runs in the folder, while a new one is written.
class EarlierResult {
 public:
  explicit EarlierResult(const fs::path& folder)
      : folder_(folder), report_(folder / kReport), kept_(previous_version(report_)) {
    pieces_ = listed_pieces(kept_);  // left by a failed run
    pieces_.merge(listed_pieces(report_));
  }

  const std::set<std::string>& pieces() const { return pieces_; }

  // Removes what killed runs left unfinished, and renames the earlier report.
  Status begin() const {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
      if (is_unfinished(entry.path().filename().string())) fs::remove(entry.path(), error);
    }
    if (!fs::exists(report_, error)) return Done{};
    fs::rename(report_, kept_, error);
    if (error) return failed("cannot replace " + report_.string() + ": " + error.message());
    return Done{};
  }

  // Removes the pieces of an incomplete result, except those that replaced earlier ones, which the kept
  // report lists for the next run.
  void remove_new(const std::vector<WrittenPiece>& written) const {
    std::error_code error;
    for (const WrittenPiece& piece : written) {
      for (const std::string& name : {piece.file, piece.outline}) {
        if (!name.empty() && !pieces_.contains(name)) fs::remove(folder_ / name, error);
      }
    }
  }

  // Removes earlier pieces that the new result lacks.
  void remove_all_but(const std::vector<WrittenPiece>& written) {
    for (const WrittenPiece& piece : written) {
      pieces_.erase(piece.file);
      pieces_.erase(piece.outline);
    }
    std::error_code error;
    for (const std::string& name : pieces_) {
      if (!fs::is_directory(folder_ / name, error)) fs::remove(folder_ / name, error);
    }
    fs::remove(kept_, error);
  }

 private:
  fs::path folder_, report_, kept_;
  std::set<std::string> pieces_;
};

struct Part {
  Extract extract;
  const Body* body = nullptr;
  std::vector<FaceId> faces;
  BodyId id{};         // of the body
  std::string source;  // name for the node or object, from its part in the file; empty if that has none
};

// Names parts after their sources in their order: "fender", "fender.001" and so on.
void name_parts(const World& world, std::vector<Part>& parts) {
  std::set<std::string> taken;
  std::map<std::string, size_t> counts;
  for (Part& part : parts) {
    const BodyId from = part.body->loaded_as;
    if (!world.contains(from)) continue;
    const std::string name = part_name_of(*part.body, world.body(from).named_parts, part.faces);
    if (name.empty()) continue;
    size_t& count = counts[name];
    do {
      char ending[24] = "";
      if (count > 0) std::snprintf(ending, sizeof ending, ".%03zu", count);
      part.source = name + ending;
      ++count;
    } while (!taken.insert(part.source).second);
  }
}

// Returns the pieces of a world, largest area first. Copies them on several threads.
std::vector<Part> parts_of(const World& world, bool split_all) {
  struct Group {
    BodyId id;
    const Body* body;
    std::vector<FaceId> faces;
  };
  std::vector<Group> groups;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    for (auto& faces : faces_by_piece(body, split_all)) groups.push_back({id, &body, std::move(faces)});
  }
  std::vector<Part> parts(groups.size());
  for_each_range(groups.size(), 1, [&](size_t i, size_t) {
    parts[i] = {extract_faces(*groups[i].body, groups[i].faces),
                groups[i].body,
                std::move(groups[i].faces),
                groups[i].id,
                {}};
  });
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Part& a, const Part& b) { return a.extract.area > b.extract.area; });
  name_parts(world, parts);
  return parts;
}

bool any_has_moved(const World& world) {
  return std::ranges::any_of(world.ids(), [&](BodyId id) { return world.body(id).motion != Motion{}; });
}

// Returns true if the body is at rest. Bodies that are pinned or have no mass never move.
bool rests(const Body& body, const MassProperties& mass) {
  return body.motion.asleep || body.pinned || !(mass.mass > 0);
}

std::vector<Vec3> seen_from(const Vec3& origin, std::vector<Vec3> positions) {
  if (origin == Vec3(0)) return positions;
  for (Vec3& p : positions) p -= origin;
  return positions;
}

// Origins of the faces of all pieces.
struct Provenance {
  std::vector<int64_t> meshes, faces, pieces;
  std::vector<double> barycentrics;

  void add(const Part& part, int64_t piece, std::span<const uint32_t> order) {
    const std::vector<FaceSource> sources = sources_of(*part.body, part.faces);
    for (size_t i = 0; i < sources.size(); ++i) {
      const FaceSource& source = sources[order.empty() ? i : order[i]];
      meshes.push_back(source.face < 0 ? -1 : int64_t{part.body->loaded_as.slot});
      faces.push_back(source.face);
      pieces.push_back(piece);
      for (const Vec3& weights : source.barycentrics) {
        for (int k = 0; k < 3; ++k) barycentrics.push_back(weights[k]);
      }
    }
  }

  Status write(const std::string& path) const {
    NpzFile file;
    const std::array<size_t, 3> shape{faces.size(), 3, 3};
    const std::span<const size_t> whole(shape), one(shape.data(), 1);
    file.add("source_face", faces, one);
    file.add("source_barycentrics", barycentrics, whole);
    file.add("source_mesh", meshes, one);
    file.add("piece", pieces, one);
    const auto bytes = file.take();
    if (!bytes) return failed(path + ": " + bytes.error().message);
    return write_file_atomically(path, *bytes);
  }
};

// Returns the hull of a piece around its node, thickened if it is a sheet, and its mass properties.
NodeCollider collider_of(const Part& part, const MassProperties& mass, const Vec3& origin,
                         std::string_view node, const std::string& engine) {
  constexpr size_t kMaxVertices = 64;
  const Extract& e = part.extract;
  NodeCollider collider;
  const std::string name(node);
  collider.name = engine == "godot" ? name + "-convcolonly" : "UCX_" + name + "_00";
  ConvexHull hull =
      e.solid
          ? convex_hull(e.positions, kMaxVertices)
          : convex_hull(thickened_sheet(e.positions, e.triangles, part.body->sheet.thickness), kMaxVertices);
  collider.positions = seen_from(origin, std::move(hull.positions));
  collider.triangles = std::move(hull.triangles);
  collider.mass = mass.mass;
  collider.centre_of_mass = mass.centre - origin;
  const glm::dmat3& i = mass.inertia;
  collider.inertia = {i[0][0], i[1][1], i[2][2], i[0][1], i[0][2], i[1][2]};
  return collider;
}

// A piece to be written. The view refers to the other members.
struct PieceFile {
  std::string stem;
  std::vector<Vec3> positions;
  CornerLooks looks;
  NodeCollider collider;
  MeshView view;
  WrittenPiece piece;

  PieceFile(const Part& part, size_t number, const PiecesFolder& folder, const SurfaceFiles& surfaces,
            const Vec3& origin, bool moved) {
    const Extract& e = part.extract;
    const MeshFormat format = *mesh_format(folder.format);
    char name[40];
    std::snprintf(name, sizeof name, "piece-%04zu", number);
    stem = name;
    positions = seen_from(origin, e.positions);
    view = {positions, e.triangles, e.materials, part.body->material_names, {}, stem, e.colours};
    if (format_row(format).uvs_and_normals) {
      const auto normals = is_gltf(format) ? LookNormals::kAll : LookNormals::kSmooth;
      looks = looks_of(*part.body, part.faces, normals);
    }
    if (looks.any()) view.looks = &looks;
    if (part.body->looks) view.surfaces = part.body->looks->surfaces().get();
    if (format == MeshFormat::kObj && !surfaces.mtl_name().empty()) {
      view.mtl = surfaces.mtl_name();
      view.material_names = surfaces.names(*part.body);
    }
    if (!part.source.empty()) view.name = view.object = part.source;
    piece.piece = {part.id, part.faces.empty() ? 0 : part.body->mesh.data(part.faces.front()).piece};
    piece.file = (folder.single_file ? kAllPieces : stem) + "." + folder.format;
    piece.faces = e.triangles.size();
    piece.vertices = e.positions.size();
    piece.boundary_edges = e.boundary_edges;
    piece.area = e.area;
    piece.centroid = e.centroid;
    piece.volume = e.volume;
    piece.mass = mass_of(e, part.body->sheet);
    piece.placement = part.body->placement;
    if (moved) piece.asleep = rests(*part.body, piece.mass);
    if (folder.colliders.empty()) return;
    collider = collider_of(part, piece.mass, origin, view.name, folder.colliders);
    view.collider = &collider;
    piece.no_collider = collider.triangles.empty();
  }
  PieceFile(const PieceFile&) = delete;
  PieceFile& operator=(const PieceFile&) = delete;
};

// Writes the outline of a flat piece and records its file.
Status write_outline(const Part& part, const PiecesFolder& folder, const Vec3& origin, PieceFile& file) {
  if (folder.outlines.empty()) return Done{};
  Extract piece = part.extract;
  piece.positions = seen_from(origin, std::move(piece.positions));
  const auto lines = flat_outline(piece);
  if (!lines) return Done{};
  const std::string name = file.stem + "." + folder.outlines;
  const std::string text = folder.outlines == "svg" ? svg_text(*lines) : dxf_text(*lines);
  const Status written = write_file_atomically(fs::path(folder.path) / name, text);
  if (written) file.piece.outline = name;
  return written;
}

// Writes one file with all pieces.
Status write_single_file(const std::vector<std::unique_ptr<PieceFile>>& pieces, const PiecesFolder& folder,
                         std::vector<WrittenPiece>& written) {
  std::vector<MeshView> views;
  for (const auto& piece : pieces) views.push_back(piece->view);
  const MeshFormat format = *mesh_format(folder.format);
  const std::string name = kAllPieces + "." + folder.format;
  if (const Status s = write_meshes(views, fs::path(folder.path) / name, format); !s) return s;
  for (const auto& file : pieces) {
    file->piece.precision = precision_loss(file->view, format);
    written.push_back(std::move(file->piece));
  }
  return Done{};
}

Status write_provenance(const std::vector<Part>& parts, const PiecesFolder& folder) {
  Provenance provenance;
  for (size_t i = 0; i < parts.size(); ++i) {
    const Extract& e = parts[i].extract;
    std::vector<uint32_t> order;
    if (is_gltf(*mesh_format(folder.format)))
      order = gltf_order({e.positions, e.triangles, e.materials, parts[i].body->material_names});
    provenance.add(parts[i], static_cast<int64_t>(i), order);
  }
  return provenance.write(folder.provenance);
}

// Writes several pieces at a time. Appends them with the names of the files that were written, and notes on
// lost looks. Fails if files are missing.
Status write_pieces(const World& world, const PiecesFolder& folder, const SurfaceFiles& surfaces,
                    const Vec3& origin, std::vector<WrittenPiece>& written, std::vector<std::string>& notes) {
  const std::vector<Part> parts = parts_of(world, folder.split_all);
  const bool moved = any_has_moved(world);
  const MeshFormat format = *mesh_format(folder.format);
  std::vector<std::optional<WrittenPiece>> results(parts.size());
  std::vector<Status> saved(parts.size(), Done{});
  std::vector<std::unique_ptr<PieceFile>> kept(folder.single_file ? parts.size() : 0);
  ProgressLine line("writing");
  const Progress progress = line.progress();
  const bool completed = for_each_range(parts.size(), 1, &progress, [&](size_t i, size_t) {
    auto file = std::make_unique<PieceFile>(parts[i], i, folder, surfaces, origin, moved);
    saved[i] = write_outline(parts[i], folder, origin, *file);
    if (folder.single_file) {
      kept[i] = std::move(file);
      return;
    }
    if (saved[i]) saved[i] = write_mesh(file->view, fs::path(folder.path) / file->piece.file, format);
    if (saved[i]) file->piece.precision = precision_loss(file->view, format);
    if (!saved[i]) file->piece.file.clear();
    results[i] = std::move(file->piece);
  });
  Status status = Done{};
  for (size_t i = 0; i < parts.size(); ++i) {
    if (results[i]) written.push_back(std::move(*results[i]));
    if (!saved[i] && status) status = saved[i];
  }
  if (completed && status && folder.single_file) status = write_single_file(kept, folder, written);
  const bool is_missing = written.size() < parts.size();
  for (const auto& file : kept) {
    if (!is_missing || !file) continue;
    file->piece.file.clear();
    written.push_back(std::move(file->piece));
  }
  if (!status) return status;
  if (is_missing) return failed("stopped before all pieces were written, so there is no report");
  LostLooks lost;
  for (const Part& part : parts) lost.add(*part.body, part.faces, part.extract, format);
  lost.add_notes(format, notes);
  return folder.provenance.empty() ? Status(Done{}) : write_provenance(parts, folder);
}

}  // namespace

Status PiecesFolder::check(const std::string& option, const InputFiles& inputs) const {
  const std::set<std::string> earlier = EarlierResult(path).pieces();
  return inputs.check_folder(option, path, [&](std::string_view name) {
    return name == kReport || earlier.contains(std::string(name)) ||
           (is_piece_name(name) &&
            (fs::path(name).extension() == "." + format || fs::path(name).extension() == "." + outlines));
  });
}

bool PiecesFolder::holds(const fs::path& file) const {
  fs::path folder = resolved(path);
  if (!folder.has_filename()) folder = folder.parent_path();  // ends with a slash
  return resolved(file).parent_path() == folder;
}

bool PiecesFolder::may_write(const fs::path& file) const {
  const std::string name = resolved(file).filename().string();
  return holds(file) && (name == kReport || is_piece_name(name));
}

Status PiecesFolder::make() const {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) return failed(path + ": cannot create the folder: " + error.message());
  if (::access(path.c_str(), W_OK | X_OK) != 0)
    return failed(path + ": cannot write to the folder: " + std::strerror(errno));
  return Done{};
}

Result<std::vector<WrittenPiece>> PiecesFolder::write(CutJob& job, const World& world,
                                                      const CutSettings& settings) const {
  EarlierResult earlier(path);
  if (const Status begun = earlier.begin(); !begun) return begun.error();
  std::vector<WrittenPiece> written;
  SurfaceFiles surfaces(world);
  std::vector<std::string> lost;  // notes
  const Status saved = [&] {
    const Stopwatch watch(job.save_s);
    if (format == "obj") {
      if (const Status described = surfaces.write(path); !described) return described;
    }
    return write_pieces(world, *this, surfaces, job.origin, written, lost);
  }();
  if (!saved) surfaces.remove();
  if (!saved) earlier.remove_new(written);
  if (!saved) return saved.error();
  PrecisionLoss precision;
  for (const WrittenPiece& piece : written) precision += piece.precision;
  const auto note = precision_note(
      precision, *mesh_format(format),
      job.origin == Vec3(0) ? "write OBJ, PLY or OFF, or cut with --recentre" : "write OBJ, PLY or OFF");
  if (note) job.notes.push_back(*note);
  const auto flat = static_cast<size_t>(std::ranges::count(written, true, &WrittenPiece::no_collider));
  if (flat > 0)
    job.notes.push_back(count_text(flat, "piece") + (flat == 1 ? " has" : " have") +
                        " no collider, because the hull has no volume");
  const auto uneven = static_cast<size_t>(std::ranges::count(written, "", &WrittenPiece::outline));
  if (!outlines.empty() && uneven > 0)
    job.notes.push_back(count_text(uneven, "piece") +
                        (uneven == 1 ? " is not flat and has" : " are not flat and have") + " no outline");
  job.notes.insert(job.notes.end(), lost.begin(), lost.end());
  nlohmann::ordered_json how = settings_json(settings, format, split_all);
  if (solid) how["solid"] = true;
  if (single_file) how["single-file"] = true;
  if (!outlines.empty()) how["outlines"] = outlines;
  if (!colliders.empty()) {
    how["colliders"] = "hull";
    how["collider-names"] = colliders;
  }
  const auto report = with_run_description(cut_report(job, world, how, written));
  const auto file = fs::path(path) / kReport;
  const std::string text = report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
  if (const auto s = write_file_atomically(file, text + "\n"); !s) return s.error();
  earlier.remove_all_but(written);
  return written;
}

}  // namespace kerf
