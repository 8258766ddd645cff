#include "ui/editor/shared/picture/shadow_methods.h"

#include <algorithm>
#include <array>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr std::array kMethods{
    MethodWords{
        ShadowMethod::kRobust, "Robust",
        "Every polygon spans a closed volume without end; counted from behind. Right for any mesh and any "
        "eye."},
    MethodWords{
        ShadowMethod::kPaperOneVolume, "Paper, one volume",
        "The silhouette of the polygons that face the light, extruded so far and left open. Right for closed "
        "meshes while the eye is in the light."},
    MethodWords{ShadowMethod::kPaperTwoVolumes, "Paper, two volumes",
                "Another volume for the averted polygons: the paper's answer for hollow meshes."},
};

}  // namespace

std::span<const MethodWords> shadow_methods() { return kMethods; }

const char* method_name(ShadowMethod method) {
  const auto found =
      std::find_if(kMethods.begin(), kMethods.end(), [&](const auto& m) { return m.method == method; });
  KERF_ASSERT(found != kMethods.end());
  return found->name;
}

}  // namespace kerf
