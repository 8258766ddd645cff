#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/editor/prepare/preview.h"

namespace kerf {

// Keeps a preview true to what is wanted. It works on a thread of its own and on a copy of the world, so that
// the document can change meanwhile.
class LivePreview {
 public:
  LivePreview() = default;
  LivePreview(const LivePreview&) = delete;
  LivePreview& operator=(const LivePreview&) = delete;
  ~LivePreview();

  // To be called once a frame: begins a preview if another one is wanted than that which is shown or under
  // way, and takes one that is ready. What is shown stays until then where only a number of the preparation
  // differs. Precondition: why_no_preview() gives no reason.
  void follow(const World& world, const std::vector<PieceRow>& pieces, const Preparation& wanted);
  // The world is another one, or nothing is wanted: shows nothing and stops the work.
  void drop();
  // Waits for the work, at most for the time (s), and takes what is ready.
  void wait(double seconds);

  bool busy() const { return job_ != nullptr || waits_; }
  double fraction() const { return job_ ? job_->fraction.load() : 1; }  // of the work that is done
  const Preview* shown() const { return shown_ ? &*shown_ : nullptr; }
  // Why there is no preview, where that was only found at work; empty otherwise.
  const std::string& fault() const { return fault_; }

 private:
  struct Wanted {
    std::vector<PieceId> pieces;
    Preparation preparation;
    friend bool operator==(const Wanted&, const Wanted&) = default;
  };
  struct Job {
    std::shared_ptr<const World> world;
    std::vector<PieceRow> pieces;
    Preparation preparation;
    std::atomic<double> fraction = 0;
    std::atomic<bool> stopped = false;
    std::future<Result<Preview>> result;
  };
  void begin(const std::vector<PieceRow>& pieces, const Preparation& preparation);

  std::optional<Wanted> wanted_;       // of what is shown or under way
  std::shared_ptr<const World> copy_;  // of the world as it is; null: not copied yet
  std::unique_ptr<Job> job_;
  bool waits_ = false;  // for the end of a job that was stopped
  std::optional<Preview> shown_;
  std::string fault_;
};

}  // namespace kerf
