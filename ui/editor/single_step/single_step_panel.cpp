#include "ui/editor/single_step/single_step_panel.h"

#include <imgui.h>
#include <algorithm>
#include <utility>

#include "core/base/assert.h"
#include "core/base/json.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/render/passes/mark_passes.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr const char* kOff = "Step mode is off.";
constexpr double kStageSeconds = 0.020;  // budget for stages per frame, or the time of a frame if longer
constexpr double kQuickSeconds = 0.100;  // above this time, going back runs in the background

}  // namespace

void play_or_pause(StageState& stages, const Document& document) {
  StageRequests& requests = stages.requests;
  const bool play = !requests.playing;
  if (play && next_stage_disabled_reason(stages, document) != nullptr) {
    requests.start_over();
  } else {
    requests.stop();
  }
  requests.playing = play;
}

const char* restart_disabled_reason(const Document& document) {
  if (!document.history().last_cut()) return "No cut yet.";
  if (*document.history().last_cut() + 1 != document.history().position()) return "Undo later changes first.";
  return can_restart_stroke(document) ? nullptr : "The undo data of the last cut were discarded.";
}

const char* next_stage_disabled_reason(const StageState& stages, const Document& document) {
  if (!stages.requests.on) return kOff;
  if (document.waiting() > 0 && stages.runs_on)
    return "This stroke is cut to its end, because its undo data were discarded.";
  return document.waiting() > 0 ? nullptr
                                : "The stroke is finished: step back, restart, or draw another one.";
}

const char* stage_back_disabled_reason(const StageState& stages, const Document& document) {
  if (!stages.requests.on) return kOff;
  return stages.log.done() > 0 ? restart_disabled_reason(document) : "No stage to undo.";
}

StageCut::Key StageCut::key_now() const {
  const Document& document = workspace_.session.document;
  return {document.revision(), document.history().position(), stages_.log.forgotten()};
}

bool StageCut::can_continue() const {
  const Document& document = workspace_.session.document;
  return document.waiting() > 0 && document.queue().next_is_of_last_step();
}

bool StageCut::holds_back() const { return stages_.requests.on && from_its_start_ && can_continue(); }

bool StageCut::waits_for_earlier() const {
  const Document& document = workspace_.session.document;
  return stages_.requests.on && document.waiting() > 0 && !document.queue().next_is_of_last_step();
}

bool StageCut::needs_step_back() const {
  const StageRequests& requests = stages_.requests;
  return requests.start_again || (requests.stage && *requests.stage < stages_.log.done());
}

bool StageCut::needs_more() const {
  const StageRequests& requests = stages_.requests;
  if (requests.stage) return stages_.log.done() < *requests.stage;
  return requests.to_end_of_move || requests.playing;
}

bool StageCut::waits() const {
  return stages_.requests.on && !workspace_.changes.is_pending() &&
         (needs_step_back() || (needs_more() && can_continue()));
}

void StageCut::advance(double seconds) {
  if (workspace_.changes.is_pending()) return;
  StageRequests& requests = stages_.requests;
  if (!requests.on) return key_.reset();
  if (std::exchange(stepped_back_, false)) show();
  follow();
  if (needs_step_back()) return go_back(requests.stage.value_or(0));
  due_ = requests.playing ? std::min(due_ + seconds * requests.per_second, 1 + requests.per_second) : 1;
  advance();
  drop_fulfilled();
}

void StageCut::follow() {
  if (!stages_.requests.on || key_ == key_now()) return;
  stages_.log.forget();
  key_ = key_now();
  begin();
}

// Restarts a stroke that was partly executed without single steps, if possible.
void StageCut::begin() {
  single_.emplace(workspace_.session.document);
  spent_ = 0;
  StageRequests& requests = stages_.requests;
  if (!requests.start_again) requests.stop();
  const Document& document = workspace_.session.document;
  from_its_start_ = !can_continue() || document.history().last().waiting();
  if (!from_its_start_ && can_restart_stroke(document)) requests.start_again = true;
  stages_.runs_on = !from_its_start_ && !requests.start_again;
}

