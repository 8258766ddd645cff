#include "ui/editor/laser/comparison_cut.h"

#include <imgui.h>

#include "core/base/assert.h"
#include "core/base/json.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

// Returns the world before the last stroke of `first`, or its current world if it has no stroke; nullopt if
// no_comparison_reason() applies.
std::optional<World> world_to_cut(Document& first) {
  if (first.history().last_cut()) return first.before_last_stroke();
  if (first.world().live_faces() > Document::kMaxFacesToCopy) return std::nullopt;
  return first.world();
}

constexpr size_t kMovesOfTwin = 16;  // per step

std::string resolution_text(const Resolution& r, FileUnit unit) {
  if (r.rule == Resolution::Rule::kTargetEdge) return "Edges of " + length_label(r.target_edge, unit);
  if (r.rule == Resolution::Rule::kTolerance) return "Within " + length_label(r.tolerance, unit);
  return r.depth == 0 ? "Whole faces" : "Depth " + std::to_string(r.depth);
}

// Draws two lines of text in the upper left corner of a half.
void draw_half_label(const Area& half, const std::string& what, const std::string& faces, ImDrawList& list) {
  const float em = ImGui::GetFontSize(), line = ImGui::GetTextLineHeight();
  const float x = static_cast<float>(half.at.x) + em, y = static_cast<float>(half.at.y) + em;
  const float width = std::max(ImGui::CalcTextSize(what.c_str()).x, ImGui::CalcTextSize(faces.c_str()).x);
  list.PushClipRect(to_im(half.at), to_im(half.at + half.size), true);
  list.AddRectFilled({x - 0.6f * em, y - 0.4f * em}, {x + width + 0.6f * em, y + 2.2f * line + 0.4f * em},
                     colours::kPictureShade, 3);
  list.AddText({x, y}, colours::kPictureText, what.c_str());
  list.AddText({x, y + 1.2f * line}, colours::kPictureSecondary, faces.c_str());
  list.PopClipRect();
}

class SplitFeature : public Feature {
 public:
  explicit SplitFeature(Workspace& workspace) : workspace_(workspace) {
    workspace.links.time_holds.push_back(
        [this] { return shown_ ? "Bodies do not move in the split view." : nullptr; });
  }

  std::vector<PanelPart> panel_parts() override {
    return {{"resolution.compare", [this] { draw_rows(); }}};
  }
  std::vector<UserAction> actions() override {
    return {make_action("view.split", "Split View", "S",
                        "Shows the last cut at a second resolution in the right half.",
                        [this] { show(!shown_); }, {.checked = [this] { return shown_; }})};
  }

  void after_queue(double) override {
    workspace_.services.statistics.shown.twin_faces = twin_.world().live_faces();
    if (!shown_) return;
    const Result<Renderer*> half = workspace_.screen.picture->second();
    if (!half) {
      show(false);
      return workspace_.message.error(half.error().message);
    }
    const double began = workspace_.screen.clock->seconds();
    const bool anything = cut(**half);
    workspace_.view.second_world = &twin_.world();
    if (!anything) return;
    workspace_.screen.cut_seconds += workspace_.screen.clock->seconds() - began;
    workspace_.view.picture_old = workspace_.services.statistics.world_changed = true;
  }
  bool needs_redraw() const override { return twin_.waiting() > 0; }
  void on_document_opened() override { restart(); }
  void draw_overlay(ImDrawList& list) override {
    const Layout& l = workspace_.view.layout;
    if (!l.split()) return;
    const Document& document = workspace_.session.document;
    const bool cut = document.history().totals().strokes > 0;
    const double radius = workspace_.laser.radius;
    const FileUnit unit = workspace_.view.frame.unit;
    draw_half_label(l.first,
                    resolution_text(cut ? document.history().last_settings().resolution
                                        : workspace_.laser.resolution.of(radius),
                                    unit),
                    count_text(workspace_.services.statistics.shown.faces, "face"), list);
    draw_half_label(l.second, resolution_text(cut ? twin_.resolution() : resolution_.of(radius), unit),
                    twin_.there() ? count_text(workspace_.services.statistics.shown.twin_faces, "face")
                                  : no_comparison_reason(document),
                    list);
    const auto x = static_cast<float>(l.second.at.x), y = static_cast<float>(l.second.at.y);
    list.AddLine({x, y}, {x, y + static_cast<float>(l.second.size.y)}, colours::kPictureShade, 3);
    list.AddLine({x, y}, {x, y + static_cast<float>(l.second.size.y)}, colours::kPictureSecondary, 1);
  }
  void write_session_log(nlohmann::ordered_json& report) const override {
    report["split"] = {{"shown", shown_}, {"faces", twin_.world().live_faces()}};
  }

