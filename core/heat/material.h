#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/interval.h"
#include "core/heat/substance.h"

namespace kerf {

// One constant of a material and where it is from.
struct MaterialNumber {
  std::string key;   // as in assets/materials.json
  double value = 0;  // in SI units
  Interval range;    // of the values that were published
  std::string source;
};

// A material that can be cut, by the name that the command line and scenes use.
struct Material {
  std::string name;        // "mild-steel"
  std::string title;       // "Mild steel"
  std::string removed_by;  // "melting" or "ablation"
  Substance substance;
  std::vector<MaterialNumber> numbers;  // all of them, in the order of the file
};

// The material of that name; null where there is none.
inline const Material* find_material(std::span<const Material> materials, const std::string& name) {
  for (const Material& material : materials) {
    if (material.name == name) return &material;
  }
  return nullptr;
}

}  // namespace kerf
