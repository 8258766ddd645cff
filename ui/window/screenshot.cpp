#include "ui/window/screenshot.h"

#include <array>
#include <chrono>
#include <ctime>

#include "core/base/user_folders.h"
#include "ui/render/picture/png.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;

std::string stamp() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm local{};
  localtime_r(&now, &local);
  std::array<char, 64> text{};
  const size_t length = std::strftime(text.data(), text.size(), "kerf-%Y-%m-%d-%H%M%S", &local);
  return {text.data(), length};
}

fs::path free_name(const fs::path& folder) {
  const std::string name = stamp();
  fs::path file = folder / (name + ".png");
  std::error_code error;
  for (int i = 2; fs::exists(file, error); ++i) file = folder / (name + "-" + std::to_string(i) + ".png");
  return file;
}

Pixels cut_out(const Pixels& all, const Area& part) {
  const auto x = static_cast<int>(part.at.x), y = static_cast<int>(part.at.y);
  const int width = std::min(static_cast<int>(part.size.x), all.width - x);
  const int height = std::min(static_cast<int>(part.size.y), all.height - y);
  Pixels pixels{width, height, {}};
  for (int row = y; row < y + height; ++row) {
    const auto from = all.rgb.begin() + std::ptrdiff_t{3} * (std::ptrdiff_t{row} * all.width + x);
    pixels.rgb.insert(pixels.rgb.end(), from, from + std::ptrdiff_t{3} * width);
  }
  return pixels;
}

}  // namespace

Result<fs::path> take_screenshot(Vec2 window, const Area& part) {
  const Pixels pixels = cut_out(read_pixels(0, static_cast<int>(window.x), static_cast<int>(window.y)), part);
  std::error_code error;
  const fs::path here = free_name(fs::current_path(error));
  const Status written = write_png(pixels, here);
  if (written) return here;
  if (home_folder().empty()) return written.error();
  const fs::path pictures = home_folder() / "Pictures";
  fs::create_directories(pictures, error);
  const fs::path there = free_name(pictures);
  const Status second = write_png(pixels, there);
  if (second) return there;
  return written.error();
}

}  // namespace kerf
