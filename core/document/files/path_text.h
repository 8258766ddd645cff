#pragma once

#include <span>
#include <string>

#include "core/document/files/path_file.h"

namespace kerf {

class Fields;

// The fields of a stroke in path files and scenes. A stroke that is written is read back to the bit.
void describe(Fields& f, StrokePath& stroke);

// The text of a path file, with one line for each key.
std::string path_file_text(std::span<const StrokePath> strokes);

}  // namespace kerf
