#include "ui/editor/file_choice.h"

#include "ui/editor/work/export_pieces.h"
#include "ui/editor/work/save_work.h"

namespace kerf {

namespace {

using Purpose = FileBrowser::Purpose;

std::string name_for(const EditorState& state, Purpose purpose) {
  if (purpose == Purpose::kExport) return "piece.obj";
  return purpose == Purpose::kSave ? suggested_name(state.work) : "";
}

std::string export_to(EditorState& state, const std::filesystem::path& file) {
  const Result<size_t> written = export_chosen(state.work.document.world(), state.view.look.pieces, file);
  if (!written) return written.error().message;
  state.message.say(*written == 1 ? "Written: " + file.string()
                                  : std::to_string(*written) +
                                        " files written, the first: " + numbered(file, 1).string());
  return "";
}

}  // namespace

void choose_file_for(EditorState& state, Purpose purpose) {
  state.browser.take = [&state](Purpose chosen_for, const std::filesystem::path& file) {
    return take_chosen_file(state, chosen_for, file);
  };
  browse(state.browser, purpose, state.settings.folder, name_for(state, purpose));
}

std::string take_chosen_file(EditorState& state, Purpose purpose, const std::filesystem::path& file) {
  if (purpose == Purpose::kExport) return export_to(state, file);
  if (purpose == Purpose::kOpen) {
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
