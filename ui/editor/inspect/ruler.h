#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace kerf {

// A measurement between two points of the world [m].
struct RulerMark {
  std::string name;
  Vec3 from{0}, to{0};
  double length() const { return glm::length(to - from); }
  friend bool operator==(const RulerMark&, const RulerMark&) = default;
};

// The measurements of a document in order of creation, with an undo of their own.
class RulerList {
 public:
  const std::vector<RulerMark>& marks() const { return marks_; }

  // Begins an undo step, which contains all edits until the next call.
  void begin_edit();
  // Edits. Preconditions: begin_edit() was called, and the index exists. add() assigns an unused name:
  // "Distance 1".
  void add(const Vec3& from, const Vec3& to);
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

  // Returns a header and a line per mark: name, X, Y and Z of both ends and the length, in file units.
  std::string to_csv() const;

 private:
  std::vector<RulerMark> marks_;
  std::vector<std::vector<RulerMark>> undone_to_, redone_to_;
};

}  // namespace kerf
