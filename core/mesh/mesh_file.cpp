#include "core/mesh/mesh_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <new>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/base/assert.h"
#include "core/base/number_format.h"
#include "core/base/platform.h"
#include "core/mesh/files/mesh_format.h"
#include "core/mesh/files/readers.h"
#include "core/mesh/files/scanner.h"
#include "core/mesh/files/soup_file.h"
#include "core/mesh/weld.h"

namespace kerf {

namespace {

constexpr size_t kMaxFileSize = size_t{1} << 32;
constexpr size_t kChunk = size_t{1} << 24;
constexpr double kLoadingShare = 0.2;  // of the progress; the rest is parsing

class OpenFile {
 public:
  // Does not wait for a pipe without a writer.
  explicit OpenFile(const std::filesystem::path& path)
      : descriptor_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {}
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

// The bytes are read, not mapped: if another program truncates a mapped file, the process crashes.
struct FileBytes {
  std::unique_ptr<char[]> data;
  size_t size = 0;

  std::string_view view() const { return {data.get(), size}; }
};

Result<size_t> readable_size(int file, const std::string& name) {
  struct stat info {};
  if (::fstat(file, &info) != 0) return failed(name + ": " + std::generic_category().message(errno) + ".");
  if (S_ISDIR(info.st_mode)) return bad_input(name + ": this is a folder, not a mesh file.");
  if (!S_ISREG(info.st_mode)) return bad_input(name + ": this is a device or a pipe, not a mesh file.");
  const auto size = static_cast<size_t>(info.st_size);
  if (size == 0) return bad_input(name + ": the file is empty.");
  if (size > kMaxFileSize) return bad_input(name + ": the file exceeds the limit of 4 GiB.");
  return size;
}

Result<FileBytes> read_bytes(const std::filesystem::path& path, const std::string& name,
                             const Progress* progress) {
  const OpenFile file(path);
  if (file.descriptor() < 0) {
    return bad_input(name + ": cannot be opened: " + std::generic_category().message(errno) + ".");
  }
  const Result<size_t> size = readable_size(file.descriptor(), name);
  if (!size) return size.error();
  FileBytes bytes{std::make_unique_for_overwrite<char[]>(*size), 0};
  while (bytes.size < *size) {
    if (progress &&
        !progress->report(kLoadingShare * static_cast<double>(bytes.size) / static_cast<double>(*size))) {
      return cancelled();
    }
    const ssize_t got =
        ::read(file.descriptor(), bytes.data.get() + bytes.size, std::min(kChunk, *size - bytes.size));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return failed(name + ": cannot be read: " + std::generic_category().message(errno) + ".");
    if (got == 0) break;
    bytes.size += static_cast<size_t>(got);
  }
  return bytes;
}

Error not_a_mesh(const std::string& name, std::string_view kind) {
  const std::string what = kind.empty() ? "" : std::string(kind) + ", ";
  return bad_input(name + ": this is " + what + "not a supported mesh format; Kerf reads " +
                   list_mesh_titles(" and ") + ".");
}

// `ending`: of the name; `folder`: of the file, empty for bytes that may refer to no other file.
Result<Soup> parse(std::string_view bytes, const std::string& name, const std::string& ending,
                   const std::filesystem::path& folder, const Progress* progress) {
  if (is_soup_file(bytes)) return read_soup(bytes, name);
  const std::optional<MeshFormat> by_content = recognise_format(bytes, {});
  if (!by_content) {
    // A file of no other kind may be a damaged one of the format of its extension.
    if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
      return bad_input(name + ": this is UTF-16 text; save it as UTF-8.");
    const std::string_view kind = kind_of_file(bytes);
    if (!kind.empty()) return not_a_mesh(name, kind);
  }
  const std::optional<MeshFormat> format = by_content ? by_content : mesh_format(ending);
  if (!format) return not_a_mesh(name, {});
  switch (*format) {
    case MeshFormat::kObj:
      return read_obj(bytes, name, progress, folder);
    case MeshFormat::kPly:
      return read_ply(bytes, name, progress, folder);
    case MeshFormat::kStl:
      return read_stl(bytes, name, progress);
    case MeshFormat::kGlb:
    case MeshFormat::kGltf:
      return read_gltf(bytes, name, progress, folder);
    case MeshFormat::k3mf:
      return read_3mf(bytes, name, progress);
    case MeshFormat::kOff:
      break;
  }
  return read_off(bytes, name, progress);
}

Result<Soup> load_and_parse(const std::filesystem::path& path, const std::string& name,
                            const Progress* progress) {
  const Result<FileBytes> bytes = read_bytes(path, name, progress);
  if (!bytes) return bytes.error();
  const Progress parsing = share_of(progress, kLoadingShare, 1);
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  return parse(bytes->view(), name, path.extension().string(), folder, &parsing);
}

void convert_to_metres(Soup& soup, FileUnit unit) {
  const auto format = mesh_format(soup.format);
  if (unit == FileUnit::kMetre || !format || states_unit(*format)) return;
  const double metres = metres_per_unit(unit);
  for (Vec3& p : soup.positions) p *= metres;
}

}  // namespace

Result<Soup> read_mesh(const std::filesystem::path& path, const Progress* progress, FileUnit unit) {
  const std::string name = one_line(path.string());
  try {
    auto soup = load_and_parse(path, name, progress);
    if (soup) convert_to_metres(*soup, unit);
    return soup;
  } catch (const std::bad_alloc&) {
    return failed(name + ": not enough memory to read it.");
  }
}

Result<Soup> decode_mesh(std::string_view bytes, const std::string& name, const std::string& format,
                         const Progress* progress) {
  if (bytes.empty()) return bad_input(name + ": must not be empty");
  return parse(bytes, name, format, {}, progress);
}

Result<BuiltMesh> load_mesh(const std::filesystem::path& file, const Progress* progress,
                            const MeshReading& how) {
  constexpr double kReading = 0.2;  // of the time; the rest is building
  const Progress reading = share_of(progress, 0, kReading), building = share_of(progress, kReading, 1);
  auto soup = read_mesh(file, &reading, how.unit);
  if (!soup) return soup.error();
  soup->keeps_corners = how.keeps_corners;
  const std::string name = one_line(file.string());
  try {
    auto built = build_mesh(*soup, &building);
    if (!built && built.error().code == ErrorCode::kBadInput)
      return bad_input(name + ": " + built.error().message);
    return built;
  } catch (const std::bad_alloc&) {
    return failed(name + ": not enough memory to build its mesh.");
  }
}

namespace {

// A sentence about a count, in the singular and the plural, both without the number.
struct Wording {
  const char* one;
  const char* many;
};

void add(size_t count, const Wording& wording, std::vector<std::string>& notes) {
  if (count == 0) return;
  notes.push_back(grouped(count) + (count == 1 ? wording.one : wording.many));
}

}  // namespace

std::vector<std::string> dropped_notes(const Repairs& r) {
  std::vector<std::string> notes;
  add(r.invalid_faces_dropped,
      {" triangle refers to a missing vertex and was dropped.",
       " triangles refer to missing vertices and were dropped."},
      notes);
  add(r.non_finite_faces_dropped,
      {" triangle has a corner that is not a finite number and was dropped.",
       " triangles have corners that are not finite numbers and were dropped."},
      notes);
  add(r.degenerate_faces_dropped,
      {" triangle has two corners at the same position and was dropped.",
       " triangles have two corners at the same position and were dropped."},
      notes);
  add(r.incomplete_faces_dropped,
      {" face has fewer than three corners and was dropped.",
       " faces have fewer than three corners and were dropped."},
      notes);
  return notes;
}

std::vector<std::string> load_notes(const MeshReport& report) {
  std::vector<std::string> notes = dropped_notes(report.repairs);
  add(report.repairs.reoriented_faces,
      {" face was flipped, so that neighbours agree and closed parts face outward.",
       " faces were flipped, so that neighbours agree and closed parts face outward."},
      notes);
  add(report.repairs.zero_area_faces,
      {" face has no area and was kept, because it connects others.",
       " faces have no area and were kept, because they connect others."},
      notes);
  add(report.non_manifold_edges,
      {" edge has three or more faces: closed parts that touch there are cut separately, open ones together.",
       " edges have three or more faces: closed parts that touch there are cut separately, open ones "
       "together."},
      notes);
  add(report.repairs.isolated_vertices_dropped,
      {" vertex is used by no face and was dropped.", " vertices are used by no face and were dropped."},
      notes);
  notes.insert(notes.end(), report.warnings.begin(), report.warnings.end());
  return notes;
}

namespace {

bool fits_float(const Vec3& p) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  return std::abs(p.x) <= kLargest && std::abs(p.y) <= kLargest && std::abs(p.z) <= kLargest;
}

std::string obstacle_to_gltf(std::span<const MeshView> meshes) {
  // Half of the range, because positions are relative to the middle.
  const auto fits = [](const Vec3& p) { return fits_float(2.0 * p); };
  size_t elements = 0, bytes = 0;  // at most
  std::set<const SurfaceLibrary*> libraries;
  for (const MeshView& mesh : meshes) {
    if (!std::all_of(mesh.positions.begin(), mesh.positions.end(), fits))
      return "glTF cannot store coordinates beyond 1.7e38";
    elements += mesh.positions.size() + mesh.triangles.size();
    if (mesh.looks) {
      const size_t corner = 64 + 8 * mesh.looks->uv_sets.size() + 16 * mesh.looks->attributes.size();
      bytes += 3 * mesh.triangles.size() * corner;
    }
    if (!mesh.surfaces || !libraries.insert(mesh.surfaces).second) continue;
    for (const SurfaceImage& image : mesh.surfaces->images) bytes += image.bytes.size();
  }
  if (elements > (size_t{1} << 28)) return "glTF cannot store more than 268435456 vertices and triangles";
  if (bytes >= size_t{1} << 32) return "glTF cannot store more than 4 GiB of UVs, normals and images";
  return {};
}

std::string obstacle_to_3mf(std::span<const MeshView> meshes) {
  const auto fits = [](const Vec3& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kMaxThreeMf;
  };
  const auto has_different_corners = [](const std::array<uint32_t, 3>& t) {
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
  };
  for (const MeshView& mesh : meshes) {
    if (!std::all_of(mesh.positions.begin(), mesh.positions.end(), fits))
      return "3MF cannot store coordinates beyond 1000 km";
    constexpr size_t kMax = size_t{1} << 31;
    if (mesh.positions.size() >= kMax || mesh.triangles.size() >= kMax)
      return "3MF cannot store more than 2147483647 vertices or triangles";
    if (!std::all_of(mesh.triangles.begin(), mesh.triangles.end(), has_different_corners))
      return "3MF cannot store faces that have the same corner twice";
  }
  return {};
}

// Returns why the format cannot store the mesh; empty if it can.
std::string obstacle(const MeshView& mesh, MeshFormat format) {
  if (format == MeshFormat::kStl && !std::all_of(mesh.positions.begin(), mesh.positions.end(), fits_float)) {
    return "STL cannot store coordinates beyond 3.4e38";
  }
  if (format == MeshFormat::kStl && mesh.triangles.size() > std::numeric_limits<uint32_t>::max()) {
    return "STL cannot store more than 4294967295 triangles";
  }
  if (format == MeshFormat::kPly && mesh.positions.size() > size_t{std::numeric_limits<int32_t>::max()} + 1) {
    return "PLY cannot store more than 2147483648 vertices";
  }
  if (is_gltf(format)) return obstacle_to_gltf({&mesh, 1});
  if (format == MeshFormat::k3mf) return obstacle_to_3mf({&mesh, 1});
  return {};
}

template <typename Encode>
Status write_encoded(const std::filesystem::path& path, const std::string& reason, const Encode& encode) {
  if (!reason.empty())
    return failed("cannot write " + path.string() + ": " + reason + "; select another format.");
  try {
    return write_file_atomically(path, encode);
  } catch (const std::bad_alloc&) {
    return failed("cannot write " + path.string() + ": not enough memory.");
  }
}

}  // namespace

Status write_mesh(const MeshView& mesh, const std::filesystem::path& path, MeshFormat format) {
  return write_encoded(path, obstacle(mesh, format),
                       [&](const ByteSink& sink) { encode(mesh, format, sink); });
}

Result<std::string> encode_mesh(const MeshView& mesh, MeshFormat format) {
  if (const std::string reason = obstacle(mesh, format); !reason.empty())
    return failed(reason + "; select another format");
  return encoded(mesh, format);
}

Status write_meshes(std::span<const MeshView> meshes, const std::filesystem::path& path, MeshFormat format) {
  KERF_ASSERT(holds_several_meshes(format));
  const auto encode = format == MeshFormat::kGlb    ? encode_glb
                      : format == MeshFormat::kGltf ? encode_gltf
                                                    : encode_3mf;
  const std::string reason = is_gltf(format) ? obstacle_to_gltf(meshes) : obstacle_to_3mf(meshes);
  return write_encoded(path, reason, [&](const ByteSink& sink) { encode(meshes, sink); });
}

namespace {

size_t repeated_positions(std::span<const Vec3> positions) {
  const std::vector<uint32_t> first = weld_positions(positions);
  size_t repeated = 0;
  for (size_t i = 0; i < first.size(); ++i) repeated += first[i] != i;
  return repeated;
}

double shortest_edge(const MeshView& mesh) {
  double shortest = 0;
  for (const auto& corners : mesh.triangles) {
    for (size_t i = 0; i < 3; ++i) {
      const double length =
          glm::length(mesh.positions[corners[i]] - mesh.positions[corners[i == 2 ? 0 : i + 1]]);
      if (length > 0 && (shortest == 0 || length < shortest)) shortest = length;
    }
  }
  return shortest;
}

}  // namespace

PrecisionLoss& PrecisionLoss::operator+=(const PrecisionLoss& other) {
  max_move = std::max(max_move, other.max_move);
  if (shortest_edge == 0 || (other.shortest_edge > 0 && other.shortest_edge < shortest_edge))
    shortest_edge = other.shortest_edge;
  merged += other.merged;
  vertices += other.vertices;
  return *this;
}

PrecisionLoss precision_loss(const MeshView& mesh, MeshFormat format) {
  PrecisionLoss loss;
  loss.vertices = mesh.positions.size();
  if (!format_row(format).single_precision) return loss;
  const Vec3 origin = is_gltf(format) ? gltf_middle(mesh.positions) : Vec3(0);
  std::vector<Vec3> rounded;
  rounded.reserve(mesh.positions.size());
  for (const Vec3& p : mesh.positions) {
    const Vec3 exact = p - origin;
    rounded.push_back(format == MeshFormat::k3mf ? three_mf_position(exact) : Vec3(glm::vec3(exact)));
    loss.max_move = std::max(loss.max_move, glm::length(rounded.back() - exact));
  }
  if (loss.max_move == 0) return loss;
  loss.shortest_edge = shortest_edge(mesh);
  loss.merged = repeated_positions(rounded) - repeated_positions(mesh.positions);
  return loss;
}

std::optional<std::string> precision_note(const PrecisionLoss& loss, MeshFormat format,
                                          const std::string& advice) {
  if (!loss.matters()) return std::nullopt;
  std::string text(format_row(format).title);
  text += " stores single precision: vertices move by up to " + length_text(loss.max_move) +
          ", while the shortest edge is " + length_text(loss.shortest_edge);
  if (loss.merged > 0) {
    text += ", and " + grouped(loss.merged) + " of " + grouped(loss.vertices) + " vertices" +
            (loss.merged == 1 ? " coincides" : " coincide") + " with others";
  }
  return text + "; " + advice;
}

}  // namespace kerf
