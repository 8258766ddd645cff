#include "core/document/journal/opened_file.h"

namespace kerf {

bool is_journal(const std::filesystem::path& file) {
  return file.extension() == ".kerf" || file.extension() == ".kerf~";
}

Result<OpenedFile> open_journal(const std::filesystem::path& file, const Progress* progress) {
  auto journal = read_journal(file);
  if (!journal) return journal.error();
  auto scene = load_scene(journal->scene, progress);
  if (!scene) return scene.error();
  return OpenedFile{std::move(*scene), std::move(*journal)};
}

Result<OpenedFile> open_file(const std::filesystem::path& file, const Progress* progress) {
  if (is_journal(file)) return open_journal(file, progress);
  auto scene = read_scene(file, progress);
  if (!scene) return scene.error();
  return OpenedFile{std::move(*scene), {}};
}

}  // namespace kerf