void StageCut::go_back(size_t stages) {
  StageRequests& requests = stages_.requests;
  const size_t done = stages_.log.done();
  requests.start_again = false;
  requests.stage.reset();
  if (!can_restart_stroke(workspace_.session.document)) return;
  stages = std::min(stages, done);
  const double again = static_cast<double>(stages - single_->resumes_after(stages));
  const double before = spent_;
  spent_ = done > 0 ? spent_ * static_cast<double>(stages) / static_cast<double>(done) : 0;
  const double seconds = done > 0 ? before * again / static_cast<double>(done) : 0;
  from_its_start_ = true;
  workspace_.changes.change("Going back", seconds < kQuickSeconds,
                            [this, stages](Document&, const Progress* progress) {
                              stages_.log.restart(single_->resumes_after(stages));
                              Outcome gone = single_->go_back_to(
                                  stages, [this](const StageRecord& stage) { note(stage); }, progress);
                              key_ = key_now();
                              stepped_back_ = true;
                              return gone;
                            });
}

void StageCut::advance() {
  const double began = workspace_.screen.clock->seconds();
  const auto spent = [&] { return workspace_.screen.clock->seconds() - began; };
  const double budget = std::max(kStageSeconds, workspace_.services.statistics.shown.frame_ms / 1000);
  const size_t before = stages_.log.done();
  while (holds_back() && needs_more() && due_ >= 1 && spent() < budget) {
    if (!next()) break;
    if (stages_.requests.playing) due_ -= 1;
  }
  if (stages_.log.done() == before) return;
  spent_ += spent();
  show();
}

// Requests made while earlier strokes are cut are kept.
void StageCut::drop_fulfilled() {
  StageRequests& requests = stages_.requests;
  const Document& document = workspace_.session.document;
  const bool over = document.waiting() == 0 && !document.queue().in_stroke();
  if (over || (requests.stage && *requests.stage <= stages_.log.done())) {
    const bool playing = requests.playing && !over;
    requests.stop();
    requests.playing = playing;
  }
}

bool StageCut::next() {
  return workspace_.changes.step([this](Document&) -> Result<StepResult> {
    Result<StageRecord> stage = single_->next();
    if (!stage) return stage.error();
    note(*stage);
    if (stage->done.moves > 0) stages_.requests.to_end_of_move = false;
    return std::move(stage->done);
  });
}

void StageCut::note(const StageRecord& stage) {
  stages_.log.note(workspace_.world(), stage, workspace_.view.frame.unit);
}

void StageCut::show() {
  const StageRecord* last = stages_.log.last();
  if (last != nullptr && last->move) {
    const World::Bounds bounds = workspace_.world().bounds();
    const Pose& pose = last->move->to;
    workspace_.beam.take_over(workspace_.session.document.history().last_settings(),
                              glm::length(0.5 * (bounds.min + bounds.max) - pose.origin));
    workspace_.beam.reach(pose);
  }
  workspace_.beam.find_impact(workspace_.session.document);
  workspace_.view.picture_old = workspace_.services.statistics.world_changed = true;
}

namespace {

constexpr float kRows = 9;

// Draws a button whose tooltip states the key of its action, or why it is disabled. Returns true if it was
// pressed.
bool button(const ViewState& view, const char* label, const char* mark, const char* tip, const char* action,
            const char* disabled_reason, float width) {
  ImGui::BeginDisabled(disabled_reason != nullptr);
  const std::string fitted = fitted_label(label, width - ImGui::GetStyle().FramePadding.x);
  const bool pressed = ImGui::Button(fitted.c_str(), {width, 0});
  ImGui::EndDisabled();
  mark_last_item(mark);
  const std::string text = disabled_reason != nullptr ? disabled_reason : with_shortcut(view, tip, action);
  tooltip((fitted == label ? text : visible_part(label) + ". " + text).c_str());
  return pressed;
}

// Returns the width of one of several buttons in a row.
float width_of_one(int buttons) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  return (ImGui::GetContentRegionAvail().x - static_cast<float>(buttons - 1) * gap) /
         static_cast<float>(buttons);
}

