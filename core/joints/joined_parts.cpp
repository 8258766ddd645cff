#include "core/joints/joined_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "core/base/assert.h"
#include "core/base/containers.h"
#include "core/edit/detach.h"
#include "core/edit/separation.h"
#include "core/mesh/measures.h"

namespace kerf {

namespace {

constexpr double kCells = 64;  // along the longest side of the bounds

// A grid over the bounds of a body that maps each cell to the nearest of some labelled points, measured in
// steps between neighbouring cells. Of equally near points the one added first wins.
class LabelGrid {
 public:
  explicit LabelGrid(const Bounds& bounds) : origin_(bounds.min) {
    const Vec3 extent = bounds.max - bounds.min;
    cell_ = std::max({extent.x, extent.y, extent.z}) / kCells;
    for (int axis = 0; axis < 3; ++axis)
      size_[axis] = cell_ > 0 ? static_cast<uint32_t>(extent[axis] / cell_) + 1 : 1;
    label_.resize(size_t{size_[0]} * size_[1] * size_[2], kNoIndex);
  }
  double cell() const { return cell_; }

  void add(const Vec3& point, uint32_t label) { reach(cell_of(point), label); }

  // Spreads the labels to all other cells, breadth first.
  void flood() {
    KERF_ASSERT(!reached_.empty());
    const std::array<uint32_t, 3> stride{1, size_[0], size_[0] * size_[1]};
    for (size_t next = 0; next < reached_.size(); ++next) {
      const uint32_t from = reached_[next];
      for (size_t axis = 0; axis < 3; ++axis) {
        const uint32_t at = from / stride[axis] % size_[axis];
        if (at > 0) reach(from - stride[axis], label_[from]);
        if (at + 1 < size_[axis]) reach(from + stride[axis], label_[from]);
      }
    }
  }

  uint32_t nearest(const Vec3& point) const { return label_[cell_of(point)]; }

 private:
  uint32_t cell_of(const Vec3& point) const {
    std::array<uint32_t, 3> at{};
    for (int axis = 0; axis < 3; ++axis) {
      const double cells = cell_ > 0 ? (point[axis] - origin_[axis]) / cell_ : 0;
      at[axis] = static_cast<uint32_t>(std::clamp(cells, 0.0, size_[axis] - 1.0));
    }
    return (at[2] * size_[1] + at[1]) * size_[0] + at[0];
  }
  void reach(uint32_t cell, uint32_t label) {
    if (label_[cell] != kNoIndex) return;
    label_[cell] = label;
    reached_.push_back(cell);
  }

  Vec3 origin_;
  double cell_ = 0;
  std::array<uint32_t, 3> size_{};
  std::vector<uint32_t> label_, reached_;
};

// A component of the mesh.
struct Component {
  uint32_t piece = kNoIndex;
  double area = 0;  // m^2
  Vec3 moment{0};   // m^3
  bool largest = false;
  std::map<uint32_t, double> nearest;  // by piece: area of the faces that are nearest to it
};

// Adds points of a triangle, at most a cell apart unless the triangle is longer than all cells.
void add_points(const Triangle& t, uint32_t label, LabelGrid& grid) {
  const double longest = std::sqrt(longest_edge2(t));
  const int parts =
      grid.cell() > 0 ? static_cast<int>(std::clamp(std::ceil(longest / grid.cell()), 1.0, kCells)) : 1;
  for (int i = 0; i <= parts; ++i) {
    for (int j = 0; i + j <= parts; ++j)
      grid.add((t[0] * double(parts - i - j) + t[1] * double(i) + t[2] * double(j)) / double(parts), label);
  }
}

Vec3 centre(const Triangle& t) { return (t[0] + t[1] + t[2]) / 3.0; }

template <typename Visit>
void for_each_live(const Mesh& mesh, const Visit& visit) {
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_live(FaceId(f))) visit(FaceId(f));
  }
}

