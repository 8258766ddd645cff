#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/document/document.h"
#include "core/document/scene.h"
#include "ui/editor/frame_statistics.h"
#include "ui/editor/laser_controls.h"
#include "ui/editor/laser_tool.h"
#include "ui/editor/layout.h"
#include "ui/render/camera.h"
#include "ui/render/renderer.h"

namespace kerf {

// Numbers of the status bar; they follow the world four times a second, so that they can be read.
struct ShownFigures {
  size_t faces = 0, pieces = 0;
  double frame_ms = 0;
};

// What the left button does, and what a drag that has begun goes on doing.
enum class Drag { kNone, kCut, kOrbit, kPan };

// Everything that the editor's parts share: what is open, how it is looked at, what the user is doing.
struct EditorState {
  Document document;
  std::map<std::string, Paint> paints;
  std::optional<View> home;  // the view that the scene asks for

  Camera camera;
  ViewOptions look;
  Layout layout;

  LaserControls laser;
  LaserTool tool;
  Drag drag = Drag::kNone;
  Vec2 pointer{0};  // screen coordinates
  bool pointer_over_picture = false;

  std::string message;  // of the last thing that happened, until the next action
  bool message_is_error = false;
  ShownFigures shown;
  FrameStatistics frames;
  size_t removed_faces = 0;

  bool cut_once = false;  // hints are no longer needed
  bool show_shortcuts = false;
  bool quit = false;
  bool picture_old = true;  // the picture of the world has to be drawn anew

  double aspect() const { return layout.viewport.size.x / layout.viewport.size.y; }
  CameraView view() const { return camera.view(aspect()); }
  // A place of the window as CameraView::ray takes it.
  Vec2 in_picture(Vec2 at) const;
  void say(std::string text, bool error = false);
};

}  // namespace kerf
