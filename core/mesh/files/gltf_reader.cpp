#include "core/mesh/files/readers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/mesh/files/gltf_file_internal.h"
#include "core/mesh/files/gltf_surfaces_internal.h"
#include "core/mesh/files/scanner.h"
#include "core/mesh/files/soup.h"

namespace kerf {

namespace {

using Matrix = GltfMatrix;

constexpr size_t kMaxTriangles = 100'000'000, kMaxPositions = 3 * kMaxTriangles;
constexpr size_t kMaxInstances = 1'000'000;  // of nodes with several
constexpr uint64_t kTriangles = 4, kStrip = 5, kFan = 6, kModes = 7;

std::string node_place(uint32_t node) { return "/nodes/" + std::to_string(node); }

class GltfReader {
 public:
  GltfReader(const GltfFile& file, const std::string& name, const Progress* progress,
             const std::filesystem::path& folder)
      : file_(file), name_(name), progress_(progress), folder_(folder), seen_(file.count("nodes"), false) {}

  Result<Soup> read() {
    if (auto problem = push_roots()) return *problem;
    while (!open_.empty()) {
      const Open next = open_.back();
      open_.pop_back();
      if (auto problem = read_node(next)) return *problem;
    }
    Result<Soup> soup = polygons_.to_soup(std::move(positions_), name_);
    if (!soup) return soup;
    if (!colours_.empty()) colours_.resize(soup->positions.size());
    soup->colours = std::move(colours_);
    soup->material_names = std::move(material_names_);
    if (soup->material_names.size() == 1 && soup->material_names[0].empty()) soup->material_names.clear();
    take_looks(*soup);
    soup->surfaces = read_gltf_surfaces(file_, materials_, folder_, warnings_);
    soup->warnings = std::move(warnings_);
    return soup;
  }

 private:
  using Problem = std::optional<Error>;
  struct Open {
    uint32_t node;
    Matrix to_scene;  // of its parent
  };

  // Pushes a list of node indices onto the stack, with the first on top.
  Problem push_nodes(const nlohmann::json& of, const char* key, const std::string& where,
                     const Matrix& to_scene) {
    const auto list = of.find(key);
    if (list == of.end()) return std::nullopt;
    if (!list->is_array()) return file_.wrong(where + "/" + key, "must be an array of nodes");
    const size_t first = open_.size();
    for (const nlohmann::json& item : *list) {
      if (!item.is_number_unsigned() || item.get<uint64_t>() >= seen_.size())
        return file_.wrong(where + "/" + key, "refers to a missing node");
      const auto node = item.get<uint32_t>();
      if (seen_[node]) return file_.wrong(node_place(node), "has two parents, or is its own ancestor");
      seen_[node] = true;
      open_.push_back({node, to_scene});
    }
    std::reverse(open_.begin() + static_cast<std::ptrdiff_t>(first), open_.end());
    return std::nullopt;
  }

  // Pushes the nodes of the default scene; without scenes, those that are no other's children.
  Problem push_roots() {
    if (file_.count("scenes") > 0) {
      const auto scene = file_.index(file_.root(), "scene", "scenes", "");
      if (!scene) return scene.error();
      const uint32_t shown = scene->value_or(0);
      if (const size_t count = file_.count("scenes"); count > 1)
        warnings_.push_back("Only one of " + std::to_string(count) + " scenes was read, the " +
                            (*scene ? "default" : "first") + " one.");
      return push_nodes(file_.element("scenes", shown), "nodes", "/scenes/" + std::to_string(shown),
                        Matrix(1));
    }
    std::vector<bool> is_child(seen_.size(), false);
    for (size_t i = 0; i < seen_.size(); ++i) {
      const nlohmann::json& node = file_.element("nodes", i);
      const auto children = node.find("children");
      if (children == node.end() || !children->is_array()) continue;
      for (const nlohmann::json& child : *children) {
        if (child.is_number_unsigned() && child.get<uint64_t>() < seen_.size())
          is_child[child.get<size_t>()] = true;
      }
    }
    for (size_t i = seen_.size(); i-- > 0;) {
      if (is_child[i]) continue;
      seen_[i] = true;
      open_.push_back({static_cast<uint32_t>(i), Matrix(1)});
    }
    return std::nullopt;
  }

