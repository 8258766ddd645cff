#include "ui/editor/prepare/prepare_feature.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "ui/editor/prepare/live_preview.h"
#include "ui/editor/prepare/prepare_panel.h"
#include "ui/editor/prepare/prepare_pieces.h"

namespace kerf {

namespace {

constexpr const char* kPreparePanel = "Prepare";

class PrepareFeature : public Feature {
 public:
  explicit PrepareFeature(Workspace& on) : on_(on) {}

  std::vector<Panel> panels() override {
    return {{kPreparePanel, Tab::kPrepare, 300, true, [this] {
               if (panel_.draw(on_.world(), on_.view, preparation_, preview_, on_.settings.prepare_preview))
                 ask();
             }}};
  }
  std::vector<ActionGroup> actions() override {
    using Kind = Preparation::Tool;
    return {{540,
             "Prepare",
             {tool_action("Simplify to faces", "Fewer faces: the panel Prepare says how many.",
                          Kind::kSimplifyToFaces),
              tool_action("Simplify to an error", "As few faces as an error in the unit of the file allows.",
                          Kind::kSimplifyToError),
              tool_action("Subdivide", "Three or four faces of each, rounder or where they are.",
                          Kind::kSubdivide),
              tool_action("Smooth", "Vertices move to the middle of their neighbours.", Kind::kSmooth),
              tool_action("Turn inner shells",
                          "Closed parts that lie in others and face the same way become cavities.",
                          Kind::kTurnShells),
              UserAction{.name = "Prepare the mesh",
                         .tip = "Does what the panel Prepare says, to the chosen pieces, or to all.",
                         .run = [this] { ask(); },
                         .why_not = [this] { return why_no_preparation(pieces(), wanted()); }},
              UserAction{.name = "Preview of the preparation",
                         .tip = "The edges that the new mesh would have, over the surface as it is.",
                         .run = [this] { on_.settings.prepare_preview = !on_.settings.prepare_preview; },
                         .checked = [this] { return on_.settings.prepare_preview; }}}}};
  }

  void follow_queue(double) override;
  bool moving() const override { return preview_.busy(); }
  void follow(const Delta& delta) override {
    if (!delta.empty()) preview_.drop();
  }
  void forget() override { preview_.drop(); }
  void report(nlohmann::ordered_json& report) const override;

 private:
  // Unfolds the panel with this tool.
  UserAction tool_action(const char* name, const char* tip, Preparation::Tool tool) {
    return {.name = name,
            .tip = tip,
            .run =
                [this, tool] {
                  on_.panels.show(kPreparePanel);
                  preparation_.tool = tool;
                  preparation_.times = 1;
                },
            .checked = [this, tool] { return on_.panels.shows(kPreparePanel) && preparation_.tool == tool; },
            .ends_group = tool == Preparation::Tool::kTurnShells};
  }

  std::vector<PieceRow> pieces() const { return pieces_to_prepare(on_.world(), on_.view.look.pieces); }
  Preparation wanted() const { return with_numbers(preparation_, pieces(), on_.world()); }

  void ask() {
    on_.changes.ask({.name = preparation_title(preparation_.tool),
                     .run = [this, wanted = wanted()] { return prepare(wanted), true; },
                     .is_one = true});
  }
  // All of them, or none if one fails or the user stops it.
  void prepare(const Preparation& wanted) {
    const std::vector<PieceRow> pieces = this->pieces();
    if (why_no_preparation(pieces, wanted) != nullptr) return;  // other pieces are chosen by now
    cancel_stroke(on_);
    const FaceForecast faces = forecast(pieces, wanted);
    const bool quick = std::max(faces.before, faces.after.value_or(0)) <= kQuickToPrepare;
    on_.changes.change(preparation_title(wanted.tool), quick,
                       [pieces, wanted](Document& d, const Progress* progress) {
                         return prepare_pieces(d, pieces, wanted, progress);
                       });
  }

  // Whether the world stays as it is, so that a copy of it is worth its time.
  bool world_rests() const {
    const Document& document = on_.work.document;
    const bool queued = document.waiting() > 0 && !document.execution().only_cools();
    return !on_.plays && !on_.cutting() && !queued && !on_.changes.is_pending() && !on_.changes.is_asked() &&
           !on_.opening.loader.busy();
  }

  Workspace& on_;
  Preparation preparation_;
  PreparePanel panel_;
  LivePreview preview_;
};

void PrepareFeature::follow_queue(double) {
  const bool seen = on_.settings.prepare_preview && on_.panels.shows(kPreparePanel) && world_rests();
  const std::vector<PieceRow> pieces = seen ? this->pieces() : std::vector<PieceRow>();
  const Preparation preparation = with_numbers(preparation_, pieces, on_.world());
  if (!seen || why_no_preview(on_.world(), pieces, preparation) != nullptr) {
    preview_.drop();
  } else {
    preview_.follow(on_.world(), pieces, preparation);
    preview_.wait(on_.background_wait);
  }
  const auto wire = preview_.shown() != nullptr ? preview_.shown()->wire : nullptr;
  if (on_.view.look.wire == wire) return;
  on_.view.look.wire = wire;
  on_.view.picture_old = true;
}

void PrepareFeature::report(nlohmann::ordered_json& report) const {
  const Preview* shown = preview_.shown();
  if (shown == nullptr) return;
  report["preview"] = {{"faces", shown->after.faces},
                       {"least_angle", shown->after.least_angle},
                       {"distance", shown->distance},
                       {"edges", 0}};
  size_t edges = 0;
  for (const DrawnWire::Part& part : shown->wire->parts) edges += part.edges.size();
  report["preview"]["edges"] = edges;
}

}  // namespace

std::unique_ptr<Feature> prepare_feature(Workspace& on) { return std::make_unique<PrepareFeature>(on); }

}  // namespace kerf