void draw_beginnings(StageState& stages, const Document& document, const ViewState& view) {
  StageRequests& requests = stages.requests;
  bool on = requests.on;
  if (ImGui::Checkbox((with_shortcut(view, "Step Mode", "stages.step_mode") + "###on").c_str(), &on)) {
    requests.stop();
    requests.on = on;
  }
  mark_last_item("stages on");
  tooltip("A drawn stroke waits and is cut stage by stage. The result is the same.");
  ImGui::SameLine();
  if (button(view, "Restart", "stage start", "Undoes the last stroke and cuts it again, stage by stage.",
             "stages.step_last_cut", restart_disabled_reason(document), width_of_one(1)))
    requests.start_over();
}

void draw_steps(StageState& stages, const Document& document, const ViewState& view) {
  StageRequests& requests = stages.requests;
  const char* no_next = next_stage_disabled_reason(stages, document);
  const float third = width_of_one(3);
  if (button(view, "Previous", "stage back", "Undoes the last stage.", "stages.previous",
             stage_back_disabled_reason(stages, document), third))
    requests.go_to(stages.log.done() - 1);
  ImGui::SameLine();
  const char* no_play = no_next != nullptr && !requests.playing ? restart_disabled_reason(document) : nullptr;
  if (button(view, requests.playing ? "Pause" : "Play", "stage play",
             "Plays the stages; restarts at the end of the stroke.", "stages.play", no_play, third))
    play_or_pause(stages, document);
  ImGui::SameLine();
  if (button(view, "Next", "stage next", "Executes one stage.", "stages.next", no_next, third))
    requests.go_to(stages.log.done() + 1);
  const float half = width_of_one(2);
  if (button(view, "Finish Segment", "stage end of move",
             "Executes the remaining stages of this segment of the beam.", "stages.finish_segment", no_next,
             half))
    requests.run_to_end_of_move();
  ImGui::SameLine();
  if (button(view, "Finish Stroke", "stage end of stroke", "Executes all remaining stages.",
             "stages.finish_stroke", no_next, half))
    requests.go_to(StageRequests::kAll);
}

void draw_speed(StageRequests& requests) {
  if (!begin_properties("speed")) return;
  property("Speed");
  real_slider({"Speed", "##speed", "Speed of playback in stages per second.", true}, requests.per_second,
              StageRequests::kSlowest, StageRequests::kFastest, "%.1f stages/s");
  mark_last_item("stage speed");
  end_properties();
}

// Returns true if the row was clicked.
bool draw_row(size_t stage, const std::string& sentence, size_t done) {
  ImGui::PushID(static_cast<int>(stage));
  const bool now = stage == done, ahead = stage > done;
  if (now) ImGui::PushStyleColor(ImGuiCol_Text, colours::accent());
  if (ahead) ImGui::PushStyleColor(ImGuiCol_Text, colours::secondary());
  const std::string text = std::to_string(stage) + "  " + sentence;
  const bool clicked = ImGui::Selectable(fitted_text(text, ImGui::GetContentRegionAvail().x).c_str(), now);
  mark_last_item("stage row", static_cast<int>(stage));
  if (now || ahead) ImGui::PopStyleColor();
  tooltip((sentence + (ahead ? " Click to execute the stages up to this one."
                       : now ? ""
                             : " Click to go back to this stage."))
              .c_str());
  ImGui::PopID();
  return clicked && !now;
}

std::string place_text(const StageState& stages, const Document& document) {
  const size_t done = stages.log.done(), known = stages.log.told().size();
  const std::string of = document.waiting() == 0 ? grouped(done)
                         : known > done          ? "at least " + grouped(known)
                                                 : "";
  if (done == 0) return document.waiting() > 0 ? "Before the first stage of the stroke" : "";
  return "Move " + grouped(stages.log.moves()) + " of the beam, stage " +
         grouped(stages.log.stage_of_move()) + " of it; " + grouped(done) + (of.empty() ? "" : " of " + of) +
         " in all";
}

}  // namespace

void SingleStepPanel::draw_list(StageState& stages, const Document& document) {
  const std::vector<std::string>& told = stages.log.told();
  const size_t done = stages.log.done();
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const float height = std::min(kRows, static_cast<float>(told.size())) * line + 0.5f * line;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetColorU32(ImGuiCol_FrameBg));
  if (ImGui::BeginChild("##stages", {0, height}, true)) {
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(told.size()), line);
    while (clipper.Step()) {
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
        const auto stage = static_cast<size_t>(i) + 1;
        const bool clicked = draw_row(stage, told[stage - 1], done);
        if (clicked && (stage > done || restart_disabled_reason(document) == nullptr))
          stages.requests.go_to(stage);
      }
    }
    if (shown_ != done) ImGui::SetScrollY(line * static_cast<float>(done) - 0.6f * height);
    shown_ = done;
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
}

