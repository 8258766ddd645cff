#include "ui/window/screenshot.h"

#include <array>
#include <chrono>
#include <ctime>

#include "core/base/user_folders.h"

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

}  // namespace

Pixels window_pixels(Vec2 window, const Area& part) {
  const Pixels all = read_pixels(0, static_cast<int>(window.x), static_cast<int>(window.y));
  return cut_out(all, static_cast<int>(part.at.x), static_cast<int>(part.at.y), static_cast<int>(part.size.x),
                 static_cast<int>(part.size.y));
}

Result<fs::path> take_screenshot(Vec2 window, const Area& part) {
  const Pixels pixels = window_pixels(window, part);
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
