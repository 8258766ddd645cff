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
#include "core/mesh/files/mesh_format.h"
#include "core/mesh/remesh/openmesh_tools.h"
#include "core/world/world.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/viewport.h"
#include "ui/render/view/view_options.h"
#include "ui/window/number_text.h"

namespace kerf {

// An operation of the Prepare panel on the selected pieces, or on all if none is selected.
struct Preparation {
  enum class Tool { kSimplifyToFaces, kSimplifyToError, kSubdivide, kSmooth, kTurnShells };
  Tool tool = Tool::kSimplifyToFaces;
  size_t faces = 0;  // target for all pieces together; 0: half of the current ones
  double error = 0;  // [m]; 0: a thousandth of the world size
  Subdivision scheme = Subdivision::kLoop;
  size_t times = 1;  // of subdivision or smoothing
  friend bool operator==(const Preparation&, const Preparation&) = default;
};

std::vector<PieceRow> pieces_to_prepare(const World& world, const PieceMap& looks);

// Number of faces of pieces before and after a preparation. `after` is nullopt for simplification to an
// error, which is known only afterwards.
struct FaceForecast {
  size_t before = 0;
  std::optional<size_t> after;
};
FaceForecast forecast(std::span<const PieceRow> pieces, const Preparation& preparation);

// Above this number of faces, a preparation takes longer than a part of a frame.
inline constexpr size_t kQuickToPrepare = 2000;

// Returns the operation as progress text: "Simplifying".
const char* preparation_title(Preparation::Tool tool);

// Returns why these pieces cannot be prepared, as a sentence, or null.
const char* prepare_disabled_reason(std::span<const PieceRow> pieces, const Preparation& preparation);

// Applies the commands of a preparation to the pieces in turn; a target number of faces is shared among
// them. If one fails or is stopped, all previous ones are undone and leave no entry in the history.
// `progress` may be null; it does not stop the queue, which is executed first. Precondition:
// prepare_disabled_reason() returns null.
Outcome prepare_pieces(Document& document, std::span<const PieceRow> pieces, const Preparation& preparation,
                       const Progress* progress);

// Predicted result of a preparation, and the current state of its pieces.
struct Preview {
  struct Statistics {
    size_t faces = 0;
    double min_angle = 0;  // [degrees]
  };
  Statistics before, after;
  double distance = 0;                    // max. of both directions [m], see surface_distance()
  std::shared_ptr<const DrawnWire> wire;  // of the result; not null
};

// Limits of a preview: faces of the world, which is copied, and of the result.
inline constexpr size_t kMaxFacesToPreview = 400'000, kMaxFacesPreviewed = 1'600'000;

// Returns why there is no preview, as a sentence, or null.
const char* preview_disabled_reason(const World& world, std::span<const PieceRow> pieces,
                                    const Preparation& preparation);

// Applies the commands of the preparation to a copy of the world and measures the result. Fails like
// prepare_pieces(), also if it is stopped. Precondition: preview_disabled_reason() returns null.
Result<Preview> make_preview(const World& world, std::span<const PieceRow> pieces,
                             const Preparation& preparation, const Progress& progress);

// Keeps a preview up to date. Works on a copy of the world on another thread, so that the document can
// change meanwhile.
class LivePreview {
 public:
  LivePreview() = default;
  LivePreview(const LivePreview&) = delete;
  LivePreview& operator=(const LivePreview&) = delete;
  ~LivePreview();

  // Call once per frame: begins a preview if another one is requested than the one shown or in progress, and
  // takes a finished one. The old preview stays visible meanwhile if only a number of the preparation
  // differs. Precondition: preview_disabled_reason() returns null.
  void follow(const World& world, const std::vector<PieceRow>& pieces, const Preparation& wanted);
  // Hides the preview and cancels the work, because the world was replaced or no preview is requested.
  void drop();
  // Waits for the work, at most `seconds`, and takes a finished preview.
  void wait(double seconds);

  bool busy() const { return job_ != nullptr || waits_; }
  double fraction() const { return job_ ? job_->fraction.load() : 1; }  // progress, 0 to 1
  const Preview* shown() const { return shown_ ? &*shown_ : nullptr; }
  // Error found while computing the preview; empty if there is none.
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

  std::optional<Wanted> wanted_;       // preview shown or in progress
  std::shared_ptr<const World> copy_;  // of the current world; null: not copied yet
  std::unique_ptr<Job> job_;
  bool waits_ = false;  // for the end of a cancelled job
  std::optional<Preview> shown_;
  std::string fault_;
};

// Draws the switch of the preview and, while it is on, the numbers before and after: faces, smallest angle
// and distance of the surfaces. `disabled_reason`: why there is no preview, or null.
void draw_preview(const LivePreview& preview, const char* disabled_reason, FileUnit unit, bool& previewed);

// Names the affected pieces: "All pieces", "3 selected pieces", or the name of one.
std::string prepared_text(std::span<const PieceRow> pieces, const PieceMap& looks);

// Forecasts the result: "69 666 faces become about 7 000.", or for simplification to an error, "69 666 faces
// are simplified to a tolerance of 0.2 mm."
std::string forecast_text(std::span<const PieceRow> pieces, const Preparation& preparation, FileUnit unit);

// Fills numbers that are not set with defaults: half of the faces, a thousandth of the world size.
Preparation with_numbers(const Preparation& preparation, std::span<const PieceRow> pieces,
                         const World& world);

// Edits a preparation and forecasts its result.
class PreparePanel {
 public:
  // Returns true if the preparation is to be applied now. `previewed`: switch of the preview.
  bool draw(const World& world, const ViewState& view, Preparation& preparation, const LivePreview& preview,
            bool& previewed);

 private:
  void draw_numbers(Preparation& preparation, const Preparation& shown, const World& world, FileUnit unit);
  void draw_times(Preparation& preparation, const char* meaning, size_t most);

  NumberFields fields_;
};

}  // namespace kerf
