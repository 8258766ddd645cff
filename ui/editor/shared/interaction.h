#pragma once

#include <functional>
#include <utility>

#include "ui/window/input_event.h"

struct ImDrawList;

namespace kerf {

// A press of the left button in the picture, without Alt, which is for looking round.
struct Press {
  const InputEvent& event;
  bool shift = false, control = false;
};

// What the mouse does from the press of a button in the picture until its release. The place of the pointer
// is Workspace::pointer; events carry their time and the modifier keys.
class Interaction {
 public:
  virtual ~Interaction() = default;

  virtual void move(const InputEvent&) {}
  virtual void release(const InputEvent&) {}
  // Esc. Returns whether the interaction is over by that; otherwise it goes on.
  virtual bool cancel() { return false; }
  // Whether it is over before the button is released.
  virtual bool over() const { return false; }

  // Whether it draws a stroke, so that handles are not in the way.
  virtual bool cuts() const { return false; }
  // What it does, for the status bar; null: nothing to tell of.
  virtual const char* words() const { return nullptr; }
  // Draws over the picture.
  virtual void draw(ImDrawList&) const {}
};

// Does something at the release of the button, wherever the pointer went since the press.
class ClickOnce : public Interaction {
 public:
  explicit ClickOnce(std::function<void()> click) : click_(std::move(click)) {}
  void release(const InputEvent&) override { click_(); }

 private:
  std::function<void()> click_;
};

// Does something at each move of the pointer.
class PlainDrag : public Interaction {
 public:
  // `words` as Interaction::words() returns them.
  PlainDrag(const char* words, std::function<void(const InputEvent&)> follow)
      : words_(words), follow_(std::move(follow)) {}
  void move(const InputEvent& event) override { follow_(event); }
  const char* words() const override { return words_; }

 private:
  const char* words_;
  std::function<void(const InputEvent&)> follow_;
};

}  // namespace kerf
