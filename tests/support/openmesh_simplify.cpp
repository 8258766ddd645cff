#include "tests/support/openmesh_simplify.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/mesh/measures.h"
#include "core/mesh/remesh/collapser_internal.h"
#include "core/mesh/remesh/openmesh_internal.h"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

namespace kerf {

namespace {

namespace decimater = OpenMesh::Decimater;
using Kernel = OpenMeshKernel;
using Collapse = decimater::CollapseInfoT<Kernel>;
using ChangedFace = FollowedFaces::Changed;

uint32_t number(Kernel::FaceHandle f) { return static_cast<uint32_t>(f.idx()); }
Vec3 to_vec3(const Kernel::Point& p) { return {p[0], p[1], p[2]}; }

// The faces that the collapse changes, as they will be, in the order around the vertex that goes.
void find_changed(const Kernel& mesh, const Collapse& collapse, std::vector<ChangedFace>& changed) {
  changed.clear();
  for (const auto f : mesh.vf_range(collapse.v0)) {
    if (f == collapse.fl || f == collapse.fr) continue;
    ChangedFace& face = changed.emplace_back(ChangedFace{number(f), {}});
    size_t i = 0;
    for (const auto v : mesh.fv_range(f))
      face.corners[i++] = to_vec3(v == collapse.v0 ? collapse.p1 : mesh.point(v));
  }
}

// The quadric error as the priority of a collapse. Where the surface is flat, rounding makes errors negative,
// which OpenMesh takes for an illegal collapse.
class QuadricError : public decimater::ModQuadricT<Kernel> {
 public:
  using Handle = decimater::ModHandleT<QuadricError>;
  using ModQuadricT::ModQuadricT;
  float collapse_priority(const Collapse& collapse) override {
    return std::max(0.0f, ModQuadricT::collapse_priority(collapse));
  }
};

// Bounds the distance of the surface that was from the surface that is, like OpenMesh's ModHausdorffT, but at
// samples of faces and edges too. That one looks at removed vertices alone: on the bunny, points between them
// were up to five times as far away.
class SurfaceDistance : public decimater::ModBaseT<Kernel> {
 public:
  using Handle = decimater::ModHandleT<SurfaceDistance>;
  explicit SurfaceDistance(Kernel& mesh) : ModBaseT(mesh, true) {}
  DECIMATER_MODNAME(SurfaceDistance)

  double most = 0;  // in the frame of the mesh

  void initialize() override {
    samples_.resize(mesh().n_faces());
    for (const auto f : mesh().faces()) {
      samples_of(f).push_back(to_vec3(mesh().calc_face_centroid(f)));
      for (const auto h : mesh().fh_range(f)) {
        const bool once = h.idx() % 2 == 0 || mesh().is_boundary(mesh().opposite_halfedge_handle(h));
        if (once) samples_of(f).push_back(to_vec3(mesh().calc_edge_midpoint(h)));
      }
    }
  }

  float collapse_priority(const Collapse& collapse) override {
    find_changed(mesh(), collapse, changed_);
    bool near = is_near(to_vec3(collapse.p0), 0);
    size_t own = 0;
    for (const auto f : mesh().vf_range(collapse.v0)) {
      if (!near) break;
      const std::vector<Vec3>& samples = samples_of(f);
      near = std::all_of(samples.begin(), samples.end(), [&](const Vec3& p) { return is_near(p, own); });
      own += changed_[own].face == number(f) && own + 1 < changed_.size();
    }
    return static_cast<float>(near ? LEGAL_COLLAPSE : ILLEGAL_COLLAPSE);
  }

  // Hands the samples on among the faces that change. The priorities of no others depend on them.
  void preprocess_collapse(const Collapse& collapse) override {
    find_changed(mesh(), collapse, changed_);
    moved_.assign(1, to_vec3(collapse.p0));
    for (const auto f : mesh().vf_range(collapse.v0)) {
      moved_.insert(moved_.end(), samples_of(f).begin(), samples_of(f).end());
      samples_of(f).clear();
    }
    for (const Vec3& p : moved_) samples_[nearest_changed(p)].push_back(p);
  }

 private:
  std::vector<Vec3>& samples_of(Kernel::FaceHandle f) { return samples_[number(f)]; }

  // Tries the face first to which the sample belongs, or one beside it.
  bool is_near(const Vec3& p, size_t first) const {
    const auto near = [&](const ChangedFace& f) { return squared_distance(p, f.corners) <= most * most; };
    return near(changed_[first]) || std::any_of(changed_.begin(), changed_.end(), near);
  }

  uint32_t nearest_changed(const Vec3& p) const {
    uint32_t nearest = kNoIndex;
    double least = std::numeric_limits<double>::infinity();
    for (const ChangedFace& f : changed_) {
      const double distance2 = squared_distance(p, f.corners);
      if (distance2 >= least && nearest != kNoIndex) continue;
      least = distance2;
      nearest = f.face;
    }
    return nearest;
  }

