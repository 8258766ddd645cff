#include "core/document/text/sheet_fields.h"

#include "core/document/text/fields.h"

namespace kerf {

namespace {

// `always` is what it means that a key is missing that every version wrote.
template <typename Owner>
void number_field(Fields& f, const NumberField<Owner>& field, Owner& owner, const Missing<double>& always) {
  f.number(field.key, owner.*field.member, field.range,
           field.missing.always_written ? always : Missing<double>(field.missing.value));
}

}  // namespace

static void describe(Fields& f, Substance& substance) {
  if (f.reading()) substance = substance_without_keys();
  for (const auto& field : kSubstanceFields) number_field(f, field, substance, kOptional);
}

void describe(Fields& f, Sheet& sheet) {
  number_field(f, kThickness, sheet, kNeeded);
  number_field(f, kDensity, sheet, kNeeded);
  for (const auto& field : kSubstanceFields) number_field(f, field, sheet.substance, kNeeded);
}

void scene_sheet_fields(Fields& f, Sheet& sheet) {
  number_field(f, kThickness, sheet, kThickness.missing.value);
  number_field(f, kDensity, sheet, kDensity.missing.value);
  if (f.reading()) sheet.substance = substance_without_keys();
  if (f.present("substance", sheet.substance != substance_without_keys()))
    f.object("substance", sheet.substance);
}

}  // namespace kerf
