#pragma once

#include <string>

#include "core/document/files/cut_report.h"

namespace kerf {

// The outcome of a job, in one line: "1 stroke removed 5 210 faces (12.3 cm²); 3 pieces and report.json are
// in out".
std::string cut_summary(const CutJob& job, size_t strokes, size_t pieces, const std::string& folder);

// Which strokes of a file met nothing: "path.json: /strokes/1 and /strokes/4 met nothing". Precondition:
// there are some.
std::string missed_text(const CutJob& job, const std::string& file);

}  // namespace kerf
