#include "app/setup_options.h"

#include <algorithm>
#include <cmath>

#include "app/arguments.h"
#include "app/console.h"
#include "core/base/deterministic_math.h"
#include "core/document/text/fields.h"
#include "core/tree/point_fit.h"

namespace kerf {

namespace {

// A datum point: where the strokes have it, and where it is on the part.
struct Datum {
  Vec3 planned{0}, measured{0};
};

struct DatumList {
  std::vector<Datum> points;
};

bool is_datum_file(const std::string& file) { return file.ends_with(".json"); }

RigidMotion in_world(const Placement& placement, const RigidMotion& motion) {
  return {placement.orientation * motion.rotation,
          placement.orientation * motion.translation + placement.position};
}

// Samples a move at equal shares, at most this far apart, and at most kMaxSamples times.
size_t samples_of(const Pose& from, const Pose& to, double apart, double length) {
  constexpr double kMaxSamples = 10'000;
  const double way =
      glm::length(to.origin - from.origin) + length * glm::length(to.direction - from.direction);
  return static_cast<size_t>(std::clamp(std::ceil(way / apart), 1.0, kMaxSamples));
}

Pose between(const Pose& from, const Pose& to, double share) {
  const Vec3 direction = (1 - share) * from.direction + share * to.direction;
  return {(1 - share) * from.origin + share * to.origin, glm::normalize(direction)};
}

// Adds what the nozzle meets at a pose.
void add_pose(const World& world, const Pose& pose, const Nozzle& nozzle, NozzleSegment& segment) {
  constexpr double kFarthest = 1e9;  // m
  std::optional<double> standoff;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    const Pose own = body.placement.to_body(pose);
    if (const auto hit = body.tree.nearest(body.mesh, own, {0, kFarthest}))
      standoff = std::min(standoff.value_or(kFarthest), hit->length);
    segment.collides = segment.collides || collides(body.mesh, body.tree, own, nozzle);
  }
  if (!standoff) return;
  if (!segment.standoff) segment.standoff = Interval{*standoff, *standoff};
  segment.standoff->low = std::min(segment.standoff->low, *standoff);
  segment.standoff->high = std::max(segment.standoff->high, *standoff);
}

}  // namespace

static void describe(Fields& f, Datum& datum) {
  f.vector("planned", datum.planned, VectorRule::kNearby);
  f.vector("measured", datum.measured, VectorRule::kNearby);
}

static void describe(Fields& f, DatumList& list) { f.list("points", "datum points", list.points); }

void SetupOptions::add_to(CLI::App& command) {
  command.add_option("--fit", fit,
                     "Move the strokes onto the part as measured: a JSON file with datum points, or the mesh "
                     "that the strokes were planned for, which is fitted to the mesh by least squares");
  command.add_option("--nozzle", nozzle,
                     "R,ANGLE,LENGTH: check a conical nozzle whose tip of radius R lies where the beam "
                     "starts, with its half angle in degrees and its length; lengths in metres");
}

Status SetupOptions::read(bool has_strokes) {
  if (!nozzle.empty()) {
    const auto values = parse_point("--nozzle", nozzle);
    if (!values || !(values->x > 0 && values->y >= 0 && values->y < 80 && values->z > 0))
      return bad_input(
          "--nozzle: must be R,ANGLE,LENGTH: radius of the tip in metres, half angle from 0 to 80 degrees, "
          "length in metres");
    const auto [sin, cos] = sin_cos(radians_of(values->y));
    nozzle_ = Nozzle{values->x, sin / cos, values->z};
  }
  constexpr const char* kNeedsStrokes = ": requires strokes; add --path, --drawing or --gcode";
  if (!has_strokes && !fit.empty()) return bad_input(std::string("--fit") + kNeedsStrokes);
  if (!has_strokes && nozzle_) return bad_input(std::string("--nozzle") + kNeedsStrokes);
  if (!is_datum_file(fit)) return Done{};
  const auto list = read_described<DatumList>(fit);
  if (!list) return list.error();
  for (const Datum& datum : list->points) datums_.emplace_back(datum.planned, datum.measured);
  if (!determine_motion(datums_))
    return bad_input(fit + ": /points: there must be three or more points that do not lie on one line");
  return Done{};
}

Status SetupOptions::fit_strokes(const World& world, const MeshReading& reading,
                                 std::vector<StrokePath>& strokes, CutJob& job) const {
  if (fit.empty()) return Done{};
  FittedStrokes found;
  if (is_datum_file(fit)) {
    found.motion = fit_points(datums_);
    double sum = 0;
    for (const auto& [planned, measured] : datums_) {
      const double residual = glm::length(found.motion.apply(planned) - measured);
      found.residuals.push_back(residual);
      found.max = std::max(found.max, residual);
      sum += residual * residual;
    }
    found.rms = std::sqrt(sum / static_cast<double>(datums_.size()));
  } else {
    if (world.ids().size() != 1)
      return bad_input("--fit: a mesh can be fitted to one mesh only; use datum points");
    auto planned = load_mesh(fit, reading);
    if (!planned) return planned.error();
    const AabbTree tree(planned->mesh);
    const Surface from{planned->mesh, tree};
    const Body& body = world.body(world.ids().front());
    const Surface to{body.mesh, body.tree};
    ProgressLine line("fitting");
    const Progress progress = line.progress();
    const auto motion = align_surfaces(from, to, Alignment::kIcp, &progress);
    if (!motion) return error_or_stopped(motion.error());
    const auto compared = compare_surfaces(from, to, false, *motion, &progress);
    if (!compared) return error_or_stopped(compared.error());
    found.motion = in_world(body.placement, *motion);
    found.rms = compared->rms;
    found.max = compared->max;
  }
  for (StrokePath& stroke : strokes) {
    for (Pose& key : stroke.keys)
      key = {found.motion.apply(key.origin), glm::normalize(found.motion.rotation * key.direction)};
  }
  job.fit = std::move(found);
  return Done{};
}

Status SetupOptions::check_nozzle(const World& world, const std::vector<StrokePath>& strokes,
                                  const LineOf& line_of, CutJob& job) const {
  if (!nozzle_) return Done{};
  ProgressLine progress("checking the nozzle");
  for (size_t i = 0; i < strokes.size(); ++i) {
    const std::vector<Pose>& keys = strokes[i].keys;
    for (size_t k = 0; k + 1 < std::max<size_t>(keys.size(), 2); ++k) {
      const auto line = line_of(i, k + 1);
      const bool is_same = !job.nozzle.empty() && k > 0 && line && job.nozzle.back().at.line == line;
      if (!is_same) job.nozzle.push_back({{i, k, line}, std::nullopt, false});
      const Pose &from = keys[k], &to = keys[std::min(k + 1, keys.size() - 1)];
      const size_t samples = samples_of(from, to, nozzle_->radius, nozzle_->length);
      for (size_t n = 0; n <= samples; ++n) {
        if (!progress.update(static_cast<double>(i) / static_cast<double>(strokes.size()))) return stopped();
        add_pose(world, between(from, to, static_cast<double>(n) / static_cast<double>(samples)), *nozzle_,
                 job.nozzle.back());
      }
    }
  }
  return Done{};
}

}  // namespace kerf
