#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <string>

#include "core/base/progress.h"
#include "core/document/document.h"

namespace kerf {

// A change of the document that takes longer than a frame may wait.
struct LongChange {
  std::string title;  // what happens, for people
  std::function<Result<Delta>(Document&, const Progress&)> run;
  std::function<void(const Result<Delta>&)> then;  // on the thread that finishes it
};

// Lets a long change happen on a thread of its own. Until it is finished the document belongs to that thread
// alone.
class ChangeThread {
 public:
  ChangeThread() = default;
  ChangeThread(ChangeThread&&) = default;
  ChangeThread& operator=(ChangeThread&&) = default;
  ~ChangeThread();

  // Nothing may be under way. The document must outlive the work.
  void start(Document& document, LongChange change);
  bool busy() const { return job_ != nullptr; }

  // Of what is under way.
  const std::string& title() const { return job_->change.title; }
  // Whether it has told how far it is, and so can be stopped.
  bool can_stop() const { return job_->told && !job_->stopped; }
  double fraction() const { return job_->fraction; }  // 0 to 1

  // Asks it to stop. Its thread ends when it next tells how far it is.
  void stop() { job_->stopped = true; }
  // Waits so long for its end (s); whether that came.
  bool is_over(double seconds) const;
  // Waits for its end and has what follows it done.
  void finish();

 private:
  struct Job {
    LongChange change;
    std::atomic<double> fraction = 0;
    std::atomic<bool> told = false, stopped = false;
    std::future<Result<Delta>> result;
  };
  std::unique_ptr<Job> job_;
};

}  // namespace kerf
