#pragma once

#include "core/document/files/scene.h"
#include "ui/render/picture/picture.h"

namespace kerf {

// The options of a picture of this size that shows what a scene asks for. The error names `file`, the
// scene's.
Result<PictureOptions> options_for(const std::filesystem::path& file, const Scene& scene, int width,
                                   int height);

}  // namespace kerf
