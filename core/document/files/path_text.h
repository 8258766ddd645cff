#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/document/files/path_file.h"

namespace kerf {

class Fields;

// The fields of a stroke in path files and scenes. A stroke that is written is read back to the bit.
void describe(Fields& f, StrokePath& stroke);

// The text of a path file, with one line for each key.
std::string path_file_text(std::span<const StrokePath> strokes);
// The strokes of such a text. Fails as read_path_file() does; `where` is the name of the text in errors.
Result<std::vector<StrokePath>> read_path_text(std::string_view text, const std::string& where);

}  // namespace kerf
