#pragma once

#include <cstddef>
#include <ctime>
#include <deque>
#include <string>
#include <utility>

namespace kerf {

// The message in the status bar, until the next one replaces it, and the log of all messages.
struct Message {
  struct Entry {
    std::time_t when = 0;
    std::string text;
    bool is_error = false;
  };

  std::string text;       // empty: no message
  bool is_error = false;  // a request of the user failed
  std::deque<Entry> log;  // the last kMaxLogged messages, oldest first

  static constexpr size_t kMaxLogged = 200;

  void info(std::string sentence) { show(std::move(sentence), false); }
  void error(std::string sentence) { show(std::move(sentence), true); }
  void clear() { show({}, false); }
  void show(std::string sentence, bool failed) {
    if (sentence.empty() && std::exchange(outlives_next_, false)) return;
    text = std::move(sentence);
    is_error = failed;
    if (!text.empty()) note(text, failed);
  }

  // Shows a message about an entry that the change which results from the entry does not clear.
  void info_before_change(std::string sentence) {
    info(std::move(sentence));
    outlives_next_ = true;
  }

  // Adds a sentence to the log without showing it.
  void note(std::string sentence, bool failed) {
    log.push_back({std::time(nullptr), std::move(sentence), failed});
    if (log.size() > kMaxLogged) log.pop_front();
  }

 private:
  bool outlives_next_ = false;
};

}  // namespace kerf
