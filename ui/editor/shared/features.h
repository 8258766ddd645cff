#pragma once

#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/workspace.h"

namespace kerf {

// Opening, saving and closing the work, recovery of unsaved work, and screenshots.
std::unique_ptr<Feature> files_feature(Workspace& workspace);
// Recent files: a menu of them, and their thumbnails.
std::unique_ptr<Feature> recent_feature(Workspace& workspace);
// The welcome window of the first launch: the car, recent files, scenes, and a guided tour. Any key or press
// outside closes it; the Help menu opens it again.
std::unique_ptr<Feature> welcome_feature(Workspace& workspace);
// The steps of the history: undo, redo, and jumps to any step.
std::unique_ptr<Feature> history_feature(Workspace& workspace);
// The laser at the pointer: its beam and resolution, the stroke being drawn, and the last one's recut.
std::unique_ptr<Feature> laser_feature(Workspace& workspace);
// The sheet of the pieces, and how the beam heats it.
std::unique_ptr<Feature> material_feature(Workspace& workspace);
// The split view: the last stroke at a second resolution, in the right half of the viewport.
std::unique_ptr<Feature> split_feature(Workspace& workspace);
// The path of the laser, drawn point by point over the surface and then run.
std::unique_ptr<Feature> path_feature(Workspace& workspace);
// A laser fixed in the scene that fires while switched on, continuously or in pulses.
std::unique_ptr<Feature> emitter_feature(Workspace& workspace);
// Stepping through the last stroke, forwards and back, and through the nodes of the last tree query.
std::unique_ptr<Feature> single_step_feature(Workspace& workspace);
// The simulation: falling bodies and springs that drag them; hot material cools even while it is paused.
std::unique_ptr<Feature> time_feature(Workspace& workspace);
// The pieces: their list, their selection, hiding, isolating, deleting, renaming, and the exploded view.
std::unique_ptr<Feature> pieces_feature(Workspace& workspace);
// Moves, rotates and duplicates the selected piece: by handles, by keys and by numbers.
std::unique_ptr<Feature> transform_feature(Workspace& workspace);
// Simplifies, subdivides and smooths the meshes of pieces before they are cut.
std::unique_ptr<Feature> prepare_feature(Workspace& workspace);
// The view: the camera, the axes gizmo, the view options with their legends, and the theme of the panels.
std::unique_ptr<Feature> view_feature(Workspace& workspace);
// The lights and their shadows: their panel, and handles of the lights while it is unfolded.
std::unique_ptr<Feature> light_feature(Workspace& workspace);
// The section plane: its handles in the viewport, its numbers in the View panel, and its actions.
std::unique_ptr<Feature> section_feature(Workspace& workspace);
// Facts about a face, the distance between two points, and the temperature of a point over time.
std::unique_ptr<Feature> inspect_feature(Workspace& workspace);
// The component graph of the last stroke or of a piece, with its traversal.
std::unique_ptr<Feature> graph_feature(Workspace& workspace);
// The AABB trees: the displayed boxes, and the sizes of the trees.
std::unique_ptr<Feature> tree_feature(Workspace& workspace);
// Times and changes of the last steps, and memory usage.
std::unique_ptr<Feature> statistics_feature(Workspace& workspace);
// Colours the faces by a quantity, with its histogram and an adjustable range.
std::unique_ptr<Feature> scalar_map_feature(Workspace& workspace);
// Kept measurements between two points of surfaces, which can be named, moved, listed, exported as CSV, and
// are saved in the head of the document.
std::unique_ptr<Feature> ruler_feature(Workspace& workspace);

}  // namespace kerf
