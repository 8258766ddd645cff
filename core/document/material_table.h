#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/heat/material.h"

namespace kerf {

class Fields;

// Reads a table of materials (assets/materials.json), in its order:
//
//   {"units", "note": texts for people,
//    "materials": [{"name", "title", "removed_by": "melting" or "ablation", "wavelength", "density",
//                   "heat_solid", "heat_liquid", "conductivity", "transition", "latent", "emissivity",
//                   "absorptivity_fibre", "absorptivity_co2"}, ...]}
//
// Each number except the wavelength (m, of the usual laser for the material) is an object {"value",
// "range": [min, max], "source"} in SI units. A material removed by ablation has "heat_of_ablation", the
// total from ambient temperature, instead of "latent". Errors are one sentence with the file and the place,
// e.g. for a value outside of its range or a duplicate name.
Result<std::vector<Material>> load_materials(const std::filesystem::path& file);
void describe(Fields& f, Material& material);

}  // namespace kerf
