#pragma once

#include "ui/editor/shared/workspace.h"

namespace kerf {

// Drags that move the camera and nothing else: around what is looked at, and parallel to the picture.
class Orbit : public Interaction {
 public:
  explicit Orbit(Workspace& on) : on_(on), last_(on.pointer) {}
  void move(const InputEvent&) override;
  const char* words() const override { return "Orbiting"; }

 private:
  Workspace& on_;
  Vec2 last_;  // of the pointer
};

class Pan : public Interaction {
 public:
  explicit Pan(Workspace& on) : on_(on), last_(on.pointer) {}
  void move(const InputEvent&) override;
  const char* words() const override { return "Panning"; }

 private:
  Workspace& on_;
  Vec2 last_;
};

// Zooms to the pointer, by so many notches of the wheel.
void zoom(Workspace& on, double notches);

}  // namespace kerf
