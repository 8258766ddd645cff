#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace kerf {

// A measurement in the world [m]: the distance of two points, or the radius of a circle from its centre to a
// point on it.
struct RulerMark {
  // The circle of a radius, fitted to a rim.
  struct Circle {
    Vec3 normal{0, 0, 1};  // a unit vector
    double deviation = 0;  // m, the largest distance of the rim from the circle
    friend bool operator==(const Circle&, const Circle&) = default;
  };

  std::string name;
  Vec3 from{0}, to{0};
  std::optional<Circle> circle = std::nullopt;
  double length() const { return glm::length(to - from); }
  friend bool operator==(const RulerMark&, const RulerMark&) = default;
};

// The measurements of a document in order of creation, with an undo of their own.
class RulerList {
 public:
  const std::vector<RulerMark>& marks() const { return marks_; }
  // Returns the radius of this circle, given the measurement of one like it, up to rounding; null if it is
  // not measured.
  const RulerMark* radius_of(const Vec3& centre, double radius, const Vec3& normal) const;

  // Begins an undo step, which contains all edits until the next call.
  void begin_edit();
  // Edits. Preconditions: begin_edit() was called, the index exists, and a moved measurement has no circle.
  // add() assigns an unused name: "Distance 1", "Radius 2".
  void add(const Vec3& from, const Vec3& to, const std::optional<RulerMark::Circle>& circle = std::nullopt);
  void move(size_t mark, bool to_end, const Vec3& at);
  void rename(size_t mark, std::string name);
  void remove(size_t mark);

  bool can_undo() const { return !undone_to_.empty(); }
  bool can_redo() const { return !redone_to_.empty(); }
  void undo();
  void redo();

  // Convert the measurements to the entry in the head of a document (null if there are none), and back.
  // Reading omits invalid measurements and clears the undo steps.
  nlohmann::json to_json() const;
  void read(const nlohmann::json& entry);

  // Returns a header and a line per mark: name, X, Y and Z of both ends, the length, the kind ("distance" or
  // "radius") and, of a radius, the deviation of the rim from the circle, in file units.
  std::string to_csv() const;

 private:
  std::vector<RulerMark> marks_;
  std::vector<std::vector<RulerMark>> undone_to_, redone_to_;
};

}  // namespace kerf
