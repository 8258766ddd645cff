#pragma once

#include <filesystem>
#include <string>

#include "core/base/progress.h"
#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

class Fields;

// Adds a body to the world from a mesh file.
struct AddMesh {
  std::filesystem::path file;
  std::string name;

  static constexpr const char* kName = "add-mesh";
  std::string words() const { return "Add " + name; }
  size_t weight() const { return file.native().size() + name.size(); }
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, AddMesh& c);

// Sets gravity and the ground.
struct SetEnvironment {
  Environment around;

  static constexpr const char* kName = "set-environment";
  std::string words() const { return "Gravity and ground"; }
  // Does it (see HappensAtOnce).
  Result<Delta> run(World& world, uint32_t generation, const Progress* progress) const;
};
void describe(Fields& f, SetEnvironment& c);

}  // namespace kerf