std::vector<Component> components_of(const Body& body, const std::vector<uint32_t>& component, size_t count) {
  std::vector<Component> all(count);
  for_each_live(body.mesh, [&](FaceId f) {
    Component& c = all[component[f.index]];
    const Triangle t = body.mesh.triangle(f);
    const double area = triangle_area(t);
    c.piece = body.mesh.data(f).piece;
    c.area += area;
    c.moment += centre(t) * area;
  });
  std::vector<Component*> largest(body.pieces.size());
  for (Component& c : all) {
    KERF_ASSERT(c.piece < body.pieces.size());
    Component*& of_piece = largest[c.piece];
    if (!of_piece || c.area > of_piece->area) of_piece = &c;
  }
  for (Component* c : largest) {
    if (c) c->largest = true;
  }
  return all;
}

// Returns by component the label of the piece with which it moves.
std::vector<uint32_t> companions(const Body& body, const std::vector<uint32_t>& component,
                                 std::vector<Component>& all) {
  LabelGrid grid(body.bounds());
  for_each_live(body.mesh, [&](FaceId f) {
    const Component& c = all[component[f.index]];
    if (c.largest) add_points(body.mesh.triangle(f), c.piece, grid);
  });
  grid.flood();
  for_each_live(body.mesh, [&](FaceId f) {
    Component& c = all[component[f.index]];
    if (c.largest) return;
    const Triangle t = body.mesh.triangle(f);
    c.nearest[grid.nearest(centre(t))] += triangle_area(t);
  });
  std::vector<uint32_t> goes_with;
  for (const Component& c : all) {
    uint32_t best = c.piece;
    double most = 0;
    for (const auto& [piece, area] : c.nearest) {
      if (area > most) {
        most = area;
        best = piece;
      }
    }
    goes_with.push_back(best);
  }
  return goes_with;
}

// Computes by piece the centre of area of all faces that move with it.
class Centres {
 public:
  explicit Centres(const Body& body) {
    for (uint32_t label = 0; label < body.pieces.size(); ++label) {
      const Piece& piece = body.pieces[label];
      const double area = piece.faces > 0 ? std::max(piece.area, 0.0) : 0.0;
      sums_.push_back({area, piece.moments.first + body.middle() * area});
    }
  }
  void move(const Component& c, uint32_t to) {
    KERF_ASSERT(std::max(c.piece, to) < sums_.size());
    sums_[c.piece].area -= c.area;
    sums_[c.piece].moment -= c.moment;
    sums_[to].area += c.area;
    sums_[to].moment += c.moment;
  }
  std::vector<Vec3> middles() const {
    std::vector<Vec3> all;
    for (const Sum& s : sums_) all.push_back(s.area > 0 ? s.moment / s.area : Vec3(0));
    return all;
  }

 private:
  struct Sum {
    double area;  // m^2
    Vec3 moment;  // m^3
  };
  std::vector<Sum> sums_;
};

bool is_cut(const Body& body) {
  uint32_t live = 0;
  for (uint32_t label = 0; label < body.pieces.size(); ++label) live += body.pieces[label].faces > 0;
  return live > 1;
}

bool comes_before(const PieceGroups::Loose& a, const PieceGroups::Loose& b) {
  return std::pair(a.piece, a.goes_with) < std::pair(b.piece, b.goes_with);
}

void find_loose(const Body& body, PieceGroups& groups, Centres& centres) {
  std::vector<uint32_t> component;
  const size_t count = label_components(body.mesh, component);
  std::vector<Component> all = components_of(body, component, count);
  const std::vector<uint32_t> goes_with = companions(body, component, all);
  for (size_t i = 0; i < count; ++i) {
    if (goes_with[i] == all[i].piece) continue;
    groups.loose.push_back({all[i].piece, goes_with[i]});
    centres.move(all[i], goes_with[i]);
  }
  if (groups.loose.empty()) return;
  std::sort(groups.loose.begin(), groups.loose.end(), comes_before);
  groups.loose.erase(std::unique(groups.loose.begin(), groups.loose.end()), groups.loose.end());
  const auto group_of = [&](size_t i) {
    const PieceGroups::Loose pair{all[i].piece, goes_with[i]};
    if (pair.piece == pair.goes_with) return pair.piece;
    const auto found = std::lower_bound(groups.loose.begin(), groups.loose.end(), pair, comes_before);
    return static_cast<uint32_t>(body.pieces.size()) + static_cast<uint32_t>(found - groups.loose.begin());
  };
  std::vector<uint32_t> group(count);
  for (size_t i = 0; i < count; ++i) group[i] = group_of(i);
  groups.of_face.resize(body.mesh.face_slots(), kNoIndex);
  for_each_live(body.mesh, [&](FaceId f) { groups.of_face[f.index] = group[component[f.index]]; });
}

