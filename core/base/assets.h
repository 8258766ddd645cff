#pragma once

#include <filesystem>

namespace kerf {

// The folder of materials, shaders, scenes and meshes: share/kerf beside the folder of the program or of the
// library that holds this code, or beside one of the folders above it, where Kerf is installed; otherwise
// `assets/` of the checkout from which it was built.
std::filesystem::path assets_folder();

}  // namespace kerf
