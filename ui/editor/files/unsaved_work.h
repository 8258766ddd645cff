#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/platform.h"
#include "core/document/autosave.h"
#include "ui/editor/shared/document_session.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/viewport.h"
#include "ui/window/status_message.h"
#include "ui/window/widgets.h"

namespace kerf {

// Whether there is anything that the file of the open work does not hold: commands, lights other than these,
// or what features keep in its head.
bool is_unsaved(const OpenWork& work, const std::vector<Light>& lights);
// Whether anything but cooling happened since: what was undone is not unsaved, but can be redone after a
// crash.
bool is_to_be_kept(const OpenWork& work, const std::vector<Light>& lights);

// The name of the open work for the user: that of its file, or of the file that it was opened from.
std::string name_of_work(const OpenWork& work);

// The title of the window: "car.kerf* - Kerf", with the star where something is not saved.
std::string window_title(const OpenWork& work, const std::vector<Light>& lights);

// A suggested name for a new file of the open work: "car.kerf".
std::string suggested_name(const OpenWork& work);

// The scene of the open work as it is looked at and lit at the moment.
SceneDescription scene_now(const OpenWork& work, const ViewState& view);

// Saves the open work: all of it as a journal, which Save writes to from then on, or where the name ends in
// .json its scene without what was cut. A name with neither ending gets .kerf. The version before is kept
// beside it with a ~ added to its name. The file becomes the first of the recent ones. Says in the status bar
// what became of it. Returns whether all of the work is saved.
bool save_work(OpenWork& work, const ViewState& view, std::filesystem::path file, Settings& settings,
               Message& message);

// Keeps what is not saved of the open work on the disk while the editor runs, so that the next editor can go
// on with it; see Autosave.
class Recovery {
 public:
  Recovery() : autosave_(state_folder()) {}

  // The open work is another one, or lies in another file: it is kept anew once there is something to keep.
  void begin(const OpenWork& work, const ViewState& view);
  // To be called once a frame: what is not saved is on its way to the disk when this returns, and what is
  // saved is kept no longer. What is being moved by the mouse is kept when it has arrived. Says in the status
  // bar when it fails, once, and tries again every second. Returns whether the last try went well.
  bool follow(OpenWork& work, const ViewState& view, bool mouse_moves, Message& message);
  // Writes what is on its way to the disk; to be called while the editor waits.
  void flush() { autosave_.flush(); }
  // Discards what is kept.
  void drop() { autosave_.drop(); }

 private:
  using Clock = std::chrono::steady_clock;

  Autosave autosave_;
  std::vector<Light> lights_;  // that are kept
  std::string head_;           // SceneDescription::others that is kept
  bool well_ = true;           // the last try
  Clock::time_point failed_at_;
};

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
