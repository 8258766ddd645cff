#pragma once

#include <cstdio>
#include <filesystem>

namespace kerf {

// The file of a frame of a film, counted from 0: "frame-00000.png" and so on.
inline std::filesystem::path frame_file(const std::filesystem::path& folder, size_t frame) {
  char name[40];
  std::snprintf(name, sizeof name, "frame-%05zu.png", frame);
  return folder / name;
}

}  // namespace kerf
