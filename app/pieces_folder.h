#pragma once

#include <string>

#include "core/document/files/cut_report.h"

namespace kerf {

// The folder that receives the pieces of a job, and the format of their files.
struct PiecesFolder {
  std::string path;
  std::string format = "obj";
  bool split_all = false;  // every connected component is a piece
  bool solid = false;      // all bodies were made solid, which the report's settings say

  // Creates the folder. Fails if it cannot be created or used.
  Status make() const;
  // Writes the pieces as piece-0000 and so on, largest area first, then report.json with the statistics of
  // the job. Returns the pieces. Shows a ProgressLine. Every file is written whole or not at all; after a
  // failure or Ctrl-C there is no report.
  Result<std::vector<WrittenPiece>> write(CutJob& job, const World& world, const CutSettings& settings) const;
};

}  // namespace kerf
