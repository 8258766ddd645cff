#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/commands.h"
#include "core/document/scene.h"
#include "core/document/text/json.h"
#include "core/world/rigid_body.h"

namespace kerf {

class Document;

// A mark of a journal: the state hash of the world after the first `commands` commands, taken while no move
// was queued. If bodies have moved, also their states, the time, and the kind of machine (see machine_kind).
struct StateMark {
  size_t commands = 0;
  uint64_t hash = 0;
  size_t line = 0;  // line number in the journal file, from 1; 0 if the mark was not read from a file
  std::string machine{};
  std::vector<BodyState> bodies{};
  std::vector<NearPair> pairs{};
  Ticks clock = 0;                  // 0 if bodies did not move, and in journals without it
  std::optional<uint64_t> looks{};  // see looks_hash()
  // The history steps between these positions are one to the user, under a name; equal without such a group.
  size_t group_from = 0, group_to = 0;
  std::string group{};
};

// Format number of journals; incremented when earlier versions of Kerf cannot read new journals.
inline constexpr uint64_t kJournalFormat = 1;

// The content of a journal file (.kerf), one JSON object per line: first the scene, with "kerf": "journal",
// its format (see Fields::format) and the hashes of its meshes; then the commands (see command_text), and
// between them marks, {"hash": "0123456789abcdef"}, with "looks" if bodies have looks, "group",
// "group-from" and "group-to" if it states a group, and "machine", "bodies", "pairs" and "clock" if bodies
// have moved.
struct Journal {
  SceneDescription scene;  // without strokes; the strokes of a scene are commands of the journal
  std::filesystem::path
      work_of;  // of an autosaved journal: the file that the document was saved to; or empty
  std::vector<std::filesystem::path> opened;  // of an autosaved journal: the files that were opened
  std::vector<Command> commands;
  std::vector<StateMark> marks;  // ascending
  std::string damage;            // one sentence about what could not be read, or empty
  bool torn = false;             // only the last line is unreadable, because it is incomplete
};

// Reads a journal up to its first invalid line or an incomplete last line (`torn`); the rest is ignored, and
// `damage` states the line and the reason. Fails with bad input if the file or its first line cannot be read.
// Does not read the mesh files.
Result<Journal> read_journal(const std::filesystem::path& file);

// Format the head of a journal, and its lines. `folder` is the folder of the journal file; if it is empty,
// meshes are named by absolute paths. `work_of` and `opened`: see Journal. Fail with bad input if a mesh has
// no hash (see record_hashes) or a name is not UTF-8.
Result<std::string> journal_head(const SceneDescription& scene, const std::filesystem::path& work_of,
                                 const std::filesystem::path& folder,
                                 std::span<const std::filesystem::path> opened = {});
Result<std::string> journal_lines(std::span<const Command> commands, std::span<const StateMark> marks,
                                  const std::filesystem::path& folder);

// The number of commands after which a mark is due, once no move is queued.
inline constexpr size_t kCommandsBetweenMarks = 50;
// Returns the mark of the current state. Preconditions: the queue is empty, and no stroke is being drawn.
// O(faces).
StateMark state_mark(const Document& document);
// Appends a mark of the current state if one is due; with `always`, if no move is queued and the state has no
// mark yet. Returns true if a mark was appended, which also seals the journal (see Document::seal_journal).
// O(faces) in that case.
bool mark_state(Document& document, std::vector<StateMark>& marks, bool always = false);
// Appends a mark with a group of history steps. Preconditions: as for state_mark(); from < to. O(faces).
void mark_group(Document& document, std::vector<StateMark>& marks, size_t from, size_t to, std::string name);

// The content of an opened file: a scene with its meshes loaded and, for a journal, its commands.
struct OpenedFile {
  Scene scene;
  Journal journal;  // with the scene as described in the file; empty if the file is not a journal
};

// Reads a scene (.json), a journal (.kerf) or a mesh. `unit`: see read_description; for meshes only.
Result<OpenedFile> open_file(const std::filesystem::path& file, const Progress* progress = nullptr,
                             FileUnit unit = FileUnit::kMetre);

// Reads a journal regardless of its file extension.
Result<OpenedFile> open_journal(const std::filesystem::path& file, const Progress* progress = nullptr);

// Returns true if the extension of a file is that of a journal (.kerf) or of its previous version (.kerf~).
bool is_journal(const std::filesystem::path& file);

// Returns a command as one line of a journal, without the line break: {"do": "move-beam", "origin": [..],
// "direction": [..]}. Numbers are exact. `folder` is the folder of the journal; mesh files are named as in
// path_text. Fails with bad input if a name or a path is not UTF-8.
Result<std::string> command_text(const Command& command, const std::filesystem::path& folder);

// Parses a line written by command_text; numbers are restored to the bit. `beam` is the beam of the last
// stroke, if any: a move must not reverse its direction. Fails with bad input, with a JSON pointer, for
// numbers out of range, missing keys and unknown keys.
Result<Command> parse_command(const JsonValue& value, const std::filesystem::path& folder,
                              const std::optional<BeamAt>& beam);

class Fields;

// A mark of a journal. If bodies have moved it has "machine", "clock" and
//   "bodies": [{"body": [slot, generation], "position", "orientation", "velocity", "spin", "quiet",
//              "asleep"}],
//   "pairs": [[slot, generation, slot, generation, touching, crossed]], without the second body for the
//            ground: 1 if the two touch, and for how many ticks they have intersected. Read sorted.
// Numbers are restored to the bit.
void describe(Fields& f, StateMark& mark);

}  // namespace kerf
