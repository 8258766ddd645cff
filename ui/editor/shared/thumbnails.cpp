#include "ui/editor/shared/thumbnails.h"

#include <algorithm>

#include "core/base/platform.h"
#include "core/base/random.h"
#include "core/document/text/hash.h"

namespace kerf {

namespace fs = std::filesystem;

namespace {

fs::path picture_of(const fs::path& folder, const fs::path& file) {
  uint64_t hash = 0;
  for (const char c : file.string()) hash = hash_combine(hash, static_cast<unsigned char>(c));
  return folder / (hash_text(hash) + ".png");
}

}  // namespace

Status Thumbnails::keep(const fs::path& file, const Pixels& picture) {
  const fs::path png = picture_of(folder_, file);
  std::error_code error;
  fs::create_directories(folder_, error);
  if (const Status written = write_png(shrunk(picture, kWidth, kHeight), png); !written) return written;
  shown_.erase(png);
  return Done{};
}

void Thumbnails::keep_only(std::span<const fs::path> files) {
  std::vector<fs::path> kept;
  for (const fs::path& file : files) kept.push_back(picture_of(folder_, file));
  const auto is_kept = [&](const fs::path& png) { return std::ranges::find(kept, png) != kept.end(); };
  std::vector<fs::path> others;
  std::error_code error;
  for (fs::directory_iterator at(folder_, error); !error && at != fs::directory_iterator();
       at.increment(error)) {
    if (at->path().extension() == ".png" && !is_kept(at->path())) others.push_back(at->path());
  }
  for (const fs::path& png : others) fs::remove(png, error);
  std::erase_if(shown_, [&](const auto& shown) { return !is_kept(shown.first); });
}

std::optional<TipPicture> Thumbnails::find(const fs::path& file) {
  const fs::path png = picture_of(folder_, file);
  auto at = shown_.find(png);
  if (at == shown_.end()) {
    at = shown_.emplace(png, std::nullopt).first;
    if (const std::optional<Pixels> pixels = read_png(png)) {
      at->second = Shown{{}, pixels->width, pixels->height};
      send_picture(*pixels, at->second->texture);
    }
  }
  if (!at->second) return std::nullopt;
  return TipPicture{at->second->texture.name(), {at->second->width, at->second->height}};
}

void send_picture(const Pixels& pixels, const gl::Texture& texture) {
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, pixels.width, pixels.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
               pixels.rgb.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
}

std::vector<fs::path> example_scenes() {
  std::vector<fs::path> scenes;
  std::error_code error;
  fs::directory_iterator at(assets_folder() / "scenes", error);
  for (; !error && at != fs::directory_iterator(); at.increment(error)) {
    const bool of_figures = at->path().stem().string().starts_with("figure-");
    if (at->path().extension() == ".json" && !of_figures) scenes.push_back(at->path());
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

std::string title_of_scene(const fs::path& scene) {
  std::string title = scene.stem().string();
  std::replace(title.begin(), title.end(), '-', ' ');
  if (!title.empty() && title.front() >= 'a' && title.front() <= 'z')
    title.front() = static_cast<char>(title.front() - 'a' + 'A');
  return title;
}

}  // namespace kerf
