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

InputFiles inputs_of(const std::filesystem::path& file, const OpenedFile& opened) {
  InputFiles inputs;
  inputs.add(file);
  inputs.add_meshes(opened.scene);
  inputs.add_meshes(opened.journal.commands);
  return inputs;
}

InputFiles inputs_of(std::span<const std::string> files) {
  InputFiles inputs;
  for (const std::string& file : files) {
    inputs.add(file);
    if (is_journal(file)) {
      const auto journal = read_journal(file);
      if (journal) inputs.add_meshes(journal->scene);
      if (journal) inputs.add_meshes(journal->commands);
    } else if (const auto scene = read_description(file)) {
      inputs.add_meshes(*scene);
    }
  }
  return inputs;
}

Status check_frames(const std::string& option, const std::filesystem::path& folder,
                    const InputFiles& inputs) {
  return inputs.check_folder(option, folder, [](std::string_view name) {
    return name.starts_with("frame-") && name.ends_with(".png");
  });
}

}  // namespace kerf
