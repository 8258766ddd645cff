#include "core/world/body_mass.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/mesh/face_batches.h"
#include "core/mesh/measures.h"

namespace kerf {

namespace {

// Minimum volume, in units of the frame below, cubed. Smaller ones are indistinguishable from rounding.
constexpr double kMinVolume = 1e-9;

// The cube around a piece, scaled so that the piece extends about from -1 to 1 around its middle.
struct PieceFrame {
  static constexpr int kMaxExponent = 1000;
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  void add(const Triangle& t) {
    for (const Vec3& p : t) {
      min = glm::min(min, p);
      max = glm::max(max, p);
    }
  }
  void close() {
    const Vec3 reach = 0.5 * max - 0.5 * min;
    (void)std::frexp(std::max({reach.x, reach.y, reach.z}), &exponent);
    exponent = std::clamp(exponent, -kMaxExponent, kMaxExponent);  // the scale is finite
    middle = 0.5 * max + 0.5 * min;
  }
  Triangle from_middle(const Triangle& t) const {
    const double scale = std::ldexp(1.0, -exponent);
    return {scale * (t[0] - middle), scale * (t[1] - middle), scale * (t[2] - middle)};
  }

  Vec3 min{kFar}, max{-kFar}, middle{0};
  int exponent = 0;
};

// Rotates a triangle to its lexicographically first corner, so that rounding does not depend on its start.
Triangle from_first_corner(const Triangle& t) {
  size_t first = 0;
  for (size_t i = 1; i < 3; ++i) {
    if (lexicographic_less(t[i], t[first])) first = i;
  }
  return {t[first], t[(first + 1) % 3], t[(first + 2) % 3]};
}

struct FixedVolumeSums {
  FixedSum volume;
  std::array<FixedSum, 3> first;
  std::array<FixedSum, 6> second;

  void add(const VolumeMoments& moments) {
    volume.add(moments.volume);
    for (int k = 0; k < 3; ++k) first[static_cast<size_t>(k)].add(moments.first[k]);
    for (size_t i = 0; i < second.size(); ++i) second[i].add(moments.second[i]);
  }
  VolumeMoments moments() const {
    VolumeMoments moments;
    moments.volume = volume.value(0);
    for (int k = 0; k < 3; ++k) moments.first[k] = first[static_cast<size_t>(k)].value(0);
    for (size_t i = 0; i < second.size(); ++i) moments.second[i] = second[i].value(0);
    return moments;
  }
};

// Converts mass properties from the units of a frame to metres.
MassProperties in_metres(const MassProperties& p, const PieceFrame& frame) {
  return {std::ldexp(p.mass, 3 * frame.exponent), frame.middle + std::ldexp(1.0, frame.exponent) * p.centre,
          std::ldexp(1.0, 5 * frame.exponent) * p.inertia};
}

bool has_inertia(const MassProperties& p) {
  const double sum = p.inertia[0][0] + p.inertia[1][1] + p.inertia[2][2];
  return std::isfinite(p.mass) && p.mass > 0 && std::isfinite(sum) && sum > 0;
}

// Sums by label; those of open pieces stay empty.
struct LabelledSums {
  std::vector<bool> closed;
  std::vector<PieceFrame> frames;
  std::vector<FixedVolumeSums> sums;

  explicit LabelledSums(const Body& body)
      : closed(closed_pieces(body.mesh, body.pieces.size())), frames(closed.size()), sums(closed.size()) {
    for_each_of(body, [&](uint32_t label, const Triangle& t) { frames[label].add(t); });
    for (size_t label = 0; label < closed.size(); ++label) {
      if (closed[label]) frames[label].close();
    }
    for_each_of(body, [&](uint32_t label, const Triangle& t) {
      sums[label].add(volume_moments(frames[label].from_middle(from_first_corner(t)), Vec3(0)));
    });
  }

  EnclosedPiece piece(uint32_t label, const Piece& counted) const {
    if (!closed[label]) return {};
    const VolumeMoments moments = sums[label].moments();
    if (!(moments.volume > kMinVolume)) return {};
    const MassProperties solid = in_metres(solid_mass(moments, Vec3(0), 1), frames[label]);
    return has_inertia(solid) ? EnclosedPiece{solid, counted.faces, counted.area} : EnclosedPiece{};
  }