  std::vector<std::vector<Vec3>>
      samples_;  // by face handle: those of the surface that was that it stands for
  std::vector<ChangedFace> changed_;
  std::vector<Vec3> moved_;
};

// The work on one mesh: what is left, where the followed faces are, and whether to go on.
struct Work {
  Sheets sheets;
  FollowedFaces followed;
  const Progress* progress = nullptr;
  size_t begin = 0, target = 0, left = 0;  // faces
  bool stopped = false;

  bool done() const { return stopped || left <= target; }
  void report(double fraction) {
    if (!stopped && progress) stopped = !progress->report(fraction);
  }
};

// Forbids what would join sheets, and follows the collapses.
class Bookkeeping : public decimater::ModBaseT<Kernel> {
 public:
  using Handle = decimater::ModHandleT<Bookkeeping>;
  explicit Bookkeeping(Kernel& mesh) : ModBaseT(mesh, true) {}
  DECIMATER_MODNAME(Bookkeeping)

  Work* work = nullptr;

  float collapse_priority(const Collapse& collapse) override {
    const bool legal = !work->stopped && !joins_sheets(collapse);
    return static_cast<float>(legal ? LEGAL_COLLAPSE : ILLEGAL_COLLAPSE);
  }

  void preprocess_collapse(const Collapse& collapse) override {
    for (const auto f : {collapse.fl, collapse.fr}) work->left -= f.is_valid();
    around_.clear();
    bool any = false;
    for (const auto f : mesh().vf_range(collapse.v0)) {
      around_.push_back(number(f));
      any |= work->followed.lie_on(number(f));
    }
    if (!any) return;
    find_changed(mesh(), collapse, changed_);
    work->followed.hand_on(around_, changed_);
  }

 private:
  // A new edge between two vertices that other sheets share could coincide with an edge of those.
  bool joins_sheets(const Collapse& collapse) {
    const auto shared = [&](Kernel::VertexHandle v) {
      return work->sheets.shared[static_cast<size_t>(v.idx())];
    };
    if (!shared(collapse.v1)) return false;
    for (const auto v : mesh().vv_range(collapse.v0)) {
      if (v != collapse.v1 && v != collapse.vl && v != collapse.vr && shared(v)) return true;
    }
    return false;
  }

  std::vector<uint32_t> around_;
  std::vector<ChangedFace> changed_;
};

// Stops the decimater when its work is done.
class Watch : public decimater::Observer {
 public:
  explicit Watch(Work& work) : Observer(1), work_(work) {}
  void notify(size_t collapses) override {
    if (collapses % kBetweenReports != 0) return;
    const auto collapsed = static_cast<double>(work_.begin - work_.left);
    work_.report(collapsed / static_cast<double>(work_.begin - work_.target));
  }
  bool abort() const override { return work_.done(); }

 private:
  static constexpr size_t kBetweenReports = 1024;
  Work& work_;
};

// By how many degrees one collapse may turn a face; where the number of faces is wanted, further steps follow
// whenever that is not enough. Small turns keep the surface from folding and halve the largest error.
constexpr std::array kMaxTurn = {15.0, 30.0, 60.0, 90.0};

// Collapses edges until the work is done. The error is bounded unless it is infinite.
void collapse_edges(Work& work, double error) {
  Kernel& mesh = work.sheets.mesh;
  mesh.update_face_normals();  // otherwise the module for them would do so and say it on standard error
  decimater::DecimaterT<Kernel> decimater(mesh);
  QuadricError::Handle quadric;
  decimater::ModNormalFlippingT<Kernel>::Handle flipping;
  SurfaceDistance::Handle distance;
  Bookkeeping::Handle bookkeeping;
  decimater.add(bookkeeping);
  decimater.module(bookkeeping).work = &work;
  decimater.add(quadric);
  decimater.add(flipping);
  const bool bounded = std::isfinite(error);
  if (bounded) {
    decimater.add(distance);
    decimater.module(distance).most = kShareForSamples * error * work.sheets.frame.scale;
  }
  Watch watch(work);
  decimater.set_observer(&watch);
  decimater.initialize();
  for (const double turn : kMaxTurn) {
    if (work.done() || (bounded && turn > kMaxTurn.front())) break;
    decimater.module(flipping).set_max_normal_deviation(turn);
    decimater.decimate();
  }
}

}  // namespace

Result<Remeshed> simplify_by_openmesh(const Mesh& mesh, const SimplifyTarget& target,
                                      const RemeshLimits& limits, const Progress* progress,
                                      std::span<const FaceId> followed) {
  ProgressShares shares(progress);
  const Progress copying = shares.next(0.15), decimating = shares.next(0.8), back = shares.next(0.05);
  auto sheets = to_sheets(mesh, limits, &copying);
  if (!sheets) return sheets.error();
  FollowedFaces places(mesh, sheets->frame, sheets->faces, followed);
  Work work{.sheets = std::move(*sheets), .followed = std::move(places), .progress = &decimating};
  work.begin = work.left = work.sheets.faces.size();
  work.target = std::min(target.faces, work.begin);
  if (!work.done()) collapse_edges(work, target.error);
  if (work.stopped || !back.report(0)) return cancelled();
  Remeshed out = from_sheets(work.sheets, work.sheets.faces, mesh);
  out.followed = work.followed.places(work.sheets.faces);
  return out;
}

}  // namespace kerf
