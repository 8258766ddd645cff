#pragma once

#include <optional>
#include <string>
#include <vector>

namespace kerf {

// Something that the user has to decide before anything else goes on: a window in the middle with one button
// for each choice. Enter takes the first choice, Esc the last, and a choice may have a letter.
struct Question {
  struct Choice {
    std::string label;
    std::string tip;
    char letter = 0;  // a capital, or 0: a key that is pressed by chance must not take this choice
  };

  std::string title, text;
  std::vector<Choice> choices;   // empty: nothing is asked
  std::optional<size_t> answer;  // the index of the choice that was taken

  bool open() const { return !choices.empty(); }
};

// Takes a key (GLFW_KEY_*) that was pressed while the question is open.
void question_key(Question& question, int key);

// Draws the question as a modal window where it is open.
void draw_question(Question& question);

}  // namespace kerf
