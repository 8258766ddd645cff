#include "core/document/work.h"

namespace kerf {

bool is_journal(const std::filesystem::path& file) {
  return file.extension() == ".kerf" || file.extension() == ".kerf~";
}

Result<Work> read_journal_work(const std::filesystem::path& file, const Progress* progress) {
  auto journal = read_journal(file);
  if (!journal) return journal.error();
  auto scene = load_scene(journal->scene, progress);
  if (!scene) return scene.error();
  return Work{std::move(*scene), std::move(*journal)};
}

Result<Work> read_work(const std::filesystem::path& file, const Progress* progress) {
  if (is_journal(file)) return read_journal_work(file, progress);
  auto scene = read_scene(file, progress);
  if (!scene) return scene.error();
  return Work{std::move(*scene), {}};
}

}  // namespace kerf
