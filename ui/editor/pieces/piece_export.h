#pragma once

#include "ui/editor/shared/workspace.h"

namespace kerf {

// Asks for a file and writes the chosen pieces to it (see export_chosen).
class PieceExport {
 public:
  // The workspace must outlive it.
  explicit PieceExport(Workspace& on) : on_(on) {}

  // Precondition: a piece is chosen.
  void choose_file();

 private:
  std::string suggested_name() const;
  std::string export_to(const std::filesystem::path& file);

  Workspace& on_;
};

}  // namespace kerf
