#pragma once

#include <string>

#include "app/cut_report.h"

namespace kerf {

// Where the pieces of a job go, and how.
struct PiecesFolder {
  std::string path;
  std::string format = "obj";
  bool split_all = false;  // every connected component is a piece

  Status make() const;
  // Writes piece-0000 and so on, largest area first, then report.json with what the job noted. Shows a
  // ProgressLine; a failure or Ctrl-C leaves whole pieces and no report. Each file is whole or not there.
  Status write(CutJob& job, const World& world, const CutSettings& settings) const;
};

}  // namespace kerf
