#include "ui/window/event_script.h"

#include <cstdio>
#include <iostream>

#include "core/base/assert.h"
#include "ui/render/picture/png.h"

namespace kerf {

namespace {

// A widget that opens or closes shows so a few frames later.
constexpr int kFramesToSettle = 4;

}  // namespace

Result<EventScript> EventScript::open(const std::filesystem::path& file, Vec2 size) {
  if (file == "-") return EventScript(nullptr, "standard input", size);
  auto steps = std::make_unique<std::ifstream>(file);
  if (!*steps) return bad_input(file.string() + ": cannot be read; it should hold a step a line");
  return EventScript(std::move(steps), file.string(), size);
}

EventScript::EventScript(std::unique_ptr<std::istream> steps, std::string name, Vec2 size)
    : own_steps_(std::move(steps)), name_(std::move(name)), input_(size) {}

std::optional<std::string> EventScript::next_line() {
  std::istream& steps = own_steps_ ? *own_steps_ : std::cin;
  std::string line;
  while (std::getline(steps, line)) {
    ++line_;
    if (line.find_first_not_of(" \t\r") != std::string::npos) return line;
  }
  return std::nullopt;
}

Result<bool> EventScript::begin_frame(bool moving, const Answer& answer) {
  KERF_ASSERT(answer);
  if (goes_on_waiting(moving)) {
    pass_frame();
    return true;
  }
  while (const auto line = next_line()) {
    const std::string where = name_ + ":" + std::to_string(line_);
    const auto step = nlohmann::json::parse(*line, nullptr, false);
    if (!step.is_object() || step.size() != 1)
      return bad_input(where + ": a step must be an object with one key, like {\"move\": [100, 200]}");
    const auto next = take(step.begin().key(), JsonValue(step, where)[step.begin().key()], answer);
    if (!next) return next.error();
    if (*next == Next::kStep) continue;
    pass_frame();
    return true;
  }
  return false;
}

bool EventScript::goes_on_waiting(bool moving) {
  if (seconds_ >= wait_until_ || (until_rest_ && !moving && still_ >= kFramesToSettle)) {
    wait_until_ = 0;
    return false;
  }
  ++still_;
  return true;
}

Result<EventScript::Next> EventScript::take(const std::string& name, const JsonValue& value,
                                            const Answer& answer) {
  const auto then = [](Next next, const Status& status) -> Result<Next> {
    if (!status) return status.error();
    return next;
  };
  if (name == "wait" || name == "settle") return wait(value, name == "settle");
  if (name == "picture") return then(Next::kStep, take_picture(value));
  if (name == "answer") return then(Next::kStep, print_answer(value, answer));
  if (name == "together") return then(Next::kFrame, hear_together(value));
  if (name == "frame") return then(Next::kStep, assign(value.positive_number(), frame_seconds_));
  if (name == "draws") return then(Next::kStep, assign(value.flag(), draws_));
  return then(Next::kFrame, input_.hear(name, value));
}

Result<EventScript::Next> EventScript::wait(const JsonValue& value, bool until_rest) {
  const auto seconds = value.positive_number();
  if (!seconds) return seconds.error();
  wait_until_ = seconds_ + *seconds;
  until_rest_ = until_rest;
  still_ = 1;
  return Next::kFrame;
}

Status EventScript::hear_together(const JsonValue& steps) {
  if (const Status list = steps.array("steps"); !list) return list;
  for (size_t i = 0; i < steps.json().size(); ++i) {
    const JsonValue step = steps[i];
    if (!step.json().is_object() || step.json().size() != 1)
      return step.wrong("must be an object with one key");
    const std::string name = step.json().begin().key();
    if (const Status heard = input_.hear(name, step[name]); !heard) return heard;
  }
  return Done{};
}

Status EventScript::take_picture(const JsonValue& value) const {
  const auto file = value.text();
  if (!file) return file.error();
  const Vec2 size = input_.size();
  return write_png(read_pixels(0, static_cast<int>(size.x), static_cast<int>(size.y)), *file);
}

Status EventScript::print_answer(const JsonValue& value, const Answer& answer) const {
  const auto what = value.text();
  if (!what) return what.error();
  std::optional<std::string> text = answer(*what);
  if (*what == "title") text = nlohmann::json(title_).dump();
  if (!text) return value.wrong("the screen that is shown has no such answer");
  std::printf("%s\n", text->c_str());
  std::fflush(stdout);
  return Done{};
}

}  // namespace kerf
