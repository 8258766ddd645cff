#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/tell.h"
#include "core/base/assets.h"
#include "core/document/files/material_reader.h"
#include "core/document/text/fields.h"

namespace kerf {

namespace {

Status run_materials() {
  const auto materials = load_materials(assets_folder() / "materials.json");
  if (!materials) return materials.error();
  nlohmann::ordered_json json{{"units", "SI: kg/m3, J/(kg K), W/(m K), K, J/kg, m"}};
  json["materials"] = nlohmann::ordered_json::array();
  for (const Material& material : *materials) {
    auto& entry = json["materials"].emplace_back(fields_json(material, {}));
    entry["enthalpy_of_removal"] = enthalpy_of_removal(material.substance);
  }
  std::cout << json.dump(2) << '\n';
  return flush_output();
}

}  // namespace

void add_materials_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("materials", "The table of materials with sources, as JSON on standard output");
  on_call(*command, invocation, run_materials, "kerf materials");
}

}  // namespace kerf
