#include "ui/render/bodies/assets.h"

namespace kerf {

std::filesystem::path assets_folder() { return KERF_ASSETS; }

}  // namespace kerf
