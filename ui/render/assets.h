#pragma once

#include <filesystem>

namespace kerf {

// The project's folder of shaders, scenes and meshes, `assets/` of the checkout that was compiled.
std::filesystem::path assets_folder();

}  // namespace kerf
