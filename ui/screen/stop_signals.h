#pragma once

namespace kerf {

// While this object exists, SIGINT and SIGTERM set a flag instead of ending the program. Precondition: there
// is only one such object at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  // Whether one of the signals came.
  bool came() const;
  // The one that came while the last such object existed; 0 if none did.
  static int last();

 private:
  using Handler = void (*)(int);
  Handler old_interrupt_, old_terminate_;
};

}  // namespace kerf
