#include "ui/editor/single_step/stage_cut.h"

#include <algorithm>
#include <utility>

namespace kerf {

namespace {

constexpr const char* kOff = "Step mode is off.";

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
                                : "The stroke is finished: go back, start again, or draw another one.";
}

const char* stage_back_disabled_reason(const StageState& stages, const Document& document) {
  if (!stages.requests.on) return kOff;
  return stages.log.done() > 0 ? restart_disabled_reason(document) : "No stage was executed yet.";
}

namespace {
constexpr double kStageSeconds = 0.020;  // budget for stages per frame, or the time of a frame if longer
constexpr double kQuickSeconds = 0.100;  // above this time, going back runs in the background
}  // namespace

StageCut::Key StageCut::key_now() const {
  const Document& document = workspace_.session.document;
  return {document.revision(), document.history().position(), stages_.log.forgotten()};
}

bool StageCut::can_go_on() const {
  const Document& document = workspace_.session.document;
  return document.waiting() > 0 && document.queue().next_is_of_last_step();
}

bool StageCut::holds_back() const { return stages_.requests.on && from_its_start_ && can_go_on(); }

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
         (needs_step_back() || (needs_more() && can_go_on()));
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
  from_its_start_ = !can_go_on() || document.history().last().waiting();
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

}  // namespace kerf
