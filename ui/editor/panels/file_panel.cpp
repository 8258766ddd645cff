#include "ui/editor/panels/file_panel.h"

#include <imgui.h>

#include "core/mesh/load_notes.h"
#include "ui/editor/view/file_frames.h"
#include "ui/window/frame_combos.h"
#include "ui/window/number_text.h"
#include "ui/window/property.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

void row(const char* name, const std::string& value, const char* meaning) {
  property(name);
  ImGui::TextWrapped("%s", value.c_str());
  tooltip(meaning);
}

std::string counted(size_t count, const char* what) { return grouped(count) + " " + what; }

void draw_body(const Body& body, FileUnit unit) {
  const MeshReport& r = body.loaded;
  row("Format", r.format, "What the content of the file is.");
  row("Faces",
      counted(r.faces, "triangles") + (r.components > 1 ? " in " + counted(r.components, "parts") : ""),
      "Triangles that were loaded, and how many sets of them hang together over edges.");
  row("Vertices", grouped(r.vertices), "Different positions.");
  row("Border", counted(r.boundary_edges, r.boundary_edges == 1 ? "edge" : "edges"),
      "Edges with one face: none where the surface is closed.");
  row("Area", area_label(r.area, unit), "Of all faces, on one side.");
  const std::vector<std::string> notes = load_notes(r);
  for (size_t i = 0; i < notes.size(); ++i) {
    row(i == 0 ? "Notes" : "", notes[i], "What was found in the file and put right when it was loaded.");
  }
}

void draw_frame(const SceneDescription& scene, ViewState& view, Settings& settings) {
  FileFrame frame = view.frame;
  property("Up");
  bool changed = up_axis_combo(frame.up);
  property("Unit");
  changed = unit_combo(frame.unit) || changed;
  if (changed) set_frame(frame, scene, view, settings);
}

}  // namespace

void draw_file_panel(const World& world, const SceneDescription& scene, ViewState& view, Settings& settings) {
  if (begin_properties("frame")) {
    draw_frame(scene, view, settings);
    end_properties();
  }
  const std::vector<BodyId> ids = world.ids();
  for (const BodyId id : ids) {
    const Body& body = world.body(id);
    ImGui::PushID(static_cast<int>(id.slot));
    ImGui::TextUnformatted(body.own_name().c_str());
    if (begin_properties("body")) {
      draw_body(body, view.frame.unit);
      end_properties();
    }
    ImGui::PopID();
  }
}

}  // namespace kerf
