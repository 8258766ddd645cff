#include "core/world/solid_body.h"

#include <algorithm>
#include <limits>

#include "core/world/weigh.h"

namespace kerf {

void make_solid(Body& body, bool solid) {
  body.solid = solid;
  if (solid && !cut_material(body)) {
    if (body.material_names.empty()) body.material_names.emplace_back();
    if (body.material_names.size() <= std::numeric_limits<uint16_t>::max())
      body.material_names.emplace_back(kCutMaterial);
  }
  weigh(body);
}

std::optional<uint16_t> cut_material(const Body& body) {
  const auto& names = body.material_names;
  const auto at = std::find(names.begin(), names.end(), kCutMaterial);
  if (at == names.end()) return std::nullopt;
  return static_cast<uint16_t>(at - names.begin());
}

}  // namespace kerf
