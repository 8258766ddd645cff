#pragma once

#include <optional>

namespace kerf {

// The pace at which the emitter fires in shots: shots are due at equal times on one clock, and those that
// nobody took in time are left out, so that slow frames make gaps and no bursts.
class FirePace {
 public:
  static constexpr double kSlowest = 0.1, kFastest = 60;  // shots a second

  double per_second() const { return per_second_; }
  // Limited to the slowest and the fastest pace.
  void set(double per_second);

  // The next shot is due at once.
  void begin() { last_.reset(); }
  // `now` (s) is of a clock that never goes back.
  bool is_due(double now) const;
  // A shot was fired. Precondition: it was due.
  void take(double now);

 private:
  double per_second_ = 4;
  std::optional<double> last_;  // when the last shot was due, s
};

}  // namespace kerf
