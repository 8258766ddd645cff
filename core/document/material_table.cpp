#include "core/document/material_table.h"

#include "core/document/text/fields.h"

namespace kerf {

static void describe(Fields& f, MaterialNumber& number) {
  f.number("value", number.value, kFinite);
  f.interval("range", number.range);
  f.text("source", number.source);
  f.check(number.value >= number.range.low && number.value <= number.range.high, "value",
          "is outside its range");
  f.check(!number.source.empty(), "source", "must state the source of the value");
}

namespace {

void sourced_field(Fields& f, const NumberField<Substance>& field, Material& material,
                   MaterialNumber& number) {
  Substance& substance = material.substance;
  const bool whole = field.member == &Substance::latent && material.removed_by == "ablation";
  number.key = whole ? "heat_of_ablation" : field.name;
  f.member(number.key.c_str(), kNeeded, [&](Fields& of_number) {
    describe(of_number, number);
    of_number.check(field.range.contains(number.value), "value",
                    "is not possible for \"" + number.key + "\"");
    substance.*field.member = number.value - (whole ? enthalpy_before_transition(substance) : 0);
    of_number.check(substance.*field.member >= 0, "value",
                    "is less than it takes to heat the material to its transition");
  });
}

}  // namespace

void describe(Fields& f, Material& material) {
  f.filled_text("name", material.name);
  f.filled_text("title", material.title);
  f.filled_text("removed_by", material.removed_by);
  f.check(material.removed_by == "melting" || material.removed_by == "ablation", "removed_by",
          "must be \"melting\" or \"ablation\"");
  f.number("wavelength", material.substance.wavelength, kPositive);
  material.numbers.resize(std::size(kSubstanceFields) - 1);
  auto number = material.numbers.begin();
  for (const NumberField<Substance>& field : kSubstanceFields) {
    if (field.member != &Substance::wavelength) sourced_field(f, field, material, *number++);
  }
}

static void describe(Fields& f, std::vector<Material>& materials) {
  std::string units, note;  // for people
  f.text("units", units, kOptional);
  f.text("note", note, kOptional);
  f.elements("materials", "materials", kNeeded, materials, [&](size_t i, Fields& of_material) {
    describe(of_material, materials[i]);
    const std::span before(materials.data(), i);
    of_material.check(find_material(before, materials[i].name) == nullptr, "name",
                      "another material has the same name");
  });
  f.check(!materials.empty(), "materials", "must have at least one material");
}

Result<std::vector<Material>> load_materials(const std::filesystem::path& file) {
  return read_described<std::vector<Material>>(file);
}

}  // namespace kerf
