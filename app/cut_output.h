#pragma once

#include <string>

#include "core/document/cut_report.h"
#include "core/document/save.h"

namespace kerf {

// Returns the outcome of a job in one line: "1 stroke removed 5 210 faces (12.3 cm²); 3 pieces and
// report.json are in out".
std::string cut_summary(const CutJob& job, size_t strokes, size_t planes, size_t pieces,
                        const std::string& folder);

// Returns a message on the strokes that missed: "path.json: /strokes/1 and /strokes/4 met nothing".
// Precondition: job.missed is not empty.
std::string missed_text(const CutJob& job, const std::string& file);

// The output folder of a job and the format of its pieces.
struct PiecesFolder {
  std::string path;
  std::string format = "obj";
  bool split_all = false;    // every connected component is a piece (see faces_by_piece)
  bool solid = false;        // all bodies were made solid; listed in the settings of the report
  std::string provenance{};  // file for the origins of the faces; empty: none
  // The engine whose names the colliders have: "unreal" or "godot"; empty: no colliders. Only for glTF.
  std::string colliders{};
  // All pieces are in one file, such as pieces.glb, if holds_several_meshes(format).
  bool single_file = false;
  std::string outlines{};  // "svg" or "dxf": format of the outlines of flat pieces; empty: none

  // Fails with bad input if a file that write() may replace or remove is an input. Errors name `option`.
  Status check(const std::string& option, const InputFiles& inputs) const;
  // Returns true if the file lies in the folder, which need not exist.
  bool holds(const std::filesystem::path& file) const;
  // Returns true if write() may write this file.
  bool may_write(const std::filesystem::path& file) const;
  // Creates the folder. Fails if it cannot be created or used.
  Status make() const;
  // Writes the pieces as piece-0000 and so on, or as one file, largest area first, relative to the origin of
  // the job, then report.json with its statistics. Adds notes to the job on losses of precision and of looks
  // by the format. Returns the pieces. Shows a ProgressLine. Every file is written completely or not at all.
  // With `outlines`, each flat piece also has a file piece-0000.svg or .dxf (see flat_outline), relative to
  // the same origin; a note counts the others. OBJ pieces share a material library, with its images in the
  // same folder (see SurfaceFiles).
  //
  // The folder holds one run. The earlier report becomes report.json~ before the first piece is written, so a
  // failure or Ctrl-C leaves no report. Once the new files are complete, removes files of pieces
  // that only report.json~ lists, and then report.json~.
  Result<std::vector<WrittenPiece>> write(CutJob& job, const World& world, const CutSettings& settings) const;
};

}  // namespace kerf
