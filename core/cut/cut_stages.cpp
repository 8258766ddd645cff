#include "core/cut/cut_stages.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <unordered_set>

#include "core/base/assert.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/cut/stopwatch.h"

namespace kerf {

namespace {

bool within_beam(const BodyStep& step, FaceId f) {
  const Triangle element = step.body().refinement.triangle(step.mesh(), f);
  return std::any_of(step.beam.begin(), step.beam.end(),
                     [&](const SweptCylinder& part) { return part.contains(element); });
}

// Returns the overshoot of a face beyond the volume of a move, relative to the nearest ray of the beam.
double overshoot(const BodyStep& step, const Triangle& t) {
  double least = std::numeric_limits<double>::infinity();
  for (const SweptCylinder& part : step.beam) least = std::min(least, part.overshoot(t));
  return least;
}

bool is_fine_enough(const BodyStep& step, const CutSettings& settings, const Triangle& element, FaceId f) {
  const Resolution& r = settings.resolution;
  const int level = step.mesh().data(f).halvings / 2;
  if (level >= Resolution::kMaxDepth) return true;
  switch (r.rule) {
    case Resolution::Rule::kDepth:
      return level >= r.depth;
    case Resolution::Rule::kTargetEdge:
      return longest_edge2(element) <= r.target_edge * r.target_edge;
    case Resolution::Rule::kTolerance:
      return overshoot(step, element) <= r.tolerance;
  }
  return true;
}

// Examines faces that the beam may touch, and splits those that are too coarse. The geometric model removes
// a face within the beam whole, without splitting it.
class Refinement {
 public:
  Refinement(BodyStep& step, const CutSettings& settings, std::vector<FaceId>& to_split)
      : step_(step), settings_(settings), to_split_(to_split) {}

  Status run() {
    for (size_t work = 0; work < faces_per_batch() && !to_split_.empty(); ++work) {
      const FaceId f = to_split_.back();
      to_split_.pop_back();
      if (!must_split(f)) continue;
      step_.edit.clear_hit(f);  // its parts lie in smaller boxes, which the next query tests
      const std::span<const Replacement> splits = split_by_scheme(step_, settings_.resolution.scheme, f);
      for (size_t i = splits.size(); i-- > 0;) {
        const Replacement& r = splits[i];
        work += r.added_count;
        to_split_.insert(to_split_.end(), r.added.begin(), r.added.begin() + r.added_count);
      }
      if (step_.mesh().live_faces() > settings_.max_faces) return too_many_faces(settings_);
    }
    return Done{};
  }

 private:
  bool must_split(FaceId f) const {
    const Mesh& mesh = step_.mesh();
    const OneToFour& refinement = step_.body().refinement;
    const Triangle face = mesh.triangle(f), element = refinement.triangle(mesh, f);
    if (is_fine_enough(step_, settings_, element, f)) return false;
    const auto touched = [&](const SweptCylinder& part) { return part.touches(face); };
    const auto within = [&](const SweptCylinder& part) { return part.contains(element); };
    return std::any_of(step_.beam.begin(), step_.beam.end(), touched) &&
           (settings_.model == Model::kThermal || std::none_of(step_.beam.begin(), step_.beam.end(), within));
  }

  BodyStep& step_;
  const CutSettings& settings_;
  std::vector<FaceId>& to_split_;
};

constexpr int kFinestSample = 5;  // max halvings of a face for samples
constexpr size_t kAtATime = 16;   // faces per task of a thread

class Deposit {
 public:
  Deposit(const BodyStep& step, const CutSettings& settings)
      : step_(step), sheet_(step.body().sheet), width_(settings.heat_width) {}

  // Returns the minimum energy of a face (J); 0 beyond the width.
  double energy(const Triangle& t) const { return mass_of_area() * integral(t, kFinestSample); }
  // Returns true if no point of the face is nearer than the width.
  bool is_beyond(const Triangle& t) const {
    const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
    const double size =
        std::sqrt(std::max({glm::dot(t[0] - middle, t[0] - middle), glm::dot(t[1] - middle, t[1] - middle),
                            glm::dot(t[2] - middle, t[2] - middle)}));
    return distance(middle) > width_ + size;
  }

