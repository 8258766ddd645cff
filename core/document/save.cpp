#include "core/document/save.h"

#include <sys/stat.h>
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <optional>
#include <utility>

#include "core/base/platform.h"
#include "core/document/extract.h"
#include "core/document/piece_looks.h"
#include "core/document/stroke_path.h"
#include "core/document/text/json.h"
#include "core/mesh/files/bytes.h"
#include "core/mesh/files/mtl_file.h"
#include "core/mesh/files/side_file.h"
#include "core/mesh/files/soup_file.h"
#include "core/mesh/looks.h"
#include "core/mesh/mesh_file.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;

std::optional<struct stat> regular_file(const fs::path& path) {
  struct stat there {};
  if (::stat(path.c_str(), &there) != 0 || !S_ISREG(there.st_mode)) return std::nullopt;
  return there;
}

// Decodes the URI of a glTF file to a path: "%20" is a space.
std::string without_escapes(std::string_view uri) {
  std::string path;
  for (size_t i = 0; i < uri.size(); ++i) {
    unsigned char code = 0;
    const char* const digits = uri.data() + i + 1;
    const bool escaped = uri[i] == '%' && i + 2 < uri.size() &&
                         std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2;
    path += escaped ? static_cast<char>(code) : uri[i];
    if (escaped) i += 2;
  }
  return path;
}

// Returns the JSON of a glTF file, of a binary one its first chunk; empty if it cannot be read.
std::string text_of_gltf(const fs::path& file) {
  constexpr size_t kHead = 20, kSizeOfText = 12;
  std::array<char, kHead> head{};
  std::ifstream in(file, std::ios::binary);
  in.read(head.data(), kHead);
  const bool is_binary = in && std::string_view(head.data(), kHead).starts_with("glTF");
  if (!is_binary) {
    const auto text = read_text_file(file);
    return text ? *text : "";
  }
  std::error_code fault;
  const uintmax_t all = fs::file_size(file, fault);
  std::string text(std::min<uintmax_t>(load<uint32_t>(head.data() + kSizeOfText, std::endian::little), all),
                   '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  return in ? text : "";
}

// Returns the folder in which the other files of a mesh file lie.
fs::path folder_of_parts(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : "."; }

// The files that a glTF file refers to; none if it cannot be read.
std::vector<fs::path> files_of_gltf(const fs::path& file) {
  const auto json = parse_json(text_of_gltf(file), "");
  std::vector<fs::path> files;
  for (const char* const list : {"buffers", "images"}) {
    if (!json || !json->is_object() || !json->contains(list)) continue;
    for (const nlohmann::json& entry : (*json)[list]) {
      if (!entry.is_object() || !entry.contains("uri") || !entry["uri"].is_string()) continue;
      const auto uri = entry["uri"].get<std::string>();
      if (uri.starts_with("data:")) continue;
      const std::string path = without_escapes(uri);
      files.push_back(folder_of_parts(file) / path);  // a buffer is read only from there
      if (const auto image = side_file(folder_of_parts(file), path)) files.push_back(*image);
    }
  }
  return files;
}

// Returns the texture that a comment in the header of a PLY file names, if any.
std::vector<fs::path> files_of_ply(const fs::path& file) {
  constexpr std::string_view kKeyword = "TextureFile", kBlanks = " \t", kLineEnds = "\r\n";
  std::string header(size_t{1} << 16, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(header.data(), static_cast<std::streamsize>(header.size()));
  header.resize(static_cast<size_t>(in.gcount()));
  header.resize(std::min(header.size(), header.find("end_header")));
  const size_t keyword = header.find(kKeyword);
  if (keyword == std::string::npos) return {};
  const size_t begin = header.find_first_not_of(kBlanks, keyword + kKeyword.size());
  std::string name = header.substr(std::min(begin, header.size()));
  name.resize(std::min(name.size(), name.find_first_of(kLineEnds)));
  name.resize(name.find_last_not_of(kBlanks) + 1);
  const auto texture = side_file(folder_of_parts(file), name);
  return texture ? std::vector{*texture} : std::vector<fs::path>();
}

fs::path folder_of(const fs::path& file) {
  std::error_code error;
  const fs::path whole = fs::absolute(file, error);
  return (error ? file : whole).parent_path();
}

// Atomically makes `previous` a hard link to the file, or a copy if the file system does not support links.
Status keep(const fs::path& file, const fs::path& previous) {
  fs::path fresh = previous;
  fresh += ".new";
  std::error_code error;
  fs::remove(fresh, error);
  fs::create_hard_link(file, fresh, error);
  if (error) fs::copy_file(file, fresh, fs::copy_options::overwrite_existing, error);
  if (!error) fs::rename(fresh, previous, error);
  if (!error) return Done{};
  return failed("cannot keep the previous version of " + file.string() + " as " + previous.string() + ": " +
                error.message());
}

// Writes faces as an OBJ file, or as a Kerf mesh if the body has looks.
Status save_faces(const Body& body, std::span<const FaceId> faces, const fs::path& file) {
  Extract e = extract_faces(body, faces);
  if (!body.looks) {
    const MeshView view{e.positions, e.triangles, e.materials, body.material_names, {}, {}, e.colours};
    return write_mesh(view, file, MeshFormat::kObj);
  }
  Soup soup;
  soup.positions = std::move(e.positions);
  soup.colours = std::move(e.colours);
  soup.triangles = std::move(e.triangles);
  soup.materials = std::move(e.materials);
  soup.material_names = body.material_names;
  soup.looks = looks_of(body, faces, LookNormals::kSmooth);
  soup.surfaces = body.looks->surfaces();
  return write_file_atomically(file, encode_soup(soup));
}

}  // namespace

void InputFiles::add(const fs::path& file) {
  const auto own = regular_file(file);
  if (!own) return;
  files_.push_back({own->st_dev, own->st_ino, file});
  const auto format = mesh_format(file.extension().string());
  if (format == MeshFormat::kObj) objs_.push_back(file);
  std::vector<fs::path> parts;
  if (format && is_gltf(*format)) parts = files_of_gltf(file);
  if (format == MeshFormat::kPly) parts = files_of_ply(file);
  for (const fs::path& part : parts) {
    if (const auto there = regular_file(part)) files_.push_back({there->st_dev, there->st_ino, part});
  }
}

void InputFiles::add_meshes(const SceneDescription& scene) {
  for (const SceneBody& body : scene.bodies) add(body.mesh);
}

void InputFiles::add_meshes(std::span<const Command> commands) {
  for (const Command& command : commands) {
    if (const auto* mesh = std::get_if<AddMesh>(&command)) add(mesh->file);
  }
}

Status InputFiles::check(const std::string& option, const fs::path& output) const {
  const auto there = regular_file(output);
  if (!there) return Done{};
  for (const fs::path& obj : std::exchange(objs_, {})) {
    for (const fs::path& part : files_of_obj(obj)) {
      if (const auto own = regular_file(part)) files_.push_back({own->st_dev, own->st_ino, part});
    }
  }
  for (const File& file : files_) {
    if (file.device != there->st_dev || file.inode != there->st_ino) continue;
    const bool same_name = file.path.lexically_normal() == output.lexically_normal();
    return bad_input(option + ": " + output.string() + " would overwrite " +
                     (same_name ? "its own input" : "the input " + file.path.string()) +
                     ": use another path");
  }
  return Done{};
}

Status InputFiles::check_folder(const std::string& option, const fs::path& folder,
                                const std::function<bool(std::string_view)>& is_output) const {
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (!is_output(at->path().filename().string())) continue;
    if (const Status free = check(option, at->path()); !free) return free;
  }
  return Done{};
}

