#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/document/history/document.h"

namespace kerf {

// The document of any file that Kerf opens, at its end: the strokes of a scene are cut, the commands of a
// journal replayed. Shows a ProgressLine, and warns of a damaged journal. Fails with an error that names the
// file, or with stopped() after Ctrl-C.
Result<Document> load_document(const std::filesystem::path& file);

}  // namespace kerf
