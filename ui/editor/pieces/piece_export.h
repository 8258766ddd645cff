#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/document/scene.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/workspace.h"

namespace kerf {

// What an export of the chosen pieces writes.
struct PieceFile {
  PieceId piece;
  std::filesystem::path mesh;
  std::filesystem::path mtl;  // the MTL file beside an OBJ file whose faces have materials; else empty
};

// The name of a piece as the name of a file without its ending: characters that file systems do not take, and
// blanks, become "-". Never empty.
std::string file_name_of(const std::string& piece);

// The files for the chosen pieces of a world, in the order of list_pieces. In the name of `file` each "*"
// stands for the name of the piece; without it several pieces get numbers, "part-1.obj" and so on. No two
// files have the same name. The ending says the format.
std::vector<PieceFile> files_to_export(const World& world, const PieceMap& looks,
                                       const std::filesystem::path& file);

// The files of an export, and what their format lost.
struct ExportedPieces {
  std::vector<PieceFile> files;
  std::optional<std::string> note;  // for the user; see precision_note
};

// Writes the chosen pieces where they stand to the files of files_to_export; MTL files hold the paints.
// Bad input if no piece is chosen or the ending is not that of a mesh; what was written
// before a failure stays.
Result<ExportedPieces> export_chosen(const World& world, const PieceMap& looks,
                                     const std::map<std::string, Paint>& paints,
                                     const std::filesystem::path& file);

// Asks for a file and writes the chosen pieces to it (see export_chosen).
class PieceExport {
 public:
  // The workspace must outlive it.
  explicit PieceExport(Workspace& workspace) : workspace_(workspace) {}

  // Precondition: a piece is chosen.
  void choose_file();

 private:
  std::string suggested_name() const;
  std::string export_to(const std::filesystem::path& file);

  Workspace& workspace_;
};

}  // namespace kerf
