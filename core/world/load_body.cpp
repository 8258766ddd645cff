#include "core/world/load_body.h"

#include "core/mesh/load_mesh.h"

namespace kerf {

Result<Body> load_body(std::string name, const std::filesystem::path& file, const Progress* progress) {
  ProgressShares shares(progress);
  const Progress loading = shares.next(0.5), making = shares.next(0.5);
  auto built = load_mesh(file, &loading);
  if (!built) return built.error();
  return make_body(std::move(name), std::move(*built), &making);
}

}  // namespace kerf
