#pragma once

#include <cstddef>
#include <ctime>
#include <deque>
#include <string>

namespace kerf {

// The sentence that the status bar shows: what happened last, until the next action replaces it. All that was
// said is kept in a log.
struct Message {
  struct Said {
    std::time_t when = 0;
    std::string text;
    bool is_error = false;
  };

  std::string text;       // empty: nothing to say
  bool is_error = false;  // the user asked for something that could not be done
  std::deque<Said> log;   // the last sentences, oldest first

  static constexpr size_t kMostLogged = 200;

  void say(std::string sentence, bool error = false) {
    text = std::move(sentence);
    is_error = error;
    if (!text.empty()) note(text, error);
  }

  // Writes a sentence to the log without showing it.
  void note(std::string sentence, bool error) {
    log.push_back({std::time(nullptr), std::move(sentence), error});
    if (log.size() > kMostLogged) log.pop_front();
  }
};

}  // namespace kerf