void SingleStepPanel::draw(StageState& stages, const Document& document, const ViewState& view) {
  draw_beginnings(stages, document, view);
  if (!stages.requests.on) return;
  draw_steps(stages, document, view);
  draw_speed(stages.requests);
  const std::string place = place_text(stages, document);
  if (place.empty()) {
    return secondary_text("Draw a stroke, or step through the last cut.");
  }
  ImGui::TextWrapped("%s", place.c_str());
  if (!stages.log.told().empty()) draw_list(stages, document);
  if (stages.log.done() > 0) ImGui::TextWrapped("%s", stages.log.told()[stages.log.done() - 1].c_str());
  mark_last_item("stage words");
}

namespace {

constexpr float kMaxEms = 44;

// Draws a description of the last stage at the lower edge of the viewport; no-op if no stage was executed.
void draw_stage_caption(const StageLog& stages, const Area& picture) {
  if (stages.done() == 0) return;
  KERF_ASSERT(stages.done() <= stages.told().size());
  const std::string text = "Move " + grouped(stages.moves()) + ", stage " + grouped(stages.stage_of_move()) +
                           ". " + stages.told()[stages.done() - 1];
  const float em = ImGui::GetFontSize();
  const float room = std::min(kMaxEms * em, static_cast<float>(picture.size.x) - 4 * em);
  if (room <= 0) return;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, room);
  const float left = static_cast<float>(picture.at.x + 0.5 * picture.size.x) - 0.5f * size.x;
  const float top = static_cast<float>(picture.at.y + picture.size.y) - size.y - 1.8f * em;
  const ImVec2 low{left - 0.8f * em, top - 0.5f * em},
      high{left + size.x + 0.8f * em, top + size.y + 0.5f * em};
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled(low, high, colours::kPictureShade, 3);
  list.AddText(ImGui::GetFont(), em, {left, top}, colours::kPictureText, text.c_str(), nullptr, room);
  mark_area("stage caption", {{low.x, low.y}, {high.x - low.x, high.y - low.y}});
}

using Found = TouchedWalk::Outcome;
using Kind = StageMarks::Kind;

void visited_row(StageLog& stages) {
  const QueryWalk& query = stages.query();
  property("Boxes Tested");
  int visited = static_cast<int>(query.visited());
  const std::string shown = grouped(query.visited()) + " of " + grouped(query.size());
  if (whole_slider(
          {"Boxes Tested", "##visited", "Boxes in the order of testing; step with the keys [ and ]."},
          visited, 1, static_cast<int>(query.size()), shown))
    stages.visit(static_cast<size_t>(visited));
  mark_last_item("query slider");
}

void drawn_row(StageLog& stages) {
  property("Last Query");
  bool drawn = stages.query().drawn;
  if (ImGui::Checkbox("Show", &drawn)) stages.draw_query(drawn);
  mark_last_item("query shown");
  tooltip("Draws the boxes tested by the last tree query, coloured by outcome.");
}

// A number next to the colour of its boxes.
void count_row(const char* name, const QueryWalk& query, Found outcome, Kind kind, const char* meaning) {
  property(name);
  const uint32_t hex = colour_of(kind);
  const float side = 0.7f * ImGui::GetFontSize();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float top = at.y + 0.5f * (ImGui::GetFrameHeight() - side);
  ImGui::GetWindowDrawList()->AddRectFilled({at.x, top}, {at.x + side, top + side},
                                            IM_COL32(hex >> 16 & 0xffu, hex >> 8 & 0xffu, hex & 0xffu, 255),
                                            2);
  ImGui::SetCursorScreenPos({at.x + 1.5f * side, at.y});
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(grouped(query.count(outcome)).c_str());
  tooltip(meaning);
}

