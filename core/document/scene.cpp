#include "core/document/scene.h"

#include <algorithm>
#include <cstdio>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/document/text/fields.h"
#include "core/document/text/hash.h"
#include "core/mesh/files/vertex_colour.h"
#include "core/mesh/measures.h"
#include "core/world/body_creation.h"
#include "core/world/body_mass.h"

namespace kerf {

namespace {

constexpr double kHashing = 0.02;  // fraction of the load time of a body with a known hash

bool is_solid(Solidity solid, const Body& loaded) {
  if (solid != Solidity::kAuto) return solid == Solidity::kSolid;
  const EnclosedVolume enclosed = enclosed_volume(loaded.mesh, loaded.middle());
  return enclosed.closed && enclosed.volume > 0;
}

// The linear value of one of the 256 levels of sRGB.
double linear_of(int step) {
  KERF_ASSERT(step >= 0 && step <= 255);
  return srgb_to_linear(step / 255.0);
}

int nearest_step(double linear) {
  int step = 0;
  while (step < 255 && linear > 0.5 * (linear_of(step) + linear_of(step + 1))) ++step;
  return step;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

constexpr std::array kUnitNames{"mm", "cm", "m", "in"};  // in the order of FileUnit
constexpr std::array kKinds{"weld", "hinge", "hub"};     // in the order of Joint::Kind

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

void limits_field(Fields& f, JointDescription& joint) {
  if (!f.present("limits", joint.limits.has_value())) return;
  f.check(joint.kind == Joint::Kind::kHinge, "limits", "only a hinge has limits");
  f.value(
      "limits", [&](const JsonValue& value) { return read_limits(value, joint.limits.emplace()); },
      [&] {
        return nlohmann::ordered_json{joint.limits->low, joint.limits->high};
      });
}

void near_field(Fields& f, JointDescription& joint) {
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

constexpr const char* kColour = "must be a colour like \"#3a6f8f\"";

// The names are joined by commas in memory.
Status read_names(const JsonValue& value, std::string& names) {
  if (const Status list = value.array("names"); !list) return list;
  for (size_t i = 0; i < value.json().size(); ++i) {
    const auto name = value[i].text();
    if (!name) return name.error();
    names += (i > 0 ? "," : "") + *name;
  }
  return Done{};
}

nlohmann::ordered_json names_json(const std::string& joined) {
  auto names = nlohmann::ordered_json::array();
  for (size_t at = 0; at < joined.size();) {
    const size_t comma = std::min(joined.find(',', at), joined.size());
    names.push_back(joined.substr(at, comma - at));
    at = comma + 1;
  }
  return names;
}

Status read_solidity(const JsonValue& value, Solidity& solid) {
  const nlohmann::json& json = value.json();
  if (json.is_boolean()) {
    solid = json.get<bool>() ? Solidity::kSolid : Solidity::kSheet;
  } else if (json == "auto") {
    solid = Solidity::kAuto;
  } else {
    return value.wrong("must be true, false or \"auto\"");
  }
  return Done{};
}

void solid_field(Fields& f, Solidity& solid) {
  if (!f.present("solid", solid != Solidity::kSheet)) return;
  f.value(
      "solid", [&](const JsonValue& value) { return read_solidity(value, solid); },
      [&]() -> nlohmann::ordered_json {
        if (solid == Solidity::kAuto) return "auto";
        return solid == Solidity::kSolid;
      });
}

}  // namespace

Error states_units(const std::filesystem::path& file) {
  return bad_input(
      file.string() +
      ": a unit can be given for mesh files only; scenes and journals state that of each mesh (\"unit\")");
}

Result<SceneDescription> read_description(const std::filesystem::path& file, FileUnit unit) {
  if (file.extension() != ".json") {
    SceneDescription scene;
    scene.bodies.push_back(body_of_file(file));
    scene.bodies.front().unit = unit;
    return scene;
  }
  if (unit != FileUnit::kMetre) return states_units(file);
  return read_described<SceneDescription>(file);
}

Status check_hash(const SceneBody& body, const Progress* progress) {
  if (!body.hash) return Done{};
  const auto hash = file_hash(body.mesh, progress);
  if (!hash) return hash.error();
  if (*hash == *body.hash) return Done{};
  return bad_input(body.mesh.string() +
                   ": the mesh differs from the one whose hash was recorded: restore the original file");
}

Result<BodyId> add_scene_body(const SceneBody& description, Body body, World& world) {
  body.placement = description.placement;
  body.sheet = description.sheet;
  body.cut_material = description.cut_material;
  if (is_solid(description.solid, body)) make_solid(body, true);
  const BodyId id = world.add(std::move(body));
  Joints joints = world.joints();
  for (const JointDescription& joint : description.joints) {
    auto made = make_joint(joint, id, world.body(id));
    if (!made) return bad_input(description.mesh.string() + ": " + made.error().message);
    joints.all.push_back(std::move(*made));
  }
  if (!description.joints.empty()) world.set_joints(std::move(joints));
  return id;
}

SceneBody body_of_file(const std::filesystem::path& mesh) {
  SceneBody body;
  body.mesh = mesh;
  body.name = mesh.stem().string();
  return body;
}

Result<Scene> load_scene(SceneDescription description, const Progress* progress) {
  Scene scene{std::move(description), {}};
  const double share = 1 / static_cast<double>(scene.bodies.size());
  ProgressShares shares(progress);
  for (const SceneBody& body : scene.bodies) {
    const double hashed = body.hash ? kHashing : 0;
    const Progress hashing = shares.next(hashed * share), loading = shares.next((1 - hashed) * share);
    if (const auto same = check_hash(body, &hashing); !same) return same.error();
    auto loaded = load_body(body.name, body.mesh, &loading, body.unit);
    if (!loaded) return loaded.error();
    if (const auto added = add_scene_body(body, std::move(*loaded), scene.world); !added)
      return added.error();
  }
  return scene;
}

Result<Scene> read_scene(const std::filesystem::path& file, const Progress* progress, FileUnit unit) {
  auto description = read_description(file, unit);
  if (!description) return description.error();
  return load_scene(std::move(*description), progress);
}

Status record_hashes(SceneDescription& description, const Progress* progress) {
  ProgressShares shares(progress);
  for (SceneBody& body : description.bodies) {
    const Progress hashing = shares.next(1 / static_cast<double>(description.bodies.size()));
    if (body.hash) continue;
    const auto hash = file_hash(body.mesh, &hashing);
    if (!hash) return hash.error();
    body.hash = *hash;
  }
  return Done{};
}

std::optional<Vec3> parse_colour(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  Vec3 colour{0};
  for (int channel = 0; channel < 3; ++channel) {
    const int high = hex_digit(text[static_cast<size_t>(1 + 2 * channel)]);
    const int low = hex_digit(text[static_cast<size_t>(2 + 2 * channel)]);
    if (high < 0 || low < 0) return std::nullopt;
    colour[channel] = linear_of(16 * high + low);
  }
  return colour;
}

std::string colour_text(const Vec3& linear) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", static_cast<unsigned>(nearest_step(linear.x)),
                static_cast<unsigned>(nearest_step(linear.y)), static_cast<unsigned>(nearest_step(linear.z)));
  return text.data();
}

void describe(Fields& f, JointDescription& joint) {
  f.choice("kind", joint.kind, kKinds);
  if (f.present("parts", !joint.parts[0].empty() || !joint.parts[1].empty())) {
    f.value(
        "parts",
        [&](const JsonValue& value) {
          return read_two(value, "names of parts of the mesh", joint.parts, &JsonValue::text);
        },
        [&] { return nlohmann::ordered_json(joint.parts); });
  } else {
    f.check(f.present("near", joint.near.has_value()), nullptr,
            "needs \"parts\", two names, or \"near\", a point of each part");
  }
  f.vector("anchor", joint.anchor);
  if (joint.kind != Joint::Kind::kWeld) f.vector("axis", joint.axis, VectorRule::kNotZero);
  if (joint.kind == Joint::Kind::kWeld) f.check(!f.present("axis", false), "axis", "a weld has no axis");
  limits_field(f, joint);
  near_field(f, joint);
  f.number("radius", joint.radius, kPositive);
}

void describe(Fields& f, Paint& paint) {
  f.coded("colour", paint.colour, parse_colour, colour_text, kColour, {Vec3(0.20, 0.27, 0.33), kOptional});
  f.number("gloss", paint.gloss, kShare, {0.5, kOptional});
}

void describe(Fields& f, View& view) {
  f.vector("eye", view.eye);
  f.vector("target", view.target);
  f.check(view.eye != view.target, nullptr, "eye and target must differ");
}

void describe(Fields& f, Light& light) {
  const bool point = f.present("position", light.kind == Light::Kind::kPoint);
  f.check(point != f.present("direction", !point), nullptr,
          "needs \"direction\" or \"position\", and not both");
  light.kind = point ? Light::Kind::kPoint : Light::Kind::kDirectional;
  f.vector(point ? "position" : "direction", light.at, point ? VectorRule::kAny : VectorRule::kNotZero);
  f.coded("colour", light.colour, parse_colour, colour_text, kColour, {Vec3(1.0, 0.938, 0.848), kOptional});
  f.number("intensity", light.intensity, kPositive, {2.1, kOptional});
}

void lights_field(Fields& f, const char* key, std::vector<Light>& lights) {
  f.list(key, "lights", lights, kOptional);
  f.check(lights.size() <= kMaxLights, key, "must contain at most " + std::to_string(kMaxLights) + " lights");
}

void describe(Fields& f, SceneBody& body) {
  f.path("mesh", body.mesh);
  if (f.present("unit", body.unit != FileUnit::kMetre)) f.choice("unit", body.unit, kUnitNames);
  if (f.reading()) body.name = body.mesh.stem().string();
  f.text("name", body.name, kOptional);
  f.vector("position", body.placement.position, VectorRule::kAny, Vec3(0));
  f.orientation("orientation", body.placement.orientation, glm::dquat(1, 0, 0, 0));
  f.coded("hash", body.hash, parse_hash, hash_text, kHashRule);
  scene_sheet_fields(f, body.sheet);
  solid_field(f, body.solid);
  if (f.present("cut_material", body.cut_material != SceneBody().cut_material))
    f.filled_text("cut_material", body.cut_material);
  f.list("joints", "joints", body.joints, kOptional);
}

void describe(Fields& f, SceneDescription& scene) {
  uint64_t version = kSceneVersion;
  f.version("version", version, kSceneVersion, kOptional);
  f.list("bodies", "bodies", scene.bodies);
  f.check(!scene.bodies.empty(), "bodies", "must contain at least one body");
  f.by_name("paints", scene.paints);
  f.object("view", scene.view);
  lights_field(f, "lights", scene.lights);
  if (f.present("show", !scene.show.empty()))
    f.value(
        "show", [&](const JsonValue& value) { return read_names(value, scene.show); },
        [&] { return names_json(scene.show); });
  f.list("strokes", "strokes", scene.strokes, kOptional);
  f.kept(kEditorKeys, scene.others);
}

Result<SceneDescription> parse_scene(const JsonValue& root, const std::filesystem::path& folder) {
  SceneDescription scene;
  const Status read = read_fields(root, folder, scene);
  if (!read) return read.error();
  return scene;
}

nlohmann::ordered_json scene_json(const SceneDescription& scene, const std::filesystem::path& folder) {
  return fields_json(scene, folder);
}

}  // namespace kerf
