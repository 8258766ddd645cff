#include "ui/editor/shell/held_press.h"

#include <glm/geometric.hpp>
#include <utility>

#include "ui/editor/shared/picture/click.h"

namespace kerf {

std::optional<InputEvent> HeldPress::begun_by(const InputEvent& event) {
  if (!held_) return std::nullopt;
  switch (event.kind) {
    case InputEvent::Kind::kMove:
      if (glm::length(event.at - held_->at) <= kClickReach) return std::nullopt;
      return std::exchange(held_, std::nullopt);
    case InputEvent::Kind::kPress:
    case InputEvent::Kind::kRelease:
      held_.reset();
      break;
    case InputEvent::Kind::kWheel:
    case InputEvent::Kind::kKey:
    case InputEvent::Kind::kKeyUp:
    case InputEvent::Kind::kText:
      break;
  }
  return std::nullopt;
}

}  // namespace kerf
