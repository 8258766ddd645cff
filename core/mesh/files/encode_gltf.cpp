#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/containers.h"
#include "core/base/json.h"
#include "core/base/random.h"
#include "core/mesh/files/bytes.h"
#include "core/mesh/files/encode.h"
#include "core/mesh/files/gltf_file_internal.h"
#include "core/mesh/files/split_vertices_internal.h"
#include "core/mesh/files/surface_conversion.h"

namespace kerf {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr size_t kColourBytes = 4 * sizeof(uint16_t);
constexpr int kVertexTarget = 34962, kIndexTarget = 34963;  // of buffer views

struct Box {
  Vec3 min{0}, max{0};

  Vec3 middle() const { return 0.5 * min + 0.5 * max; }
};

// Precondition: there are positions.
Box box_of(std::span<const Vec3> positions) {
  Box box{positions[0], positions[0]};
  for (const Vec3& p : positions) box = {glm::min(box.min, p), glm::max(box.max, p)};
  return box;
}

// Positions are floats relative to the middle of the mesh, which is the translation of the node, so that
// rounding is relative to the size of the mesh, wherever it is.
struct Floats {
  Vec3 middle{0};
  glm::vec3 low{0}, high{0};

  explicit Floats(std::span<const Vec3> positions) {
    if (positions.empty()) return;
    const Box box = box_of(positions);
    middle = box.middle();
    low = of(box.min);
    high = of(box.max);
  }
  glm::vec3 of(const Vec3& p) const { return glm::vec3(p - middle); }
};

// The triangle numbers of each material in use, in their order.
struct Group {
  uint16_t material;
  std::vector<uint32_t> triangles;
};

std::vector<Group> by_material(const MeshView& mesh) {
  std::vector<Group> groups;
  std::vector<uint32_t> group_of(mesh.material_names.size() + 1, 0);  // plus one
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const uint16_t material = mesh.materials.empty() ? uint16_t{0} : mesh.materials[t];
    if (material >= group_of.size()) group_of.resize(material + size_t{1}, 0);
    uint32_t& group = group_of[material];
    if (group == 0) {
      groups.push_back({material, {}});
      group = static_cast<uint32_t>(groups.size());
    }
    groups[group - 1].triangles.push_back(t);
  }
  return groups;
}

// Returns a vector with the length 1 that glTF requires of normals; any for zero. Keeps the bits of one that
// has it.
glm::vec3 unit_vector(const glm::vec3& v) {
  constexpr double kSlack = 1e-6;
  const double length = glm::length(Vec3(v));
  if (!(length > 0)) return {0, 1, 0};
  return std::abs(length - 1) <= kSlack ? v : glm::vec3(Vec3(v) / length);
}

OrderedJson list_of(const glm::vec3& v) { return {v.x, v.y, v.z}; }