// Rows of the Tree panel: a slider through the boxes of the last tree query.
void draw_query_walk(StageLog& stages) {
  const QueryWalk& query = stages.query();
  ImGui::Separator();
  if (!begin_properties("query")) return;
  drawn_row(stages);
  if (query.empty()) {
    end_properties();
    return;
  }
  visited_row(stages);
  count_row("Entered", query, Found::kEntered, Kind::kEntered, "Boxes that may intersect the beam.");
  count_row("Culled", query, Found::kCulled, Kind::kCulled,
            "Boxes outside the beam, with everything in them.");
  count_row("Missed", query, Found::kMissed, Kind::kMissed, "Tested faces that the beam misses.");
  count_row("Hit", query, Found::kTouched, Kind::kTouched, "Tested faces that the beam hits.");
  end_properties();
  ImGui::TextWrapped("%s", query.words().c_str());
  mark_last_item("query words");
}

constexpr double kSpeedStep = 2;

class SingleStepFeature : public Feature {
 public:
  explicit SingleStepFeature(Workspace& workspace) : workspace_(workspace) {
    workspace.links.holds_back = [this] { return cut_.holds_back(); };
    workspace.links.time_holds.push_back(
        [this] { return stages_.requests.on ? "Bodies do not move in step mode." : nullptr; });
  }

  std::vector<PanelPart> panel_parts() override {
    return {{"tree.query",
             [this] {
               if (stages_.requests.on) draw_query_walk(stages_.log);
             }},
            {"single_step", [this] { panel_.draw(stages_, workspace_.session.document, workspace_.view); }}};
  }
  std::vector<UserAction> actions() override { return joined({beginnings(), steps(), view_actions()}); }

  void update(double seconds) override { cut_.advance(std::min(seconds, Workspace::kLongestStep)); }
  void after_queue(double) override {
    if (workspace_.changes.is_pending()) return;
    std::shared_ptr<const StageMarks> marks;
    if (stages_.requests.on) marks = stages_.log.marks(workspace_.world());
    if (workspace_.view.look.stage == marks) return;
    workspace_.view.look.stage = std::move(marks);
    workspace_.view.picture_old = true;
  }
  bool needs_redraw() const override { return cut_.waits(); }
  void on_document_opened() override { stages_.log.forget(); }

  void draw_overlay(ImDrawList&) override {
    if (!stages_.requests.on) return;
    workspace_.services.badges.draw(workspace_.view, Badges::Sign::kMode, "Step mode: " + state_text(),
                                    "single step badge");
    if (stages_.log.done() > 0) draw_stage_caption(stages_.log, workspace_.view.layout.first);
  }
  void write_session_log(nlohmann::ordered_json& report) const override {
    const QueryWalk& query = stages_.log.query();
    report["stages"] = {
        {"on", stages_.requests.on},
        {"playing", stages_.requests.playing},
        {"done", stages_.log.done()},
        {"told", stages_.log.told()},
        {"state", stages_.requests.on ? state_text() : ""},
        {"query", {{"drawn", query.drawn}, {"visited", query.visited()}, {"boxes", query.size()}}}};
  }

