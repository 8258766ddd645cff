#include "app/knife_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "app/arguments.h"
#include "core/document/cut_report.h"

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

// Parses "COUNT,DIAMETER,DEPTH,TOLERANCE".
Result<Pegs> parse_pegs(const std::string& text) {
  const Error wrong = bad_input(
      "--pegs: must be COUNT,DIAMETER,DEPTH,TOLERANCE: a number of pegs from 1 to " +
      std::to_string(Pegs::kMaxCount) + ", two positive lengths and one that is not negative, in metres");
  std::array<double, 4> numbers{};
  std::string_view rest = text;
  for (double& number : numbers) {
    const size_t comma = &number == &numbers.back() ? rest.size() : rest.find(',');
    if (comma == std::string_view::npos || !parse_number(rest.substr(0, comma), number)) return wrong;
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  const auto [count, diameter, depth, tolerance] = numbers;
  if (!(count >= 1 && count <= Pegs::kMaxCount) || count != std::floor(count) || !(diameter > 0) ||
      !(depth > 0) || !(tolerance >= 0))
    return wrong;
  return Pegs{static_cast<int>(count), diameter, depth, tolerance};
}

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
  command
      .add_option(
          "--plane", plane_texts_,
          "NX,NY,NZ,D: cut along the plane N.x = D (metres) after the strokes, by a knife that removes "
          "nothing; repeat for more planes")
      ->allow_extra_args(false);
  command.add_option("--fit-bed", bed_text_,
                     "W,D,H: then cut bodies along planes into pieces of at most this size along x, y and z, "
                     "in metres");
  command.add_option(
      "--pegs", pegs_text_,
      "COUNT,DIAMETER,DEPTH,TOLERANCE: join both sides of each cut of a solid by pegs and holes, with a gap "
      "of TOLERANCE around and at the end of each peg, in metres");
  command.add_flag("--lay-flat", lay_flat_,
                   "Lay each piece with its largest cut face on z = 0, in a row along x");
}

Status KnifeOptions::read() {
  for (const std::string& text : plane_texts_) {
    if (const Status s = unpack(parse_plane(text), planes_.emplace_back()); !s) return s;
  }
  if (pegs_text_) {
    if (const Status s = unpack(parse_pegs(*pegs_text_), pegs_); !s) return s;
    if (planes_.empty() && !bed_text_) return bad_input("--pegs: requires --plane or --fit-bed");
  }
  if (!bed_text_) return Done{};
  const Result<Vec3> bed = parse_point("--fit-bed", *bed_text_);
  if (!bed || std::min({bed->x, bed->y, bed->z}) <= 0)
    return bad_input("--fit-bed: must be three positive numbers, W,D,H in metres");
  // Pegs stand out of the pieces.
  bed_ = *bed - Vec3(pegs_.count > 0 ? pegs_.depth : 0);
  if (std::min({bed_->x, bed_->y, bed_->z}) <= 0)
    return bad_input("--pegs: the pegs are as long as the bed of --fit-bed; use shorter ones");
  return Done{};
}

Status KnifeOptions::cut(const World& world, const std::function<Result<bool>(const Command&)>& run,
                         std::vector<std::string>& notes) const {
  for (size_t i = 0; i < planes_.size(); ++i) {
    const Result<bool> met = run(CutPlane{.plane = planes_[i], .pegs = pegs_});
    if (!met) return met.error();
    if (!*met) notes.push_back("--plane " + plane_texts_[i] + ": the plane crosses no mesh");
  }
  if (pegs_.count > 0 && !any_is_solid(world))
    notes.push_back("--pegs: only solids get pegs; add --solid for closed meshes");
  if (!bed_) return Done{};
  const std::vector<BodyId> ids = world.ids();
  for (const BodyId id : ids) {
    if (world.body(id).hidden || world.body(id).mesh.live_faces() == 0) continue;
    const auto planes = bed_planes(bounds_of(world.body(id)), *bed_);
    if (!planes) return planes.error();
    for (const KnifePlane& plane : *planes) {
      if (const Result<bool> met = run(CutPlane{.plane = plane, .bodies = {id}, .pegs = pegs_}); !met)
        return met.error();
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