 private:
  void show(bool shown) {
    cancel_stroke(workspace_);
    shown_ = shown;
    restart();
    workspace_.view.in_second = false;
    workspace_.view.picture_old = true;
  }
  void restart() {
    twin_.forget();
    workspace_.view.second_world = shown_ ? &twin_.world() : nullptr;
  }
  void draw_rows() {
    if (!begin_properties("split view")) return;
    property("Split View");
    bool shown = shown_;
    if (ImGui::Checkbox(
            (with_shortcut(workspace_.view, "Two Resolutions", "view.split") + "###split").c_str(), &shown))
      show(shown);
    tooltip("Shows the last cut at a second resolution in the right half of the viewport.");
    if (shown_) {
      property("Right View");
      ImGui::Dummy({1, ImGui::GetFrameHeight()});
      if (resolution_rows(resolution_, {workspace_.laser.radius, workspace_.view.frame.unit}))
        workspace_.view.picture_old = true;
      figure_row("Faces", grouped(workspace_.services.statistics.shown.twin_faces),
                 "Faces of all bodies in the right view.");
    }
    end_properties();
  }
  // Returns true if anything was queued, or if the world was replaced.
  bool cut(Renderer& renderer) {
    const bool restarted = twin_.follow(workspace_.session.document, resolution_);
    if (restarted) workspace_.changes.show_world(twin_.world(), renderer);
    const bool waited = twin_.waiting() > 0;
    while (twin_.waiting() > 0 && workspace_.screen.clock->seconds() < workspace_.screen.cut_until) {
      const Result<StepResult> step = twin_.step(kMovesOfTwin);
      if (!step) {
        renderer.resend(twin_.world());
        workspace_.message.error("Right view: " + step.error().message);
        break;
      }
      renderer.follow(twin_.world(), step->delta);
      if (workspace_.view.look.ghost || workspace_.view.look.show.face_numbers)
        renderer.send_faces(twin_.world());
    }
    return restarted || waited;
  }

  Workspace& workspace_;
  bool shown_ = false;
  ResolutionControls resolution_{.edge_fraction = 1};
  TwinCut twin_;
};

}  // namespace

const char* no_comparison_reason(const Document& document) {
  const UndoStack& history = document.history();
  if (document.world().live_faces() > Document::kMaxFacesToCopy)
    return "Too large to compare (more than 400 000 faces)";
  if (history.last_cut() && *history.last_cut() + 1 != history.position())
    return "Undo later changes to compare the last cut";
  return "The undo data of the last cut were discarded";
}

void TwinCut::begin(Document& first, const Resolution& resolution) {
  std::optional<World> world = world_to_cut(first);
  there_ = world.has_value();
  document_ = there_ ? Document(std::move(*world)) : Document();
  document_.set_window(0);
  resolution_ = resolution;
  revision_ = first.revision();
  position_ = first.history().position();
  commands_ = 0;
  begun_ = true;
}

bool TwinCut::follow(Document& first, const ResolutionControls& controls) {
  const UndoStack& history = first.history();
  if (!history.last_cut()) {
    const bool fits = first.world().live_faces() <= Document::kMaxFacesToCopy;
    const bool is_old = first.revision() != revision_ || history.position() != position_;
    const bool restarted = !begun_ || is_old || (!there_ && fits);
    if (restarted) begin(first, controls.of(1));
    return restarted;
  }
  const Resolution resolution = controls.of(history.last_settings().laser.radius);
  const bool restarted = !begun_ || first.revision() != revision_ || resolution != resolution_;
  if (restarted) begin(first, resolution);
  if (!there_) return restarted;
  const std::vector<Command>& stroke = history.step(history.base_of(*history.last_cut())).commands();
  for (; commands_ < stroke.size(); ++commands_) {
    Command command = stroke[commands_];
    if (auto* start = std::get_if<BeginStroke>(&command)) {
      start->settings = history.last_settings();
      start->settings.resolution = resolution_;
    }
    // The twin skips commands that let time pass.
    const bool in_time = std::visit([]<typename C>(const C&) { return TimedCommand<C>; }, command);
    if (in_time) continue;
    const Outcome applied = document_.apply(command);
    KERF_ASSERT(applied.ok());
    (void)applied;
  }
  return restarted;
}

std::unique_ptr<Feature> split_feature(Workspace& workspace) {
  return std::make_unique<SplitFeature>(workspace);
}

}  // namespace kerf
