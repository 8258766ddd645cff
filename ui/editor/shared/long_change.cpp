#include "ui/editor/shared/long_change.h"

#include <chrono>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr size_t kManyFaces = 40'000;  // from here on changes of bodies take longer than a part of a frame
constexpr size_t kManyMoves = 20;      // of the queue, that take longer than a part of a frame

}  // namespace

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

bool is_small(const Document& document) { return document.world().live_faces() <= kManyFaces; }

bool is_quick(const Document& document, const Command& command) {
  const bool small = is_small(document);
  const size_t now = document.history().position();
  return std::visit(
      Overloaded{
          [](const BeginStroke&) { return true; },
          [](const MoveBeam&) { return true; },
          [](const EndStroke&) { return true; },
          [&](const StopStroke&) { return document.execution().stop_here().has_value(); },
          [](const Recut&) { return true; },
          [](const HappensInTime auto&) { return true; },
          [](const Play&) { return true; },
          [&](const Undo&) { return small && (now == 0 || document.remembers_way_to(now - 1)); },
          [&](const Redo&) { return small; },
          [](const AddMesh&) { return false; },
          [&](const HappensAtOnce auto&) { return small && document.waiting() <= kManyMoves; },
      },
      command);
}

const char* why_beside(const Document& document) {
  return document.execution().next_makes_ready() > kManyFaces ? "Making bodies of the pieces" : nullptr;
}

}  // namespace kerf
