#include "core/mesh/load_notes.h"

#include "core/base/count_text.h"

namespace kerf {

namespace {

// A sentence about a number of things, in the singular and the plural, both without the number.
struct Wording {
  const char* one;
  const char* many;
};

void add(size_t count, const Wording& wording, std::vector<std::string>& notes) {
  if (count == 0) return;
  notes.push_back(grouped(count) + (count == 1 ? wording.one : wording.many));
}

}  // namespace

std::vector<std::string> dropped_notes(const Repairs& r) {
  std::vector<std::string> notes;
  add(r.invalid_faces_dropped,
      {" triangle names a vertex that is not there and was dropped.",
       " triangles name vertices that are not there and were dropped."},
      notes);
  add(r.non_finite_faces_dropped,
      {" triangle has a corner that is not a finite number and was dropped.",
       " triangles have corners that are not finite numbers and were dropped."},
      notes);
  add(r.degenerate_faces_dropped,
      {" triangle has two corners at the same place and was dropped.",
       " triangles have two corners at the same place and were dropped."},
      notes);
  return notes;
}

std::vector<std::string> load_notes(const MeshReport& report) {
  std::vector<std::string> notes = dropped_notes(report.repairs);
  add(report.repairs.reoriented_faces,
      {" face was turned round, so that neighbours agree and closed parts face outward.",
       " faces were turned round, so that neighbours agree and closed parts face outward."},
      notes);
  add(report.repairs.zero_area_faces,
      {" face had no area and holds others together.", " faces had no area and hold the others together."},
      notes);
  add(report.non_manifold_edges,
      {" edge has three faces or more: closed parts that touch there are cut one by one, open ones together.",
       " edges have three faces or more: closed parts that touch there are cut one by one, open ones "
       "together."},
      notes);
  add(report.repairs.isolated_vertices_dropped,
      {" vertex was used by no face and was left out.", " vertices were used by no face and were left out."},
      notes);
  notes.insert(notes.end(), report.warnings.begin(), report.warnings.end());
  return notes;
}

}  // namespace kerf
