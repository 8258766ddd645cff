#include "ui/editor/file_choice.h"

#include "ui/editor/laser_desk.h"
#include "ui/editor/work/export_pieces.h"
#include "ui/editor/work/save_work.h"

namespace kerf {

namespace {

using Purpose = FileBrowser::Purpose;

// The chosen piece, or a "*" for the names of several.
std::string name_to_export(const EditorState& state) {
  const PieceMap& looks = state.view.look.pieces;
  const std::string ending = "." + std::string(format_name(state.browser.format));
  if (chosen_pieces(looks) != 1) return "*" + ending;
  for (const PieceRow& row : list_pieces(state.work.document.world(), looks)) {
    if (row.id == first_chosen(looks)) return file_name_of(row.name) + ending;
  }
  return "piece" + ending;
}

std::string name_for(const EditorState& state, Purpose purpose) {
  if (purpose == Purpose::kExport) return name_to_export(state);
  if (purpose == Purpose::kSavePath) {
    const std::string name = state.lasers.path.file().filename().string();
    return name.empty() ? "path.json" : name;
  }
  return purpose == Purpose::kSave ? suggested_name(state.work) : "";
}

std::string export_to(EditorState& state, const std::filesystem::path& file) {
  const auto written =
      export_chosen(state.work.document.world(), state.view.look.pieces, state.work.paints, file);
  if (!written) return written.error().message;
  const std::string first = written->front().mesh.string();
  state.message.say(written->size() == 1
                        ? "Written: " + first
                        : std::to_string(written->size()) + " pieces written, the first: " + first);
  return "";
}

}  // namespace

void choose_file_for(EditorState& state, Purpose purpose) {
  state.browser.take = [&state](Purpose chosen_for, const std::filesystem::path& file) {
    return take_chosen_file(state, chosen_for, file);
  };
  state.browser.writes = [&state](const std::filesystem::path& file) {
    std::vector<std::filesystem::path> files;
    for (const PieceFile& f : files_to_export(state.work.document.world(), state.view.look.pieces, file)) {
      files.push_back(f.mesh);
      if (!f.library.empty()) files.push_back(f.library);
    }
    return files;
  };
  browse(state.browser, purpose, state.settings.folder, name_for(state, purpose));
}

std::string take_chosen_file(EditorState& state, Purpose purpose, const std::filesystem::path& file) {
  if (purpose == Purpose::kExport) return export_to(state, file);
  if (purpose == Purpose::kOpenPath) return load_path(state, file);
  if (purpose == Purpose::kSavePath) {
    state.requests.save_path_to = file;
  } else if (purpose == Purpose::kOpen) {
    state.requests.open = {file};
  } else {
    state.requests.save_to = file;
  }
  return "";
}

void draw_file_choice(EditorState& state) {
  const bool was_open = state.browser.open;
  draw_file_browser(state.browser);
  if (was_open && !state.browser.open) state.settings.folder = state.browser.folder;
}

}  // namespace kerf
