#include "ui/render/passes/assets.h"

namespace kerf {

std::filesystem::path assets_folder() { return KERF_ASSETS; }

}  // namespace kerf
