#pragma once

#include <array>
#include <string>

#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"

namespace kerf {

// Holds a piece by a spring, or moves the far end of the spring that holds it (see Spring). It takes effect
// between the ticks before and after it; bodies only follow a spring while they move.
struct Pull {
  PieceId piece;
  Vec3 at{0};  // m, the point that is held, in the frame of the body
  Vec3 to{0};  // m, in the world, where the spring pulls it

  static constexpr const char* kName = "pull";
  static constexpr std::array<const char*, 3> kKeys{"piece", "at", "to"};
  static constexpr std::array<const char*, 0> kOptionalKeys{};
  std::string words() const;
  size_t weight() const { return 0; }
  void write(CommandWriter& line) const;
  static Result<Pull> read(const CommandReader& line);
};

// Takes the spring away.
struct LetGo {
  static constexpr const char* kName = "let-go";
  static constexpr std::array<const char*, 0> kKeys{};
  static constexpr std::array<const char*, 0> kOptionalKeys{};
  std::string words() const { return "Let go"; }
  size_t weight() const { return 0; }
  void write(CommandWriter&) const {}
  static Result<LetGo> read(const CommandReader&) { return LetGo{}; }
};

}  // namespace kerf
