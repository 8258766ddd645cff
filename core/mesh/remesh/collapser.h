#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/remesh/collapse_rules.h"
#include "core/mesh/remesh/flat_sheets.h"
#include "core/mesh/remesh/flat_surface.h"
#include "core/mesh/remesh/followed_faces.h"
#include "core/mesh/remesh/quadric.h"
#include "core/mesh/remesh/surface_samples.h"

namespace kerf {

// Collapses the vertices of sheets in rounds, each in the order of the quadric error, until a number of faces
// is left or a round finds no more.
class Collapser {
 public:
  // What a round allows.
  struct Limits {
    size_t faces = 0;          // the round ends when so many are left
    double least_cosine2 = 0;  // of the angle by which one collapse may turn a face, squared
  };

  // `sheets` must outlive the collapser, and `progress`, which may be null, too; it is told how far the way
  // to `faces` faces is gone.
  Collapser(const Mesh& mesh, const FlatSheets& sheets, size_t faces, std::span<const FaceId> followed,
            const Progress* progress);

  const FlatSurface& surface() const { return surface_; }
  size_t left() const { return left_; }  // faces
  double area() const;                   // in the frame of the sheets; O(faces)
  std::vector<FollowedFace> followed() const { return followed_.places(sheets_.faces); }

  // From now on no collapse takes samples of the surface as it is at the first call farther than `most` from
  // it, in the frame of the sheets; or, with none, there is no such bound.
  void bound_distance(std::optional<double> most);

  // Returns false if it was stopped.
  bool run_round(const Limits& limits);

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  // Where a vertex goes, and the quadric error of that.
  struct Choice {
    double error = kNever;
    uint32_t to = kNoIndex;
  };
  // A vertex with a lower bound of the error of its best collapse.
  struct Queued {
    double error;
    uint32_t vertex;
    bool operator>(const Queued& o) const {
      return error > o.error || (error == o.error && vertex > o.vertex);
    }
  };

  bool may_go(uint32_t v) const { return surface_.in_use(v) && !sheets_.locked[v] && !rules_.is_hub(v); }
  void sum_quadrics();
  void queue_all();
  void enqueue(uint32_t v, double error);
  double error_of(uint32_t v, uint32_t to) const;
  double least_error(uint32_t v) const;
  Choice best_choice(uint32_t v);
  bool stays_near(uint32_t v, const Choice& choice);
  void find_changed(uint32_t to);
  void hand_on(uint32_t v, uint32_t to);
  void collapse(uint32_t v, uint32_t to);
  bool go_on();

  const FlatSheets& sheets_;
  FlatSurface surface_;
  CollapseRules rules_;
  std::vector<Quadric> quadrics_;  // by vertex
  std::vector<double> queued_;     // by vertex: the error with which it is in the queue
  std::priority_queue<Queued, std::vector<Queued>, std::greater<>> queue_;
  FollowedFaces followed_;
  std::optional<SurfaceSamples> samples_;
  std::optional<double> most2_;  // the bound of the distance of samples, squared
  size_t begin_, left_, target_;
  const Progress* progress_;
  size_t reported_;  // faces that were left at the last report
  Ring ring_;        // of the vertex at which the rules look
  std::vector<uint32_t> changed_vertices_, around_;
  std::vector<FollowedFaces::Changed> changed_;
  std::vector<Choice> choices_;
};

}  // namespace kerf
