#pragma once

#include <atomic>
#include <cstddef>
#include <future>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/mesh/remesh/openmesh_tools.h"
#include "core/world/world.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// What the Prepare panel does to the chosen pieces, or to all if none is chosen.
struct Preparation {
  enum class Tool { kSimplifyToFaces, kSimplifyToError, kSubdivide, kSmooth, kTurnShells };
  Tool tool = Tool::kSimplifyToFaces;
  size_t faces = 0;  // that are left of all of them; 0: half of what there is
  double error = 0;  // m; 0: a thousandth of the size of the world
  Subdivision scheme = Subdivision::kLoop;
  size_t times = 1;  // that faces are subdivided, or vertices move
  friend bool operator==(const Preparation&, const Preparation&) = default;
};

// The chosen pieces, or all pieces if none is chosen.
std::vector<PieceRow> pieces_to_prepare(const World& world, const PieceMap& looks);

// The number of faces that these pieces have, and that they will have as far as it is known: a simplification
// to an error says only afterwards.
struct FaceForecast {
  size_t before = 0;
  std::optional<size_t> after;
};
FaceForecast forecast(std::span<const PieceRow> pieces, const Preparation& preparation);

// From more faces on a preparation takes longer than a part of a frame.
inline constexpr size_t kQuickToPrepare = 2000;

// What happens, for the user: "Simplifying".
const char* preparation_title(Preparation::Tool tool);

// Why these pieces cannot be prepared so, in one sentence, or null if they can.
const char* why_no_preparation(std::span<const PieceRow> pieces, const Preparation& preparation);

// Applies the commands of a preparation to the pieces, one after the other; of a number of faces each gets
// its share. Where one fails or is stopped, those before it are undone. `progress` may be null. Precondition:
// why_no_preparation() gives no reason.
Outcome prepare_pieces(Document& document, std::span<const PieceRow> pieces, const Preparation& preparation,
                       const Progress* progress);

// What a preparation would make of pieces, beside what they are.
struct Preview {
  struct Statistics {
    size_t faces = 0;
    double least_angle = 0;  // of a face, degrees
  };
  Statistics before, after;
  double distance = 0;  // m, of the two surfaces at most, both ways (see surface_distance())
  std::shared_ptr<const DrawnWire> wire;  // of what they would be; not null
};

// More faces than these are not previewed: of a world that is to be copied, and of what is made.
inline constexpr size_t kMaxFacesToPreview = 400'000, kMaxFacesPreviewed = 1'600'000;

// Why there is no preview of it, in one sentence, or null if there is one.
const char* why_no_preview(const World& world, std::span<const PieceRow> pieces,
                           const Preparation& preparation);

// Applies the commands of the preparation to a copy of the world and measures it. Fails like
// prepare_pieces(), also where it is stopped. Precondition: why_no_preview() gives no reason.
Result<Preview> make_preview(const World& world, std::span<const PieceRow> pieces,
                             const Preparation& preparation, const Progress& progress);

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
