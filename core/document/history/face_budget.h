#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/result.h"

namespace kerf {

// The number of faces, live and removed ones, that so much memory (bytes) is enough for, with the tree, the
// before-images of strokes and what the program holds beside; see Document::set_face_budget.
size_t usual_face_budget(uint64_t memory);

// The error of a stroke that makes more faces than the budget.
Error over_face_budget(size_t budget);

}  // namespace kerf
