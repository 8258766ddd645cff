#include "core/document/lost_looks.h"

#include <algorithm>

#include "core/base/number_format.h"
#include "core/mesh/files/scanner.h"
#include "core/mesh/files/surface_conversion.h"
#include "core/mesh/looks.h"

namespace kerf {

void LostLooks::add(const Body& body, const Extract& extract, MeshFormat format) {
  const MeshFormatRow& row = format_row(format);
  const Looks* looks = body.looks.get();
  std::vector<std::string> lost;
  const size_t uv_sets = looks ? looks->uv_sets() : 0;
  if (uv_sets > 0 && !row.uvs_and_normals) lost.emplace_back("UVs");
  if (uv_sets > 1 && row.uvs_and_normals && !is_gltf(format)) lost.emplace_back("second UVs");
  if (looks && looks->has_normals() && !row.uvs_and_normals) lost.emplace_back("normals");
  if (looks && looks->has_tangents() && !is_gltf(format)) lost.emplace_back("tangents");
  for (size_t i = 0; looks && i < looks->attributes() && !row.attributes; ++i)
    lost.push_back("attribute " + in_quotes(looks->attribute_name(i)));
  const bool names = std::ranges::any_of(
      body.material_names, [&](const std::string& n) { return !n.empty() && n != body.cut_material; });
  if (names && !row.materials) lost.emplace_back("materials");
  const bool textures = looks && looks->surfaces() && !looks->surfaces()->images.empty();
  if (textures && !row.textures) lost.emplace_back("textures");
  if (!extract.colours.empty() && format == MeshFormat::kStl) lost.emplace_back("vertex colours");
  if (!extract.colours.empty() && names && format == MeshFormat::k3mf)
    lost.emplace_back("materials with vertex colours");
  if (!lost.empty()) faces_ += extract.triangles.size();
  for (const std::string& what : lost) {
    if (std::ranges::find(kinds_, what) == kinds_.end()) kinds_.push_back(what);
  }
  if (!looks || !looks->surfaces() || !row.materials) return;
  for (const uint16_t m : std::set<uint16_t>(extract.materials.begin(), extract.materials.end())) {
    if (m >= looks->surfaces()->materials.size()) continue;
    const SurfaceMaterial& material = looks->surfaces()->materials[m];
    const auto members = is_gltf(format)              ? lost_in_gltf(*looks->surfaces(), material)
                         : format == MeshFormat::k3mf ? lost_in_3mf(material)
                                                      : lost_in_mtl(material);
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
