#include "ui/window/status_message.h"

#include <string_view>

namespace kerf {

std::string error_sentence(std::string text) {
  constexpr std::string_view kEnd = ": ";
  for (size_t at = text.find('/'); at != std::string::npos; at = text.find('/', at + 1)) {
    const bool begins = at == 0 || text[at - 1] == ' ';
    const size_t end = text.find(kEnd, at);
    if (!begins || end == std::string::npos || end == at + 1 || text[at + 1] == ' ') continue;
    const size_t name = text.rfind('/', end) + 1;
    text.erase(at, name - at);
  }
  constexpr std::string_view kStops = ".!?";
  if (!text.empty() && kStops.find(text.back()) == std::string_view::npos) text += '.';
  return text;
}

void Message::show(std::string sentence, bool failed) {
  if (sentence.empty() && std::exchange(outlives_next_, false)) return;
  text = failed ? error_sentence(std::move(sentence)) : std::move(sentence);
  is_error = failed;
  is_objection_ = false;
  if (!text.empty()) note(text, failed);
}

void Message::note(std::string sentence, bool failed) {
  log.push_back(
      {std::time(nullptr), failed ? error_sentence(std::move(sentence)) : std::move(sentence), failed});
  if (log.size() > kMaxLogged) log.pop_front();
}

}  // namespace kerf
