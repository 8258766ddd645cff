#include "core/joints/piece_groups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/edit/separation.h"

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

}  // namespace kerf
