#include "core/world/delta.h"

#include <algorithm>
#include <iterator>

namespace kerf {

namespace {

// The union of two ascending lists.
void unite(std::vector<FaceId>& faces, const std::vector<FaceId>& more) {
  std::vector<FaceId> both;
  std::set_union(faces.begin(), faces.end(), more.begin(), more.end(), std::back_inserter(both));
  faces = std::move(both);
}

void take_away(std::vector<FaceId>& faces, const std::vector<FaceId>& these) {
  std::vector<FaceId> rest;
  std::set_difference(faces.begin(), faces.end(), these.begin(), these.end(), std::back_inserter(rest));
  faces = std::move(rest);
}

void append_body(BodyDelta& body, const BodyDelta& later) {
  unite(body.born, later.born);
  take_away(body.born, later.gone);
  unite(body.gone, later.gone);
  take_away(body.gone, later.born);
  unite(body.relabelled, later.relabelled);
  take_away(body.relabelled, body.gone);
  body.new_pieces.insert(body.new_pieces.end(), later.new_pieces.begin(), later.new_pieces.end());
}

}  // namespace

void Delta::append(Delta later) {
  removed_faces += later.removed_faces;
  removed_area += later.removed_area;
  anew = anew || later.anew;
  for (BodyDelta& b : later.bodies) {
    const auto same =
        std::find_if(bodies.begin(), bodies.end(), [&](const BodyDelta& a) { return a.body == b.body; });
    if (same == bodies.end()) {
      bodies.push_back(std::move(b));
    } else {
      append_body(*same, b);
    }
  }
}

}  // namespace kerf
