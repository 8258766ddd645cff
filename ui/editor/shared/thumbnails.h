#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/gl/buffers.h"
#include "ui/render/png.h"
#include "ui/window/property_rows.h"

namespace kerf {

// Small pictures of files as they looked when they were last open, kept from session to session: one PNG a
// file, in one folder that holds nothing else.
class Thumbnails {
 public:
  static constexpr int kWidth = 240, kHeight = 150;  // pixels

  // The folder need not exist.
  explicit Thumbnails(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // Keeps a picture of a file (an absolute path) in place of an earlier one, cut to the proportions of a
  // thumbnail. Fails if it cannot be written; the earlier one is kept then.
  Status keep(const std::filesystem::path& file, const Pixels& picture);
  // Removes the thumbnails of all other files.
  void keep_only(std::span<const std::filesystem::path> files);

  // The thumbnail of a file; nothing where there is none. Read once. Precondition: an OpenGL context is
  // current, and outlives this object.
  std::optional<TipPicture> find(const std::filesystem::path& file);

 private:
  struct Shown {
    gl::Texture texture;
    int width = 0, height = 0;
  };

  std::filesystem::path folder_;
  std::map<std::filesystem::path, std::optional<Shown>> shown_;  // by the names of the pictures
};

// The scenes that come with Kerf, in the order of their names, without those of the figures of the paper:
// they are many, and few of them are good to begin with.
std::vector<std::filesystem::path> example_scenes();

// "thin-plate.json" as "Thin plate".
std::string title_of_scene(const std::filesystem::path& scene);

}  // namespace kerf
