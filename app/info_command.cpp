#include <iostream>

#include "app/arguments.h"
#include "app/console.h"
#include "app/run_description.h"
#include "core/base/json.h"
#include "core/base/platform.h"
#include "core/document/material_table.h"
#include "core/document/text/fields.h"
#include "core/document/text/json.h"
#include "core/mesh/looks.h"
#include "core/mesh/measures.h"
#include "core/mesh/mesh_file.h"

namespace kerf {

namespace {

nlohmann::ordered_json to_json(const Repairs& r) {
  return {{"welded_vertices", r.welded_vertices},
          {"duplicated_vertices", r.duplicated_vertices},
          {"reoriented_faces", r.reoriented_faces},
          {"degenerate_faces_dropped", r.degenerate_faces_dropped},
          {"non_finite_faces_dropped", r.non_finite_faces_dropped},
          {"invalid_faces_dropped", r.invalid_faces_dropped},
          {"incomplete_faces_dropped", r.incomplete_faces_dropped},
          {"zero_area_faces", r.zero_area_faces},
          {"isolated_vertices_dropped", r.isolated_vertices_dropped}};
}

// Lists what the file holds in addition to its triangles.
nlohmann::ordered_json looks_json(const BuiltMesh& built) {
  const Looks* looks = built.looks.get();
  nlohmann::ordered_json json{
      {"uv_sets", looks ? looks->uv_sets() : 0},         {"normals", looks && looks->has_normals()},
      {"vertex_colours", !built.mesh.colours().blank()}, {"materials", built.material_names},
      {"images", nlohmann::ordered_json::array()},       {"parts", built.parts.size()}};
  if (looks && looks->has_tangents()) json["tangents"] = true;
  for (size_t i = 0; looks && i < looks->attributes(); ++i)
    json["attributes"].push_back(looks->attribute_name(i));
  if (!looks || !looks->surfaces()) return json;
  for (const SurfaceImage& image : looks->surfaces()->images)
    json["images"].push_back({{"name", image.name}, {"bytes", image.bytes.size()}});
  return json;
}

nlohmann::ordered_json to_json(const std::string& file, const BuiltMesh& built, bool closed) {
  const MeshReport& m = built.report;
  return {{"file", file},
          {"format", m.format},
          {"units", units_json()},
          {"faces_in_file", m.faces_in_file},
          {"triangles_in_file", m.triangles_in_file},
          {"faces", m.faces},
          {"vertices", m.vertices},
          {"boundary_edges", m.boundary_edges},
          {"non_manifold_edges", m.non_manifold_edges},
          {"components", m.components},
          {"closed", closed},
          {"area", m.area},
          {"bounds", {{"min", vector_json(m.min)}, {"max", vector_json(m.max)}}},
          {"looks", looks_json(built)},
          {"repairs", to_json(m.repairs)},
          {"notes", load_notes(m)}};
}

Status run_info(const std::string& file, const std::string& unit_name) {
  MeshReading reading;
  if (const Status s = unpack(parse_unit(unit_name), reading.unit); !s) return s;
  record_mesh_unit(reading.unit);
  const auto path = input_file(file);
  if (!path) return path.error();
  catch_interrupts();
  const auto built = load_mesh(*path, reading);
  if (!built) return built.error();
  for (const std::string& warning : built->report.warnings) warn(warning);
  const bool closed = enclosed_volume(built->mesh, 0.5 * (built->report.min + built->report.max)).closed;
  std::cout << to_json(file, *built, closed).dump(2, ' ', false, nlohmann::json::error_handler_t::replace)
            << '\n';
  return flush_output();
}

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

void add_info_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("info", "Describe a mesh file as JSON on standard output");
  auto file = std::make_shared<std::string>();
  command->add_option("MESH", *file, "A mesh file, or - for standard input: " + list_mesh_titles())
      ->required();
  auto unit = std::make_shared<std::string>("m");
  add_unit_option(*command, *unit);
  on_call(
      *command, invocation, [file, unit] { return run_info(*file, *unit); },
      "kerf info assets/meshes/car.obj");
}

void add_materials_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("materials", "Print the materials with sources as JSON on standard output");
  on_call(*command, invocation, run_materials, "kerf materials");
}

}  // namespace kerf
