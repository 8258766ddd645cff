#pragma once

#include <string>
#include <utility>
#include <variant>

#include "core/base/assert.h"

namespace kerf {

// The kind of a failure; determines the exit status of the command line.
enum class ErrorCode {
  kBadInput,  // invalid file, setting or command line (exit 2)
  kFailed,    // the operation failed: disk full, no OpenGL, cancelled (exit 1)
};

// An expected failure. The message is one sentence for the user: what failed, where, and what to do.
struct Error {
  ErrorCode code = ErrorCode::kFailed;
  std::string message;
};

inline Error bad_input(std::string message) { return {ErrorCode::kBadInput, std::move(message)}; }
inline Error failed(std::string message) { return {ErrorCode::kFailed, std::move(message)}; }

// A value or an error. Precondition of value(), * and ->: ok(); of error(): !ok().
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}      // NOLINT: a value converts into its success
  Result(Error error) : state_(std::move(error)) {}  // NOLINT: an error converts into its failure

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }
  T& value() {
    KERF_ASSERT(ok());
    return *std::get_if<0>(&state_);
  }
  const T& value() const {
    KERF_ASSERT(ok());
    return *std::get_if<0>(&state_);
  }
  T& operator*() { return value(); }
  const T& operator*() const { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Error& error() const {
    KERF_ASSERT(!ok());
    return *std::get_if<1>(&state_);
  }

 private:
  std::variant<T, Error> state_;
};

// The value of an operation without a result.
struct Done {};
using Status = Result<Done>;

// Moves the value of a result into `to`, or returns its error and leaves `to` unchanged.
template <typename T, typename U>
Status unpack(Result<T> result, U& to) {
  if (!result) return result.error();
  to = std::move(*result);
  return Done{};
}

}  // namespace kerf
