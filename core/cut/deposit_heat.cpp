#include "core/cut/deposit_heat.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "core/base/assert.h"
#include "core/base/parallel.h"

namespace kerf {

namespace {

constexpr int kFinestSample = 5;  // halvings of a face in samples
constexpr size_t kAtATime = 16;   // faces, by one thread

class Deposit {
 public:
  Deposit(const BodyStep& step, const CutSettings& settings)
      : step_(step), sheet_(step.body().sheet), width_(settings.heat_width) {}

  // The energy that a face should have at least (J); 0 where it is too far away.
  double energy(const Triangle& t) const { return mass_of_area() * integral(t, kFinestSample); }
  // Whether no point of the face is nearer than the width.
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

  // The integral of the enthalpy over the area of a triangle, by the midpoint rule on parts that are small
  // compared with the width.
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

// The live faces within the width that hang together with `beside`, in the order in which they are found.
std::vector<FaceId> faces_within(const BodyStep& step, const Deposit& deposit,
                                 std::span<const FaceId> beside) {
  std::unordered_set<uint32_t> seen;  // asked, never iterated
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

}  // namespace

namespace {

// Gives faces energies (J) where they have less, and books it.
void raise(World& world, BodyId id, std::span<const FaceId> faces, std::span<const double> energies) {
  Body& body = world.body(id);
  double added = 0;
  for (size_t i = 0; i < faces.size(); ++i) {
    const FaceId f = faces[i];
    const double before = body.heat.energy_of(body.mesh, f), now = energies[i];
    if (now <= before) continue;
    body.heat.set_energy(body.mesh, f, now);
    body.heat.note_hottest(body.mesh, f,
                           body.heat.temperature(body.mesh, f, body.sheet.substance, body.sheet.thickness));
    added += now - before;
  }
  EnergyLedger& ledger = world.edit_energy();
  ledger.emitted += added;
  ledger.absorbed += added;
}

}  // namespace

void deposit_heat(World& world, BodyStep& step, const CutSettings& settings, std::span<const FaceId> beside) {
  KERF_ASSERT(settings.heat_width > 0);
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