  Problem read_node(const Open& open) {
    const nlohmann::json& node = file_.element("nodes", open.node);
    const std::string where = node_place(open.node);
    const auto own = gltf_transform(file_, node, where);
    if (!own) return own.error();
    const Matrix to_scene = open.to_scene * *own;
    if (auto problem = push_nodes(node, "children", where, to_scene)) return problem;
    const auto mesh = file_.index(node, "mesh", "meshes", where);
    if (!mesh) return mesh.error();
    if (!*mesh) return std::nullopt;
    if (node.contains("skin")) record_once(skinned_, "Meshes with a skin were read in their rest pose.");
    const auto instances = gltf_instances(file_, node, where, to_scene, kMaxInstances - instances_);
    if (!instances) return instances.error();
    if (instances->size() > 1) instances_ += instances->size();
    for (const Matrix& instance : *instances) {
      polygons_.begin_parts(PolygonList::Level::kObject, {name_of(node, file_.element("meshes", **mesh))});
      if (auto problem = read_mesh(**mesh, instance)) return problem;
    }
    return std::nullopt;
  }

  static std::string text_of(const nlohmann::json& of, const char* key) {
    const auto at = of.find(key);
    return at != of.end() && at->is_string() ? one_line(at->get<std::string>()) : "";
  }
  static std::string name_of(const nlohmann::json& node, const nlohmann::json& mesh) {
    const std::string own = text_of(node, "name");
    return own.empty() ? text_of(mesh, "name") : own;
  }

  void record_once(bool& noted, const char* warning) {
    if (!noted) warnings_.emplace_back(warning);
    noted = true;
  }

  Problem read_mesh(uint32_t mesh, const Matrix& to_scene) {
    const nlohmann::json& json = file_.element("meshes", mesh);
    const std::string where = "/meshes/" + std::to_string(mesh) + "/primitives";
    const auto primitives = json.find("primitives");
    if (primitives == json.end() || !primitives->is_array()) return file_.wrong(where, "must be an array");
    placed_.clear();
    const auto read_one = [&](size_t i) {
      return read_primitive((*primitives)[i], where + "/" + std::to_string(i), to_scene);
    };
    // Only primitives with triangles are read again, so that the time is linear in the number of triangles.
    const auto [known, is_new] = drawn_.try_emplace(mesh);
    for (size_t i = 0; i < known->second.size(); ++i) {
      if (auto problem = read_one(known->second[i])) return problem;
    }
    for (size_t i = 0; is_new && i < primitives->size(); ++i) {
      const size_t before = polygons_.size();
      if (auto problem = read_one(i)) return problem;
      if (polygons_.size() > before) known->second.push_back(i);
    }
    return std::nullopt;
  }

  Problem read_primitive(const nlohmann::json& primitive, const std::string& where, const Matrix& to_scene) {
    if (!primitive.is_object()) return file_.wrong(where, "must be an object");
    const auto mode = file_.whole(primitive, "mode", kTriangles, where);
    if (!mode) return mode.error();
    if (*mode >= kModes) return file_.wrong(where + "/mode", "must be from 0 to 6");
    if (*mode < kTriangles) {
      record_once(lines_, "Points and lines were skipped.");
      return std::nullopt;
    }
    if (primitive.contains("targets")) record_once(morphed_, "Morph targets were ignored.");
    const auto attributes = primitive.find("attributes");
    if (attributes == primitive.end() || !attributes->is_object())
      return file_.wrong(where + "/attributes", "is missing");
    const auto accessor = file_.index(*attributes, "POSITION", "accessors", where + "/attributes");
    if (!accessor) return accessor.error();
    if (!*accessor) return std::nullopt;  // a mesh without positions is not drawn
    VertexAccessors accessors{**accessor};
    for (const char* name : kLookAttributes) {
      const auto own = file_.index(*attributes, name, "accessors", where + "/attributes");
      if (!own) return own.error();
      accessors.push_back(*own ? int64_t{**own} : -1);
    }
    if (auto problem = add_attributes(*attributes, where + "/attributes", accessors)) return problem;
    record_ignored(primitive, *attributes);
    const auto first = place_vertices(accessors, to_scene);
    if (!first) return first.error();
    const auto material = material_of(primitive, where);
    if (!material) return material.error();
    const bool mirrors = glm::determinant(glm::dmat3(to_scene)) < 0;
    return read_triangles(primitive, where, *mode, {*first, *material, mirrors});
  }