// Writes U+FFFD for bytes that are not UTF-8.
std::string gltf_text(const OrderedJson& json) {
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

// A buffer view.
struct BufferPart {
  size_t offset, bytes;
  int target;  // 0: none
};

// A mesh with its collider in a glTF file to be written.
class GltfMesh {
 public:
  explicit GltfMesh(const MeshView& mesh)
      : mesh_(mesh), floats_(mesh.positions), vertices_(mesh, true, true), groups_(by_material(mesh)) {
    for (glm::vec3& normal : vertices_.normals) normal = unit_vector(normal);
  }

  // Lists the materials in use, in their order; nullopt for one without a name or a description.
  std::vector<std::optional<GltfMaterial>> materials() const {
    std::vector<std::optional<GltfMaterial>> used;
    for (const auto& [material, triangles] : groups_) {
      const std::string_view name =
          material < mesh_.material_names.size() ? mesh_.material_names[material] : std::string_view();
      const SurfaceLibrary* const library = mesh_.surfaces;
      const bool described =
          library && material < library->materials.size() &&
          (!library->materials[material].gltf.empty() || !library->materials[material].mtl.empty());
      used.emplace_back();
      if (!name.empty() || described) used.back() = {library, material, name};
    }
    return used;
  }
  // Sets the numbers of these in the file.
  void set_materials(std::vector<std::optional<size_t>> numbers) { materials_ = std::move(numbers); }

  // Appends the buffer views and adds their size: positions, indices, other values of vertices, the hull.
  void lay_out(std::vector<BufferPart>& parts, size_t& bytes) {
    first_view_ = parts.size();
    const size_t count = vertices_.count(mesh_);
    std::vector<size_t> sizes{count * 3 * sizeof(float)};
    if (!mesh_.colours.empty()) sizes.push_back(count * kColourBytes);
    if (!vertices_.normals.empty()) sizes.push_back(count * 3 * sizeof(float));
    if (!vertices_.tangents.empty()) sizes.push_back(count * 4 * sizeof(float));
    for (size_t set = 0; set < vertices_.uv_sets.size(); ++set) sizes.push_back(count * 2 * sizeof(float));
    for (size_t i = 0; i < vertices_.attributes.size(); ++i)
      sizes.push_back(count * mesh_.looks->attributes[i].parts * sizeof(float));
    const auto add = [&](size_t place, size_t size, int target) {
      parts.insert(parts.begin() + static_cast<std::ptrdiff_t>(place), {bytes, size, target});
      bytes += size;
    };
    for (const size_t size : sizes) add(parts.size(), size, kVertexTarget);
    add(first_view_ + 1, 3 * sizeof(uint32_t) * mesh_.triangles.size(), kIndexTarget);
    if (!has_hull()) return;
    hull_view_ = parts.size();
    add(parts.size(), mesh_.collider->positions.size() * 3 * sizeof(float), kVertexTarget);
    add(parts.size(), mesh_.collider->triangles.size() * 3 * sizeof(uint32_t), kIndexTarget);
  }

  // Appends the nodes, meshes and accessors. Precondition: set_materials() and lay_out() were called.
  void describe(OrderedJson& nodes, OrderedJson& meshes, OrderedJson& accessors) const {
    const size_t count = vertices_.count(mesh_);
    OrderedJson primitives = OrderedJson::array(), attributes;
    size_t view = first_view_;
    const auto add = [&](const std::string& name, OrderedJson more) {
      attributes[name] = accessors.size();
      OrderedJson accessor{{"bufferView", view}, {"count", count}};
      accessor.update(more);
      accessors.push_back(std::move(accessor));
      view += view == first_view_ ? 2 : 1;  // the second one has the indices
    };
    const auto add_floats = [&](const std::string& name, const char* type) {
      add(name, {{"componentType", kGltfFloat}, {"type", type}});
    };
    add("POSITION", {{"componentType", kGltfFloat},
                     {"type", "VEC3"},
                     {"min", list_of(floats_.low)},
                     {"max", list_of(floats_.high)}});
    if (!mesh_.colours.empty())
      add("COLOR_0", {{"componentType", kGltfShort}, {"normalized", true}, {"type", "VEC4"}});
    if (!vertices_.normals.empty()) add_floats("NORMAL", "VEC3");
    if (!vertices_.tangents.empty()) add_floats("TANGENT", "VEC4");
    for (size_t set = 0; set < vertices_.uv_sets.size(); ++set)
      add_floats("TEXCOORD_" + std::to_string(set), "VEC2");
    constexpr std::array<const char*, 4> kTypes{"SCALAR", "VEC2", "VEC3", "VEC4"};
    const std::vector<std::string> names = attribute_names();
    for (size_t i = 0; i < names.size(); ++i)
      add_floats(names[i], kTypes[mesh_.looks->attributes[i].parts - 1u]);
    size_t offset = 0;
    for (size_t g = 0; g < groups_.size(); ++g) {
      OrderedJson primitive{{"attributes", attributes}, {"indices", accessors.size()}};
      accessors.push_back({{"bufferView", first_view_ + 1},
                           {"byteOffset", offset},
                           {"componentType", kGltfInt},
                           {"count", 3 * groups_[g].triangles.size()},
                           {"type", "SCALAR"}});
      offset += 3 * sizeof(uint32_t) * groups_[g].triangles.size();
      if (materials_[g]) primitive["material"] = *materials_[g];
      primitives.push_back(std::move(primitive));
    }
    nodes.push_back(node_of(meshes.size(), mesh_.name));
    meshes.push_back({{"primitives", std::move(primitives)}});
    if (mesh_.collider) describe_collider(nodes, meshes, accessors);
  }

  // Writes the bytes of the buffer: positions, colours, normals, tangents, UVs, attributes, the indices of
  // each group, the hull of the collider.
  bool emit(const ByteSink& sink) const {
    const size_t count = vertices_.count(mesh_);
    const auto append_positions = [&](size_t i, size_t end, std::string& part) {
      for (; i < end; ++i) {
        const glm::vec3 p = floats_.of(mesh_.positions[vertices_.position(i)]);
        for (int k = 0; k < 3; ++k) append_little(p[k], part);
      }
    };
    const auto append_colours = [&](size_t i, size_t end, std::string& part) {
      for (; i < end; ++i) {
        const VertexColour& c = mesh_.colours[vertices_.position(i)];
        for (size_t k = 0; k < VertexColour::kOpacity; ++k)
          append_little(colour_part(linear_light(c.part[k])), part);
        append_little(c.part[VertexColour::kOpacity], part);
      }
    };
    const auto emit_parts = [&](const auto& values, int parts) {
      return emit_ranges(values.size(), sink, [&](size_t i, size_t end, std::string& part) {
        for (; i < end; ++i) {
          for (int k = 0; k < parts; ++k) append_little(values[i][k], part);
        }
      });
    };
    const auto emit_vectors = [&](const auto& values) {
      return emit_parts(values, std::decay_t<decltype(values[0])>::length());
    };
    if (!emit_ranges(count, sink, append_positions)) return false;
    if (!mesh_.colours.empty() && !emit_ranges(count, sink, append_colours)) return false;
    if (!emit_vectors(vertices_.normals) || !emit_vectors(vertices_.tangents)) return false;
    for (const auto& set : vertices_.uv_sets) {
      if (!emit_vectors(set)) return false;
    }
    for (size_t i = 0; i < vertices_.attributes.size(); ++i) {
      if (!emit_parts(vertices_.attributes[i], mesh_.looks->attributes[i].parts)) return false;
    }
    const auto triangles = vertices_.triangles(mesh_);
    for (const Group& group : groups_) {
      const bool done =
          emit_ranges(group.triangles.size(), sink, [&](size_t i, size_t end, std::string& part) {
            for (; i < end; ++i) {
              for (const uint32_t v : triangles[group.triangles[i]]) append_little(v, part);
            }
          });
      if (!done) return false;
    }
    return !has_hull() || sink(hull_bytes());
  }

 private:
  // Returns the distinct names of the custom attributes in the file.
  std::vector<std::string> attribute_names() const {
    std::vector<std::string> names;
    for (size_t i = 0; i < vertices_.attributes.size(); ++i) {
      const std::string text = gltf_text("_" + mesh_.looks->attributes[i].name);
      names.push_back(OrderedJson::parse(text).get<std::string>());
    }
    return distinct_names(std::move(names));
  }

  OrderedJson node_of(size_t mesh, std::string_view name) const {
    const Vec3& middle = floats_.middle;
    OrderedJson node{{"mesh", mesh}, {"translation", {middle.x, middle.y, middle.z}}};
    if (!name.empty()) node["name"] = std::string(name);
    return node;
  }

  bool has_hull() const { return mesh_.collider && !mesh_.collider->triangles.empty(); }

  // Adds the mass properties to the last node, and a node with the hull.
  void describe_collider(OrderedJson& nodes, OrderedJson& meshes, OrderedJson& accessors) const {
    const NodeCollider& collider = *mesh_.collider;
    const Vec3 centre = collider.centre_of_mass - floats_.middle;
    nodes.back()["extras"] = {{"mass", collider.mass},
                              {"centre_of_mass", {centre.x, centre.y, centre.z}},
                              {"inertia", collider.inertia}};
    if (!has_hull()) return;
    // Engines refer to the mesh by its name, too.
    if (!mesh_.name.empty()) meshes.back()["name"] = std::string(mesh_.name);
    nodes.push_back(node_of(meshes.size(), collider.name));
    const OrderedJson primitive{{"attributes", {{"POSITION", accessors.size()}}},
                                {"indices", accessors.size() + 1}};
    meshes.push_back({{"name", collider.name}, {"primitives", OrderedJson::array({primitive})}});
    const Box box = box_of(collider.positions);
    accessors.push_back({{"bufferView", hull_view_},
                         {"componentType", kGltfFloat},
                         {"count", collider.positions.size()},
                         {"type", "VEC3"},
                         {"min", list_of(floats_.of(box.min))},
                         {"max", list_of(floats_.of(box.max))}});
    accessors.push_back({{"bufferView", hull_view_ + 1},
                         {"componentType", kGltfInt},
                         {"count", 3 * collider.triangles.size()},
                         {"type", "SCALAR"}});
  }

  std::string hull_bytes() const {
    std::string bytes;
    for (const Vec3& p : mesh_.collider->positions) {
      const glm::vec3 own = floats_.of(p);
      for (int k = 0; k < 3; ++k) append_little(own[k], bytes);
    }
    for (const auto& triangle : mesh_.collider->triangles) {
      for (const uint32_t v : triangle) append_little(v, bytes);
    }
    return bytes;
  }

  const MeshView& mesh_;
  Floats floats_;
  SplitVertices vertices_;
  std::vector<Group> groups_;
  std::vector<std::optional<size_t>> materials_;  // by group
  size_t first_view_ = 0, hull_view_ = 0;
};

// A glTF file to be written: its meshes, materials and the layout of its buffer.
class GltfDocument {
 public:
  explicit GltfDocument(std::span<const MeshView> meshes) {
    std::vector<GltfMaterial> used;
    std::map<GltfMaterial, size_t> numbers;
    for (const MeshView& mesh : meshes) {
      std::vector<std::optional<size_t>> own;
      for (const auto& material : meshes_.emplace_back(mesh).materials()) {
        own.emplace_back();
        if (!material) continue;
        const auto [known, added] = numbers.try_emplace(*material, used.size());
        if (added) used.push_back(*material);
        own.back() = known->second;
      }
      meshes_.back().set_materials(std::move(own));
      meshes_.back().lay_out(parts_, bytes_);
    }
    surfaces_ = gltf_surfaces(used);
    first_image_view_ = parts_.size();
    for (const SurfaceImage* image : surfaces_.sources) {
      parts_.push_back({bytes_, image->bytes.size(), 0});
      bytes_ += image->bytes.size() + padding(image->bytes.size());
    }
  }

  size_t bytes() const { return bytes_; }

  OrderedJson describe() const {
    OrderedJson nodes = OrderedJson::array(), meshes = nodes, accessors = nodes, roots = nodes;
    for (const GltfMesh& mesh : meshes_) mesh.describe(nodes, meshes, accessors);
    OrderedJson json{{"asset", {{"version", "2.0"}, {"generator", "Kerf"}}}, {"scene", 0}};
    if (!surfaces_.used_extensions.empty()) json["extensionsUsed"] = surfaces_.used_extensions;
    if (!surfaces_.required_extensions.empty()) json["extensionsRequired"] = surfaces_.required_extensions;
    for (size_t i = 0; i < nodes.size(); ++i) roots.push_back(i);
    json["scenes"] = OrderedJson::array({OrderedJson{{"nodes", std::move(roots)}}});
    json["nodes"] = std::move(nodes);
    json["meshes"] = std::move(meshes);
    if (!surfaces_.materials.empty()) json["materials"] = surfaces_.materials;
    if (!surfaces_.textures.empty()) json["textures"] = surfaces_.textures;
    if (!surfaces_.samplers.empty()) json["samplers"] = surfaces_.samplers;
    json["accessors"] = std::move(accessors);
    json["bufferViews"] = OrderedJson::array();
    for (const BufferPart& part : parts_) {
      OrderedJson own{{"buffer", 0}};
      if (part.offset > 0) own["byteOffset"] = part.offset;
      own["byteLength"] = part.bytes;
      if (part.target != 0) own["target"] = part.target;
      json["bufferViews"].push_back(std::move(own));
    }
    if (!surfaces_.images.empty()) {
      json["images"] = surfaces_.images;
      for (size_t i = 0; i < surfaces_.images.size(); ++i)
        json["images"][i]["bufferView"] = first_image_view_ + i;
    }
    json["buffers"] = OrderedJson::array({OrderedJson{{"byteLength", bytes_}}});
    return json;
  }

  // Writes the buffer: the meshes, then the images.
  bool emit_buffer(const ByteSink& sink) const {
    for (const GltfMesh& mesh : meshes_) {
      if (!mesh.emit(sink)) return false;
    }
    for (const SurfaceImage* image : surfaces_.sources) {
      if (!sink(image->bytes) || !sink(std::string(padding(image->bytes.size()), '\0'))) return false;
    }
    return true;
  }

 private:
  static size_t padding(size_t bytes) { return (4 - bytes % 4) % 4; }

  std::deque<GltfMesh> meshes_;
  GltfSurfaces surfaces_;
  std::vector<BufferPart> parts_;
  size_t first_image_view_ = 0, bytes_ = 0;
};

}  // namespace

