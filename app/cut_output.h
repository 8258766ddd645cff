#pragma once

#include <string>

#include "core/document/cut_report.h"
#include "core/document/input_files.h"

namespace kerf {

// The outcome of a job, in one line: "1 stroke removed 5 210 faces (12.3 cm²); 3 pieces and report.json are
// in out".
std::string cut_summary(const CutJob& job, size_t strokes, size_t pieces, const std::string& folder);

// Which strokes of a file met nothing: "path.json: /strokes/1 and /strokes/4 met nothing". Precondition:
// there are some.
std::string missed_text(const CutJob& job, const std::string& file);

// The folder that receives the pieces of a job, and the format of their files.
struct PiecesFolder {
  std::string path;
  std::string format = "obj";
  bool split_all = false;  // every connected component is a piece
  bool solid = false;      // all bodies were made solid, which the report's settings say

  // Bad input if a file that write() may replace or remove is an input. `option` names the folder in errors.
  Status check(const std::string& option, const InputFiles& inputs) const;
  // Whether write() may write a file of this path.
  bool may_write(const std::filesystem::path& file) const;
  // Creates the folder. Fails if it cannot be created or used.
  Status make() const;
  // Writes the pieces as piece-0000 and so on, largest area first, about the origin of the job, then
  // report.json with the statistics of the job. Adds a note to the job if the format loses too much. Returns
  // the pieces. Shows a ProgressLine. Every file is written whole or not at all.
  //
  // The folder tells of one run. The report of an earlier run becomes report.json~ before the first piece is
  // written, so that after a failure or Ctrl-C there is no report. Once the new files are whole, pieces of
  // earlier runs are removed, i.e. files named piece-NNNN.* that report.json~ lists and the new report does
  // not, and then report.json~ itself.
  Result<std::vector<WrittenPiece>> write(CutJob& job, const World& world, const CutSettings& settings) const;
};

}  // namespace kerf