  static constexpr std::array<const char*, 7> kLookAttributes{
      "COLOR_0", "NORMAL", "TEXCOORD_0", "TEXCOORD_1", "TEXCOORD_2", "TEXCOORD_3", "TANGENT"};
  static constexpr size_t kUvSets = 4;

  // Records what of a primitive is not read.
  void record_ignored(const nlohmann::json& primitive, const nlohmann::json& attributes) {
    for (const auto& [key, value] : attributes.items()) {
      if (std::find(kLookAttributes.begin(), kLookAttributes.end(), key) != kLookAttributes.end()) continue;
      if (key.starts_with("TEXCOORD_")) record_once(more_uvs_, "UVs beyond the fourth set were ignored.");
      if (key.starts_with("COLOR_"))
        record_once(more_colours_, "Vertex colours beyond the first set were ignored.");
    }
    const auto extensions = primitive.find("extensions");
    if (extensions != primitive.end() && extensions->contains("KHR_materials_variants"))
      record_once(variants_, "Variants of materials were ignored.");
  }

  // Appends the custom attributes of a primitive, each as its number among those of the file and its
  // accessor.
  Problem add_attributes(const nlohmann::json& attributes, const std::string& where,
                         std::vector<int64_t>& accessors) {
    for (const auto& [key, value] : attributes.items()) {
      if (key.size() < 2 || key[0] != '_') continue;
      const auto accessor = file_.index(attributes, key.c_str(), "accessors", where);
      if (!accessor) return accessor.error();
      if (!*accessor) continue;
      auto known = std::find(attribute_keys_.begin(), attribute_keys_.end(), key);
      if (known == attribute_keys_.end()) {
        if (attributes_.size() == kMaxLookAttributes) {
          record_once(crowded_, "Custom attributes beyond the limit of 16 were ignored.");
          continue;
        }
        known = attribute_keys_.insert(known, key);
        attributes_.push_back({one_line(key.substr(1)), 0, {}});
      }
      accessors.push_back(known - attribute_keys_.begin());
      accessors.push_back(int64_t{**accessor});
    }
    return std::nullopt;
  }

  // The positions of an accessor; primitives of a mesh with the same attributes share them.
  struct Placed {
    size_t first, count;
  };
  // Of positions, then of kLookAttributes, -1 for none, then pairs of a custom attribute and its accessor.
  using VertexAccessors = std::vector<int64_t>;
  Result<Placed> place_vertices(const VertexAccessors& accessors, const Matrix& to_scene) {
    if (const auto known = placed_.find(accessors); known != placed_.end()) return known->second;
    const auto of_positions = static_cast<uint32_t>(accessors[0]);
    const auto rows = GltfAccessor::vectors(file_, of_positions, 3);
    if (!rows) return rows.error();
    if (rows->size() > kMaxPositions - positions_.size())
      return file_.wrong("/accessors/" + std::to_string(of_positions),
                         "exceeds the maximum number of positions per glTF file");
    const Placed placed{positions_.size(), rows->size()};
    for (size_t i = 0; i < rows->size(); ++i) {
      if (i % kBetweenReports == 0 && progress_ && !progress_->report(0)) return cancelled();
      positions_.push_back(Vec3(to_scene * glm::dvec4(Vec3(rows->vector(i)), 1)));
    }
    if (accessors[1] >= 0) {
      if (auto problem = place_colours(static_cast<uint32_t>(accessors[1]), placed)) return *problem;
    }
    const glm::dmat3 turn(to_scene);
    // Inverse transposed but for its length, which exists for flattened parts, too. Mirroring turns it
    // around.
    const glm::dmat3 cofactors(glm::cross(turn[1], turn[2]), glm::cross(turn[2], turn[0]),
                               glm::cross(turn[0], turn[1]));
    const double side = glm::determinant(turn) < 0 ? -1 : 1;
    place_vectors(accessors[2], 3, placed, normals_, [&](const glm::dvec4& own) {
      const Vec3 n(own), turned = side * (cofactors * n);
      const double length = glm::length(turned);
      return glm::vec3(length > 0 ? turned / length : n);
    });
    for (size_t set = 0; set < kUvSets; ++set) {
      place_vectors(accessors[3 + set], 2, placed, uv_sets_[set],
                    [](const glm::dvec4& uv) { return glm::vec2(uv); });
    }
    place_vectors(accessors[3 + kUvSets], 4, placed, tangents_, [&](const glm::dvec4& t) {
      const Vec3 turned = turn * Vec3(t);
      const double length = glm::length(turned);
      return glm::vec4(glm::vec3(length > 0 ? turned / length : Vec3(t)),
                       static_cast<float>(t.w < 0 ? -side : side));
    });
    for (size_t i = 1 + kLookAttributes.size(); i < accessors.size(); i += 2)
      place_attribute(attributes_[static_cast<size_t>(accessors[i])], static_cast<uint32_t>(accessors[i + 1]),
                      placed);
    placed_.emplace(accessors, placed);
    return placed;
  }

