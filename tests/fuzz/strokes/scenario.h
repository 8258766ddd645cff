#pragma once

#include "core/document/history/document.h"
#include "core/mesh/files/soup.h"
#include "tests/fuzz/strokes/byte_source.h"

namespace kerf::fuzz {

// A mesh of at most 200 faces of any class, at any place and of any size that the bytes say.
Soup mesh_from(ByteSource& bytes);

// What somebody does at a document: strokes of one to six poses with both rims, schemes, patterns and models
// and bites of 1 to 50 faces, time, undo, redo, other settings for the last stroke, and edits of pieces.
// After each command the queue may be executed not at all, in part or whole.
class Scenario {
 public:
  Scenario(Document& document, ByteSource& bytes);

  // Does what the next bytes say. Commands that fail must leave the world as it was, which is checked.
  void act();
  // Whether a command changed the area of faces that it did not remove.
  bool remade() const { return remade_; }

 private:
  CutSettings settings();
  Pose pose();
  void draw();
  void edit();
  void prepare(const PieceId& piece);
  void apply(const Command& command);
  void execute();
  PieceId piece();

  Document& document_;
  ByteSource& bytes_;
  Vec3 middle_{0};
  double size_ = 1;  // half the diagonal of the world as loaded (m)
  bool remade_ = false;
  bool heated_ = false;  // one stroke has been thermal; further ones would take too long
};

}  // namespace kerf::fuzz
