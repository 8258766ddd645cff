#pragma once

#include <string>

#include "core/base/number_format.h"
#include "core/document/scene.h"
#include "core/document/undo_stack.h"
#include "core/mesh/files/mesh_format.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/viewport.h"

namespace kerf {

struct DocumentSession;

// Frames: the displayed unit and up axis of the open document. Positions keep the values of the file.

// Returns the format of the only mesh file of a scene, such as "stl", under which the frame is remembered;
// empty if the scene has several bodies or the format is unknown.
std::string mesh_kind(const SceneDescription& scene);

// The frame of a newly opened scene. `ask`: the user is asked about it.
struct FrameChoice {
  FileFrame frame;
  bool ask = false;
};
// Returns the frame that was saved with the scene; else the user's setting for the format; else, for a mesh
// file, a guess from its size and format, about which the user is asked once per format. Scenes use metres
// and +Y up.
FrameChoice select_frame(const SceneDescription& scene, bool is_mesh_file, const World::Bounds& bounds,
                         const Settings& settings);

// Records the frame in a scene to be saved. No-op if the frame is the default one and the scene records no
// other.
void record_frame(SceneDescription& scene, const FileFrame& frame);

// Shows the world in this frame. The lights turn with the ground, and the camera keeps its direction to it.
void show_in_frame(ViewState& view, const FileFrame& frame);

// Shows the open document in another frame. Lights that turn with the ground are no unsaved change.
void change_frame(const FileFrame& frame, DocumentSession& session, ViewState& view);

// Shows the world in the user's frame, remembers it for mesh files of this format, and ends the question.
// Another frame is an unsaved change of the document, unless that is an opened mesh file without a journal.
void set_frame(const FileFrame& frame, DocumentSession& session, ViewState& view, Settings& settings);

// Formats an area in file units, like length_label: "2.75 cm^2".
std::string area_label(double area, FileUnit unit);
// Formats a volume of file units likewise: "2.75 cm^3".
std::string volume_label(double volume, FileUnit unit);
// Formats the extents of a box in file units, each in the same metric unit: "68 x 75 x 16 mm".
std::string extents_label(const Vec3& size, FileUnit unit);

// Describes a step of the history. Strokes are numbered and described by the cut bodies and their settings:
// "Cut 2: roof, radius 4 mm", "Recut 2: roof, edges of 3 mm"; other steps by their commands. `unit` is
// the displayed unit. O(steps). Precondition: the history has the step.
std::string step_words(const UndoStack& history, size_t step, FileUnit unit);

}  // namespace kerf
