#include "core/face/call.h"

#include <xmmintrin.h>

#include <algorithm>
#include <cfenv>
#include <new>
#include <utility>

#include "core/base/parallel.h"

namespace kerf {

namespace {

constexpr unsigned kMostThreads = 1024;

constexpr const char* kNoMemory = "there is not enough memory";

// The message of this thread; where memory was lacking to keep one, kNoMemory takes its place.
struct Kept {
  std::string text;
  bool lacks_memory = false;
};
Kept& kept() {
  static thread_local Kept message;
  return message;
}

// Rounding to nearest, without flushing of small numbers to zero, while it exists. Programs that were
// compiled with -ffast-math run with the latter.
class DefaultArithmetic {
 public:
  DefaultArithmetic() : control_(_mm_getcsr()) {
    std::fegetenv(&environment_);
    std::fesetenv(FE_DFL_ENV);
    _mm_setcsr(kDefault);
  }
  ~DefaultArithmetic() {
    std::fesetenv(&environment_);
    _mm_setcsr(control_);
  }
  DefaultArithmetic(const DefaultArithmetic&) = delete;
  DefaultArithmetic& operator=(const DefaultArithmetic&) = delete;

 private:
  static constexpr unsigned kDefault = 0x1f80;

  std::fenv_t environment_{};
  unsigned control_;
};

}  // namespace

kerf_result told(kerf_result result, const char* message) noexcept {
  try {
    kept() = {message, false};
    // A name in it, such as that of a file, may have several lines.
    std::ranges::replace_if(
        kept().text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  } catch (const std::bad_alloc&) {
    kept().lacks_memory = true;
  }
  return result;
}

const char* last_message() { return kept().lacks_memory ? kNoMemory : kept().text.c_str(); }

Call::Call(const kerf_control* control) {
  if (control != nullptr) control_ = *control;
}

kerf_result Call::run(const std::function<Status(const Progress&)>& work) {
  if (control_.threads > kMostThreads) return told(KERF_BAD_INPUT, "threads: must be from 0 to 1024");
  const DefaultArithmetic arithmetic;
  const Progress progress{[&](double share) {
    stopped_ = stopped_ || (control_.progress != nullptr && control_.progress(share, control_.user) != 0);
    return !stopped_;
  }};
  try {
    Status status = Done{};
    with_threads(control_.threads, [&] { status = work(progress); });
    if (status) return KERF_OK;
    if (stopped_) return told(KERF_CANCELLED, "cancelled");
    const bool bad = status.error().code == ErrorCode::kBadInput;
    return told(bad ? KERF_BAD_INPUT : KERF_FAILED, status.error().message.c_str());
  } catch (const std::bad_alloc&) {
    return told(KERF_FAILED, kNoMemory);
  } catch (const std::exception& fault) {
    return told(KERF_FAILED, fault.what());
  } catch (...) {
    return told(KERF_FAILED, "stopped by an unknown fault");
  }
}

}  // namespace kerf
