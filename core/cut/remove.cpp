#include "core/cut/step_state.h"
#include "core/cut/stopwatch.h"

namespace kerf {

namespace {

void remove_face(BodyStep& step, FaceId f) {
  Body& body = step.body;
  const double area = triangle_area(body.mesh.triangle(f));
  Piece& piece = body.pieces[body.mesh.data(f).piece];
  --piece.faces;
  piece.area -= area;
  step.removed_area += area;
  ++step.removed_faces;
  step.separation.note_removal(body.mesh, f);
  body.mesh.remove_face(f);
  step.edited.push_back(f);
}

}  // namespace

// A green pair goes as a whole when the beam touches either half.
void remove(BodyStep& step) {
  const size_t first = step.edited.size();
  {
    const Stopwatch watch(step.figures.remove_s);
    for (const FaceId f : step.hit) {
      if (!step.body.mesh.is_live(f)) continue;  // its other half took it along
      const OneToFour::Element element = step.body.refinement.element(step.body.mesh, f);
      step.body.refinement.forget(step.body.mesh, f);
      for (int i = 0; i < element.face_count; ++i) remove_face(step, element.faces[i]);
    }
  }
  const Stopwatch watch(step.figures.update_tree_s);
  for (size_t i = first; i < step.edited.size(); ++i) step.body.tree.remove(step.edited[i]);
}

}  // namespace kerf
