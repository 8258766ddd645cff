#pragma once

#include <cstddef>
#include <ctime>
#include <deque>
#include <string>
#include <utility>

namespace kerf {

// Returns the text of an error as the window shows it: with a full stop, and files before a colon by their
// names without the folder: "/home/a/part.stl: cannot be read" becomes "part.stl: cannot be read."
std::string error_sentence(std::string text);

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
  // Shows why an action is disabled or a number is refused. drop_objection() clears it, which the next
  // action, press or accepted number calls.
  void object(std::string reason) {
    error(std::move(reason));
    is_objection_ = true;
  }
  void drop_objection() {
    if (is_objection_) clear();
  }
  void show(std::string sentence, bool failed);

  // Shows a message about an entry that the change which results from the entry does not clear.
  void info_before_change(std::string sentence) {
    info(std::move(sentence));
    outlives_next_ = true;
  }

  // Adds a sentence to the log without showing it.
  void note(std::string sentence, bool failed);

 private:
  bool outlives_next_ = false, is_objection_ = false;
};

}  // namespace kerf
