#include "ui/editor/shared/long_change.h"

#include <chrono>

#include "core/base/assert.h"

namespace kerf {

ChangeThread::~ChangeThread() {
  if (job_) stop();
}

void ChangeThread::start(Document& document, LongChange change) {
  KERF_ASSERT(!busy() && change.run && change.then);
  job_ = std::make_unique<Job>();
  job_->change = std::move(change);
  job_->result = std::async(std::launch::async, [job = job_.get(), &document] {
    const Progress progress{[job](double fraction) {
      job->fraction = fraction;
      job->told = true;
      return !job->stopped;
    }};
    return job->change.run(document, progress);
  });
}

bool ChangeThread::is_over(double seconds) const {
  KERF_ASSERT(busy());
  return job_->result.wait_for(std::chrono::duration<double>(seconds)) == std::future_status::ready;
}

void ChangeThread::finish() {
  KERF_ASSERT(busy());
  const std::unique_ptr<Job> job = std::move(job_);
  const Outcome result = job->result.get();
  job->change.then(result);
}

}  // namespace kerf
