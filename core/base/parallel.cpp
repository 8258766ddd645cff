#include "core/base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace kerf {

namespace {

// Synchronises a thread with the threads that work for it. oneTBB already orders them; this reports the order
// to the thread sanitizer, which does not see into that library.
class Handover {
 public:
  Handover() { release(); }
  ~Handover() { acquire(); }
  Handover(const Handover&) = delete;
  Handover& operator=(const Handover&) = delete;
  // Runs the work of one of these threads.
  template <typename Work>
  void receive(const Work& work) {
    acquire();
    work();
    release();
  }

 private:
#ifdef __SANITIZE_THREAD__
  void acquire() { __tsan_acquire(this); }
  void release() { __tsan_release(this); }
#else
  void acquire() {}
  void release() {}
#endif
};

// Runs ranges `first` to `last` (exclusive) of for_each_range().
void work_on(size_t first, size_t last, size_t items, size_t grain, const RangeWork& work) {
  Handover handover;
  const auto work_on_part = [&](const tbb::blocked_range<size_t>& part) {
    handover.receive([&] {
      for (size_t r = part.begin(); r < part.end(); ++r) work(r * grain, std::min(items, (r + 1) * grain));
    });
  };
  tbb::parallel_for(tbb::blocked_range<size_t>(first, last, 1), work_on_part, tbb::simple_partitioner());
}

}  // namespace

void for_each_range(size_t items, size_t grain, const RangeWork& work) {
  KERF_ASSERT(grain > 0);
  const size_t ranges = range_count(items, grain);
  if (ranges == 1) return work(0, items);
  work_on(0, ranges, items, grain, work);
}

bool for_each_range(size_t items, size_t grain, const Progress* progress, const RangeWork& work) {
  KERF_ASSERT(grain > 0);
  constexpr size_t kReports = 16;  // at most
  const size_t ranges = range_count(items, grain);
  const size_t group = std::max(range_count(ranges, kReports), 2 * thread_count());
  for (size_t first = 0; first < ranges; first += group) {
    const size_t last = std::min(ranges, first + group);
    work_on(first, last, items, grain, work);
    if (progress && !progress->report(static_cast<double>(last) / static_cast<double>(ranges))) return false;
  }
  return true;
}

void do_both(const std::function<void()>& first, const std::function<void()>& second) {
  Handover handover;
  tbb::parallel_invoke([&] { handover.receive(first); }, [&] { handover.receive(second); });
}

void with_threads(size_t threads, const std::function<void()>& work) {
  const size_t most = std::min(threads, thread_count());  // more would make TBB warn
  tbb::task_arena arena(most == 0 ? tbb::task_arena::automatic : static_cast<int>(most));
  Handover handover;
  arena.execute([&] { handover.receive(work); });
}

size_t thread_count() {
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

struct ThreadLimit::Control {
  tbb::global_control limit;
};

ThreadLimit::ThreadLimit(size_t threads)
    : control_(new Control{{tbb::global_control::max_allowed_parallelism, threads}}) {
  KERF_ASSERT(threads > 0);
}
ThreadLimit::~ThreadLimit() = default;
ThreadLimit::ThreadLimit(ThreadLimit&&) noexcept = default;
ThreadLimit& ThreadLimit::operator=(ThreadLimit&&) noexcept = default;

}  // namespace kerf
