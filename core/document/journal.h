#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/document/commands.h"
#include "core/document/scene.h"
#include "core/world/rigid_body.h"

namespace kerf {

class Document;

// The state hash of the world after the first `commands` commands, taken while no move was queued; and, where
// bodies have moved by themselves, the kind of machine on which they did (see machine_kind), where it has
// brought them, and when.
struct StateMark {
  size_t commands = 0;
  uint64_t hash = 0;
  size_t line = 0;  // line number in the journal file, from 1; 0 if the mark was not read from a file
  std::string machine{};
  std::vector<BodyState> bodies{};
  std::vector<NearPair> pairs{};
  Ticks clock = 0;  // 0 where bodies did not move, and in journals that do not say it
};

// The format of journals: raised when journals change so that earlier versions of Kerf cannot read them.
inline constexpr uint64_t kJournalFormat = 1;

// A document as its file (.kerf) holds it, one JSON object a line: first the scene, with "kerf": "journal",
// its format (see Fields::format) and the hashes of its meshes, then the commands since (see command_text),
// and between them marks, {"hash": "0123456789abcdef"}, with "machine", "bodies", "pairs" and "clock" where
// bodies have moved (see mark_fields.h).
struct Journal {
  SceneDescription scene;  // without strokes; the strokes of a scene are commands of the journal
  std::filesystem::path
      work_of;  // of an autosaved journal: the file that the document was saved to; or empty
  std::vector<std::filesystem::path> opened;  // of one: the files that the document was opened from
  std::vector<Command> commands;
  std::vector<StateMark> marks;  // ascending
  std::string damage;            // one sentence on what could not be read, or empty
  bool torn = false;             // only the last line could not be read, because it is incomplete
};

// Reads a journal up to its first damaged line. An incomplete last line (`torn`), and everything from the
// first invalid line on, is left out, and `damage` says which line and why. Bad input if the file or its
// first line cannot be read. The mesh files are not read.
Result<Journal> read_journal(const std::filesystem::path& file);

// The text of a journal. `folder` is the folder of the journal file; if it is empty, meshes are named by
// their absolute paths. `work_of` and `opened` are those of Journal. Bad input if a mesh has no hash (see
// record_hashes) or a name is not UTF-8.
Result<std::string> journal_head(const SceneDescription& scene, const std::filesystem::path& work_of,
                                 const std::filesystem::path& folder,
                                 std::span<const std::filesystem::path> opened = {});
Result<std::string> journal_lines(std::span<const Command> commands, std::span<const StateMark> marks,
                                  const std::filesystem::path& folder);

// A mark is due when the document has applied this many commands since the last mark and no move is queued.
inline constexpr size_t kCommandsBetweenMarks = 50;
// The mark of the current state. Precondition: nothing waits, and no stroke is being drawn. O(faces).
StateMark state_mark(const Document& document);
// Appends a mark of the current state if one is due; with `always`, if no move is queued and the state is not
// marked yet. Returns whether it did. A mark seals the journal (see Document::seal_journal). O(faces) if a
// mark is appended.
bool mark_state(Document& document, std::vector<StateMark>& marks, bool always = false);

// The content of any file that Kerf opens: a scene with its meshes loaded and, if the file is a journal, the
// commands that were applied to it.
struct OpenedFile {
  Scene scene;
  Journal journal;  // with the scene as the file describes it; empty if the file is no journal
};

// Reads a scene (.json), a journal (.kerf) or a mesh.
Result<OpenedFile> open_file(const std::filesystem::path& file, const Progress* progress = nullptr);

// Reads a journal regardless of the extension of its name.
Result<OpenedFile> open_journal(const std::filesystem::path& file, const Progress* progress = nullptr);

// Whether the extension of a file is that of a journal (.kerf) or of its previous version (.kerf~).
bool is_journal(const std::filesystem::path& file);

}  // namespace kerf
