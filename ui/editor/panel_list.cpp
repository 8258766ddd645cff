#include "ui/editor/panel_list.h"

#include "ui/editor/actions.h"
#include "ui/editor/bodies/bodies_panel.h"
#include "ui/editor/changes/world_changes.h"
#include "ui/editor/file_choice.h"
#include "ui/editor/graph/graph_panel.h"
#include "ui/editor/laser_desk.h"
#include "ui/editor/material/laser_heat_rows.h"
#include "ui/editor/material/material_panel.h"
#include "ui/editor/panels/display_panel.h"
#include "ui/editor/panels/file_panel.h"
#include "ui/editor/panels/history_panel.h"
#include "ui/editor/panels/laser_panel.h"
#include "ui/editor/panels/light_panel.h"
#include "ui/editor/panels/pieces_panel.h"
#include "ui/editor/panels/resolution_panel.h"
#include "ui/editor/panels/statistics_panel.h"
#include "ui/editor/panels/tree_panel.h"
#include "ui/editor/panels/view_panel.h"
#include "ui/editor/path/emitter_rows.h"
#include "ui/editor/path/path_panel.h"
#include "ui/editor/prepare/prepare_panel.h"
#include "ui/editor/section/section_rows.h"
#include "ui/editor/single_step/query_walk_rows.h"
#include "ui/editor/single_step/single_step_panel.h"

namespace kerf {

namespace {

void draw_laser(EditorState& s, EmitterRows& emitter, LaserHeatRows& heat) {
  const bool changed = draw_laser_panel(s.hand.laser, s.view.frame.unit);
  const World& world = s.work.document.world();
  const auto piece = piece_of_sheet(world, s.view);
  heat.draw({s.hand.laser, s.settings.heat_held, world, piece ? world.body(piece->body).sheet : Sheet(),
             s.lasers.path.speed(), s.figures.shown.stroke, s.view.frame.unit});
  emitter.draw(s.lasers.emitter, s.view, [&s] { place_emitter(s); });
  if (changed && s.settings.live_recut && why_no_recut(s.work.document) == nullptr)
    s.requests.recut_radius = true;
}

void draw_resolution(EditorState& s) {
  draw_resolution_panel({s.work.document, s.hand.laser, s.split, s.view, s.settings, s.requests, s.figures,
                         [&s](bool on) { show_split(s.split, on, s.hand, s.work.document, s.view); }});
}

void draw_path(EditorState& s, PathPanel& panel) {
  const World& world = s.work.document.world();
  panel.draw(
      s.lasers, s.view, world, PathTool::beam_for(world, s.hand.laser.radius), why_no_run(s),
      {[&s] { s.requests.run_path = true; }, [&s] { choose_file_for(s, FileBrowser::Purpose::kOpenPath); },
       [&s] { choose_file_for(s, FileBrowser::Purpose::kSavePath); }});
}

void draw_pieces(EditorState& s, PiecesPanel& panel) {
  panel.draw(s.work.document.world(), s.view, s.requests,
             [&s] { choose_file_for(s, FileBrowser::Purpose::kExport); });
}

void draw_tree(EditorState& s) {
  draw_tree_panel(s.view, s.work.document.world(), s.settings, s.figures.shown);
  if (s.stages.wishes.on) draw_query_walk(s.stages.log);
}

void draw_graph(EditorState& s, GraphPanel& panel) {
  const bool seen = s.hand.over_picture && s.hand.drag == Drag::kNone && !s.view.in_second;
  panel.draw(s.graph, s.work.document, s.view, seen ? std::optional(s.hand.pointer) : std::nullopt);
}

void draw_view(EditorState& s, SectionRows& rows) {
  rows.draw(s.view, s.message);
  draw_view_panel(s.view);
}

}  // namespace

std::vector<Panel> make_panels(EditorState& s) {
  const Document& document = s.work.document;
  return {
      {PanelId::kLaser, "Laser",
       [&s, emitter = EmitterRows(), heat = LaserHeatRows()]() mutable { draw_laser(s, emitter, heat); }},
      {PanelId::kMaterial, "Material",
       [&s, panel = MaterialPanel()]() mutable { panel.draw(s.work.document.world(), s.view, s.requests); }},
      {PanelId::kPrepare, "Prepare",
       [&s, panel = PreparePanel()]() mutable {
         panel.draw(s.work.document.world(), s.view, s.preparation, s.requests);
       }},
      {PanelId::kResolution, "Resolution", [&s] { draw_resolution(s); }},
      {PanelId::kPath, "Path", [&s, panel = PathPanel()]() mutable { draw_path(s, panel); }},
      {PanelId::kPieces, "Pieces", [&s, panel = PiecesPanel()]() mutable { draw_pieces(s, panel); }},
      {PanelId::kBodies, "Bodies",
       [&s, panel = BodiesPanel()]() mutable { panel.draw(body_parts(s), s.view); }},
      {PanelId::kHistory, "History",
       [&s, panel = HistoryPanel()]() mutable { panel.draw(s.work.document, s.settings, s.requests); }},
      {PanelId::kLight, "Light",
       [&] { draw_light_panel(s.view, document.world().bounds(), s.figures.shadows); }},
      {PanelId::kTree, "Tree", [&s] { draw_tree(s); }},
      {PanelId::kGraph, "Graph", [&s, panel = GraphPanel()]() mutable { draw_graph(s, panel); }},
      {PanelId::kSingleStep, "Single step",
       [&s, panel = SingleStepPanel()]() mutable { panel.draw(s.stages, s.work.document, s.view); }},
      {PanelId::kView, "View", [&s, rows = SectionRows()]() mutable { draw_view(s, rows); }},
      {PanelId::kStatistics, "Statistics", [&s] { draw_statistics_panel(s.figures.chart, s.figures.shown); }},
      {PanelId::kFile, "File", [&] { draw_file_panel(document.world(), s.work.scene, s.view, s.settings); }},
      {PanelId::kDisplay, "Display",
       [&s, panel = DisplayPanel()]() mutable { panel.draw(s.settings, s.view); }},
  };
}

}  // namespace kerf
