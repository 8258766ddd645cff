#pragma once

#include "core/document/document.h"
#include "core/mesh/files/soup.h"
#include "tests/fuzz/strokes/byte_source.h"

namespace kerf::fuzz {

// A mesh of at most 200 faces of any class, at any place and of any size that the bytes say, and whether it
// is meant to be solid.
struct FuzzedMesh {
  Soup soup;
  bool solid = false;
};
FuzzedMesh mesh_from(ByteSource& bytes);

// What somebody does at a document: strokes of one to six poses with both rims, schemes, patterns and models
// and steps of 1 to 50 faces, time, undo, redo, other settings for the last stroke, and edits of pieces.
// After each command the queue may be executed not at all, in part or whole. A solid world is cut by strokes
// that close it.
class Scenario {
 public:
  Scenario(Document& document, ByteSource& bytes, bool solid);

  // Does what the next bytes say. Commands that fail must leave the world as it was, which is checked.
  void act();
  // Ends the stroke and executes the queue.
  void finish();
  // Whether a command changed the area of faces that it did not remove.
  bool remade() const { return remade_; }
  // Whether a step failed, a command made faces anew, or a body was said to be left open.
  bool may_be_open() const { return may_be_open_; }

 private:
  CutSettings settings();
  Pose pose();
  void draw();
  void edit();
  void prepare(const PieceId& piece);
  void apply(const Command& command);
  void execute();
  void step(size_t moves);
  PieceId piece();

  Document& document_;
  ByteSource& bytes_;
  Vec3 middle_{0};
  double size_ = 1;  // half the diagonal of the world as loaded (m)
  bool solid_ = false;
  bool remade_ = false, may_be_open_ = false;
  bool heated_ = false;  // one stroke has been thermal; further ones would take too long
};

}  // namespace kerf::fuzz
