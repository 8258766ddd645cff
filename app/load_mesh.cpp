#include "app/load_mesh.h"

#include "app/progress_line.h"
#include "core/mesh/load_mesh.h"

namespace kerf {

Result<BuiltMesh> load_mesh(const std::filesystem::path& file) {
  ProgressLine line("loading " + file.filename().string());
  const Progress progress = line.progress();
  auto built = load_mesh(file, &progress);
  if (!built) return error_or_stopped(built.error());
  return built;
}

}  // namespace kerf