  // Converts the vectors of an accessor, or warns if they are unreadable. Vertices without any are NaN.
  template <typename T, typename Convert>
  void place_vectors(int64_t accessor, size_t parts, const Placed& positions, std::vector<T>& to,
                     const Convert& convert) {
    if (accessor < 0) return;
    const auto rows = GltfAccessor::vectors(file_, static_cast<uint32_t>(accessor), parts);
    if (!rows || rows->size() != positions.count) {
      record_once(unreadable_, "Unreadable normals or UVs were ignored.");
      return;
    }
    to.resize(positions.first, T(std::numeric_limits<float>::quiet_NaN()));
    for (size_t i = 0; i < rows->size(); ++i) to.push_back(convert(rows->vector(i)));
  }

  void place_attribute(LookAttribute& attribute, uint32_t accessor, const Placed& positions) {
    const auto rows = GltfAccessor::vectors(file_, accessor);
    if (!rows || rows->size() != positions.count ||
        (attribute.parts != 0 && attribute.parts != rows->parts())) {
      record_once(unreadable_attributes_, "Unreadable custom attributes were ignored.");
      return;
    }
    attribute.parts = static_cast<uint8_t>(rows->parts());
    auto& values = attribute.channel.values;
    values.resize(positions.first, glm::vec4(std::numeric_limits<float>::quiet_NaN()));
    for (size_t i = 0; i < rows->size(); ++i) values.emplace_back(rows->vector(i));
  }

  // Gives the triangles the normals and UVs of their vertices.
  void take_looks(Soup& soup) {
    const auto take = [&](auto& values, auto& channel) {
      using T = std::decay_t<decltype(values[0])>;
      channel.values = std::move(values);
      channel.corners = soup.triangles;
      const auto is_missing = [&](uint32_t v) {
        return v >= channel.values.size() || std::isnan(channel.values[v].x);
      };
      for (auto& corners : channel.corners) {
        if (std::any_of(corners.begin(), corners.end(), is_missing)) corners.fill(LookChannel<T>::kNone);
      }
    };
    if (!normals_.empty()) take(normals_, soup.looks.normals);
    if (!tangents_.empty()) take(tangents_, soup.looks.tangents);
    for (LookAttribute& attribute : attributes_) {
      if (attribute.channel.values.empty()) continue;
      auto values = std::move(attribute.channel.values);
      take(values, attribute.channel);
      soup.looks.attributes.push_back(std::move(attribute));
    }
    // Materials refer to sets by number, so that empty ones before the last stay.
    size_t sets = kUvSets;
    while (sets > 0 && uv_sets_[sets - 1].empty()) --sets;
    soup.looks.uv_sets.resize(sets);
    for (size_t set = 0; set < sets; ++set) take(uv_sets_[set], soup.looks.uv_sets[set]);
    soup.looks.v_points_down = true;
  }

  Problem place_colours(uint32_t accessor, const Placed& positions) {
    const auto rows = GltfAccessor::colours(file_, accessor);
    if (!rows || rows->size() != positions.count) {
      record_once(uncoloured_, "Unreadable vertex colours were ignored.");
      return std::nullopt;
    }
    colours_.resize(positions.first);
    for (size_t i = 0; i < rows->size(); ++i) {
      if (i % kBetweenReports == 0 && progress_ && !progress_->report(0)) return cancelled();
      colours_.push_back(rows->colour(i));
    }
    return std::nullopt;
  }

