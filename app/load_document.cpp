#include "app/load_document.h"

#include "app/interrupt.h"
#include "app/progress_line.h"
#include "app/tell.h"
#include "core/document/journal/opened_file.h"
#include "core/document/journal/replay.h"
#include "ui/render/picture/scene_strokes.h"

namespace kerf {

namespace {

Result<OpenedFile> open_with_progress(const std::filesystem::path& file) {
  ProgressLine line("loading " + file.filename().string());
  const Progress progress = line.progress();
  return open_file(file, &progress);
}

// A step that fails here failed when the journal was made, too.
Status replay_all(const Journal& journal, Document& document) {
  ProgressLine line("replaying");
  const Progress progress = line.progress();
  Walk how;
  how.progress = &progress;
  how.told = [](const Result<StepResult>&) -> Status { return interrupted() ? Status(stopped()) : Done{}; };
  return Replay(journal, document).run(how);
}

Status cut_all(const std::vector<StrokePath>& strokes, Document& document) {
  ProgressLine line("cutting");
  const Progress progress = line.progress();
  return cut_strokes(
      document, strokes, [](const StepResult&) {}, &progress);
}

}  // namespace

Result<Document> load_document(const std::filesystem::path& file) {
  auto work = open_with_progress(file);
  if (!work) return error_or_stopped(work.error());
  if (!work->journal.damage.empty()) warn(work->journal.damage);
  Document document(std::move(work->scene.world));
  if (const Status cut = cut_all(work->scene.strokes, document); !cut) return error_or_stopped(cut.error());
  if (const Status run = replay_all(work->journal, document); !run) return error_or_stopped(run.error());
  return document;
}

}  // namespace kerf