 private:
  double mass_of_area() const { return sheet_.thickness * sheet_.substance.density; }

  double distance(const Vec3& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const SweptCylinder& part : step_.beam) least = std::min(least, part.signed_distance(p));
    return std::max(0.0, least);
  }

  double enthalpy(const Vec3& p) const {
    const double share = std::max(0.0, 1 - distance(p) / width_);
    return share * enthalpy_before_transition(sheet_.substance);
  }

  // Integrates the enthalpy over a triangle, by the midpoint rule on parts much smaller than the width.
  double integral(const Triangle& t, int halvings) const {
    if (halvings == 0 || longest_edge2(t) <= 0.25 * width_ * width_)
      return triangle_area(t) * enthalpy((t[0] + t[1] + t[2]) / 3.0);
    if (is_beyond(t)) return 0;
    const Vec3 a = 0.5 * t[0] + 0.5 * t[1], b = 0.5 * t[1] + 0.5 * t[2], c = 0.5 * t[2] + 0.5 * t[0];
    return integral({t[0], a, c}, halvings - 1) + integral({a, t[1], b}, halvings - 1) +
           integral({c, b, t[2]}, halvings - 1) + integral({a, b, c}, halvings - 1);
  }

  const BodyStep& step_;
  const Sheet& sheet_;
  double width_;
};

// Returns the live faces within the width that are connected to the given ones, in the order of discovery.
std::vector<FaceId> faces_within(const BodyStep& step, const Deposit& deposit,
                                 std::span<const FaceId> beside) {
  std::unordered_set<uint32_t> seen;  // lookups only, never iterated
  std::vector<FaceId> found;
  const auto add = [&](FaceId f) {
    if (!step.mesh().is_live(f) || !seen.insert(f.index).second) return;
    if (!deposit.is_beyond(step.mesh().triangle(f))) found.push_back(f);
  };
  for (const FaceId f : beside) add(f);
  std::vector<FaceId> neighbours;
  for (size_t i = 0; i < found.size(); ++i) {
    neighbours.clear();
    step.mesh().append_neighbours(found[i], neighbours);
    for (const FaceId f : neighbours) add(f);
  }
  return found;
}

// Raises the energies (J) of faces to at least the given ones, and adds the difference to the energy balance.
void raise(World& world, BodyId id, std::span<const FaceId> faces, std::span<const double> energies) {
  KERF_ASSERT(faces.size() == energies.size());
  Body& body = world.body(id);
  double added = 0;
  for (size_t i = 0; i < faces.size(); ++i) {
    const FaceId f = faces[i];
    const double before = body.heat.energy_of(body.mesh, f), now = energies[i];
    if (now <= before) continue;
    body.heat.set_energy(body.mesh, f, now);
    body.heat.record_hottest(body.mesh, f,
                             body.heat.temperature(body.mesh, f, body.sheet.substance, body.sheet.thickness));
    added += now - before;
  }
  EnergyLedger& ledger = world.edit_energy();
  ledger.emitted += added;
  ledger.absorbed += added;
}

}  // namespace

size_t faces_per_batch() {
  static const size_t faces = [] {
    constexpr size_t kVaried[] = {1, 17, 128, 3000};
    const Shuffle& shuffle = Shuffle::selected();
    return shuffle.on() ? kVaried[shuffle.random(2).below(std::size(kVaried))] : 128;
  }();
  return faces;
}

void sweep(BodyStep& step, const Laser& laser, const BeamMove& move, bool in_body_frame) {
  const Placement& placement = step.body().placement;
  const BeamMove seen{placement.to_body(move.from), placement.to_body(move.to)};
  step.beam = sweep_beam(laser, in_body_frame ? move : seen);
}