// State of one side of a joint during the visit of faces.
struct SideState {
  std::optional<ConnectedPart> part;
  bool apart = false;
  bool reaches_pin = false;
  bool holds() const { return part && !apart && reaches_pin; }
  // Returns true if a face of this part may change the state.
  bool is_open(const ConnectedPart& other) const {
    return !part || (!apart && (*part != other || !reaches_pin));
  }
  void add(const ConnectedPart& other) {
    apart = part && *part != other;
    if (!part) part = other;
  }
};

// Sides of joints (joint index times two, plus the side) by the loaded face that carries them.
class Carriers {
 public:
  Carriers(const Joints& joints, BodyId loaded_as) {
    for_each_pair(joints, loaded_as, [&](uint32_t face, uint32_t) {
      if (first_.size() <= face + 1) first_.resize(size_t{face} + 2, 0);
      ++first_[face];
    });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    if (!first_.empty()) sides_.resize(first_.back());
    for_each_pair(joints, loaded_as, [&](uint32_t face, uint32_t side) { sides_[--first_[face]] = side; });
  }

  bool empty() const { return sides_.empty(); }

  std::span<const uint32_t> sides_of(FaceId loaded) const {
    if (loaded.index + 1 >= first_.size()) return {};
    const uint32_t first = first_[loaded.index];
    return std::span(sides_).subspan(first, first_[loaded.index + 1] - first);
  }

 private:
  template <typename Visit>
  static void for_each_pair(const Joints& joints, BodyId loaded_as, Visit visit) {
    for (uint32_t j = 0; j < joints.all.size(); ++j) {
      if (joints.all[j].body != loaded_as) continue;
      for (uint32_t s = 0; s < 2; ++s) {
        for (const uint32_t f : joints.all[j].sides[s].faces) visit(f, 2 * j + s);
      }
    }
  }

  std::vector<uint32_t> sides_;
  std::vector<uint32_t> first_;  // by loaded face: index in sides_
};

bool is_near(const Vec3& point, double radius, const Triangle& t) {
  const Vec3 low = glm::min(glm::min(t[0], t[1]), t[2]), high = glm::max(glm::max(t[0], t[1]), t[2]);
  for (int k = 0; k < 3; ++k) {
    if (low[k] - point[k] > radius || point[k] - high[k] > radius) return false;
  }
  return squared_distance(point, t) <= radius * radius;
}

void look_through(BodyId id, const Body& body, const Joints& joints, const Carriers& carriers,
                  std::vector<SideState>& sides) {
  KERF_ASSERT(sides.size() == 2 * joints.all.size());
  for (uint32_t slot = 0; slot < body.mesh.face_slots(); ++slot) {
    const FaceId f(slot);
    if (!body.mesh.is_live(f)) continue;
    const std::span<const uint32_t> carried = carriers.sides_of(body.loaded_face(body.loaded_base(f)));
    if (carried.empty()) continue;
    const ConnectedPart part = part_of(id, body, f);
    for (const uint32_t side : carried) {
      SideState& known = sides[side];
      if (!known.is_open(part)) continue;
      const Joint& joint = joints.all[side / 2];
      const JointSide& own = joint.sides[side % 2];
      const Triangle t = body.mesh.triangle(f);
      if (!is_near(own.point, own.radius, t)) continue;
      known.add(part);
      known.reaches_pin = known.reaches_pin || is_near(joint.anchor, own.reaches_pin, t);
    }
  }
}

// Returns the loaded faces from which those of a piece were made, ascending, one entry per face of the piece.
std::vector<uint32_t> loaded_faces_of(const Body& body, uint32_t label) {
  std::vector<uint32_t> faces;
  for (const FaceId f : body.faces_of(label)) faces.push_back(body.loaded_face(body.loaded_base(f)).index);
  std::sort(faces.begin(), faces.end());
  return faces;
}

