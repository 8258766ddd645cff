#include "ui/editor/shared/panels/shortcut_text.h"

namespace kerf {

std::string shortcut_of(const ViewState& view, const std::string& action) {
  const auto found = view.shortcuts.find(action);
  return found != view.shortcuts.end() ? found->second : "";
}

std::string with_shortcut(const ViewState& view, std::string sentence, const std::string& action) {
  const std::string key = shortcut_of(view, action);
  if (key.empty()) return sentence;
  const bool stop = sentence.ends_with('.');
  if (stop) sentence.pop_back();
  return sentence + " (" + key + ")" + (stop ? "." : "");
}

}  // namespace kerf
