#pragma once

#include <filesystem>
#include <string>

#include "core/base/number_format.h"
#include "core/document/history.h"
#include "core/document/scene.h"
#include "core/mesh/files/mesh_format.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/viewport.h"

namespace kerf {

// A frame is the unit and the upward axis in which the open work is shown. Positions stay as they were read.

// The format by which choices are remembered: "stl", of the mesh file that a scene consists of; empty for a
// scene of several bodies or of a file in no known format.
std::string mesh_kind(const SceneDescription& scene);

// How a scene is shown that was just opened, and whether the user is to be asked about it.
struct FrameChoice {
  FileFrame frame;
  bool ask = false;
};
// What was saved with the scene; else what the user chose for files of this kind; else, for a mesh file, what
// its size and kind suggest, about which the user is asked once a kind. Scenes have metres and +Y upwards.
FrameChoice choose_frame(const SceneDescription& scene, bool is_mesh_file, const World::Bounds& bounds,
                         const Settings& settings);

// Notes the frame in a scene that is to be saved; nothing where it is Kerf's own and was not noted before.
void record_frame(SceneDescription& scene, const FileFrame& frame);

// Shows the world in this frame. The lights turn with the ground, and the camera keeps its direction to it.
void show_in_frame(ViewState& view, const FileFrame& frame);

// Shows the world in the frame that the user chose, remembers it for mesh files of this kind, and withdraws
// the question about them.
void set_frame(const FileFrame& frame, const SceneDescription& scene, ViewState& view, Settings& settings);

// An area in the numbers of the file as a label, as length_label does it with a length: "2.75 cm^2".
std::string area_label(double area, FileUnit unit);
// The extents of a box in the numbers of the file, each in the same metric unit: "68 x 75 x 16 mm".
std::string extents_label(const Vec3& size, FileUnit unit);

// What a step of the history is to people. Strokes are counted, and say what they cut and how: "Cut 2: roof,
// radius 4 mm", "Cut 2 again: roof, edges of 3 mm"; every other step says what its command does. `unit` is
// the one in which the work is shown. O(steps). Precondition: the history has the step.
std::string step_words(const History& history, size_t step, FileUnit unit);

}  // namespace kerf
