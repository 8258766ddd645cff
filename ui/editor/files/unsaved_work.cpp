#include "ui/editor/files/unsaved_work.h"

#include <chrono>
#include <ctime>

#include "core/base/assert.h"
#include "ui/editor/files/save_work.h"
#include "ui/editor/shared/files/file_frames.h"

namespace kerf {

namespace {

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
  if (!journal.opened.empty()) return journal.opened.front().filename().string();
  return journal.scene.bodies.front().mesh.filename().string();
}

void ask_what_becomes(Decisions& decisions, const OpenWork& work) {
  decisions.about = Decisions::About::kUnsaved;
  Question& q = decisions.question = Question();
  q.title = "Not saved";
  q.text = name_of_work(work) + " has changes that are not saved.";
  q.choices = {{"Save", "Saves them first (Enter, S).", 'S'},
               {"Discard", "They are gone then (D).", 'D'},
               {"Cancel", "Goes back to the work (Esc, C).", 'C'}};
}

Decision decide_on_unsaved(Decisions& decisions, size_t answer) {
  if (answer == 0) return Decision::kSaveFirst;
  if (answer == 1) return Decision::kLeave;
  decisions.leaving = nullptr;
  return Decision::kNone;
}

Decision decide_on_left(Decisions& decisions, std::vector<LeftWork>& left_work, size_t answer) {
  KERF_ASSERT(!left_work.empty());
  if (answer == 0) return Decision::kGoOn;
  if (answer == 2) {
    left_work.clear();
    return Decision::kNone;
  }
  left_work.front().file.remove();
  left_work.erase(left_work.begin());
  ask_about_left_work(decisions, left_work);
  return Decision::kNone;
}

}  // namespace

bool may_leave(Decisions& decisions, const OpenWork& work, const std::vector<Light>& lights,
               const std::function<void()>& then) {
  if (!is_unsaved(work, lights)) return true;
  KERF_ASSERT(!decisions.question.open());
  decisions.leaving = then;
  ask_what_becomes(decisions, work);
  return false;
}

void ask_about_left_work(Decisions& decisions, const std::vector<LeftWork>& left_work) {
  if (left_work.empty()) return;
  const LeftWork& left = left_work.front();
  decisions.about = Decisions::About::kLeftWork;
  Question& q = decisions.question = Question();
  q.title = "Unsaved work was left";
  q.text = "The editor ended without saving " + name_of(left) + ", with " +
           count_text(left.strokes, "stroke") + ", last changed on " + time_text(left.last_change) + ".";
  if (left_work.size() > 1)
    q.text += " " + count_text(left_work.size() - 1, "more piece") + " of work was left besides.";
  q.choices = {{"Recover", "Opens it as it was left (Enter, R).", 'R'},
               {"Discard", "It is gone then."},
               {"Later", "Asks again at the next start (Esc, L).", 'L'}};
}

Decision take_decision(Decisions& decisions, std::vector<LeftWork>& left_work) {
  if (!decisions.question.answer) return Decision::kNone;
  KERF_ASSERT(*decisions.question.answer < decisions.question.choices.size());
  const size_t answer = *std::exchange(decisions.question, {}).answer;
  return decisions.about == Decisions::About::kUnsaved ? decide_on_unsaved(decisions, answer)
                                                       : decide_on_left(decisions, left_work, answer);
}

}  // namespace kerf
