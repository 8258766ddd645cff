#include "core/mesh/files/encode.h"

#include <algorithm>

namespace kerf {

bool MeshView::any_translucent() const {
  return std::any_of(colours.begin(), colours.end(), [](const VertexColour& c) {
    return c.part[VertexColour::kOpacity] != VertexColour::kFull;
  });
}

void encode(const MeshView& mesh, MeshFormat format, const ByteSink& sink) {
  switch (format) {
    case MeshFormat::kObj:
      return encode_obj(mesh, sink);
    case MeshFormat::kPly:
      return encode_ply(mesh, sink);
    case MeshFormat::kStl:
      return encode_stl(mesh, sink);
    case MeshFormat::kOff:
      return encode_off(mesh, sink);
    case MeshFormat::kGlb:
      return encode_glb(mesh, sink);
    case MeshFormat::kGltf:
      return encode_gltf(mesh, sink);
  }
}

std::string encoded(const MeshView& mesh, MeshFormat format) {
  std::string bytes;
  encode(mesh, format, [&](std::string_view part) {
    bytes += part;
    return true;
  });
  return bytes;
}

}  // namespace kerf