 private:
  template <typename Visit>
  void for_each_of(const Body& body, Visit visit) const {
    for_each_triangle(body.mesh, 0, body.mesh.face_slots(), [&](FaceId f, const Triangle& t) {
      const uint32_t label = body.mesh.data(f).piece;
      if (closed[label]) visit(label, t);
    });
  }
};

bool are_same(const EnclosedPiece& a, const EnclosedPiece& b) {
  return a.faces == b.faces && a.area == b.area && a.solid.mass == b.solid.mass &&
         a.solid.centre == b.solid.centre && a.solid.inertia == b.solid.inertia;
}

// Lengths in units of 2^exponent m, in which a loaded body extends from -1 to 1 around its middle, so that
// its areas and moments are in the range of FixedSum.
struct Unit {
  explicit Unit(const Body& body) : origin(body.middle()) {
    const Vec3 reach = 0.5 * body.loaded.max - 0.5 * body.loaded.min;
    const double most = std::max({reach.x, reach.y, reach.z});
    (void)std::frexp(most, &exponent);
    exponent = std::clamp(exponent, -kMaxExponent, kMaxExponent);  // the scale and its inverse are finite
    scale = std::ldexp(1.0, -exponent);
  }
  Triangle from_middle(const Triangle& t) const {
    return {scale * (t[0] - origin), scale * (t[1] - origin), scale * (t[2] - origin)};
  }
  double area(const Triangle& t) const { return triangle_area({scale * t[0], scale * t[1], scale * t[2]}); }

  static constexpr int kMaxExponent = 1000;
  Vec3 origin;
  int exponent = 0;
  double scale = 1;
};

// Sorts the corners by position, so that rounding is independent of their order.
Triangle sorted(Triangle t) {
  if (lexicographic_less(t[1], t[0])) std::swap(t[0], t[1]);
  if (lexicographic_less(t[2], t[1])) std::swap(t[1], t[2]);
  if (lexicographic_less(t[1], t[0])) std::swap(t[0], t[1]);
  return t;
}

struct FixedSums {
  FixedSum area;
  std::array<FixedSum, 3> first;
  std::array<FixedSum, 6> second;

  void add(const AreaMoments& moments) {
    for (int k = 0; k < 3; ++k) first[static_cast<size_t>(k)].add(moments.first[k]);
    for (size_t i = 0; i < second.size(); ++i) second[i].add(moments.second[i]);
  }
  AreaMoments moments(const Unit& unit) const {
    AreaMoments moments;
    for (int k = 0; k < 3; ++k) moments.first[k] = first[static_cast<size_t>(k)].value(3 * unit.exponent);
    for (size_t i = 0; i < second.size(); ++i) moments.second[i] = second[i].value(4 * unit.exponent);
    return moments;
  }
};

}  // namespace

void update_solid_mass(Body& body) {
  const LabelledSums sums(body);
  KERF_ASSERT(sums.closed.size() == body.pieces.size());
  body.enclosed.grow_to(body.pieces.size());
  for (uint32_t label = 0; label < body.pieces.size(); ++label) {
    const EnclosedPiece piece = sums.piece(label, body.pieces[label]);
    if (!are_same(piece, body.enclosed[label])) body.enclosed.edit(label) = piece;
  }
}

const EnclosedPiece* enclosed_piece(const Body& body, uint32_t label) {
  if (!body.solid || label >= body.enclosed.size()) return nullptr;
  const EnclosedPiece& known = body.enclosed[label];
  KERF_ASSERT(label < body.pieces.size());
  const Piece& piece = body.pieces[label];
  return known.faces > 0 && known.faces == piece.faces && known.area == piece.area ? &known : nullptr;
}

void update_mass_properties(Body& body) {
  const Unit unit(body);
  std::vector<FixedSums> sums(body.pieces.size());
  for_each_triangle(body.mesh, 0, body.mesh.face_slots(), [&](FaceId f, const Triangle& corners) {
    const Triangle t = sorted(corners);
    const double area = unit.area(t);
    sums[body.label(f)].area.add(area);
    sums[body.mesh.data(f).piece].add(area_moments(unit.from_middle(t), area, Vec3(0)));
  });
  for (uint32_t label = 0; label < body.pieces.size(); ++label) {
    const double area = sums[label].area.value(2 * unit.exponent);
    const AreaMoments moments = sums[label].moments(unit);
    const Piece& before = body.pieces[label];
    if (before.area == area && before.moments == moments) continue;
    Piece& piece = body.pieces.edit(label);
    piece.area = area;
    piece.moments = moments;
  }
  if (body.solid) update_solid_mass(body);
}

void make_solid(Body& body, bool solid) {
  body.solid = solid;
  if (solid && !cut_material(body)) {
    if (body.material_names.empty()) body.material_names.emplace_back();
    if (body.material_names.size() <= std::numeric_limits<uint16_t>::max())
      body.material_names.push_back(body.cut_material);
  }
  update_mass_properties(body);
}

std::optional<uint16_t> cut_material(const Body& body) {
  const auto& names = body.material_names;
  const auto at = std::find(names.begin(), names.end(), body.cut_material);
  if (at == names.end() || at - names.begin() > std::numeric_limits<uint16_t>::max()) return std::nullopt;
  return static_cast<uint16_t>(at - names.begin());
}

}  // namespace kerf
