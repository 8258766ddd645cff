#include "ui/editor/changes/long_work.h"

#include <chrono>

namespace kerf {

LongWork::~LongWork() {
  if (job_) stop();
}

void LongWork::start(Document& document, LongChange change) {
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

bool LongWork::is_over(double seconds) const {
  return job_->result.wait_for(std::chrono::duration<double>(seconds)) == std::future_status::ready;
}

void LongWork::finish() {
  const std::unique_ptr<Job> job = std::move(job_);
  const Result<Delta> result = job->result.get();
  job->change.then(result);
}

}  // namespace kerf
