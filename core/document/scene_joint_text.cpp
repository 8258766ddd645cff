#include "core/document/scene_joint_text.h"

#include <array>
#include <string_view>

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

struct KindName {
  Joint::Kind kind;
  const char* name;
};
constexpr std::array<KindName, 3> kKinds{
    {{Joint::Kind::kWeld, "weld"}, {Joint::Kind::kHinge, "hinge"}, {Joint::Kind::kHub, "hub"}}};

Result<Joint::Kind> parse_kind(const JsonValue& value) {
  const auto text = value.text();
  if (!text) return text.error();
  for (const KindName& k : kKinds) {
    if (*text == k.name) return k.kind;
  }
  return value.wrong("must be \"hinge\", \"hub\" or \"weld\"");
}

// A list of two elements.
Status check_two(const JsonValue& value, const char* of_what) {
  if (value.json().is_array() && value.json().size() == 2) return Done{};
  return value.wrong(std::string("must be two ") + of_what);
}

Status parse_parts(const JsonValue& value, SceneJoint& joint) {
  if (const auto two = check_two(value, "names of parts of the mesh"); !two) return two;
  for (size_t i = 0; i < 2; ++i) {
    const auto name = value[i].text();
    if (!name) return name.error();
    joint.parts[i] = *name;
  }
  return Done{};
}

Status parse_near(const JsonValue& value, SceneJoint& joint) {
  if (const auto two = check_two(value, "points, one for each part"); !two) return two;
  joint.near.emplace();
  for (size_t i = 0; i < 2; ++i) {
    const auto point = value[i].vector();
    if (!point) return point.error();
    (*joint.near)[i] = *point;
  }
  return Done{};
}

Status parse_axis(const JsonValue& root, SceneJoint& joint) {
  if (joint.kind == Joint::Kind::kWeld)
    return root.has("axis") ? Status(root["axis"].wrong("a weld has no axis")) : Done{};
  if (!root.has("axis")) return root.wrong("needs \"axis\"");
  const auto axis = root["axis"].vector();
  if (!axis) return axis.error();
  if (*axis == Vec3(0)) return root["axis"].wrong("must not be zero");
  joint.axis = *axis;
  return Done{};
}

Status parse_limits(const JsonValue& value, SceneJoint& joint) {
  if (joint.kind != Joint::Kind::kHinge) return value.wrong("only a hinge has limits");
  if (const auto two = check_two(value, "angles in degrees"); !two) return two;
  const auto low = value[0].number(), high = value[1].number();
  if (!low) return low.error();
  if (!high) return high.error();
  if (!(-180 <= *low && *low <= 0 && 0 <= *high && *high <= 180))
    return value.wrong("must be an angle from -180 to 0 and one from 0 to 180 degrees");
  joint.limits = Interval{*low, *high};
  return Done{};
}

Status parse_radius(const JsonValue& value, SceneJoint& joint) {
  const auto radius = value.positive_number();
  if (!radius) return radius.error();
  joint.radius = *radius;
  return Done{};
}

Result<SceneJoint> parse_joint(const JsonValue& value) {
  if (const auto object = value.object(); !object) return object.error();
  for (const char* key : {"kind", "parts", "anchor"}) {
    if (!value.has(key)) return value.wrong(std::string("needs \"") + key + "\"");
  }
  SceneJoint joint;
  const auto kind = parse_kind(value["kind"]);
  if (!kind) return kind.error();
  joint.kind = *kind;
  if (const auto s = parse_parts(value["parts"], joint); !s) return s.error();
  const auto anchor = value["anchor"].vector();
  if (!anchor) return anchor.error();
  joint.anchor = *anchor;
  if (const auto s = parse_axis(value, joint); !s) return s.error();
  struct Part {
    const char* key;
    Status (*parse)(const JsonValue&, SceneJoint&);
  };
  for (const Part& part :
       {Part{"limits", parse_limits}, Part{"near", parse_near}, Part{"radius", parse_radius}}) {
    if (!value.has(part.key)) continue;
    if (const auto s = part.parse(value[part.key], joint); !s) return s.error();
  }
  nlohmann::json others = value.json();
  for (const char* key : {"kind", "parts", "anchor", "axis", "limits", "near", "radius"}) others.erase(key);
  joint.others = others.dump();
  return joint;
}

}  // namespace

Result<std::vector<SceneJoint>> parse_joints(const JsonValue& value) {
  if (const auto array = value.array("joints"); !array) return array.error();
  std::vector<SceneJoint> joints;
  for (size_t i = 0; i < value.json().size(); ++i) {
    auto joint = parse_joint(value[i]);
    if (!joint) return joint.error();
    joints.push_back(std::move(*joint));
  }
  return joints;
}

Json joint_json(const SceneJoint& joint) {
  Json json;
  for (const KindName& k : kKinds) {
    if (k.kind == joint.kind) json["kind"] = k.name;
  }
  json["parts"] = joint.parts;
  json["anchor"] = vector_json(joint.anchor);
  if (joint.kind != Joint::Kind::kWeld) json["axis"] = vector_json(joint.axis);
  if (joint.limits) json["limits"] = {joint.limits->low, joint.limits->high};
  if (joint.near) json["near"] = {vector_json((*joint.near)[0]), vector_json((*joint.near)[1])};
  if (joint.radius) json["radius"] = *joint.radius;
  const Json kept = Json::parse(joint.others, nullptr, false);
  if (kept.is_object()) json.update(kept);
  return json;
}

}  // namespace kerf
