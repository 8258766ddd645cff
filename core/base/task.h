#pragma once

#include <coroutine>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/assert.h"

namespace kerf {

// `co_await worked(units)` in a computation that can be resumed says how much it has done since the last time
// it said so. One unit is the work that a face costs in a step of a cut, about a third of a microsecond. The
// computation pauses there if it has done a part, kPartOfWork units, since the last pause.
struct Worked {
  size_t units;
};
inline Worked worked(size_t units) { return {units}; }
inline constexpr size_t kPartOfWork = 1500;

// The computations that wait for each other, the innermost last, and what they have done since the last
// pause.
struct WaitingComputations {
  std::vector<std::coroutine_handle<>> waiting;
  size_t units = 0;
  bool is_paused = false;

  bool is_part_done(Worked more) {
    units += more.units;
    if (units < kPartOfWork) return false;
    units = 0;
    return is_paused = true;
  }
};

// A computation that is done in parts and yields a T: a coroutine that says what it has worked, waits for
// others of its kind by `co_await other(...)`, and ends by `co_return value`. It begins with the first call
// of go_on(); what its arguments refer to must live until it is over. Its result does not depend on when it
// is resumed. An exception leaves go_on(), which must not be called again then.
template <typename T>
class [[nodiscard]] Resumable {
 public:
  struct promise_type;

  Resumable(Resumable&& other) noexcept
      : coroutine_(std::exchange(other.coroutine_, {})), all_(std::move(other.all_)) {}
  Resumable& operator=(Resumable&& other) noexcept {
    std::swap(coroutine_, other.coroutine_);
    std::swap(all_, other.all_);
    return *this;
  }
  ~Resumable() {
    if (coroutine_) coroutine_.destroy();
  }

  // Does the next part. Returns whether the computation is over. Precondition: it was not.
  bool go_on() {
    if (!all_) {
      all_ = std::make_unique<WaitingComputations>();
      begin(*all_);
    }
    KERF_ASSERT(!all_->waiting.empty());
    all_->is_paused = false;
    while (!all_->waiting.empty() && !all_->is_paused) all_->waiting.back().resume();
    return all_->waiting.empty();
  }

  // Moves the result out. Precondition: the computation is over.
  T take() {
    KERF_ASSERT(coroutine_.promise().result);
    return std::move(*coroutine_.promise().result);
  }

 private:
  template <typename Other>
  friend class Resumable;

  explicit Resumable(std::coroutine_handle<promise_type> coroutine) : coroutine_(coroutine) {}

  void begin(WaitingComputations& all) {
    coroutine_.promise().all = &all;
    all.waiting.push_back(coroutine_);
  }

  std::coroutine_handle<promise_type> coroutine_;
  std::unique_ptr<WaitingComputations> all_;  // of the outermost computation
};

template <typename T>
struct Resumable<T>::promise_type {
  WaitingComputations* all = nullptr;
  std::optional<T> result;

  // Goes back to go_on(), which resumes what waits for this computation.
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
  struct WaitFor {
    Resumable<Other>& other;
    bool await_ready() const noexcept { return false; }
    void await_suspend(std::coroutine_handle<promise_type> own) const { other.begin(*own.promise().all); }
    Other await_resume() const { return other.take(); }
  };

  Resumable get_return_object() {
    return Resumable(std::coroutine_handle<promise_type>::from_promise(*this));
  }
  std::suspend_always initial_suspend() const noexcept { return {}; }
  End final_suspend() const noexcept { return {}; }
  void return_value(T value) { result.emplace(std::move(value)); }
  void unhandled_exception() const { throw; }

  PauseIf await_transform(Worked work) { return {all->is_part_done(work)}; }
  template <typename Other>
  WaitFor<Other> await_transform(Resumable<Other>&& other) const {
    return {other};
  }
};

// Does all parts of a computation.
template <typename T>
T at_once(Resumable<T> computation) {
  while (!computation.go_on()) {
  }
  return computation.take();
}

}  // namespace kerf
