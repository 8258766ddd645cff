#pragma once

#include <filesystem>

namespace kerf {

// The folder of shaders, scenes and meshes: `assets/` of the checkout from which the program was built.
std::filesystem::path assets_folder();

}  // namespace kerf
