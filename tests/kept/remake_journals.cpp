// Replays journals and writes their marks anew, for a change that leads to other states: `remake_journals
// FILE...`. What a user of such files sees belongs into the message of its commit.
#include <cstdio>
#include <filesystem>

#include "core/document/document.h"
#include "core/document/journal.h"
#include "core/document/replay.h"
#include "core/document/save.h"

namespace kerf {
namespace {

Status remake(const std::filesystem::path& file) {
  auto opened = open_journal(file);
  if (!opened) return opened.error();
  const Journal& journal = opened->journal;
  Document document(std::move(opened->scene.world));
  Replay replay(journal, document);
  QueueRun how;
  how.told = [](const Result<StepResult>&) -> Status { return Done{}; };
  std::vector<StateMark> marks;
  for (const StateMark& mark : journal.marks) {
    while (!replay.done() && replay.applied() < mark.commands) {
      if (const Status next = replay.next(how); !next) return next;
    }
    mark_state(document, marks, true);
  }
  if (const Status saved = save_journal(file, journal.scene, journal.commands, marks); !saved) return saved;
  std::filesystem::remove(previous_version(file));
  return Done{};
}

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (const kerf::Status remade = kerf::remake(argv[i]); !remade) {
      std::fprintf(stderr, "%s\n", remade.error().message.c_str());
      return 1;
    }
  }
  return 0;
}
