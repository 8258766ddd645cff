#include "core/base/json.h"
#include "core/document/material_table.h"

#include <gtest/gtest.h>

#include "core/document/text/json.h"
#include "tests/support/checkout.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

std::filesystem::path table() { return checkout() / "assets" / "materials.json"; }

nlohmann::json read_table() { return nlohmann::json::parse(*read_text_file(table())); }

std::string error_of(const nlohmann::json& json) {
  const TemporaryFolder folder;
  write_text(folder / "table.json", json.dump());
  const auto materials = load_materials(folder / "table.json");
  return materials.ok() ? "" : materials.error().message.substr(folder.path().string().size() + 1);
}

TEST(MaterialReader, reads_the_materials_of_the_command_line) {
  const auto materials = load_materials(table());
  ASSERT_TRUE(materials.ok()) << materials.error().message;
  for (const char* name : {"mild-steel", "stainless-304", "aluminium-6061", "titanium-64", "copper", "pmma",
                           "plywood", "glass", "rubber", "abs"}) {
    ASSERT_NE(find_material(*materials, name), nullptr) << name;
  }
  EXPECT_EQ(materials->size(), 10u);
  EXPECT_EQ(find_material(*materials, "unobtainium"), nullptr);
  EXPECT_EQ(find_material(*materials, "mild-steel")->substance, Substance());
  EXPECT_EQ(find_material(*materials, "mild-steel")->title, "Mild steel");
}

TEST(MaterialReader, counts_ablation_heat_from_the_ambient_temperature) {
  const auto materials = load_materials(table());
  ASSERT_TRUE(materials.ok());
  EXPECT_NEAR(enthalpy_of_removal(find_material(*materials, "pmma")->substance), 3.5e6, 1);
  EXPECT_NEAR(enthalpy_of_removal(find_material(*materials, "plywood")->substance), 4e6, 1);
  EXPECT_EQ(find_material(*materials, "pmma")->substance.wavelength, 10.6e-6);
}

TEST(MaterialReader, reports_errors_with_their_location) {
  const nlohmann::json good = read_table();
  EXPECT_EQ(error_of(good), "");
  auto bad = good;
  bad["materials"][2]["density"]["value"] = 1;
  EXPECT_EQ(error_of(bad), "table.json: /materials/2/density/value: is outside its range");
  bad = good;
  bad["materials"][3]["emissivity"] = {{"value", 2}, {"range", {1, 3}}, {"source", "none"}};
  EXPECT_EQ(error_of(bad), "table.json: /materials/3/emissivity/value: is not possible for \"emissivity\"");
  bad = good;
  bad["materials"][1]["name"] = "mild-steel";
  EXPECT_EQ(error_of(bad), "table.json: /materials/1/name: another material has the same name");
  bad = good;
  bad["materials"][0].erase("latent");
  EXPECT_EQ(error_of(bad), "table.json: /materials/0: needs \"latent\"");
  bad = good;
  bad["materials"][0]["latent"]["source"] = "";
  EXPECT_EQ(error_of(bad), "table.json: /materials/0/latent/source: must state the source of the value");
  bad = good;
  bad["materials"][5]["heat_of_ablation"] = {{"value", 100}, {"range", {1, 200}}, {"source", "none"}};
  EXPECT_EQ(
      error_of(bad),
      "table.json: /materials/5/heat_of_ablation/value: is less than it takes to heat the material to its "
      "transition");
  EXPECT_EQ(error_of({{"materials", nlohmann::json::array()}}),
            "table.json: /materials: must have at least one material");
  EXPECT_EQ(error_of(nlohmann::json::array({1, 2})), "table.json: must be an object");
}

}  // namespace
}  // namespace kerf::test
