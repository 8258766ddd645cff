#pragma once

#include <string>

#include "core/base/ids.h"
#include "core/base/vec3.h"

namespace kerf {

class Fields;

// Holds a piece by a spring, or moves the far end of the spring that holds it (see Spring). It takes effect
// between the ticks before and after it; bodies only follow a spring while they move.
struct Pull {
  PieceId piece;
  Vec3 at{0};  // m, the point that is held, in the frame of the body
  Vec3 to{0};  // m, in the world, where the spring pulls it

  static constexpr const char* kName = "pull";
  std::string words() const;
  size_t weight() const { return 0; }
};
void describe(Fields& f, Pull& c);

// Takes the spring away.
struct LetGo {
  static constexpr const char* kName = "let-go";
  std::string words() const { return "Let go"; }
  size_t weight() const { return 0; }
};
inline void describe(Fields&, LetGo&) {}

}  // namespace kerf
