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
// Each number but the wavelength (m, with which the material is usually cut) is an object {"value", "range":
// [least, most], "source"} in SI units. What is removed by ablation has "heat_of_ablation" in place of
// "latent": the whole of it from the ambient on. The error is one sentence that names the file and the place,
// e.g. a value outside of its range or a second material of the same name.
Result<std::vector<Material>> load_materials(const std::filesystem::path& file);
// The table of the fields of a material.
void describe(Fields& f, Material& material);

}  // namespace kerf
