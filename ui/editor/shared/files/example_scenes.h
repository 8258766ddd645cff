#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kerf {

// The scenes that come with Kerf, in the order of their names, without those of the figures of the paper:
// they are many, and few of them are good to begin with.
std::vector<std::filesystem::path> example_scenes();

// "thin-plate.json" as "Thin plate".
std::string title_of_scene(const std::filesystem::path& scene);

}  // namespace kerf
