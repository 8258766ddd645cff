#pragma once

#include <memory>
#include <span>

#include "core/world/world.h"
#include "ui/editor/prepare/prepare_pieces.h"
#include "ui/render/view/drawn_wire.h"

namespace kerf {

// What a preparation would make of pieces, beside what they are.
struct Preview {
  struct Statistics {
    size_t faces = 0;
    double least_angle = 0;  // of a face, degrees
  };
  Statistics before, after;
  double distance = 0;  // m, of the two surfaces at most, both ways (see surface_distance())
  std::shared_ptr<const DrawnWire> wire;  // of what they would be; not null
};

// More faces than these are not previewed: of a world that is to be copied, and of what is made.
inline constexpr size_t kMostFacesToPreview = 400'000, kMostFacesPreviewed = 1'600'000;

// Why there is no preview of it, in one sentence, or null if there is one.
const char* why_no_preview(const World& world, std::span<const PieceRow> pieces,
                           const Preparation& preparation);

// Applies the commands of the preparation to a copy of the world and measures it. Fails like
// prepare_pieces(), also where it is stopped. Precondition: why_no_preview() gives no reason.
Result<Preview> make_preview(const World& world, std::span<const PieceRow> pieces,
                             const Preparation& preparation, const Progress& progress);

}  // namespace kerf
