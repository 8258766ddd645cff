#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/gl/buffers.h"
#include "ui/gl/image.h"
#include "ui/window/widgets.h"

namespace kerf {

// Thumbnails of files as last open, kept between sessions: a PNG per file, in a folder of their own.
class Thumbnails {
 public:
  static constexpr int kWidth = 240, kHeight = 150;  // pixels

  // The folder need not exist.
  explicit Thumbnails(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // Stores the thumbnail of a file (an absolute path), cropped to its proportions, in place of an earlier
  // one, which is kept on failure.
  Status keep(const std::filesystem::path& file, const Pixels& picture);
  // Removes the thumbnails of all other files.
  void keep_only(std::span<const std::filesystem::path> files);

  // Returns the thumbnail of a file, if any. Each is read once. Precondition: an OpenGL context is current,
  // and outlives this object.
  std::optional<TipPicture> find(const std::filesystem::path& file);

 private:
  struct Shown {
    gl::Texture texture;
    int width = 0, height = 0;
  };

  std::filesystem::path folder_;
  std::map<std::filesystem::path, std::optional<Shown>> shown_;  // by the paths of their images
};

// Stores an image in a texture of the current context.
void send_picture(const Pixels& pixels, const gl::Texture& texture);

// Returns the example scenes, ordered by name, without the many scenes of the paper's figures.
std::vector<std::filesystem::path> example_scenes();

// Returns "Thin plate" for "thin-plate.json".
std::string title_of_scene(const std::filesystem::path& scene);

}  // namespace kerf
