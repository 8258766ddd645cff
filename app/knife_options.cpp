#include "app/knife_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "app/arguments.h"

namespace kerf {

namespace {

constexpr int kMaxBeds = 100;  // along an axis

// Returns the bounds of a body in the world.
Bounds bounds_of(const Body& body) {
  Bounds bounds = Bounds::none();
  for (uint32_t slot = 0; slot < body.mesh.face_slots(); ++slot) {
    if (!body.mesh.is_live(FaceId(slot))) continue;
    for (const Vec3& p : body.mesh.triangle(FaceId(slot))) bounds.add(body.placement.to_world(p));
  }
  return bounds;
}

// The faces of walls of a piece by their plane, in the frame of the body.
class SectionAreas {
 public:
  // Precondition: `size` is that of the body [m] and positive.
  explicit SectionAreas(double size) : size_(size) {}

  void add(const Triangle& t) {
    const Vec3 area = 0.5 * glm::cross(t[1] - t[0], t[2] - t[0]);
    const double length = glm::length(area);
    if (!(length > 0)) return;
    const Vec3 normal = area / length;
    Vec3& sum = areas_[{rounded(normal.x), rounded(normal.y), rounded(normal.z),
                        rounded(glm::dot(normal, t[0]) / size_)}];
    sum += area;
  }
  // Returns the unit normal of the largest plane; nullopt if there is none.
  std::optional<Vec3> largest() const {
    double most = 0;
    std::optional<Vec3> normal;
    for (const auto& [plane, area] : areas_) {
      const double length = glm::length(area);
      if (length > most) most = length, normal = area / length;
    }
    return normal;
  }

 private:
  // Planes that differ by less count as one.
  static int64_t rounded(double x) { return std::llround(x * 0x1p20); }

  double size_;
  std::map<std::array<int64_t, 4>, Vec3> areas_;  // m^2, along the normals
};

// Returns the shortest rotation from a unit vector to -z.
glm::dquat turn_down(const Vec3& from) {
  const Vec3 down(0, 0, -1);
  if (are_opposite(from, down)) return {0, 1, 0, 0};
  return glm::normalize(glm::dquat(1 + glm::dot(from, down), glm::cross(from, down)));
}

}  // namespace

Result<std::vector<KnifePlane>> bed_planes(const Bounds& box, const Vec3& bed) {
  std::vector<KnifePlane> planes;
  for (int k = 0; k < 3; ++k) {
    const double length = box.max[k] - box.min[k], count = std::ceil(length / bed[k]);
    if (count > kMaxBeds)
      return bad_input("--fit-bed: a body is more than " + std::to_string(kMaxBeds) +
                       " beds long; use a larger bed");
    for (int i = 1; i < count; ++i) {
      KnifePlane& plane = planes.emplace_back();
      plane.normal = Vec3(0);
      plane.normal[k] = 1;
      plane.distance = box.min[k] + length * i / count;
    }
  }
  return planes;
}

void KnifeOptions::add_to(CLI::App& command) {
  command.add_option(
      "--plane", plane_texts_,
      "NX,NY,NZ,D: cut along the plane N.x = D (metres) after the strokes, by a knife that removes "
      "nothing; repeat for more planes");
  command.add_option("--fit-bed", bed_text_,
                     "W,D,H: then cut bodies along planes into pieces of at most this size along x, y and z, "
                     "in metres");
  command.add_flag("--lay-flat", lay_flat_,
                   "Lay each piece with its largest cut face on z = 0, in a row along x");
}

Status KnifeOptions::read() {
  for (const std::string& text : plane_texts_) {
    if (const Status s = unpack(parse_plane(text), planes_.emplace_back()); !s) return s;
  }
  if (!bed_text_) return Done{};
  const Result<Vec3> bed = parse_point("--fit-bed", *bed_text_);
  if (!bed || std::min({bed->x, bed->y, bed->z}) <= 0)
    return bad_input("--fit-bed: must be three positive numbers, W,D,H in metres");
  bed_ = *bed;
  return Done{};
}

Status KnifeOptions::cut(const World& world, const std::function<Result<bool>(const Command&)>& run,
                         std::vector<std::string>& notes) const {
  for (size_t i = 0; i < planes_.size(); ++i) {
    const Result<bool> met = run(CutPlane{planes_[i]});
    if (!met) return met.error();
    if (!*met) notes.push_back("--plane " + plane_texts_[i] + ": the plane crosses no mesh");
  }
  if (!bed_) return Done{};
  const std::vector<BodyId> ids = world.ids();
  for (const BodyId id : ids) {
    if (world.body(id).hidden || world.body(id).mesh.live_faces() == 0) continue;
    const auto planes = bed_planes(bounds_of(world.body(id)), *bed_);
    if (!planes) return planes.error();
    for (const KnifePlane& plane : *planes) {
      if (const Result<bool> met = run(CutPlane{plane, {id}}); !met) return met.error();
    }
  }
  return Done{};
}

std::vector<Command> KnifeOptions::lay_flat(const World& world) const {
  constexpr double kGap = 0.1;  // between pieces, as a share of the size of the next one
  std::vector<Command> moves;
  double x = 0;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    for (uint32_t label = 0; lay_flat_ && label < body.pieces.size(); ++label) {
      if (body.pieces[label].faces == 0) continue;
      SectionAreas sections(body.bounds().diagonal());
      const std::vector<FaceId> faces = body.faces_of(label);
      for (const FaceId f : faces) {
        if (body.walls.contain(body.mesh, f)) sections.add(body.mesh.triangle(f));
      }
      const std::optional<Vec3> down = sections.largest();
      const glm::dquat turn = down ? turn_down(*down) : body.placement.orientation;
      Bounds box = Bounds::none();
      for (const FaceId f : faces) {
        for (const Vec3& p : body.mesh.triangle(f)) box.add(turn * p);
      }
      const double width = box.max.x - box.min.x;
      if (x > 0) x += kGap * width;
      moves.push_back(MovePiece{{id, label}, {{x - box.min.x, -box.centre().y, -box.min.z}, turn}});
      x += width;
    }
  }
  return moves;
}

}  // namespace kerf