 private:
  // Describes what single steps do or wait for.
  std::string state_text() const {
    if (cut_.waits_for_earlier())
      return cut_.needs_more() ? "an earlier stroke is cut first, then the next stage"
                               : "an earlier stroke is cut first";
    const size_t waiting = workspace_.session.document.waiting();
    if (waiting > 0 && stages_.runs_on) return "this stroke is cut to its end";
    if (waiting > 0 && stages_.requests.playing) return "playing";
    if (waiting > 0) return with_shortcut(workspace_.view, "next stage", "stages.next");
    return stages_.log.done() > 0 ? "the stroke is cut" : "draw a stroke";
  }
  const char* next_disabled_reason() const {
    return next_stage_disabled_reason(stages_, workspace_.session.document);
  }
  std::vector<UserAction> beginnings() {
    StageRequests& requests = stages_.requests;
    const auto start_disabled_reason = [this] {
      return restart_disabled_reason(workspace_.session.document);
    };
    const auto play_disabled_reason = [this, start_disabled_reason]() -> const char* {
      return stages_.requests.playing || next_disabled_reason() == nullptr ? nullptr
                                                                           : start_disabled_reason();
    };
    return {
        make_action("stages.step_mode", "Step Mode", "F8",
                    "Cuts a drawn stroke stage by stage: sweep, hit, refine, remove, separate.",
                    [&requests] { requests.stop(), requests.on = !requests.on; },
                    {.checked = [&requests] { return requests.on; }}),
        make_action("stages.step_last_cut", "Step Through Last Cut", "Shift+F8",
                    "Undoes the last stroke and cuts it again, stage by stage.",
                    [&requests] { requests.start_over(); }, {.disabled_reason = start_disabled_reason}),
        make_action("stages.play", "Play Stages", "Space",
                    "Plays the stages in slow motion, or pauses; restarts at the end of the stroke.",
                    [this] { cut_.follow(), play_or_pause(stages_, workspace_.session.document); },
                    {.disabled_reason = play_disabled_reason,
                     .checked = [&requests] { return requests.playing; },
                     .has_key_when = [&requests] { return requests.on; }}),
    };
  }
  std::vector<UserAction> steps() {
    StageRequests& requests = stages_.requests;
    const auto disabled_reason = [this] { return next_disabled_reason(); };
    const auto while_on = [&requests] { return requests.on; };  // otherwise the key advances a tick
    return {
        make_action("stages.next", "Next Stage", ".", "Executes one stage of the stroke.",
                    [this] {
                      cut_.follow();
                      stages_.requests.go_to(stages_.log.done() + 1);
                    },
                    {.disabled_reason = disabled_reason, .has_key_when = while_on}),
        make_action(
            "stages.previous", "Previous Stage", ",", "Undoes the last stage, to the bit.",
            [this] { stages_.requests.go_to(stages_.log.done() - 1); },
            {.disabled_reason =
                 [this] { return stage_back_disabled_reason(stages_, workspace_.session.document); }}),
        make_action("stages.finish_segment", "Finish Segment", "Shift+.",
                    "Executes the remaining stages of this segment of the beam.",
                    [this] { cut_.follow(), stages_.requests.run_to_end_of_move(); },
                    {.disabled_reason = disabled_reason}),
        make_action("stages.finish_stroke", "Finish Stroke", "End", "Executes all remaining stages.",
                    [this] { cut_.follow(), stages_.requests.go_to(StageRequests::kAll); },
                    {.disabled_reason = disabled_reason}),
    };
  }
  std::vector<UserAction> view_actions() {
    return {speed_action("stages.faster", "Faster Stages", kSpeedStep),
            speed_action("stages.slower", "Slower Stages", 1 / kSpeedStep),
            visit_action("tree.next_node", "Next Node", "]", 1),
            visit_action("tree.previous_node", "Previous Node", "[", -1),
            make_action("tree.show_query", "Show Last Tree Query", "",
                        "Draws the boxes tested by the last tree query, coloured by outcome.",
                        [this] { stages_.log.draw_query(!stages_.log.query().drawn); },
                        {.checked = [this] { return stages_.log.query().drawn; }})};
  }
  UserAction speed_action(const char* id, const char* name, double factor) {
    return make_action(id, name, "", "Speed of playback in stages per second.", [this, factor] {
      double& speed = stages_.requests.per_second;
      speed = std::clamp(speed * factor, StageRequests::kSlowest, StageRequests::kFastest);
    });
  }
  // Visits one more or one less box of the last query.
  UserAction visit_action(const char* id, const char* name, const char* shortcut, int by) {
    return make_action(id, name, shortcut,
                       "Steps through the boxes of the last tree query in the order of their tests.",
                       [this, by] {
                         const auto visited = static_cast<std::ptrdiff_t>(stages_.log.query().visited());
                         stages_.log.visit(static_cast<size_t>(std::max<std::ptrdiff_t>(1, visited + by)));
                       },
                       {.disabled_reason = [this] {
                         return stages_.log.query().empty() ? "No stage has queried the tree yet." : nullptr;
                       }});
  }

  Workspace& workspace_;
  StageState stages_;
  StageCut cut_{workspace_, stages_};
  SingleStepPanel panel_;
};

}  // namespace

std::unique_ptr<Feature> single_step_feature(Workspace& workspace) {
  return std::make_unique<SingleStepFeature>(workspace);
}

}  // namespace kerf
