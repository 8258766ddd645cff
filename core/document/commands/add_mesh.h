#pragma once

#include <array>
#include <string>

#include "core/base/progress.h"
#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// Adds a body to the world from a mesh file.
struct AddMesh {
  std::filesystem::path file;
  std::string name;

  static constexpr const char* kName = "add-mesh";
  static constexpr std::array<const char*, 2> kKeys{"mesh", "name"};
  static constexpr std::array<const char*, 0> kOptionalKeys{};
  std::string words() const;
  size_t weight() const { return file.native().size() + name.size(); }
  void write(CommandWriter& line) const;
  static Result<AddMesh> read(const CommandReader& line);
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};

}  // namespace kerf
