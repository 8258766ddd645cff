#pragma once

#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/workspace.h"

namespace kerf {

// Opening, saving and leaving the work, what becomes of it when it is not saved, and pictures of it.
std::unique_ptr<Feature> files_feature(Workspace& workspace);

// The files that were opened and saved last, each with a picture of how it looked: a menu of them, and the
// pictures.
std::unique_ptr<Feature> recent_feature(Workspace& workspace);

// What meets who has never opened anything: the car, recent files, scenes, and a tour of the first five
// minutes. Any key or press outside closes it; the Help menu opens it again.
std::unique_ptr<Feature> welcome_feature(Workspace& workspace);

// The steps of the history: undo, redo, and the way to any of them.
std::unique_ptr<Feature> history_feature(Workspace& workspace);

// The laser that the pointer holds: its beam and its resolution, the stroke that is drawn, and cutting the
// last stroke again.
std::unique_ptr<Feature> laser_feature(Workspace& workspace);

// The sheet of the pieces, and what the beam does with heat.
std::unique_ptr<Feature> material_feature(Workspace& workspace);

// The split view: the last stroke at a second resolution, in a right half of the picture.
std::unique_ptr<Feature> split_feature(Workspace& workspace);

// The path of the laser, which is drawn point by point over the surface and then run.
std::unique_ptr<Feature> path_feature(Workspace& workspace);

// A laser that stands in the scene and fires while it is switched on, without a break or in shots.
std::unique_ptr<Feature> emitter_feature(Workspace& workspace);

// The last stroke in single steps, forth and back, and the last query of the tree box by box.
std::unique_ptr<Feature> single_step_feature(Workspace& workspace);

// Time: bodies move while the user plays and can be pulled by springs; what is hot cools down otherwise.
std::unique_ptr<Feature> time_feature(Workspace& workspace);

// The pieces: their list, which of them are chosen, hidden, isolated, deleted and renamed, and how far they
// are drawn apart.
std::unique_ptr<Feature> pieces_feature(Workspace& workspace);

// The chosen piece is moved, turned and duplicated: by handles, by keys and by numbers.
std::unique_ptr<Feature> moving_feature(Workspace& workspace);

// Simplifying, subdividing and smoothing the meshes of pieces before they are cut.
std::unique_ptr<Feature> prepare_feature(Workspace& workspace);

// How the world is looked at: the camera, the axes in the corner, the switches of the picture with their
// legends, and the look of the panels.
std::unique_ptr<Feature> view_feature(Workspace& workspace);

// The lights and their shadows: their panel, and a handle for each light while that is unfolded.
std::unique_ptr<Feature> light_feature(Workspace& workspace);

// The section plane: its handles in the picture, its numbers in the View panel, and what is done with it by
// name.
std::unique_ptr<Feature> section_feature(Workspace& workspace);

// What there is to know about a face, the distance between two points, and the temperature of a point over
// time.
std::unique_ptr<Feature> inspect_feature(Workspace& workspace);

// The component graph of the last stroke or of a piece, with its traversal.
std::unique_ptr<Feature> graph_feature(Workspace& workspace);

// The boxes of the trees: which of them are drawn, and how large the trees are.
std::unique_ptr<Feature> tree_feature(Workspace& workspace);

// What the last steps took and changed, and where memory goes.
std::unique_ptr<Feature> statistics_feature(Workspace& workspace);

// Colours the faces by a quantity, with its histogram and a range that is dragged.
std::unique_ptr<Feature> scalar_map_feature(Workspace& workspace);

// Distances that are measured and stay: marks between two points of surfaces, which are named, moved, listed,
// exported as CSV, and saved in the head of the document.
std::unique_ptr<Feature> ruler_feature(Workspace& workspace);

}  // namespace kerf
