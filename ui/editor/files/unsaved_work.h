#pragma once

#include <functional>
#include <vector>

#include "core/document/journal/autosave.h"
#include "ui/editor/shared/files/open_work.h"
#include "ui/window/question.h"

namespace kerf {

// What becomes of unsaved work when the user asks for something that would close it, and of the work that
// editors that died have left. The frame loop does what is asked for; here is what has to be decided first.

struct Decisions {
  Question question;
  enum class About { kUnsaved, kLeftWork };
  About about = About::kUnsaved;  // meaningful while the question is open
  std::function<void()> leaving;  // waits until it is known what becomes of the unsaved work
};

// Whether what closes the open work can be done at once; where that is unsaved, it waits in `leaving` and the
// user is asked. Precondition: no other question is open.
bool may_leave(Decisions& decisions, const OpenWork& work, const std::vector<Light>& lights,
               const std::function<void()>& then);

// Asks what to do with the first of the work that editors that died have left, if there is any.
void ask_about_left_work(Decisions& decisions, const std::vector<LeftWork>& left_work);

// What follows from the answer to a question.
enum class Decision {
  kNone,
  kLeave,      // do what is in `leaving`
  kSaveFirst,  // save the work, then do it
  kGoOn,       // open the first of the left work
};

// Takes the answer to the question, once, and does all that needs no frame loop: discards what was left,
// closes the question, asks the next one.
Decision take_decision(Decisions& decisions, std::vector<LeftWork>& left_work);

}  // namespace kerf
