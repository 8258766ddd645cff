#pragma once

#include <cstddef>
#include <ctime>
#include <deque>
#include <string>
#include <utility>

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

  static constexpr size_t kMaxLogged = 200;

  void say(std::string sentence, bool error = false) {
    if (sentence.empty() && std::exchange(outlives_next_, false)) return;
    text = std::move(sentence);
    is_error = error;
    if (!text.empty()) note(text, error);
  }

  // Shows a sentence about what was entered, which the change that follows from it does not clear.
  void say_before_change(std::string sentence) {
    say(std::move(sentence));
    outlives_next_ = true;
  }

  // Writes a sentence to the log without showing it.
  void note(std::string sentence, bool error) {
    log.push_back({std::time(nullptr), std::move(sentence), error});
    if (log.size() > kMaxLogged) log.pop_front();
  }

 private:
  bool outlives_next_ = false;
};

}  // namespace kerf