InputFiles input_files(std::span<const fs::path> files) {
  InputFiles inputs;
  for (const fs::path& file : files) inputs.add(file);
  return inputs;
}

fs::path previous_version(const fs::path& file) {
  fs::path previous = file;
  previous += "~";
  return previous;
}

Status save_file(const fs::path& file, std::string_view bytes) {
  auto fresh = AtomicFile::open(file);
  if (!fresh) return fresh.error();
  if (const Status written = fresh->append(bytes); !written) return written;
  std::error_code error;
  const fs::path target = fs::is_regular_file(file, error) ? fs::canonical(file, error) : file;
  if (!error && fs::is_regular_file(target, error)) {
    if (const auto kept = keep(target, previous_version(target)); !kept) return kept;
  }
  return fresh->commit();
}

Status save_journal(const fs::path& file, const SceneDescription& scene, std::span<const Command> commands,
                    std::span<const StateMark> marks) {
  InputFiles inputs;
  inputs.add_meshes(scene);
  inputs.add_meshes(commands);
  if (const Status free = inputs.check("journal", file); !free) return free;
  const fs::path folder = folder_of(file);
  const auto head = journal_head(scene, {}, folder);
  if (!head) return head.error();
  const auto lines = journal_lines(commands, marks, folder);
  if (!lines) return lines.error();
  return save_file(file, *head + *lines);
}

Status save_scene(const fs::path& file, const SceneDescription& scene) {
  InputFiles inputs;
  inputs.add_meshes(scene);
  if (const Status free = inputs.check("scene", file); !free) return free;
  SceneDescription without_hashes = scene;
  for (SceneBody& body : without_hashes.bodies) body.hash.reset();
  const auto text = dump_json(scene_json(without_hashes, folder_of(file)), 2);
  if (!text) return text.error();
  return save_file(file, *text + "\n");
}

Status save_path(const fs::path& file, std::span<const StrokePath> strokes) {
  return save_file(file, path_file_text(strokes));
}

Result<std::filesystem::path> save_world_as_scene(const World& world, SceneDescription description,
                                                  const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return failed(folder.string() + ": cannot create the folder: " + error.message());
  description.bodies.clear();
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    if (body.hidden || body.mesh.live_faces() == 0) continue;
    std::vector<FaceId> faces;
    for (const auto& piece : faces_by_piece(body, false))
      faces.insert(faces.end(), piece.begin(), piece.end());
    std::sort(faces.begin(), faces.end());
    Body at_rest = body;  // far from the origin, small faces would collapse
    at_rest.placement = {};
    char name[40];
    std::snprintf(name, sizeof name, "body-%04zu.%s", description.bodies.size() + 1,
                  body.looks ? std::string(kSoupFileEnding).c_str() : "obj");
    if (const Status written = save_faces(at_rest, faces, folder / name); !written) return written.error();
    SceneBody entry;
    entry.mesh = folder / name;
    entry.name = body.own_name();
    entry.placement = body.placement;
    entry.sheet = body.sheet;
    entry.solid = body.solid ? Solidity::kSolid : Solidity::kSheet;
    entry.cut_material = body.cut_material;
    description.bodies.push_back(std::move(entry));
  }
  const std::filesystem::path file = folder / "scene.json";
  if (const Status saved = save_scene(file, description); !saved) return saved.error();
  return file;
}

}  // namespace kerf
