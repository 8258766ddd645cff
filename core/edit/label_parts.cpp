#include <algorithm>
#include <utility>

#include "core/base/assert.h"
#include "core/edit/part_search.h"

namespace kerf {

void PartSearch::assign_labels(SettleResult& result) {
  std::vector<uint32_t> came_off;
  for (const Found& found : found_) {
    std::vector<uint32_t> parts;
    for (uint32_t i = 0; i < search_.fronts.size(); ++i) {
      const SearchFront& front = search_.fronts[i];
      if (search_.front_parent[i] != i || !front.exhausted() || front.faces == 0) continue;
      if (&body_.whole_of(search_.seed[i]) == found.whole) parts.push_back(i);
    }
    if (found.rest_faces() == 0) drop_largest(parts);
    came_off.insert(came_off.end(), parts.begin(), parts.end());
  }
  std::sort(came_off.begin(), came_off.end(),
            [&](uint32_t a, uint32_t b) { return search_.fronts[a].lowest < search_.fronts[b].lowest; });
  search_.new_label.assign(search_.fronts.size(), 0);
  for (const uint32_t part : came_off) give_label(part, result);
  search_.stage = came_off.empty() ? OpenSearch::Stage::kNone : OpenSearch::Stage::kRelabel;
  if (came_off.empty()) return reset();
  for (uint32_t i = 0; i < search_.fronts.size(); ++i)
    search_.new_label[i] = search_.new_label[root(search_.front_parent, i)];
}

void PartSearch::drop_largest(std::vector<uint32_t>& parts) const {
  double largest = 0, whole = 0;
  for (const uint32_t part : parts) {
    largest = std::max(largest, search_.fronts[part].area);
    whole += search_.fronts[part].area;
  }
  const auto rank = [&](uint32_t part) {
    const SearchFront& front = search_.fronts[part];
    return std::pair(largest - front.area > kEqualArea * whole, front.lowest);
  };
  const auto stays =
      std::min_element(parts.begin(), parts.end(), [&](uint32_t a, uint32_t b) { return rank(a) < rank(b); });
  if (stays != parts.end()) parts.erase(stays);
}

// Transfers the counts at once; relabel() transfers the faces and their moments one by one.
void PartSearch::give_label(uint32_t part, SettleResult& result) {
  const SearchFront& front = search_.fronts[part];
  const FaceId seed = search_.seed[part];
  FaceCounts &old = body_.edit_piece_of(seed), &whole = body_.edit_whole_of(seed);
  for (FaceCounts* counts : {&old, &whole}) {
    KERF_ASSERT(counts->faces >= front.faces);
    counts->faces -= front.faces;
    counts->area -= front.area;
    if (&old == &whole) break;
  }
  search_.new_label[part] = body_.pieces.size();
  result.new_pieces.push_back(search_.new_label[part]);
  body_.pieces.push_back({{front.faces, front.area}, {}, {front.faces, front.area}});
}

// Relabels faces in slot order. Returns true if all have their labels.
bool PartSearch::relabel(size_t most, SettleResult& result) {
  const bool complete = find_unlabelled(most - std::min(most, result.relabelled.size()));
  moved_from_.clear();
  const size_t first = result.relabelled.size();
  for (const FaceId f : unlabelled_) {
    const uint32_t label = search_.label_to_be(f);
    if (body_.mesh.data(f).piece == label) continue;  // already labelled with the other half of its pair
    if (body_.mesh.data(f).element == FaceData::kNoElement) {
      assign_label(f, label, result);
      continue;
    }
    // Relabels both halves of a green pair at once: the faces that replace the pair take area from both.
    const OneToFour::Element pair = body_.refinement.element(body_.mesh, f);
    for (int i = 0; i < pair.face_count; ++i) assign_label(pair.faces[i], label, result);
  }
  move_moments(std::span(result.relabelled).subspan(first));
  if (!complete) return false;
  search_.stage = OpenSearch::Stage::kNone;
  reset();
  return true;
}

void PartSearch::assign_label(FaceId f, uint32_t label, SettleResult& result) {
  moved_from_.push_back(std::exchange(body_.mesh.edit_data(f).piece, label));
  result.relabelled.push_back(f);
}

// Moves the moments of relabelled faces from their former pieces.
void PartSearch::move_moments(std::span<const FaceId> faces) {
  const std::span<const Triangle> triangles = walk_.triangles(faces);
  const Vec3 origin = body_.middle();
  AreaMoments *left = nullptr, *gained = nullptr;
  uint32_t from = kNoIndex, to = kNoIndex;
  for (size_t i = 0; i < faces.size(); ++i) {
    const uint32_t label = body_.mesh.data(faces[i]).piece;
    if (moved_from_[i] != from) left = &body_.pieces.edit(from = moved_from_[i]).moments;
    if (label != to) gained = &body_.pieces.edit(to = label).moments;
    const AreaMoments moments = area_moments(triangles[i], triangle_area(triangles[i]), origin);
    *left -= moments;
    *gained += moments;
  }
}

// Sets `unlabelled_` to at most `most` faces without their label. Returns true if they are the last.
bool PartSearch::find_unlabelled(size_t most) {
  constexpr uint32_t kPage = PagedArray<uint32_t>::kPage;
  unlabelled_.clear();
  for (uint32_t& next = search_.next_slot; next < search_.mark.end();) {
    const uint32_t* marks = search_.mark.page(next);
    const uint32_t page_end = next - next % kPage + kPage;
    if (marks == nullptr) next = page_end;
    for (; next < page_end; ++next) {
      const uint32_t label = search_.label_of(marks[next % kPage]);
      if (label == 0) continue;
      const FaceId f(next);
      if (!body_.mesh.is_live(f) || body_.mesh.data(f).piece == label) continue;
      if (unlabelled_.size() >= most) return false;
      unlabelled_.push_back(f);
    }
  }
  return true;
}

void PartSearch::reset() {
  search_.mark.clear();
  search_.fronts.clear();
  search_.new_label.clear();
  search_.next_slot = 0;
}

}  // namespace kerf
