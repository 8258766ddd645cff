#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/json.h"
#include "core/mesh/files/bytes.h"
#include "core/mesh/files/encode.h"
#include "core/mesh/files/gltf_file_internal.h"

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

OrderedJson list_of(const glm::vec3& v) { return {v.x, v.y, v.z}; }

OrderedJson describe(const MeshView& mesh, const Floats& floats, const std::vector<Group>& groups,
                     size_t bytes) {
  const size_t position_bytes = mesh.positions.size() * 3 * sizeof(float),
               vertex_bytes = position_bytes + mesh.colours.size() * kColourBytes;
  OrderedJson primitives = OrderedJson::array(), materials = OrderedJson::array(),
              accessors = OrderedJson::array();
  accessors.push_back({{"bufferView", 0},
                       {"componentType", kGltfFloat},
                       {"count", mesh.positions.size()},
                       {"type", "VEC3"},
                       {"min", list_of(floats.low)},
                       {"max", list_of(floats.high)}});
  OrderedJson attributes{{"POSITION", 0}};
  if (!mesh.colours.empty()) {
    attributes["COLOR_0"] = accessors.size();
    accessors.push_back({{"bufferView", 2},
                         {"componentType", kGltfShort},
                         {"normalized", true},
                         {"count", mesh.colours.size()},
                         {"type", "VEC4"}});
  }
  size_t offset = 0;
  for (const Group& group : groups) {
    OrderedJson primitive{{"attributes", attributes}, {"indices", accessors.size()}};
    accessors.push_back({{"bufferView", 1},
                         {"byteOffset", offset},
                         {"componentType", kGltfInt},
                         {"count", 3 * group.triangles.size()},
                         {"type", "SCALAR"}});
    offset += 3 * sizeof(uint32_t) * group.triangles.size();
    if (group.material < mesh.material_names.size() && !mesh.material_names[group.material].empty()) {
      primitive["material"] = materials.size();
      materials.push_back({{"name", mesh.material_names[group.material]}});
    }
    primitives.push_back(std::move(primitive));
  }
  OrderedJson node{{"mesh", 0}, {"translation", {floats.middle.x, floats.middle.y, floats.middle.z}}};
  if (!mesh.name.empty()) node["name"] = std::string(mesh.name);
  OrderedJson json{{"asset", {{"version", "2.0"}, {"generator", "Kerf"}}}, {"scene", 0}};
  json["scenes"] = OrderedJson::array({OrderedJson{{"nodes", OrderedJson::array({0})}}});
  json["nodes"] = OrderedJson::array({std::move(node)});
  json["meshes"] = OrderedJson::array({OrderedJson{{"primitives", std::move(primitives)}}});
  if (!materials.empty()) json["materials"] = std::move(materials);
  json["accessors"] = std::move(accessors);
  json["bufferViews"] = OrderedJson::array(
      {OrderedJson{{"buffer", 0}, {"byteLength", position_bytes}, {"target", kVertexTarget}},
       OrderedJson{{"buffer", 0},
                   {"byteOffset", vertex_bytes},
                   {"byteLength", bytes - vertex_bytes},
                   {"target", kIndexTarget}}});
  if (!mesh.colours.empty()) {
    json["bufferViews"].push_back({{"buffer", 0},
                                   {"byteOffset", position_bytes},
                                   {"byteLength", vertex_bytes - position_bytes},
                                   {"target", kVertexTarget}});
  }
  json["buffers"] = OrderedJson::array({OrderedJson{{"byteLength", bytes}}});
  return json;
}

// Writes the bytes of the buffer: positions, colours, then the indices of each group.
bool emit_buffer(const MeshView& mesh, const Floats& floats, const std::vector<Group>& groups,
                 const ByteSink& sink) {
  const auto append_positions = [&](size_t i, size_t end, std::string& part) {
    for (; i < end; ++i) {
      const glm::vec3 p = floats.of(mesh.positions[i]);
      for (int k = 0; k < 3; ++k) append_little(p[k], part);
    }
  };
  const auto append_colours = [&](size_t i, size_t end, std::string& part) {
    for (; i < end; ++i) {
      const VertexColour& c = mesh.colours[i];
      for (size_t k = 0; k < VertexColour::kOpacity; ++k)
        append_little(colour_part(linear_light(c.part[k])), part);
      append_little(c.part[VertexColour::kOpacity], part);
    }
  };
  if (!emit_ranges(mesh.positions.size(), sink, append_positions) ||
      !emit_ranges(mesh.colours.size(), sink, append_colours))
    return false;
  return std::all_of(groups.begin(), groups.end(), [&](const Group& group) {
    return emit_ranges(group.triangles.size(), sink, [&](size_t i, size_t end, std::string& part) {
      for (; i < end; ++i) {
        for (const uint32_t v : mesh.triangles[group.triangles[i]]) append_little(v, part);
      }
    });
  });
}

size_t buffer_size(const MeshView& mesh) {
  return 3 * (sizeof(float) * mesh.positions.size() + sizeof(uint32_t) * mesh.triangles.size()) +
         kColourBytes * mesh.colours.size();
}

std::string gltf_text(const OrderedJson& json) {
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

}  // namespace

Vec3 gltf_middle(std::span<const Vec3> positions) {
  return positions.empty() ? Vec3(0) : box_of(positions).middle();
}

void encode_glb(const MeshView& mesh, const ByteSink& sink) {
  const Floats floats(mesh.positions);
  const std::vector<Group> groups = by_material(mesh);
  const size_t bytes = buffer_size(mesh);
  std::string text = gltf_text(describe(mesh, floats, groups, bytes));
  text.append((4 - text.size() % 4) % 4, ' ');
  std::string head;
  for (const uint32_t word : {kGlbMagic, kGlbVersion, static_cast<uint32_t>(28 + text.size() + bytes),
                              static_cast<uint32_t>(text.size()), kGlbJson}) {
    append_little(word, head);
  }
  head += text;
  append_little(static_cast<uint32_t>(bytes), head);
  append_little(kGlbBinary, head);
  if (sink(head)) emit_buffer(mesh, floats, groups, sink);
}

void encode_gltf(const MeshView& mesh, const ByteSink& sink) {
  const Floats floats(mesh.positions);
  const std::vector<Group> groups = by_material(mesh);
  std::string buffer;
  emit_buffer(mesh, floats, groups, [&](std::string_view part) {
    buffer += part;
    return true;
  });
  OrderedJson json = describe(mesh, floats, groups, buffer.size());
  json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + to_base64(buffer);
  sink(gltf_text(json) + "\n");
}

}  // namespace kerf
