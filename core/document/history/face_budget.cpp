#include "core/document/history/face_budget.h"

#include <algorithm>

#include "core/base/count_text.h"
#include "core/cut/cut_step.h"

namespace kerf {

namespace {

// Loading a mesh and writing its pieces takes 260 bytes a face, and a stroke 130 bytes for each face that it
// makes; before-images and what is drawn take as much again.
constexpr uint64_t kBytesAFace = 400;
constexpr size_t kLeastBudget = 100'000;

}  // namespace

size_t usual_face_budget(uint64_t memory) {
  return std::clamp<uint64_t>(memory / kBytesAFace, kLeastBudget, CutSettings::kMostFaces);
}

Error over_face_budget(size_t budget) {
  return failed(
      "the cut makes more than " + grouped(budget) +
      " faces, for which the memory of this machine is not enough: choose a coarser resolution or a "
      "shorter stroke");
}

}  // namespace kerf
