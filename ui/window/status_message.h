#pragma once

#include <cstddef>
#include <ctime>
#include <deque>
#include <string>
#include <utility>

namespace kerf {

// The sentence in the status bar: the latest event, until the next action replaces it. A log keeps all
// sentences.
struct Message {
  struct Said {
    std::time_t when = 0;
    std::string text;
    bool is_error = false;
  };

  std::string text;       // empty: no message
  bool is_error = false;  // a request of the user failed
  std::deque<Said> log;   // the last sentences, oldest first

  static constexpr size_t kMaxLogged = 200;

  void say(std::string sentence, bool error = false) {
    if (sentence.empty() && std::exchange(outlives_next_, false)) return;
    text = std::move(sentence);
    is_error = error;
    if (!text.empty()) note(text, error);
  }

  // Shows a sentence about an entry; the change that results from the entry does not clear it.
  void say_before_change(std::string sentence) {
    say(std::move(sentence));
    outlives_next_ = true;
  }

  // Adds a sentence to the log without showing it.
  void note(std::string sentence, bool error) {
    log.push_back({std::time(nullptr), std::move(sentence), error});
    if (log.size() > kMaxLogged) log.pop_front();
  }

 private:
  bool outlives_next_ = false;
};

}  // namespace kerf