// Loaded components that joints name, by the body as which they were loaded.
class NamedComponents {
 public:
  explicit NamedComponents(const Joints& joints) {
    for (const Joint& joint : joints.all) {
      for (const JointSide& side : joint.sides) of_[joint.body].insert(side.component);
    }
  }
  // Returns null if the body has no joints.
  const std::set<uint32_t>* of(const Body& body) const {
    const auto at = of_.find(body.loaded_as);
    return at != of_.end() && !body.is_copy ? &at->second : nullptr;
  }

 private:
  std::map<BodyId, std::set<uint32_t>> of_;
};

// Connected parts of all bodies with joints, and their grouping.
class Groups {
 public:
  Groups(const World& world, JointMode mode, const LoadedBodies& of) : world_(world) {
    const NamedComponents named(world.joints());
    for (const BodyId id : world.ids()) {
      if (!std::ranges::binary_search(of, world.body(id).loaded_as)) continue;
      if (const auto* own = named.of(world.body(id))) add_parts(id, *own);
    }
    together_ = UnionFind(parts_.size());
    unite_unnamed();
    for (const HeldJoint& held : held_joints(world, of)) {
      const bool turns = world.joints().all[held.joint].kind != Joint::Kind::kWeld;
      const bool moves = mode == JointMode::kArticulated || held.parts[0].piece() != held.parts[1].piece();
      if (turns && moves) continue;
      together_.unite(index_of(held.parts[0]), index_of(held.parts[1]));
    }
  }

  // Returns the components that must move to another piece, by body. Labels from Body::pieces.size() on are
  // new.
  std::map<BodyId, std::map<uint32_t, uint32_t>> changes() {
    std::map<BodyId, std::map<uint32_t, uint32_t>> changes;
    std::map<std::pair<BodyId, uint32_t>, uint32_t> new_label;  // by body and group
    std::map<BodyId, uint32_t> labels;
    for (uint32_t i = 0; i < parts_.size(); ++i) {
      const ConnectedPart& part = parts_[i].part;
      const uint32_t group = together_.find(i);
      if (together_.find(seat_.at(part.piece())) == group) continue;
      const auto seat = largest_seat(part, group);
      if (seat) {
        changes[part.body][part.component] = *seat;
        continue;
      }
      const uint32_t next = labels.try_emplace(part.body, world_.body(part.body).pieces.size()).first->second;
      const auto [label, is_new] = new_label.try_emplace({part.body, group}, next);
      if (is_new) ++labels[part.body];
      changes[part.body][part.component] = label->second;
    }
    return changes;
  }

 private:
  struct Part {
    ConnectedPart part;
    double area = 0;
    bool named = false;  // by a joint
  };

  // Adds the parts in ascending order, and the seat of each piece, to which its other parts belong: the
  // part that was cut off, or the largest one.
  void add_parts(BodyId id, const std::set<uint32_t>& named) {
    const Body& body = world_.body(id);
    const auto add = [&](const ConnectedPart& part, const FaceCounts& counts, bool is_named) {
      // A component without faces may have no home.
      if (counts.faces == 0 || body.pieces[part.label].faces == 0) return;
      const auto at = static_cast<uint32_t>(parts_.size());
      parts_.push_back({part, counts.area, is_named});
      index_.emplace(part, at);
      const auto [seat, is_first] = seat_.try_emplace(part.piece(), at);
      const Part& other = parts_[seat->second];
      const bool cut_off = part.component == LoadedComponents::kNone;
      const bool other_cut_off = other.part.component == LoadedComponents::kNone;
      if (!is_first && (cut_off || (!other_cut_off && counts.area > other.area))) seat->second = at;
    };
    std::set<uint32_t> merged;
    for (const uint32_t c : named) merged.insert(body.components.merged(c));
    for (uint32_t c = 0; c < body.components.left.size(); ++c)
      add({id, body.components.home[c], c}, body.components.left[c], merged.contains(c));
    const bool connected = body.components.of_base.empty();
    for (uint32_t label = 0; label < body.pieces.size(); ++label) {
      const Piece& piece = body.pieces[label];
      const FaceCounts& whole = label == 0 && connected ? piece : piece.cut_off;
      add({id, label, LoadedComponents::kNone}, whole, true);
    }
  }

