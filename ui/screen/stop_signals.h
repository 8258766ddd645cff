#pragma once

namespace kerf {

// While this object exists, SIGINT and SIGTERM set a flag instead of ending the program. Precondition: only
// one such object exists at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  bool received() const;
  // The signal that arrived during the lifetime of the last such object; 0: none.
  static int last();

 private:
  using Handler = void (*)(int);
  Handler old_interrupt_, old_terminate_;
};

}  // namespace kerf
