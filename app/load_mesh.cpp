#include "app/load_mesh.h"

#include "core/mesh/read_mesh.h"

namespace kerf {

Result<BuiltMesh> load_mesh(const std::filesystem::path& file) {
  const auto soup = read_mesh(file);
  if (!soup) return soup.error();
  auto built = build_mesh(*soup);
  if (!built) return Error{built.error().code, file.string() + ": " + built.error().message};
  return built;
}

}  // namespace kerf