  void unite_unnamed() {
    for (uint32_t i = 0; i < parts_.size(); ++i) {
      if (!parts_[i].named) together_.unite(i, seat_.at(parts_[i].part.piece()));
    }
  }

  uint32_t index_of(const ConnectedPart& part) const {
    const auto at = index_.find(part);
    KERF_ASSERT(at != index_.end());
    return at->second;
  }

  // Returns the label of the piece in the body of a loaded component whose seat is in the group, the
  // largest of several. The rest of a component and a part that was cut off it differ by label, so they
  // stay two pieces even if joints connect them.
  std::optional<uint32_t> largest_seat(const ConnectedPart& component, uint32_t group) {
    std::optional<uint32_t> label;
    double area = 0;
    for (const auto& [piece, seat] : seat_) {
      if (piece.body != component.body || together_.find(seat) != group) continue;
      if (label && parts_[seat].area <= area) continue;
      if (cut_off_from(piece) == component.component) continue;
      label = piece.label;
      area = parts_[seat].area;
    }
    return label;
  }

  // Returns the component from which the seat of a piece was cut off; kNone if none was.
  uint32_t cut_off_from(const PieceId& piece) {
    const Body& body = world_.body(piece.body);
    if (body.pieces[piece.label].cut_off.faces == 0) return LoadedComponents::kNone;
    const auto [known, is_new] = cut_off_from_.try_emplace(piece, LoadedComponents::kNone);
    for (uint32_t f = 0; is_new && f < body.mesh.face_slots(); ++f) {
      if (!body.mesh.is_live(FaceId(f)) || body.label(FaceId(f)) != piece.label) continue;
      const FaceId base = body.loaded_base(FaceId(f));
      if (body.components.at_home(base, piece.label) != LoadedComponents::kNone) continue;
      known->second = body.components.of(base);
      break;
    }
    return known->second;
  }

  const World& world_;
  std::vector<Part> parts_;
  std::map<ConnectedPart, uint32_t> index_;  // index in parts_
  std::map<PieceId, uint32_t> seat_;
  std::map<PieceId, uint32_t> cut_off_from_;
  UnionFind together_{0};
};

void separate_loaded_by_joints(World& world, const LoadedBodies& of, JointMode mode, Delta& delta) {
  Delta step;
  for (const auto& [id, label_of] : Groups(world, mode, of).changes())
    step.bodies.push_back(move_components(id, world.body(id), label_of));
  for (const BodyId id : world.ids()) {
    KERF_ASSERT(is_settled(world.body(id)));
    world.body(id).separation.joints_requested = false;
  }
  delta.append(std::move(step));
}

// Returns true if one of the removed faces carried a joint.
bool any_carries(const Joints& joints, const Body& body, std::span<const FaceId> removed) {
  const std::vector<const JointSide*> sides = joints.sides_of(body.loaded_as);
  if (sides.empty()) return false;
  return std::ranges::any_of(removed, [&](FaceId f) {
    if (body.mesh.is_live(f)) return false;
    const FaceId loaded = body.loaded_face(body.loaded_base(f));
    return std::ranges::any_of(sides, [&](const JointSide* side) { return side->carries(loaded); });
  });
}

}  // namespace

PieceGroups group_pieces(const Body& body) {
  PieceGroups groups;
  Centres centres(body);
  if (is_cut(body)) find_loose(body, groups, centres);
  groups.middles = centres.middles();
  return groups;
}

std::vector<FaceId> regrouped(const Mesh& mesh, const PieceGroups* before, const PieceGroups* after) {
  std::vector<FaceId> faces;
  const auto splits = [](const PieceGroups* groups) { return groups && !groups->loose.empty(); };
  if (before == after || (!splits(before) && !splits(after))) return faces;
  const auto group = [&](const PieceGroups* groups, FaceId f) {
    return groups ? groups->of(mesh, f) : mesh.data(f).piece;
  };
  for_each_live(mesh, [&](FaceId f) {
    if (group(before, f) != group(after, f)) faces.push_back(f);
  });
  return faces;
}

