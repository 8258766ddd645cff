#pragma once

#include "ui/editor/shared/workspace.h"

namespace kerf {

// Hides all pieces but the chosen ones, and shows again those that were hidden by it, and no others.
class Isolation {
 public:
  // The workspace must outlive it.
  explicit Isolation(Workspace& on) : on_(on) {}

  // Asks for the change. Precondition: why_not() is null.
  void change();
  // The sentence why nothing can be isolated nor shown again, or null.
  const char* why_not() const;

  // To be called after each change of the world, and when another document is open.
  void follow();
  void forget() { isolated_from_.clear(); }

 private:
  std::vector<PieceId> to_show_again() const;

  Workspace& on_;
  std::vector<BodyId> isolated_from_;                 // bodies that are hidden because others were isolated
  std::optional<std::vector<BodyId>> hidden_before_;  // while an isolation is going on
};

}  // namespace kerf
