#include "ui/render/pick.h"

#include <limits>
#include <vector>

namespace kerf {

namespace {

// How the pieces of one body are looked at.
class BodyLooks {
 public:
  BodyLooks(BodyId id, const ViewOptions& options)
      : id_(id), pieces_(options.pieces), cull_backs_(options.cull_backs) {
    offsets_.emplace_back(0);
    for (auto i = pieces_.lower_bound({id, 0}); i != pieces_.end() && i->first.body == id; ++i) {
      const Vec3 offset = i->second.offset;
      if (std::find(offsets_.begin(), offsets_.end(), offset) == offsets_.end()) offsets_.push_back(offset);
    }
  }
  const std::vector<Vec3>& offsets() const { return offsets_; }

  // Whether a ray through the body as it is moved by `offset` meets this face there.
  bool meets(const Body& body, FaceId f, const Vec3& offset, const Vec3& direction) const {
    const auto found = pieces_.find({id_, body.mesh.data(f).piece});
    const PieceLook look = found == pieces_.end() ? PieceLook{} : found->second;
    if (look.hidden || look.offset != offset) return false;
    if (!cull_backs_) return true;
    const Triangle t = body.mesh.triangle(f);
    return glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), direction) < 0;
  }

 private:
  BodyId id_;
  const std::map<PieceId, PieceLook>& pieces_;
  bool cull_backs_;
  std::vector<Vec3> offsets_;
};

}  // namespace

std::optional<Pick> pick(const World& world, const ViewOptions& options, const Pose& ray) {
  std::optional<Pick> nearest;
  std::vector<RayHit> hits;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    const BodyLooks looks(id, options);
    for (const Vec3& offset : looks.offsets()) {
      const Pose through = body.placement.to_body(Pose{ray.origin - offset, ray.direction});
      const double most = nearest ? nearest->length : std::numeric_limits<double>::max();
      hits.clear();
      body.tree.crossings(body.mesh, through, {0, most}, hits);
      for (const RayHit& hit : hits) {
        if (!looks.meets(body, hit.face, offset, through.direction)) continue;
        if (!nearest || hit.length < nearest->length) nearest = Pick{id, hit.face, hit.length};
        break;
      }
    }
  }
  return nearest;
}

}  // namespace kerf
