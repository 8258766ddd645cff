#include "core/document/material_reader.h"

#include <array>

#include "core/document/json_value.h"

namespace kerf {
namespace {

// A constant in the file, where it goes, and the limits within which it makes sense.
struct Constant {
  const char* key;
  double& target;
  double least, most;
};

Result<MaterialNumber> read_number(const JsonValue& material, const Constant& constant) {
  if (!material.has(constant.key)) return material.wrong("needs \"" + std::string(constant.key) + "\"");
  const JsonValue entry = material[constant.key];
  for (const char* member : {"value", "range", "source"}) {
    if (!entry.has(member)) return entry.wrong("needs \"" + std::string(member) + "\"");
  }
  const auto value = entry["value"].number();
  if (!value) return value.error();
  const auto range = entry["range"].interval();
  if (!range) return range.error();
  const auto source = entry["source"].text();
  if (!source) return source.error();
  if (*value < range->low || *value > range->high) return entry["value"].wrong("is outside of its range");
  if (*value < constant.least || *value > constant.most)
    return entry["value"].wrong("is not possible for \"" + std::string(constant.key) + "\"");
  if (source->empty()) return entry["source"].wrong("must say where the value is from");
  return MaterialNumber{constant.key, *value, *range, *source};
}

std::array<Constant, 9> constants(Substance& s, bool ablates) {
  return {{{"density", s.density, 1e-3, 1e6},
           {"heat_solid", s.heat_solid, 1e-3, 1e6},
           {"heat_liquid", s.heat_liquid, 1e-3, 1e6},
           {"conductivity", s.conductivity, 0, 1e6},
           {"transition", s.transition, kAmbient + 1, 1e5},
           {ablates ? "heat_of_ablation" : "latent", s.latent, 0, 1e9},
           {"emissivity", s.emissivity, 0, 1},
           {"absorptivity_fibre", s.absorptivity_fibre, 0, 1},
           {"absorptivity_co2", s.absorptivity_co2, 0, 1}}};
}

Status read_texts(const JsonValue& json, Material& material) {
  const std::array<std::pair<const char*, std::string*>, 3> texts{
      {{"name", &material.name}, {"title", &material.title}, {"removed_by", &material.removed_by}}};
  for (const auto& [key, target] : texts) {
    if (!json.has(key)) return json.wrong("needs \"" + std::string(key) + "\"");
    const auto text = json[key].text();
    if (!text) return text.error();
    if (text->empty()) return json[key].wrong("must not be empty");
    *target = *text;
  }
  if (material.removed_by != "melting" && material.removed_by != "ablation")
    return json["removed_by"].wrong("must be \"melting\" or \"ablation\"");
  return Done{};
}

Result<Material> read_material(const JsonValue& json) {
  if (const Status object = json.object(); !object) return object.error();
  Material material;
  if (const Status texts = read_texts(json, material); !texts) return texts.error();
  Substance& substance = material.substance;
  if (!json.has("wavelength")) return json.wrong("needs \"wavelength\"");
  const auto wavelength = json["wavelength"].positive_number();
  if (!wavelength) return wavelength.error();
  substance.wavelength = *wavelength;

  const bool ablates = material.removed_by == "ablation";
  for (const Constant& constant : constants(substance, ablates)) {
    const auto number = read_number(json, constant);
    if (!number) return number.error();
    constant.target = number->value;
    material.numbers.push_back(*number);
  }
  if (!ablates) return material;
  substance.latent -= enthalpy_before_transition(substance);
  if (substance.latent < 0)
    return json["heat_of_ablation"]["value"].wrong(
        "is less than it takes to heat the material to its transition");
  return material;
}

}  // namespace

Result<std::vector<Material>> parse_materials(std::string_view text, const std::string& file) {
  const auto json = parse_json(text, file);
  if (!json) return json.error();
  const JsonValue root(*json, file);
  if (!root.has("materials")) return root.wrong("needs \"materials\"");
  const JsonValue list = root["materials"];
  if (const Status array = list.array("materials"); !array) return array.error();
  std::vector<Material> materials;
  for (size_t i = 0; i < list.json().size(); ++i) {
    auto material = read_material(list[i]);
    if (!material) return material.error();
    if (find_material(materials, material->name) != nullptr)
      return list[i]["name"].wrong("another material has the same name");
    materials.push_back(std::move(*material));
  }
  if (materials.empty()) return list.wrong("must have at least one material");
  return materials;
}

Result<std::vector<Material>> load_materials(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return parse_materials(*text, file.string());
}

}  // namespace kerf
