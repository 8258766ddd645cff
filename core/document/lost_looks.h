#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/document/extract.h"
#include "core/mesh/files/mesh_format.h"

namespace kerf {

// Counts the looks (UVs, normals and materials) that a file format cannot represent, by kind of loss.
class LostLooks {
 public:
  // Adds the losses of faces of a body, by face and by material. Precondition: the extract is that of these
  // faces. Linear time.
  void add(const Body& body, std::span<const FaceId> faces, const Extract& extract, MeshFormat format);
  // Appends a sentence for the user about the losses of faces, and one about those of materials.
  void add_notes(MeshFormat format, std::vector<std::string>& notes) const;

 private:
  void add_faces(const Body& body, std::span<const FaceId> faces, const Extract& extract, MeshFormat format);
  void add_materials(const Body& body, const Extract& extract, MeshFormat format);

  std::vector<std::string> kinds_;
  size_t faces_ = 0;
  std::set<std::string> members_;
  std::set<const SurfaceMaterial*> materials_;
};

}  // namespace kerf
