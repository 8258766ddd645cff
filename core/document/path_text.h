#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "core/document/path_file.h"

namespace kerf {

// A stroke as the JSON object that path files and scenes hold. It is read back as the same stroke to the bit.
nlohmann::ordered_json stroke_json(const StrokePath& stroke);

// The text of a path file, with one line for each key.
std::string path_file_text(std::span<const StrokePath> strokes);

}  // namespace kerf
