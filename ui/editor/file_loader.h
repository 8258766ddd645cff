#pragma once

#include <atomic>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/work.h"
#include "ui/render/prepared_body.h"

namespace kerf {

// Files that were read: one scene, or a journal, and what its pictures need.
struct LoadedFiles {
  std::vector<std::filesystem::path> files;
  Work work;
  PreparedBodies prepared;
  std::optional<Error> cannot_be_kept;  // why the work cannot be saved
};

// Makes ready what follows from the work, or says that it was stopped; `progress` may be null.
Status prepare(LoadedFiles& loaded, const Progress* progress);
// The same, which nobody stops.
void prepare(LoadedFiles& loaded);

// Bodies, paints and strokes of several files as one scene, or a journal alone; a view only where there is
// one file. `progress` may be null.
Result<LoadedFiles> load_files(std::vector<std::filesystem::path> files, const Progress* progress);

// Reads files on a thread of its own, into a world of its own, while the editor goes on.
class FileLoader {
 public:
  // Gives up what is being read, and reads these.
  void start(std::vector<std::filesystem::path> files);
  // Gives up what is being read. Its thread ends when it next tells how far it is.
  void cancel();
  bool busy() const { return job_ != nullptr; }

  // What is being read, for people.
  std::string name() const;
  // How far it is, 0 to 1.
  double fraction() const;

  // What was read or why it could not be, once.
  std::optional<Result<LoadedFiles>> take();

 private:
  struct Job {
    std::vector<std::filesystem::path> files;
    std::atomic<double> fraction = 0;
    std::atomic<bool> given_up = false;
    std::future<Result<LoadedFiles>> result;
  };
  std::unique_ptr<Job> job_;
  std::vector<std::unique_ptr<Job>> given_up_;  // until their threads have ended
};

// Files of so few bytes are read faster than a frame is missed.
bool opens_at_once(std::span<const std::filesystem::path> files);

}  // namespace kerf
