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

// The files of one exported piece.
struct PieceFile {
  PieceId piece;
  std::filesystem::path mesh;
  std::filesystem::path mtl;  // with paints, for an OBJ file whose materials no file describes; else empty
  std::string name;           // of the node or object
};

// Turns the name of a piece into a file name without extension: blanks and characters not allowed in file
// names become "-". Never empty.
std::string file_name_of(const std::string& piece);

// Returns the files for the selected pieces, in the order of list_pieces. "*" in the name of `file` is
// replaced by the name of the piece; without it several pieces are numbered: "part-1.obj" etc. All names
// differ. The extension sets the format. With `single_file` all pieces have the same file if the format holds
// several meshes; "*" then becomes "pieces".
std::vector<PieceFile> files_to_export(const World& world, const PieceMap& looks,
                                       const std::filesystem::path& file, bool single_file = false);

// Returns `name`, or with "-2", "-3" etc. added if its files_to_export() in the folder exist.
std::string unused_name(const World& world, const PieceMap& looks, const std::filesystem::path& folder,
                        const std::string& name, bool single_file = false);

// The files of an export, and what their format lost.
struct ExportedPieces {
  std::vector<PieceFile> files;
  std::optional<std::string> note;  // for the user; see LostLooks and precision_note
};

// Writes the selected pieces, in world space and with their looks, to the files of files_to_export. Materials
// that a mesh file describes are written with their images in the folder of OBJ files (see SurfaceFiles).
// Returns bad input if no piece is selected or the extension is not that of a mesh. Files written before a
// failure remain.
Result<ExportedPieces> export_selected(const World& world, const PieceMap& looks,
                                       const std::map<std::string, Paint>& paints,
                                       const std::filesystem::path& file, bool single_file = false);

// Opens a file dialog and exports the selected pieces (see export_selected).
class PieceExport {
 public:
  // The workspace must outlive it.
  explicit PieceExport(Workspace& workspace) : workspace_(workspace) {}

  // Precondition: a piece is selected.
  void select_file();

 private:
  std::string suggested_name() const;
  std::string export_to(const std::filesystem::path& file);

  Workspace& workspace_;
};

}  // namespace kerf