ConnectedPart part_of(BodyId id, const Body& body, FaceId f) {
  KERF_ASSERT(body.mesh.is_live(f));
  const uint32_t label = body.mesh.data(f).piece;
  return {id, label, body.components.at_home(body.loaded_base(f), label)};
}

LoadedBodies bodies_with_joints(const Joints& joints) {
  LoadedBodies bodies;
  for (const Joint& joint : joints.all) bodies.push_back(joint.body);
  std::ranges::sort(bodies);
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  return bodies;
}

std::vector<HeldJoint> held_joints(const World& world) {
  return held_joints(world, bodies_with_joints(world.joints()));
}

std::vector<HeldJoint> held_joints(const World& world, const LoadedBodies& of) {
  KERF_ASSERT(std::ranges::is_sorted(of));
  const std::vector<Joint>& all = world.joints().all;
  std::vector<HeldJoint> held;
  if (all.empty() || of.empty()) return held;
  std::vector<SideState> sides(2 * all.size());
  std::map<BodyId, Carriers> carriers;  // by the body as which faces were loaded
  for (const BodyId id : world.ids()) {
    const BodyId loaded_as = world.body(id).loaded_as;
    if (world.body(id).is_copy || !std::ranges::binary_search(of, loaded_as)) continue;
    auto at = carriers.find(loaded_as);
    if (at == carriers.end()) at = carriers.emplace(loaded_as, Carriers(world.joints(), loaded_as)).first;
    if (!at->second.empty()) look_through(id, world.body(id), world.joints(), at->second, sides);
  }
  for (uint32_t j = 0; j < all.size(); ++j) {
    const SideState &a = sides[2 * j], &b = sides[2 * j + 1];
    if (a.holds() && b.holds()) held.push_back({j, {*a.part, *b.part}});
  }
  return held;
}

bool is_loaded_part(const Body& body, uint32_t label) {
  KERF_ASSERT(label < body.pieces.size());
  return label != 0 && body.pieces[label].faces > 0 && body.pieces[label].cut_off.faces == 0;
}

std::string loaded_part_name(const World& world, const PieceId& piece) {
  const Body& body = world.body(piece.body);
  if (!world.contains(body.loaded_as) || world.body(body.loaded_as).named_parts.empty()) return "";
  const std::vector<uint32_t> faces = loaded_faces_of(body, piece.label);
  const MeshPart* best = nullptr;
  ptrdiff_t most = 0;
  for (const MeshPart& part : world.body(body.loaded_as).named_parts) {
    const auto first = std::lower_bound(faces.begin(), faces.end(), part.first);
    const ptrdiff_t held = std::lower_bound(first, faces.end(), part.last) - first;
    const bool smaller = best != nullptr && part.last - part.first < best->last - best->first;
    if (held < most || held == 0 || (held == most && !smaller)) continue;
    best = &part;
    most = held;
  }
  return best != nullptr ? best->name : "";
}

void separate_by_joints(World& world, JointMode mode, Delta& delta) {
  const LoadedBodies all = bodies_with_joints(world.joints());
  if (!all.empty()) separate_loaded_by_joints(world, all, mode, delta);
}

void separate_requested_by_joints(World& world, JointMode mode, Delta& delta) {
  LoadedBodies asked;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    if (body.separation.joints_requested) asked.push_back(body.loaded_as);
  }
  std::ranges::sort(asked);
  if (!asked.empty()) separate_loaded_by_joints(world, asked, mode, delta);
}

bool joints_requested(const World& world) {
  if (world.joints().all.empty()) return false;
  return std::ranges::any_of(world.ids(),
                             [&](BodyId id) { return world.body(id).separation.joints_requested; });
}

void request_joints(const World& world, Body& body, std::span<const FaceId> removed, bool separated) {
  const Joints& joints = world.joints();
  if (joints.all.empty() || body.separation.joints_requested) return;
  body.separation.joints_requested = separated || any_carries(joints, body, removed);
}

}  // namespace kerf
