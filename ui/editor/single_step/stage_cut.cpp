#include "ui/editor/single_step/stage_cut.h"

#include <algorithm>
#include <utility>

namespace kerf {

namespace {

constexpr const char* kOff = "Step mode is off.";

}  // namespace

void play_or_pause(StageState& stages, const Document& document) {
  StageWishes& wishes = stages.wishes;
  const bool play = !wishes.playing;
  if (play && why_no_next_stage(stages, document) != nullptr) {
    wishes.begin_again();
  } else {
    wishes.stop();
  }
  wishes.playing = play;
}

const char* why_not_again(const Document& document) {
  if (!document.history().last_cut()) return "No cut yet.";
  if (*document.history().last_cut() + 1 != document.history().position()) return "Undo later changes first.";
  return can_restart_stroke(document) ? nullptr : "The undo data of the last cut were discarded.";
}

const char* why_no_next_stage(const StageState& stages, const Document& document) {
  if (!stages.wishes.on) return kOff;
  if (document.waiting() > 0 && stages.runs_on)
    return "This stroke is cut to its end, because its undo data were discarded.";
  return document.waiting() > 0 ? nullptr
                                : "The stroke is finished: go back, start again, or draw another one.";
}

const char* why_no_stage_back(const StageState& stages, const Document& document) {
  if (!stages.wishes.on) return kOff;
  return stages.log.done() > 0 ? why_not_again(document) : "No stage was executed yet.";
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

bool StageCut::holds_back() const { return stages_.wishes.on && from_its_start_ && can_go_on(); }

bool StageCut::waits_for_earlier() const {
  const Document& document = workspace_.session.document;
  return stages_.wishes.on && document.waiting() > 0 && !document.queue().next_is_of_last_step();
}

bool StageCut::must_go_back() const {
  const StageWishes& wishes = stages_.wishes;
  return wishes.start_again || (wishes.stage && *wishes.stage < stages_.log.done());
}

bool StageCut::wants_more() const {
  const StageWishes& wishes = stages_.wishes;
  if (wishes.stage) return stages_.log.done() < *wishes.stage;
  return wishes.to_end_of_move || wishes.playing;
}

bool StageCut::waits() const {
  return stages_.wishes.on && !workspace_.changes.is_pending() &&
         (must_go_back() || (wants_more() && can_go_on()));
}

void StageCut::advance(double seconds) {
  if (workspace_.changes.is_pending()) return;
  StageWishes& wishes = stages_.wishes;
  if (!wishes.on) return key_.reset();
  if (std::exchange(went_back_, false)) show();
  follow();
  if (must_go_back()) return go_back(wishes.stage.value_or(0));
  due_ = wishes.playing ? std::min(due_ + seconds * wishes.per_second, 1 + wishes.per_second) : 1;
  go_on();
  drop_fulfilled();
}

void StageCut::follow() {
  if (!stages_.wishes.on || key_ == key_now()) return;
  stages_.log.forget();
  key_ = key_now();
  begin();
}

// Restarts a stroke that was partly executed without single steps, if possible.
void StageCut::begin() {
  single_.emplace(workspace_.session.document);
  spent_ = 0;
  StageWishes& wishes = stages_.wishes;
  if (!wishes.start_again) wishes.stop();
  const Document& document = workspace_.session.document;
  from_its_start_ = !can_go_on() || document.history().last().waiting();
  if (!from_its_start_ && can_restart_stroke(document)) wishes.start_again = true;
  stages_.runs_on = !from_its_start_ && !wishes.start_again;
}

void StageCut::go_back(size_t stages) {
  StageWishes& wishes = stages_.wishes;
  const size_t done = stages_.log.done();
  wishes.start_again = false;
  wishes.stage.reset();
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
                              went_back_ = true;
                              return gone;
                            });
}

void StageCut::go_on() {
  const double began = workspace_.screen.clock->seconds();
  const auto spent = [&] { return workspace_.screen.clock->seconds() - began; };
  const double budget = std::max(kStageSeconds, workspace_.services.statistics.shown.frame_ms / 1000);
  const size_t before = stages_.log.done();
  while (holds_back() && wants_more() && due_ >= 1 && spent() < budget) {
    if (!next()) break;
    if (stages_.wishes.playing) due_ -= 1;
  }
  if (stages_.log.done() == before) return;
  spent_ += spent();
  show();
}

// Requests made while earlier strokes are cut are kept.
void StageCut::drop_fulfilled() {
  StageWishes& wishes = stages_.wishes;
  const Document& document = workspace_.session.document;
  const bool over = document.waiting() == 0 && !document.queue().in_stroke();
  if (over || (wishes.stage && *wishes.stage <= stages_.log.done())) {
    const bool playing = wishes.playing && !over;
    wishes.stop();
    wishes.playing = playing;
  }
}

bool StageCut::next() {
  return workspace_.changes.step([this](Document&) -> Result<StepResult> {
    Result<StageRecord> stage = single_->next();
    if (!stage) return stage.error();
    note(*stage);
    if (stage->done.moves > 0) stages_.wishes.to_end_of_move = false;
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
  workspace_.beam.find_strike(workspace_.session.document);
  workspace_.view.picture_old = workspace_.services.statistics.world_changed = true;
}

}  // namespace kerf
