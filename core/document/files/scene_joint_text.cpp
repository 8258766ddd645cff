#include <array>

#include "core/document/files/scene_text.h"
#include "core/document/text/fields.h"

namespace kerf {

namespace {

constexpr std::array kKinds{"weld", "hinge", "hub"};  // in the order of Joint::Kind

// Reads a list of two elements.
template <typename T>
Status read_two(const JsonValue& value, const char* of_what, std::array<T, 2>& two,
                Result<T> (JsonValue::*read)() const) {
  if (!value.json().is_array() || value.json().size() != 2)
    return value.wrong(std::string("must be two ") + of_what);
  for (size_t i = 0; i < 2; ++i) {
    if (const Status element = assign((value[i].*read)(), two[i]); !element) return element;
  }
  return Done{};
}

Status read_limits(const JsonValue& value, Interval& limits) {
  if (const Status two = assign(value.pair(), limits); !two) return two;
  if (-180 <= limits.low && limits.low <= 0 && 0 <= limits.high && limits.high <= 180) return Done{};
  return value.wrong("must be an angle from -180 to 0 and one from 0 to 180 degrees");
}

void limits_field(Fields& f, SceneJoint& joint) {
  if (!f.present("limits", joint.limits.has_value())) return;
  f.check(joint.kind == Joint::Kind::kHinge, "limits", "only a hinge has limits");
  f.value(
      "limits", [&](const JsonValue& value) { return read_limits(value, joint.limits.emplace()); },
      [&] {
        return nlohmann::ordered_json{joint.limits->low, joint.limits->high};
      });
}

void near_field(Fields& f, SceneJoint& joint) {
  if (!f.present("near", joint.near.has_value())) return;
  f.value(
      "near",
      [&](const JsonValue& value) {
        return read_two(value, "points, one for each part", joint.near.emplace(), &JsonValue::vector);
      },
      [&] {
        return nlohmann::ordered_json{vector_json((*joint.near)[0]), vector_json((*joint.near)[1])};
      });
}

}  // namespace

void describe(Fields& f, SceneJoint& joint) {
  f.choice("kind", joint.kind, kKinds);
  f.value(
      "parts",
      [&](const JsonValue& value) {
        return read_two(value, "names of parts of the mesh", joint.parts, &JsonValue::text);
      },
      [&] { return nlohmann::ordered_json(joint.parts); });
  f.vector("anchor", joint.anchor);
  if (joint.kind != Joint::Kind::kWeld) f.vector("axis", joint.axis, VectorRule::kNotZero);
  if (joint.kind == Joint::Kind::kWeld) f.check(!f.present("axis", false), "axis", "a weld has no axis");
  limits_field(f, joint);
  near_field(f, joint);
  f.number("radius", joint.radius, kPositive);
  f.others(joint.others);
}

}  // namespace kerf
