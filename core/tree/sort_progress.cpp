#include "core/tree/sort_progress.h"

#include <algorithm>
#include <cmath>

namespace kerf {

namespace {

double need(size_t faces) {
  return faces < 2 ? 0 : static_cast<double>(faces) * std::log2(static_cast<double>(faces));
}

}  // namespace

SortProgress::SortProgress(const Progress* progress, size_t faces)
    : progress_(progress), owner_(std::this_thread::get_id()), all_(need(faces)) {}

void SortProgress::note_split(size_t whole, size_t left, size_t right) {
  note(need(whole) - need(left) - need(right));
}
void SortProgress::note_done(size_t faces) { note(need(faces)); }

void SortProgress::note(double done) {
  constexpr double kReports = 100;  // at most
  const double sum = done_.fetch_add(done) + done;
  if (!progress_ || stopped_ || std::this_thread::get_id() != owner_ || sum < next_) return;
  if (!progress_->report(std::min(1.0, sum / all_))) stopped_ = true;
  next_ = sum + all_ / kReports;
}

}  // namespace kerf
