#pragma once

#include <atomic>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/thumbnails.h"
#include "ui/gl/buffers.h"
#include "ui/gl/image.h"

namespace kerf {

// The preview of a file: named facts, and an image of its faces.
struct FilePreview {
  std::vector<std::pair<std::string, std::string>> facts{};  // name and value: "Faces", "12 345"
  std::string note{};                                        // a sentence if the file was not read whole
  Pixels picture{};                                          // empty if the faces were not read
};

struct PreviewRequest {
  std::filesystem::path file;
  Theme theme = Theme::kDark;                                // of the picture
  std::map<std::string, std::optional<FileFrame>> frames{};  // see Settings::frames
  friend bool operator==(const PreviewRequest&, const PreviewRequest&) = default;
};

// Files of more bytes are not read whole: their preview has the counts of the header, if there are any.
inline constexpr uintmax_t kMaxPreviewBytes = 128 << 20;

// Reads a mesh, a scene or a journal, draws its faces in an orthographic view from the front right, and
// describes it; or counts the lines of a drawing, or the strokes of a path or a program. A file that cannot
// be read has its error as the note. Stops early if `progress` does; the result is then incomplete. Linear in
// the size of the file; independent of it above kMaxPreviewBytes.
FilePreview preview_of(const PreviewRequest& request, const Progress& progress);

// Reads the preview of one file at a time on a background thread. Another request cancels a running job, and
// begins when its thread has ended.
class FilePreviewer {
 public:
  FilePreviewer() = default;
  FilePreviewer(const FilePreviewer&) = delete;
  FilePreviewer& operator=(const FilePreviewer&) = delete;
  // Cancels the job and waits for its thread.
  ~FilePreviewer();

  // Requests a preview; nullopt: none. No-op if the request is the last one.
  void select(const std::optional<PreviewRequest>& request);
  // Returns true if a job is running or waits for a cancelled one.
  bool busy() const { return job_ != nullptr; }
  // Waits for the running job, at most `seconds`, then takes its result. Never blocks if that is 0.
  void update(double seconds);
  // Returns the preview of the requested file; null as long as it is not read.
  const FilePreview* shown() const { return shown_ ? &*shown_ : nullptr; }
  const std::optional<PreviewRequest>& selected() const { return selected_; }

  // Draws the preview into the current window. `thumbnail` replaces an empty image. Precondition: an OpenGL
  // context is current, and outlives this object.
  void draw(const std::optional<TipPicture>& thumbnail);

 private:
  struct Job {
    PreviewRequest request;
    std::atomic<bool> cancelled = false;
    std::future<FilePreview> result;
  };
  void start();
  TipPicture picture();

  std::optional<PreviewRequest> selected_;
  std::optional<FilePreview> shown_;  // of the selected file
  std::unique_ptr<Job> job_;          // of the selected file, or a cancelled one before it
  // Of the last image. It outlives the selection, because the lists of the current frame may refer to it.
  std::optional<gl::Texture> texture_;
  bool is_sent_ = false;  // the texture holds the image of shown_
};

}  // namespace kerf
