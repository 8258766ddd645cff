#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/command.h"
#include "core/document/scene.h"

namespace kerf {

class Document;

// The state hash that the world had after so many commands, when nothing waited.
struct StateMark {
  size_t commands = 0;
  uint64_t hash = 0;
  size_t line = 0;  // of the journal file, from 1; 0: of none
};

// A document as its file (.kerf) holds it, one JSON object a line: first the scene, with "kerf": "journal"
// and the hashes of its meshes, then the commands since (see command_text), and between them marks,
// {"hash": "0123456789abcdef"}.
struct Journal {
  SceneDescription scene;         // without strokes: those that a scene brings are commands here
  std::filesystem::path work_of;  // the file that the work was last saved to, where this is a copy; or empty
  std::vector<Command> commands;
  std::vector<StateMark> marks;  // ascending
  std::string damage;            // one sentence on what could not be read, or empty
};

// Reads a journal as far as it is whole: a torn last line, and everything from the first line on that makes
// no sense, is left out, and `damage` says which line and why. Bad input where the file or its first line
// cannot be read. The meshes are not looked at.
Result<Journal> read_journal(const std::filesystem::path& file);

// The lines of a journal. `folder` is where it will lie, empty where its meshes are to be named by their
// whole paths. Bad input where a mesh has no hash (see note_hashes) or a name is not UTF-8.
Result<std::string> journal_head(const SceneDescription& scene, const std::filesystem::path& work_of,
                                 const std::filesystem::path& folder);
Result<std::string> journal_lines(std::span<const Command> commands, std::span<const StateMark> marks,
                                  const std::filesystem::path& folder);

// The state of a document in which nothing waits is marked when so many commands have come since the last
// mark.
inline constexpr size_t kCommandsBetweenMarks = 50;
// Marks the state where that is due, or with `always` wherever nothing waits and the state is not marked yet;
// returns whether it did. A mark seals the journal (see Document::seal_journal). O(faces) where it marks.
bool mark_state(Document& document, std::vector<StateMark>& marks, bool always = false);

}  // namespace kerf
