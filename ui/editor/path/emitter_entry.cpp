#include "ui/editor/path/emitter_entry.h"

#include "core/document/text/json_value.h"

namespace kerf {

namespace {

constexpr const char* kAtKey = "at";
constexpr const char* kTargetKey = "target";
constexpr const char* kInShotsKey = "in_shots";
constexpr const char* kPaceKey = "pace";

}  // namespace

nlohmann::json emitter_entry(const Emitter& emitter) {
  if (!emitter.placed()) return nullptr;
  return {{kAtKey, vector_json(emitter.at())},
          {kTargetKey, vector_json(emitter.target())},
          {kInShotsKey, emitter.in_shots},
          {kPaceKey, emitter.pace.per_second()}};
}

Emitter emitter_of_entry(const nlohmann::json& entry) {
  Emitter emitter;
  const JsonValue value(entry, "emitter");
  if (!value.has(kAtKey) || !value.has(kTargetKey)) return emitter;
  const Result<Vec3> at = value[kAtKey].vector(), target = value[kTargetKey].vector();
  if (!at || !target || *at == *target) return emitter;
  emitter.place(*at, *target);
  if (value.has(kInShotsKey)) (void)assign(value[kInShotsKey].flag(), emitter.in_shots);
  double pace = emitter.pace.per_second();
  if (value.has(kPaceKey)) (void)assign(value[kPaceKey].number(), pace);
  emitter.pace.set(pace);
  return emitter;
}

}  // namespace kerf