  // Returns the index of the primitive's material in material_names_; the unnamed one if it has none.
  Result<uint16_t> material_of(const nlohmann::json& primitive, const std::string& where) {
    const auto index = file_.index(primitive, "material", "materials", where);
    if (!index) return index.error();
    std::string name;
    if (*index) {
      name = text_of(file_.element("materials", **index), "name");
      if (name.empty()) name = "material " + std::to_string(**index);
    }
    const auto [known, added] =
        material_numbers_.try_emplace(*index ? int64_t{**index} : -1, static_cast<uint16_t>(0));
    if (added) {
      constexpr size_t kMost = std::numeric_limits<uint16_t>::max();
      known->second = static_cast<uint16_t>(std::min(material_names_.size(), kMost));
      if (material_names_.size() <= kMost) {
        material_names_.push_back(name);
        materials_.push_back(*index);
      }
    }
    return known->second;
  }

  struct Target {
    Placed positions;
    uint16_t material;
    bool mirrors;
  };
  Problem read_triangles(const nlohmann::json& primitive, const std::string& where, uint64_t mode,
                         const Target& target) {
    const auto accessor = file_.index(primitive, "indices", "accessors", where);
    if (!accessor) return accessor.error();
    std::optional<GltfAccessor> indices;
    if (*accessor) {
      auto rows = GltfAccessor::indices(file_, **accessor);
      if (!rows) return rows.error();
      indices = *rows;
    }
    const size_t corners = indices ? indices->size() : target.positions.count;
    const size_t triangles = mode == kTriangles ? corners / 3 : corners < 3 ? 0 : corners - 2;
    if (triangles > kMaxTriangles - polygons_.size())
      return file_.wrong(where, "exceeds the maximum number of faces per glTF file");
    const auto corner = [&](size_t i) -> int64_t {
      const size_t v = indices ? indices->index(i) : i;
      return v < target.positions.count ? static_cast<int64_t>(target.positions.first + v) : -1;
    };
    for (size_t t = 0; t < triangles; ++t) {
      if (t % kBetweenReports == 0 && progress_ && !progress_->report(0)) return cancelled();
      std::array<size_t, 3> at{3 * t, 3 * t + 1, 3 * t + 2};
      if (mode == kStrip) at = {t, t + 1 + t % 2, t + 2 - t % 2};
      if (mode == kFan) at = {t + 1, t + 2, 0};
      if (target.mirrors) std::swap(at[1], at[2]);
      for (const size_t i : at) polygons_.add_corner(corner(i));
      polygons_.close(target.material);
    }
    return std::nullopt;
  }

  static constexpr size_t kBetweenReports = size_t{1} << 20;

  const GltfFile& file_;
  const std::string& name_;
  const Progress* progress_;
  const std::filesystem::path& folder_;
  std::vector<bool> seen_;  // by node
  std::vector<Open> open_;
  size_t instances_ = 0;  // of nodes with several
  std::vector<Vec3> positions_;
  std::vector<VertexColour> colours_;  // by position, up to the last coloured one
  PolygonList polygons_;
  std::map<uint32_t, std::vector<size_t>> drawn_;  // by mesh that was read: the primitives with triangles
  std::map<VertexAccessors, Placed> placed_;       // of the current mesh
  std::map<int64_t, uint16_t> material_numbers_;   // by material of the file, or -1
  std::vector<std::string> material_names_, warnings_;
  std::vector<std::optional<uint32_t>> materials_;  // by number: of the file
  std::vector<glm::vec3> normals_;                  // by position, up to the last one with a normal
  std::array<std::vector<glm::vec2>, kUvSets> uv_sets_;
  std::vector<glm::vec4> tangents_;
  std::vector<LookAttribute> attributes_;
  std::vector<std::string> attribute_keys_;  // of these, as in the file
  bool skinned_ = false, morphed_ = false, lines_ = false, uncoloured_ = false, unreadable_ = false;
  bool crowded_ = false, unreadable_attributes_ = false;
  bool more_uvs_ = false, more_colours_ = false, variants_ = false;
};

}  // namespace

Result<Soup> read_gltf(std::string_view bytes, const std::string& file_name, const Progress* progress,
                       const std::filesystem::path& folder) {
  const auto file = GltfFile::open(bytes, file_name, folder);
  if (!file) return file.error();
  auto soup = GltfReader(*file, file_name, progress, folder).read();
  if (soup) soup->format = GltfFile::is_binary(bytes) ? "glb" : "gltf";
  return soup;
}

}  // namespace kerf