std::vector<uint32_t> gltf_order(const MeshView& mesh) {
  std::vector<uint32_t> order;
  for (const Group& group : by_material(mesh))
    order.insert(order.end(), group.triangles.begin(), group.triangles.end());
  return order;
}

Vec3 gltf_middle(std::span<const Vec3> positions) {
  return positions.empty() ? Vec3(0) : box_of(positions).middle();
}

void encode_glb(std::span<const MeshView> meshes, const ByteSink& sink) {
  const GltfDocument document(meshes);
  std::string text = gltf_text(document.describe());
  text.append((4 - text.size() % 4) % 4, ' ');
  std::string head;
  for (const uint32_t word :
       {kGlbMagic, kGlbVersion, static_cast<uint32_t>(28 + text.size() + document.bytes()),
        static_cast<uint32_t>(text.size()), kGlbJson}) {
    append_little(word, head);
  }
  head += text;
  append_little(static_cast<uint32_t>(document.bytes()), head);
  append_little(kGlbBinary, head);
  if (sink(head)) document.emit_buffer(sink);
}

void encode_gltf(std::span<const MeshView> meshes, const ByteSink& sink) {
  const GltfDocument document(meshes);
  std::string buffer;
  document.emit_buffer([&](std::string_view part) {
    buffer += part;
    return true;
  });
  OrderedJson json = document.describe();
  json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + to_base64(buffer);
  sink(gltf_text(json) + "\n");
}

}  // namespace kerf
