#pragma once

#include <string>

#include "core/base/result.h"
#include "core/document/files/scene.h"

namespace kerf {

// The text of a view for the clipboard: {"eye":[x,y,z],"target":[x,y,z]}, like the "view" of a scene file.
std::string view_text(const View& view);

// Parses that text, or a whole scene that has a "view".
Result<View> parse_view_text(const std::string& text);

}  // namespace kerf
