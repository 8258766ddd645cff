#include "ui/editor/prepare/live_preview.h"

#include <chrono>

#include "core/base/assert.h"

namespace kerf {

LivePreview::~LivePreview() {
  if (job_) job_->stopped = true;
}

void LivePreview::follow(const World& world, const std::vector<PieceRow>& pieces, const Preparation& wanted) {
  KERF_ASSERT(why_no_preview(world, pieces, wanted) == nullptr);
  wait(0);
  Wanted now{{}, wanted};
  for (const PieceRow& row : pieces) now.pieces.push_back(row.id);
  if (wanted_ == now && !waits_) return;
  if (wanted_ && wanted_->pieces != now.pieces) shown_.reset();
  wanted_ = std::move(now);
  waits_ = job_ != nullptr;
  if (job_) job_->stopped = true;
  if (waits_) return;
  if (!copy_) copy_ = std::make_shared<const World>(world);
  begin(pieces, wanted);
}

void LivePreview::begin(const std::vector<PieceRow>& pieces, const Preparation& preparation) {
  fault_.clear();
  job_ = std::make_unique<Job>();
  job_->world = copy_;
  job_->pieces = pieces;
  job_->preparation = preparation;
  job_->result = std::async(std::launch::async, [job = job_.get()] {
    const Progress progress{[job](double fraction) {
      job->fraction = fraction;
      return !job->stopped;
    }};
    return make_preview(*job->world, job->pieces, job->preparation, progress);
  });
}

void LivePreview::drop() {
  if (job_) job_->stopped = true;
  wait(0);
  waits_ = false;
  wanted_.reset();
  copy_.reset();
  shown_.reset();
  fault_.clear();
}

void LivePreview::wait(double seconds) {
  if (!job_) return;
  const auto limit = std::chrono::duration<double>(seconds);
  if (job_->result.wait_for(limit) != std::future_status::ready) return;
  const std::unique_ptr<Job> job = std::move(job_);
  Result<Preview> made = job->result.get();
  if (job->stopped) return;
  shown_.reset();
  if (made) {
    shown_ = std::move(*made);
  } else {
    fault_ = made.error().message;
  }
}

}  // namespace kerf
