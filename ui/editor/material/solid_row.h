#pragma once

#include <optional>

#include "ui/editor/shared/workspace.h"

namespace kerf {

// Why a piece with this laser cannot be made solid: a sentence, or null.
const char* why_not_solid(bool closed, const LaserControls& laser);

// Whether a piece is closed. It is looked at again, in O(faces), once its faces have changed.
class KnownClosed {
 public:
  // Precondition: the world has the piece.
  bool of(const World& world, const PieceId& piece);

 private:
  struct Asked {
    PieceId piece;
    size_t faces;
    double area;
    friend bool operator==(const Asked&, const Asked&) = default;
  };
  std::optional<Asked> asked_;
  bool closed_ = false;
};

// The row of the Material panel that says whether a piece is solid.
class SolidRow {
 public:
  // Returns what the user has chosen, if anything.
  std::optional<bool> draw(const Workspace& on, const PieceId& piece);

 private:
  KnownClosed closed_;
};

}  // namespace kerf
