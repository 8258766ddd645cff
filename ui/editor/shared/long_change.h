#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <string>

#include "core/base/progress.h"
#include "core/document/history/document.h"

namespace kerf {

// A change of the document that takes too long for a frame.
struct LongChange {
  std::string title;  // what happens, for the user
  std::function<Outcome(Document&, const Progress&)> run;
  std::function<void(const Outcome&)> then;  // on the thread that finishes it
};

// Runs a long change on a background thread. Until it is finished, only that thread may access the document.
class ChangeThread {
 public:
  ChangeThread() = default;
  ChangeThread(ChangeThread&&) = default;
  ChangeThread& operator=(ChangeThread&&) = default;
  ~ChangeThread();

  // Starts a change. Preconditions: none is running, the document outlives it, and both of its functions are
  // set.
  void start(Document& document, LongChange change);
  bool busy() const { return job_ != nullptr; }

  // The title of the running change. Precondition of this and of what follows: busy().
  const std::string& title() const { return job_->change.title; }
  // Whether the change has reported progress, so that it can be stopped.
  bool can_stop() const { return job_->told && !job_->stopped; }
  double fraction() const { return job_->fraction; }  // 0 to 1

  // Asks the change to stop; it ends at its next report of progress.
  void stop() { job_->stopped = true; }
  // Waits for the end for at most the given time (s). Returns whether it has ended.
  bool is_over(double seconds) const;
  // Waits for the end and calls the continuation of the change.
  void finish();

 private:
  struct Job {
    LongChange change;
    std::atomic<double> fraction = 0;
    std::atomic<bool> told = false, stopped = false;
    std::future<Outcome> result;
  };
  std::unique_ptr<Job> job_;
};

// Whether the world is so small that changes of its bodies take no longer than a part of a frame.
bool is_small(const Document& document);

// Whether a command takes no longer than that.
bool is_quick(const Document& document, const Command& command);

// What the next step of the document does, in a few words, if it takes so long that it has to run beside the
// frames because it makes bodies or colliders of many faces. Null for any other step. O(pieces).
const char* why_beside(const Document& document);

}  // namespace kerf
