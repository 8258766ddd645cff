#include "core/edit/body_edit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/assert.h"
#include "core/mesh/measures.h"
#include "core/mesh/refinement.h"
#include "core/world/body_mass.h"

namespace kerf {

namespace {

// Updates the number of halvings of a face after its area changed relative to that of its base face.
void follow_area(FaceData& data, double area_before, double area_now) {
  if (!(area_before > 0 && area_now > 0)) return;
  int halvings = 0;
  const double share =
      std::frexp(area_before / area_now, &halvings);  // in [1/2, 1): their ratio is share * 2^halvings
  if (share < 0.7071067811865476) --halvings;
  data.halvings = static_cast<uint8_t>(std::clamp(data.halvings + halvings, 0, 255));
}

Replacement in_two(const Mesh::FaceSplit& s) {
  return {{s.kept, FaceId()}, {s.kept, s.added, FaceId(), FaceId()}, 1, 2};
}

void sort_each_once(std::vector<FaceId>& faces) {
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
}

}  // namespace

BodyEdit::~BodyEdit() {
  update_tree();
  refit_tree();
}

// Area lost with a face or by a vertex move counts as removed.
void BodyEdit::count(FaceId f, int faces, double area) {
  body_->count(f, faces, area);
  removed_area_ -= area;
}

AreaMoments BodyEdit::moments_of(FaceId f) const {
  const Triangle t = mesh().triangle(f);
  return area_moments(t, triangle_area(t), body_->middle());
}

// Splitting -------------------------------------------------------------------------------------------------

void BodyEdit::split_in_four(FaceId f) {
  KERF_ASSERT(mesh().is_live(f));
  if (!body_->refinement.can_split(mesh(), f)) return;
  const size_t first = splits_.size();
  body_->refinement.split(body_->mesh, f, splits_);
  record_splits(first);
}

void BodyEdit::bisect_at_longest_edge(FaceId f) {
  KERF_ASSERT(mesh().is_live(f));
  const size_t first = splits_.size();
  bisect_longest_edge(body_->mesh, body_->refinement, f, splits_);
  record_splits(first);
}

void BodyEdit::split_edge_at(FaceId f, VertexId from, VertexId to, const Vec3& at,
                             std::vector<Mesh::FaceSplit>& out) {
  KERF_ASSERT(mesh().is_live(f));
  KERF_ASSERT(at != mesh().position(from) && at != mesh().position(to));
  std::vector<Mesh::Side> sides;
  mesh().append_edge_sides(f, from, to, sides);
  forget_pair(f);
  for (const Mesh::Side& side : sides) forget_pair(side.face);
  const size_t first = out.size(), first_split = splits_.size();
  body_->mesh.split_edge_at(f, from, to, at, out);
  body_->tree.enlarge_bounds(at);
  for (size_t i = first; i < out.size(); ++i) {
    const Mesh::FaceSplit& s = out[i];
    const double kept = triangle_area(mesh().triangle(s.kept)),
                 added = triangle_area(mesh().triangle(s.added));
    follow_area(body_->mesh.edit_data(s.kept), kept + added, kept);
    follow_area(body_->mesh.edit_data(s.added), kept + added, added);
    splits_.push_back(in_two(s));
  }
  record_splits(first_split);
}

// Updates the counts and the separation state at once, because they also receive later moves and flips.
void BodyEdit::record_splits(size_t first) {
  for (size_t i = first; i < splits_.size(); ++i) {
    const Replacement& r = splits_[i];
    edited_.insert(edited_.end(), r.added.begin(), r.added.begin() + r.added_count);
    const int made = r.added_count - r.removed_count;
    faces_made_ += static_cast<size_t>(made);
    record_replaced(*body_, r);
    count(r.added[0], made, 0);
  }
}

// Removing --------------------------------------------------------------------------------------------------

void BodyEdit::remove(std::span<const FaceId> faces) {
  KERF_ASSERT(splits_.empty());
  for (const FaceId f : faces) {
    if (!mesh().is_live(f)) continue;
    forget_pair(f);
    remove_face(f);
  }
}

void BodyEdit::remove_face(FaceId f) {
  const Triangle t = mesh().triangle(f);
  const double area = triangle_area(t);
  const int64_t loops = body_->separation.loops;
  record_removed_part(*body_, f);
  record_removal(f, t, loops);
  count(f, -1, -area);
  body_->edit_piece_of(f).moments -= area_moments(t, area, body_->middle());
  ++removed_faces_;
  if (body_->solid) solid_.removed_volume += volume_under(t, body_->middle());
  body_->ejected += body_->heat.energy_of(mesh(), f);
  body_->mesh.remove_face(f);
  removed_.push_back(f);
  edited_.push_back(f);
}

// Precondition: the separation state of the body still holds the neighbours of f (see record_removed_part).
void BodyEdit::record_removal(FaceId f, const Triangle& corners, int64_t loops_before) {
  const FaceData& data = mesh().data(f);
  CutFace cut;
  cut.face = f;
  cut.base = body_->loaded_base(f);
  cut.piece = data.piece;
  cut.corners = corners;
  cut.closed_loop = body_->separation.loops > loops_before;
  const std::vector<FaceId>& neighbours = body_->separation.neighbours;
  KERF_ASSERT(neighbours.size() <= cut.neighbours.size());
  std::copy(neighbours.begin(), neighbours.end(), cut.neighbours.begin());
  cut_faces_.push_back(cut);
}

void BodyEdit::take_out(std::span<const FaceId> faces) {
  KERF_ASSERT(is_settled(*body_) && splits_.empty());
  KERF_ASSERT(std::is_sorted(faces.begin(), faces.end()));
  for (const FaceId f : faces) {
    forget_pair(f);
    body_->edit_piece_of(f) = Piece{};
    body_->mesh.remove_face(f);
    removed_.push_back(f);
  }
}

// Adding ----------------------------------------------------------------------------------------------------

std::vector<FaceId> BodyEdit::add_walls(FaceAddition& addition, std::span<const FaceId> beside) {
  KERF_ASSERT(is_settled(*body_) && splits_.empty() && removed_.empty());
  const std::optional<uint16_t> material = cut_material(*body_);
  std::vector<FaceData> data;
  for (const FaceId f : beside) {
    FaceData own;
    own.piece = mesh().data(f).piece;
    own.hit = true;
    own.material = material.value_or(mesh().data(f).material);
    data.push_back(own);
  }
  const std::vector<FaceId> added = addition.add(body_->mesh, data);
  KERF_ASSERT(added.size() == beside.size());
  body_->tree.add(mesh(), added);
  for (size_t i = 0; i < added.size(); ++i) {
    const FaceId f = added[i];
    body_->walls.set(body_->mesh, f, body_->loaded_base(beside[i]));
    const Triangle t = mesh().triangle(f);
    const double area = triangle_area(t);
    body_->count(f, 1, area);
    body_->edit_piece_of(f).moments += area_moments(t, area, body_->middle());
    ++solid_.wall_faces;
    solid_.wall_area += area;
    solid_.removed_volume -= volume_under(t, body_->middle());
    edited_.push_back(f);
  }
  faces_made_ += added.size();
  return added;
}

void BodyEdit::open_edges(std::span<const Mesh::Side> sides) {
  KERF_ASSERT(is_settled(*body_) && splits_.empty() && removed_.empty());
  std::vector<Mesh::Side> others(sides.begin(), sides.end());
  for (const Mesh::Side& s : sides) mesh().append_edge_sides(s.face, s.from, s.to, others);
  for (const Mesh::Side& s : others) {
    forget_pair(s.face);
    edited_.push_back(s.face);
  }
  body_->mesh.open_edges(sides, moved_);
}

// The tree stores the vertices of faces, so that the changed faces must be refitted.
bool BodyEdit::split_fans(FaceAddition& addition, size_t most) {
  return addition.split_fans(body_->mesh, most, moved_);
}

// Turning and moving ----------------------------------------------------------------------------------------

void BodyEdit::flip_edge(FaceId f, VertexId from, VertexId to) {
  KERF_ASSERT(mesh().can_flip_edge(f, from, to));
  std::vector<Mesh::Side> sides;
  mesh().append_edge_sides(f, from, to, sides);
  KERF_ASSERT(sides.size() == 1);
  const std::array<FaceId, 2> faces{f, sides[0].face};
  // While a search assigns labels, the two may belong to different pieces.
  const bool one_piece = mesh().data(faces[0]).piece == mesh().data(faces[1]).piece;
  std::array<double, 2> before;
  for (size_t i = 0; i < 2; ++i) {
    forget_pair(faces[i]);
    before[i] = triangle_area(mesh().triangle(faces[i]));
    if (!one_piece) body_->edit_piece_of(faces[i]).moments -= moments_of(faces[i]);
  }
  body_->mesh.flip_edge(f, from, to);
  for (size_t i = 0; i < 2; ++i) {
    const double area = triangle_area(mesh().triangle(faces[i]));
    follow_area(body_->mesh.edit_data(faces[i]), before[i], area);
    moved_.push_back(faces[i]);
    edited_.push_back(faces[i]);
    record_flipped(*body_, faces[i], area - before[i]);
    if (!one_piece) body_->edit_piece_of(faces[i]).moments += moments_of(faces[i]);
  }
}

void BodyEdit::move_vertex(VertexId v, const Vec3& to, const Mesh::Star& around) {
  KERF_ASSERT(around.alone);
  KERF_ASSERT(!around.faces.empty());
  const Vec3 origin = body_->middle();
  std::vector<Triangle> before;
  for (const FaceId f : around.faces) {
    forget_pair(f);
    before.push_back(mesh().triangle(f));
  }
  body_->mesh.move_vertex(v, to);
  for (size_t i = 0; i < around.faces.size(); ++i) {
    const FaceId f = around.faces[i];
    const Triangle now = mesh().triangle(f);
    const double old_area = triangle_area(before[i]), area = triangle_area(now);
    follow_area(body_->mesh.edit_data(f), old_area, area);
    count(f, 0, area - old_area);
    if (body_->solid) solid_.removed_volume += volume_under(before[i], origin) - volume_under(now, origin);
    AreaMoments& moments = body_->edit_piece_of(f).moments;
    moments -= area_moments(before[i], old_area, origin);
    moments += area_moments(now, area, origin);
    moved_.push_back(f);
    edited_.push_back(f);
  }
}

// Updating --------------------------------------------------------------------------------------------------

void BodyEdit::update_tree() {
  KERF_ASSERT(splits_.empty() || removed_.empty());
  if (!splits_.empty()) body_->tree.replace(mesh(), splits_);
  splits_.clear();
  for (const FaceId f : removed_) body_->tree.remove(f);
  removed_.clear();
  body_->tree.fit_bounds(mesh());
  body_->tree.vary(mesh());
}

void BodyEdit::refit_tree() {
  KERF_ASSERT(splits_.empty() && removed_.empty());
  std::erase_if(moved_, [&](FaceId f) { return !mesh().is_live(f); });
  body_->tree.refit(mesh(), moved_);
  moved_.clear();
  body_->tree.fit_bounds(mesh());
}

QueryCounts BodyEdit::touched(const SweptCylinder& beam, std::vector<FaceId>& out) {
  KERF_ASSERT(splits_.empty() && removed_.empty());
  std::vector<FaceId> near;
  const QueryCounts counts = body_->tree.touched(mesh(), beam, out, &near);
  for (const FaceId f : near) {
    if (!mesh().data(f).hit) body_->mesh.edit_data(f).hit = true;
  }
  return counts;
}

void BodyEdit::clear_hit(FaceId f) {
  if (mesh().data(f).hit) body_->mesh.edit_data(f).hit = false;
}

size_t BodyEdit::separate(size_t most, EditPolicy policy) {
  const SettleResult result = settle(*body_, most, policy);
  new_pieces_.insert(new_pieces_.end(), result.new_pieces.begin(), result.new_pieces.end());
  relabelled_.insert(relabelled_.end(), result.relabelled.begin(), result.relabelled.end());
  return result.visited + result.relabelled.size();
}

BodyDelta BodyEdit::take_delta(BodyId id) {
  KERF_ASSERT(splits_.empty() && removed_.empty());
  BodyDelta delta;
  delta.body = id;
  sort_each_once(edited_);
  for (const FaceId f : edited_) (mesh().is_live(f) ? delta.added : delta.dead).push_back(f);
  sort_each_once(relabelled_);
  std::erase_if(relabelled_, [&](FaceId f) { return !mesh().is_live(f); });
  delta.relabelled = std::exchange(relabelled_, {});
  delta.new_pieces = std::exchange(new_pieces_, {});
  delta.removed = std::exchange(cut_faces_, {});
  edited_.clear();
  return delta;
}

}  // namespace kerf
