#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>

#include "core/document/files/scene.h"
#include "core/world/world.h"
#include "ui/render/bodies/prepared_body.h"

namespace kerf {

// A world of which not everything is cut again yet, with the data for drawing it.
struct CutSoFar {
  SceneDescription scene;
  World world;  // a copy
  PreparedBodies prepared;
};

// What a thread that reads files says on the way to the thread that waits for it.
class LoadNews {
 public:
  // By the reader: what is being done, in a word or two.
  void say(const char* what) { doing_ = what; }
  // By the reader, after every step that cuts: shows a copy of the world, unless nobody watches, it is too
  // large for one (see Document::kMostFacesToCopy), the last copy was not taken yet, or copying would take
  // more than a small part of the time. `shadings` has the bodies as loaded. O(faces) for a copy.
  void show(const SceneDescription& scene, const World& world, const LoadedShadings& shadings);

  // By whoever waits: he wants to be shown copies. Before the reader begins.
  void watch() { watched_ = true; }
  const char* doing() const { return doing_; }
  // The last copy that was shown, once.
  std::optional<CutSoFar> take();

 private:
  using Clock = std::chrono::steady_clock;

  std::atomic<const char*> doing_ = "reading";
  bool watched_ = false;
  Clock::time_point next_ = Clock::now();  // the reader copies no earlier; known to it alone
  std::mutex mutex_;
  std::optional<CutSoFar> so_far_;  // guarded by the mutex
};

}  // namespace kerf
