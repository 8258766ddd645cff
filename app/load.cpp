#include "app/load.h"

#include "app/tell.h"
#include "core/mesh/load_mesh.h"

namespace kerf {

Result<BuiltMesh> load_mesh(const std::filesystem::path& file) {
  return load_showing_progress<BuiltMesh>(file, load_mesh);
}

Result<OpenedFile> load_file(const std::filesystem::path& file) {
  auto opened = load_showing_progress<OpenedFile>(file, open_file);
  if (opened && !opened->journal.damage.empty()) warn(opened->journal.damage);
  return opened;
}

}  // namespace kerf
