#pragma once

#include <string>

namespace kerf {

// The sentence that the status bar shows: what happened last, until the next action replaces it.
struct Message {
  std::string text;       // empty: nothing to say
  bool is_error = false;  // the user asked for something that could not be done

  void say(std::string sentence, bool error = false) {
    text = std::move(sentence);
    is_error = error;
  }
};

}  // namespace kerf
