#include "core/document/lost_looks.h"

#include <algorithm>
#include <array>
#include <functional>

#include "core/base/assert.h"
#include "core/base/number_format.h"
#include "core/mesh/files/scanner.h"
#include "core/mesh/files/surface_conversion.h"
#include "core/mesh/looks.h"

namespace kerf {

namespace {

// A kind of looks that a format cannot represent.
struct LostKind {
  std::string name;
  // Returns true if a face has such looks: by the loaded face that contains it, which may be invalid, and by
  // its material.
  std::function<bool(FaceId source, uint16_t material)> is_of;
};

std::set<uint16_t> materials_of(const Extract& extract) {
  if (extract.materials.empty()) return {0};
  return {extract.materials.begin(), extract.materials.end()};
}

bool has_images(const SurfaceLibrary& library, uint16_t number) {
  const SurfaceMaterial& material = library.materials[number];
  if (material.gltf.empty())
    return std::ranges::any_of(material.mtl, [](const MtlLine& line) { return line.image.has_value(); });
  return !gltf_surfaces(std::array{GltfMaterial{&library, number}}, MissingImages::kKeep).sources.empty();
}

void add_kinds_of_looks(const Looks& looks, MeshFormat format, std::vector<LostKind>& kinds) {
  const MeshFormatRow& row = format_row(format);
  const auto add_uvs = [&](const char* name, size_t first) {
    if (looks.uv_sets() <= first) return;
    kinds.push_back({name, [&looks, first](FaceId source, uint16_t) {
                       for (size_t set = first; set < looks.uv_sets(); ++set) {
                         if (looks.has_uvs(set, source)) return true;
                       }
                       return false;
                     }});
  };
  if (!row.uvs_and_normals) {
    add_uvs("UVs", 0);
    if (looks.has_normals())
      kinds.push_back({"normals", [&looks](FaceId source, uint16_t) { return looks.has_normal(source); }});
  } else if (!is_gltf(format)) {
    add_uvs("second UVs", 1);
  }
  if (looks.has_tangents() && !is_gltf(format))
    kinds.push_back({"tangents", [&looks](FaceId source, uint16_t) { return looks.has_tangent(source); }});
  for (size_t i = 0; i < looks.attributes() && !row.attributes; ++i) {
    kinds.push_back({"attribute " + in_quotes(looks.attribute_name(i)),
                     [&looks, i](FaceId source, uint16_t) { return looks.has_attribute(i, source); }});
  }
}

void add_kinds_of_materials(const Body& body, const Extract& extract, MeshFormat format,
                            std::vector<LostKind>& kinds) {
  const MeshFormatRow& row = format_row(format);
  const auto is_named = [&body](FaceId, uint16_t material) {
    const auto& names = body.material_names;
    return material < names.size() && !names[material].empty() && names[material] != body.cut_material;
  };
  if (!row.materials && !body.material_names.empty()) kinds.push_back({"materials", is_named});
  if (body.looks && body.looks->surfaces() && !row.textures) {
    const SurfaceLibrary& library = *body.looks->surfaces();
    std::set<uint16_t> textured = materials_of(extract);
    std::erase_if(textured,
                  [&](uint16_t m) { return m >= library.materials.size() || !has_images(library, m); });
    if (!textured.empty())
      kinds.push_back(
          {"textures", [textured](FaceId, uint16_t material) { return textured.contains(material); }});
  }
  if (extract.colours.empty()) return;
  if (format == MeshFormat::kStl) kinds.push_back({"vertex colours", [](FaceId, uint16_t) { return true; }});
  if (format == MeshFormat::k3mf) kinds.push_back({"materials with vertex colours", is_named});
}

}  // namespace

void LostLooks::add(const Body& body, std::span<const FaceId> faces, const Extract& extract,
                    MeshFormat format) {
  KERF_ASSERT(faces.size() == extract.triangles.size());
  if (faces.empty()) return;
  add_faces(body, faces, extract, format);
  add_materials(body, extract, format);
}

void LostLooks::add_faces(const Body& body, std::span<const FaceId> faces, const Extract& extract,
                          MeshFormat format) {
  std::vector<LostKind> kinds;
  if (body.looks) add_kinds_of_looks(*body.looks, format, kinds);
  add_kinds_of_materials(body, extract, format, kinds);
  std::vector<bool> is_lost(kinds.size());
  for (size_t i = 0; i < faces.size() && !kinds.empty(); ++i) {
    const FaceId source = body.loaded_source(faces[i]);
    const uint16_t material = extract.materials.empty() ? uint16_t{0} : extract.materials[i];
    bool loses_any = false;
    for (size_t k = 0; k < kinds.size(); ++k) {
      if (kinds[k].is_of(source, material)) is_lost[k] = loses_any = true;
    }
    faces_ += loses_any;
  }
  for (size_t k = 0; k < kinds.size(); ++k) {
    if (is_lost[k] && std::ranges::find(kinds_, kinds[k].name) == kinds_.end())
      kinds_.push_back(kinds[k].name);
  }
}

void LostLooks::add_materials(const Body& body, const Extract& extract, MeshFormat format) {
  const Looks* looks = body.looks.get();
  if (!looks || !looks->surfaces() || !format_row(format).materials) return;
  for (const uint16_t m : materials_of(extract)) {
    if (m >= looks->surfaces()->materials.size()) continue;
    const SurfaceMaterial& material = looks->surfaces()->materials[m];
    const auto members = is_gltf(format)              ? lost_in_gltf(*looks->surfaces(), material)
                         : format == MeshFormat::k3mf ? lost_in_3mf(material)
                                                      : lost_in_mtl(*looks->surfaces(), material);
    if (members.empty()) continue;
    materials_.insert(&material);
    members_.insert(members.begin(), members.end());
  }
}

void LostLooks::add_notes(MeshFormat format, std::vector<std::string>& notes) const {
  const std::string title =
      std::string(format_row(format).title) + (format == MeshFormat::kPly ? " as written by Kerf" : "");
  if (faces_ > 0) {
    notes.push_back(title + " holds no " + listed(kinds_) + ": " + count_text(faces_, "face") +
                    (faces_ == 1 ? " loses its" : " lose theirs"));
  }
  if (!members_.empty()) {
    notes.push_back(title + " holds no " + listed(std::vector(members_.begin(), members_.end())) + ": " +
                    count_text(materials_.size(), "material") +
                    (materials_.size() == 1 ? " loses its" : " lose theirs"));
  }
}

}  // namespace kerf
