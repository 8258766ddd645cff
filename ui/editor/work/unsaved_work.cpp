#include "ui/editor/work/unsaved_work.h"

#include <chrono>
#include <ctime>

#include "ui/editor/work/save_work.h"

namespace kerf {

namespace {

std::string count_text(size_t count, const char* what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

std::string time_text(std::filesystem::file_time_type time) {
  const auto system = std::chrono::file_clock::to_sys(time);
  const std::time_t seconds = std::chrono::system_clock::to_time_t(
      std::chrono::time_point_cast<std::chrono::system_clock::duration>(system));
  std::tm parts{};
  localtime_r(&seconds, &parts);
  std::array<char, 64> text{};
  std::strftime(text.data(), text.size(), "%e %B %Y, %H:%M", &parts);
  return text.data();
}

std::string name_of(const LeftWork& left) {
  const Journal& journal = left.journal;
  if (!journal.work_of.empty()) return journal.work_of.filename().string();
  return journal.scene.bodies.front().mesh.filename().string();
}

void ask_what_becomes(EditorState& state) {
  Question& q = state.question;
  q = Question();
  q.about = Question::About::kUnsaved;
  q.title = "Not saved";
  q.text = name_of_work(state) + " has changes that are not saved.";
  q.choices = {{"Save", "Saves them first (Enter, S).", 'S'},
               {"Discard", "They are gone then (D).", 'D'},
               {"Cancel", "Goes back to the work (Esc, C).", 'C'}};
}

Decision decide_on_unsaved(EditorState& state, size_t answer) {
  if (answer == 0) return Decision::kSaveFirst;
  if (answer == 1) return Decision::kLeave;
  state.leaving.reset();
  return Decision::kNone;
}

Decision decide_on_left(EditorState& state, size_t answer) {
  if (answer == 0) return Decision::kGoOn;
  if (answer == 2) {
    state.left_work.clear();
    return Decision::kNone;
  }
  state.left_work.front().file.remove();
  state.left_work.erase(state.left_work.begin());
  ask_about_left_work(state);
  return Decision::kNone;
}

}  // namespace

bool may_leave(EditorState& state, const Requests& wanted) {
  if (!is_unsaved(state)) return true;
  state.leaving = wanted;
  ask_what_becomes(state);
  return false;
}

void ask_about_left_work(EditorState& state) {
  if (state.left_work.empty()) return;
  const LeftWork& left = state.left_work.front();
  Question& q = state.question;
  q = Question();
  q.about = Question::About::kLeftWork;
  q.title = "Unsaved work was left";
  q.text = "The editor ended without saving " + name_of(left) + ", with " +
           count_text(left.strokes, "stroke") + ", last changed on " + time_text(left.last_change) + ".";
  if (state.left_work.size() > 1)
    q.text += " " + count_text(state.left_work.size() - 1, "more piece") + " of work was left besides.";
  q.choices = {{"Go on", "Opens it as it was left (Enter, G).", 'G'},
               {"Discard", "It is gone then."},
               {"Later", "Asks again at the next start (Esc, L).", 'L'}};
}

Decision take_decision(EditorState& state) {
  if (!state.question.answer) return Decision::kNone;
  const Question answered = std::exchange(state.question, {});
  const bool unsaved = answered.about == Question::About::kUnsaved;
  return unsaved ? decide_on_unsaved(state, *answered.answer) : decide_on_left(state, *answered.answer);
}

}  // namespace kerf
