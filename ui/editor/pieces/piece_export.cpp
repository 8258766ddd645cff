#include "ui/editor/pieces/piece_export.h"

#include "ui/editor/pieces/export_pieces.h"
#include "ui/editor/shared/pieces/piece_set.h"

namespace kerf {

// The chosen piece, or a "*" for the names of several.
std::string PieceExport::suggested_name() const {
  const PieceMap& looks = on_.view.look.pieces;
  const std::string ending = "." + std::string(format_row(on_.browser.format).ending);
  if (chosen_pieces(looks) != 1) return "*" + ending;
  for (const PieceRow& row : list_pieces(on_.world(), looks)) {
    if (row.id == first_chosen(looks)) return file_name_of(row.name) + ending;
  }
  return "piece" + ending;
}

void PieceExport::choose_file() {
  browse(on_.browser,
         {.title = "Export the chosen pieces",
          .verb = "Export",
          .hint = "Name; a * stands for the name of each piece",
          .take = [this](const std::filesystem::path& file) { return export_to(file); },
          .writes =
              [this](const std::filesystem::path& file) {
                std::vector<std::filesystem::path> files;
                for (const PieceFile& f : files_to_export(on_.world(), on_.view.look.pieces, file)) {
                  files.push_back(f.mesh);
                  if (!f.mtl.empty()) files.push_back(f.mtl);
                }
                return files;
              },
          .inputs = [this] { return inputs_of(on_.work); }},
         on_.settings.folder, suggested_name());
}

std::string PieceExport::export_to(const std::filesystem::path& file) {
  const auto written = export_chosen(on_.world(), on_.view.look.pieces, on_.work.paints, file);
  if (!written) return written.error().message;
  const std::string first = written->files.front().mesh.string();
  const std::string done = written->files.size() == 1 ? "Written: " + first
                                                      : std::to_string(written->files.size()) +
                                                            " pieces written, the first: " + first;
  on_.message.say(written->note ? done + ". " + *written->note + "." : done, written->note.has_value());
  return "";
}

}  // namespace kerf
