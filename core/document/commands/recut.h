#pragma once

#include <array>
#include <string>

#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"

namespace kerf {

// Takes the last stroke back and cuts it again with other settings.
struct Recut {
  CutSettings settings;

  static constexpr const char* kName = "recut";
  static constexpr std::array<const char*, 1> kKeys{"settings"};
  static constexpr std::array<const char*, 0> kOptionalKeys{};
  std::string words() const;
  size_t weight() const { return 0; }
  void write(CommandWriter& line) const;
  static Result<Recut> read(const CommandReader& line);
};

}  // namespace kerf