void hit(BodyStep& step, std::vector<FaceId>& faces) {
  const Stopwatch watch(step.statistics.query_s);
  faces.clear();
  for (const SweptCylinder& part : step.beam) {
    const QueryCounts counts = step.edit.touched(part, faces);
    ++step.statistics.queries;
    step.statistics.tested.boxes += counts.boxes;
    step.statistics.tested.faces += counts.faces;
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
}

// Removes both halves of a green pair together: if the beam touches either, or, for a smooth rim, if it
// contains both.
void remove(BodyStep& step, UnfinishedMove& move, bool only_within, bool keeps_beside) {
  KERF_ASSERT(move.removed <= move.hit.size());
  std::vector<FaceId> going;
  const size_t end = std::min(move.hit.size(), move.removed + faces_per_batch());
  for (; move.removed < end; ++move.removed) {
    const FaceId f = move.hit[move.removed];
    if (!step.mesh().is_live(f)) continue;  // removed with the other half of its pair
    if (only_within && !within_beam(step, f)) continue;
    const OneToFour::Element element = step.body().refinement.element(step.mesh(), f);
    going.insert(going.end(), element.faces.begin(), element.faces.begin() + element.face_count);
  }
  if (keeps_beside) {
    for (const FaceId f : going) step.mesh().append_neighbours(f, move.beside);
  }
  remove_faces(step, going);
}

void remove_faces(BodyStep& step, std::span<const FaceId> faces) {
  {
    const Stopwatch watch(step.statistics.remove_s);
    step.edit.remove(faces);
  }
  update_tree(step);
}

// The tree must be updated even if the work fails.
Status refine(BodyStep& step, UnfinishedMove& move, const CutSettings& settings, const Progress& progress) {
  if (!progress.report(0)) return cancelled();
  Refinement refinement(step, settings, move.to_split);
  const Status done = [&] {
    const Stopwatch watch(step.statistics.refine_s);
    return refinement.run();
  }();
  if (step.edit.splits().empty()) return done;
  move.has_split = true;
  update_tree(step);
  return done;
}

bool is_fine_enough(const BodyStep& step, const CutSettings& settings, FaceId f) {
  KERF_ASSERT(step.mesh().is_live(f));
  return is_fine_enough(step, settings, step.body().refinement.triangle(step.mesh(), f), f);
}

Error too_many_faces(const CutSettings& settings) {
  return failed("the cut would make more than " + std::to_string(settings.max_faces) +
                " faces: use a coarser resolution or a shorter stroke");
}

void update_tree(BodyStep& step) {
  const Stopwatch watch(step.statistics.update_tree_s);
  step.edit.update_tree();
}

std::span<const Replacement> split_by_scheme(BodyStep& step, Scheme scheme, FaceId f) {
  const size_t first = step.edit.splits().size();
  if (scheme == Scheme::kOneToFour) {
    step.edit.split_in_four(f);
  } else {
    step.edit.bisect_at_longest_edge(f);
  }
  return step.edit.splits().subspan(first);
}

void deposit_heat(World& world, BodyStep& step, const CutSettings& settings, std::span<const FaceId> beside) {
  KERF_ASSERT(settings.heat_width > 0);
  KERF_ASSERT(!step.beam.empty());
  const Deposit deposit(step, settings);
  const std::vector<FaceId> faces = faces_within(step, deposit, beside);
  std::vector<double> energies(faces.size());
  for_each_range(faces.size(), kAtATime, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) energies[i] = deposit.energy(step.mesh().triangle(faces[i]));
  });
  raise(world, step.id, faces, energies);
}

void heat_walls(World& world, const BodyStep& step, std::span<const FaceId> walls) {
  const Sheet& sheet = step.body().sheet;
  const double of_area =
      enthalpy_before_transition(sheet.substance) * sheet.thickness * sheet.substance.density;
  std::vector<double> energies;
  for (const FaceId f : walls) energies.push_back(of_area * triangle_area(step.mesh().triangle(f)));
  raise(world, step.id, walls, energies);
}

}  // namespace kerf
