#pragma once

#include <coroutine>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/assert.h"

namespace kerf {

// `co_await yield_after(units)` in a resumable computation reports the work done since the last report. One
// unit is the work of one face in a slice of a cut, about a third of a microsecond. The computation pauses
// there once it has done kPartOfWork units since the last pause.
struct YieldAfter {
  size_t units;
};
inline YieldAfter yield_after(size_t units) { return {units}; }
inline constexpr size_t kPartOfWork = 1500;

// The stack of waiting computations, the innermost last, and their work since the last pause.
struct TaskStack {
  std::vector<std::coroutine_handle<>> waiting;
  size_t units = 0;
  bool is_paused = false;

  bool is_part_done(YieldAfter more) {
    units += more.units;
    if (units < kPartOfWork) return false;
    units = 0;
    return is_paused = true;
  }
};

// A computation in parts that yields a T: a coroutine that reports its work, awaits others of its kind by
// `co_await other(...)`, and ends by `co_return value`. It starts with the first call of resume(); objects
// that its arguments refer to must outlive it. Its result does not depend on when it is resumed. An exception
// leaves resume(), which must not be called again then.
template <typename T>
class [[nodiscard]] Task {
 public:
  struct promise_type;

  Task(Task&& other) noexcept
      : coroutine_(std::exchange(other.coroutine_, {})), all_(std::move(other.all_)) {}
  Task& operator=(Task&& other) noexcept {
    std::swap(coroutine_, other.coroutine_);
    std::swap(all_, other.all_);
    return *this;
  }
  ~Task() {
    if (coroutine_) coroutine_.destroy();
  }

  // Runs the next part. Returns true if the computation is complete. Precondition: it was not.
  bool resume() {
    if (!all_) {
      all_ = std::make_unique<TaskStack>();
      begin(*all_);
    }
    KERF_ASSERT(!all_->waiting.empty());
    all_->is_paused = false;
    while (!all_->waiting.empty() && !all_->is_paused) all_->waiting.back().resume();
    return all_->waiting.empty();
  }

  // Moves the result out. Precondition: the computation is complete.
  T take() {
    KERF_ASSERT(coroutine_.promise().result);
    return std::move(*coroutine_.promise().result);
  }

 private:
  template <typename Other>
  friend class Task;

  explicit Task(std::coroutine_handle<promise_type> coroutine) : coroutine_(coroutine) {}

  void begin(TaskStack& all) {
    coroutine_.promise().all = &all;
    all.waiting.push_back(coroutine_);
  }

  std::coroutine_handle<promise_type> coroutine_;
  std::unique_ptr<TaskStack> all_;  // of the outermost computation
};

template <typename T>
struct Task<T>::promise_type {
  TaskStack* all = nullptr;
  std::optional<T> result;

  // Returns to resume(), which resumes the computation that awaits this one.
  struct End {
    bool await_ready() const noexcept { return false; }
    void await_suspend(std::coroutine_handle<promise_type> own) const noexcept {
      own.promise().all->waiting.pop_back();
    }
    void await_resume() const noexcept {}
  };
  struct PauseIf {
    bool pauses;
    bool await_ready() const noexcept { return !pauses; }
    void await_suspend(std::coroutine_handle<>) const noexcept {}
    void await_resume() const noexcept {}
  };
  template <typename Other>
  struct Await {
    Task<Other>& other;
    bool await_ready() const noexcept { return false; }
    void await_suspend(std::coroutine_handle<promise_type> own) const { other.begin(*own.promise().all); }
    Other await_resume() const { return other.take(); }
  };

  Task get_return_object() { return Task(std::coroutine_handle<promise_type>::from_promise(*this)); }
  std::suspend_always initial_suspend() const noexcept { return {}; }
  End final_suspend() const noexcept { return {}; }
  void return_value(T value) { result.emplace(std::move(value)); }
  void unhandled_exception() const { throw; }

  PauseIf await_transform(YieldAfter work) { return {all->is_part_done(work)}; }
  template <typename Other>
  Await<Other> await_transform(Task<Other>&& other) const {
    return {other};
  }
};

// Runs a computation to completion.
template <typename T>
T run_to_completion(Task<T> computation) {
  while (!computation.resume()) {
  }
  return computation.take();
}

}  // namespace kerf
