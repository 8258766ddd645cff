#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/document/journal.h"

namespace kerf {

// A file locked by this program. No other program can lock it while this object exists; the operating system
// releases the lock when the program ends, even by a crash. Other programs can still read, rename and remove
// the file.
class LockedFile {
 public:
  // Creates a file with these bytes; it appears under its name atomically, locked and flushed to the disk.
  // Fails if the file exists.
  static Result<LockedFile> create(const std::filesystem::path& path, std::string_view bytes);
  // Opens and locks an existing file. Fails if another program has locked it.
  static Result<LockedFile> open(const std::filesystem::path& path);

  LockedFile(LockedFile&& other) noexcept;
  LockedFile& operator=(LockedFile&& other) noexcept;
  ~LockedFile();

  const std::filesystem::path& path() const { return path_; }

  // Appends all bytes or, on failure, none. They survive a crash of the program, and a loss of power only
  // after flush().
  Status append(std::string_view bytes);
  // Flushes appended bytes to the disk asynchronously. Returns true if a flush was started or is in progress;
  // call flush() again in that case.
  bool flush();

  // Returns true if another program has removed the file. O(1).
  bool is_removed() const;
  // Removes the file, if it still exists.
  void remove();

 private:
  struct Handle;
  LockedFile(std::filesystem::path path, Handle* handle);
  std::filesystem::path path_;
  Handle* handle_ = nullptr;
};

// Stores the unsaved changes of one editor in a journal file that survives a crash. Each editor locks its own
// file and ignores those of other editors.
class Autosave {
 public:
  explicit Autosave(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // Starts autosaving a document with this scene. `work_of`: the file it was last saved to; may be empty.
  // `opened`: the files it was read from. The autosave file of the previous document is removed once the new
  // one is written. Precondition: the meshes have hashes (see record_hashes).
  void begin(SceneDescription scene, std::filesystem::path work_of,
             std::vector<std::filesystem::path> opened = {});

  // Appends the final commands (see Document::final_commands) and marks since the last call; the first call
  // writes all of them to a new file, as does the next one after another program removed the file.
  // AdvanceTime commands lag by less than a second. On failure, everything written before is kept, and the
  // next call retries. The cost is proportional to the number of new
  // commands. Data reach the disk asynchronously, so call follow() or flush() again within about a second.
  // Precondition: `document` and `marks` continue those of the last call.
  Status follow(const Document& document, std::span<const StateMark> marks);
  // Returns true if follow() would write something. O(1).
  bool is_behind(const Document& document, std::span<const StateMark> marks) const;
  // Continues flushing to the disk. Returns true if anything is left to flush.
  bool flush() { return file_ && file_->flush(); }

  // Removes the file; the next call of follow creates a new one.
  void drop();

  bool keeps() const { return file_.has_value() || replaced_.has_value(); }

 private:
  Result<LockedFile> create(std::string_view text) const;

  std::filesystem::path folder_;
  SceneDescription scene_;
  std::filesystem::path work_of_;
  std::vector<std::filesystem::path> opened_;
  std::optional<LockedFile> file_, replaced_;
  size_t commands_ = 0, marks_ = 0;  // numbers written to the file
};

// Unsaved work of a crashed editor. No other editor finds it while this object holds the lock.
struct RecoverableDocument {
  LockedFile file;
  Journal journal;
  size_t cuts = 0;  // strokes and cuts by a knife that are not undone
  std::filesystem::file_time_type last_change;
};

// Finds the unsaved work of crashed editors in the folder, the latest first. Skips the locked files of
// running editors. Leaves an unreadable file unchanged and appends a sentence about it to `faults`.
std::vector<RecoverableDocument> find_recoverable_documents(const std::filesystem::path& folder,
                                                            std::vector<std::string>& faults);

}  // namespace kerf
