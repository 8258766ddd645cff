#pragma once

#include <optional>
#include <string>
#include <vector>

namespace kerf {

struct EditorState;

// Something that the user has to decide before anything else goes on: a window in the middle with a button
// for each choice. Enter takes the first choice, Esc the last, and a choice may have a letter.
struct Question {
  enum class About { kNone, kUnsaved, kLeftWork };
  struct Choice {
    std::string label;
    std::string tip;
    char letter = 0;  // a capital, or 0: a key that is pressed by chance must not take it
  };

  About about = About::kNone;  // kNone: nothing is asked
  std::string title, text;
  std::vector<Choice> choices;
  std::optional<size_t> answer;  // that was given

  bool open() const { return about != About::kNone; }
};

// A key (GLFW_KEY_*) while the question is open.
void question_key(Question& question, int key);

void draw_question(EditorState& state);

}  // namespace kerf
