#include "core/document/colour_text.h"
#include "core/document/exact_number.h"
#include "core/document/hash_text.h"
#include "core/document/parse_strokes.h"
#include "core/document/scene_joint_text.h"
#include "core/document/scene_text.h"
#include "core/document/substance_numbers.h"

namespace kerf {

namespace {

Result<Vec3> colour(const JsonValue& value) {
  const auto text = value.text();
  if (!text) return text.error();
  const auto colour = parse_colour(*text);
  if (!colour) return value.wrong("must be a colour like \"#3a6f8f\"");
  return *colour;
}

// The text of a JSON object without some of its keys.
template <typename... Keys>
std::string without(nlohmann::json json, Keys... keys) {
  (json.erase(keys), ...);
  return json.dump();
}

Status parse_placement(const JsonValue& value, Placement& placement) {
  if (value.has("position")) {
    const auto position = value["position"].vector();
    if (!position) return position.error();
    placement.position = *position;
  }
  if (value.has("orientation")) {
    const auto turn = value["orientation"].orientation();
    if (!turn) return turn.error();
    placement.orientation = *turn;
  }
  return Done{};
}

Status parse_sheet(const JsonValue& value, Sheet& sheet) {
  struct Part {
    const char* key;
    double& number;
    Interval allowed;
    const char* text;
  };
  for (const Part& part : {Part{"thickness", sheet.thickness, {1e-9, 1e3}, "from 1e-9 to 1000 m"},
                           Part{"density", sheet.density, {1e-3, 1e6}, "from 0.001 to 1000000 kg/m^3"}}) {
    if (!value.has(part.key)) continue;
    const auto number = value[part.key].positive_number();
    if (!number) return number.error();
    if (*number < part.allowed.low || *number > part.allowed.high)
      return value[part.key].wrong(std::string("must be ") + part.text);
    part.number = *number;
  }
  return Done{};
}

// Constants that are not given are those of mild steel.
Status parse_substance(const JsonValue& value, Substance& substance) {
  if (const auto object = value.object(); !object) return object;
  for (const SubstanceNumber& constant : substance_numbers(substance)) {
    if (!value.has(constant.key)) continue;
    const auto number = value[constant.key].number();
    if (!number) return number.error();
    if (*number < constant.least || *number > constant.most) {
      std::string range = "must be from ";
      append_number(range, constant.least);
      append_number(range += " to ", constant.most);
      return value[constant.key].wrong(range);
    }
    constant.number = *number;
  }
  return Done{};
}

Status parse_physics(const JsonValue& value, SceneBody& body) {
  if (const auto sheet = parse_sheet(value, body.sheet); !sheet) return sheet;
  if (value.has("substance")) {
    if (const auto s = parse_substance(value["substance"], body.sheet.substance); !s) return s;
  }
  if (!value.has("joints")) return Done{};
  auto joints = parse_joints(value["joints"]);
  if (!joints) return joints.error();
  body.joints = std::move(*joints);
  return Done{};
}

Status parse_bodies(const JsonValue& value, const std::filesystem::path& folder, SceneDescription& scene) {
  if (const auto array = value.array("bodies"); !array) return array;
  if (value.json().empty()) return value.wrong("must hold one body or more");
  for (size_t i = 0; i < value.json().size(); ++i) {
    auto body = parse_scene_body(value[i], folder);
    if (!body) return body.error();
    scene.bodies.push_back(std::move(*body));
  }
  return Done{};
}

Result<Paint> paint_of(const JsonValue& value) {
  if (const auto object = value.object(); !object) return object.error();
  Paint paint;
  if (value.has("colour")) {
    const auto c = colour(value["colour"]);
    if (!c) return c.error();
    paint.colour = *c;
  }
  if (value.has("gloss")) {
    const auto gloss = value["gloss"].number();
    if (!gloss) return gloss.error();
    if (*gloss < 0 || *gloss > 1) return value["gloss"].wrong("must be between 0 and 1");
    paint.gloss = *gloss;
  }
  return paint;
}

Status parse_view(const JsonValue& value, SceneDescription& scene) {
  if (const auto object = value.object(); !object) return object;
  if (!value.has("eye") || !value.has("target")) return value.wrong("needs \"eye\" and \"target\"");
  const auto eye = value["eye"].vector(), target = value["target"].vector();
  if (!eye) return eye.error();
  if (!target) return target.error();
  if (*eye == *target) return value.wrong("eye and target must differ");
  scene.view = View{*eye, *target};
  return Done{};
}

Status parse_light(const JsonValue& value, Light& light) {
  if (const auto object = value.object(); !object) return object;
  const bool point = value.has("position");
  if (point == value.has("direction"))
    return value.wrong("needs \"direction\" or \"position\", and not both");
  const JsonValue place = value[point ? "position" : "direction"];
  const auto at = place.vector();
  if (!at) return at.error();
  if (!point && *at == Vec3(0)) return place.wrong("must not be zero: it points towards the light");
  light.kind = point ? Light::Kind::kPoint : Light::Kind::kDirectional;
  light.at = *at;
  if (value.has("colour")) {
    const auto c = colour(value["colour"]);
    if (!c) return c.error();
    light.colour = *c;
  }
  if (value.has("intensity")) {
    const auto intensity = value["intensity"].positive_number();
    if (!intensity) return intensity.error();
    light.intensity = *intensity;
  }
  return Done{};
}

Status parse_scene_lights(const JsonValue& value, SceneDescription& scene) {
  auto lights = parse_lights(value);
  if (!lights) return lights.error();
  scene.lights = std::move(*lights);
  return Done{};
}

Status parse_scene_paints(const JsonValue& value, SceneDescription& scene) {
  auto paints = parse_paints(value);
  if (!paints) return paints.error();
  scene.paints = std::move(*paints);
  return Done{};
}

Status parse_show(const JsonValue& value, SceneDescription& scene) {
  if (const auto array = value.array("names"); !array) return array;
  for (size_t i = 0; i < value.json().size(); ++i) {
    const auto name = value[i].text();
    if (!name) return name.error();
    scene.show += (i > 0 ? "," : "") + *name;
  }
  return Done{};
}

Status parse_scene_strokes(const JsonValue& value, SceneDescription& scene) {
  auto strokes = parse_strokes(value);
  if (!strokes) return strokes.error();
  scene.strokes = std::move(*strokes);
  return Done{};
}

Status check_version(const JsonValue& value) {
  if (value.json() == nlohmann::json(kSceneVersion)) return Done{};
  return value.wrong("this Kerf reads version " + std::to_string(kSceneVersion) + " and no other");
}

}  // namespace

Result<SceneBody> parse_scene_body(const JsonValue& value, const std::filesystem::path& folder) {
  if (const auto object = value.object(); !object) return object.error();
  if (!value.has("mesh")) return value.wrong("needs \"mesh\"");
  const auto mesh = value["mesh"].text();
  if (!mesh) return mesh.error();
  SceneBody body;
  body.mesh = folder / *mesh;
  body.name = body.mesh.stem().string();
  if (value.has("name")) {
    const auto given = value["name"].text();
    if (!given) return given.error();
    body.name = *given;
  }
  if (value.has("hash")) {
    const auto text = value["hash"].text();
    if (!text) return text.error();
    body.hash = parse_hash(*text);
    if (!body.hash) return value["hash"].wrong("must be sixteen hexadecimal digits");
  }
  if (const auto placed = parse_placement(value, body.placement); !placed) return placed.error();
  if (const auto physics = parse_physics(value, body); !physics) return physics.error();
  body.others = without(value.json(), "mesh", "name", "hash", "position", "orientation", "thickness",
                        "density", "substance", "joints");
  return body;
}

Result<std::map<std::string, Paint>> parse_paints(const JsonValue& value) {
  if (const auto object = value.object(); !object) return object.error();
  std::map<std::string, Paint> paints;
  for (const auto& [name, json] : value.json().items()) {
    const auto paint = paint_of(value[name]);
    if (!paint) return paint.error();
    paints[name] = *paint;
  }
  return paints;
}

Result<std::vector<Light>> parse_lights(const JsonValue& value) {
  if (const auto array = value.array("lights"); !array) return array.error();
  if (value.json().size() > kMostLights)
    return value.wrong("must hold no more than " + std::to_string(kMostLights) + " lights");
  std::vector<Light> lights;
  for (size_t i = 0; i < value.json().size(); ++i) {
    if (const auto light = parse_light(value[i], lights.emplace_back()); !light) return light.error();
  }
  return lights;
}

Result<SceneDescription> parse_scene(const JsonValue& root, const std::filesystem::path& folder) {
  if (const auto object = root.object(); !object) return object.error();
  if (root.has("version")) {
    if (const auto version = check_version(root["version"]); !version) return version.error();
  }
  if (!root.has("bodies")) return root.wrong("needs \"bodies\"");
  SceneDescription scene;
  if (const auto bodies = parse_bodies(root["bodies"], folder, scene); !bodies) return bodies.error();
  struct Part {
    const char* key;
    Status (*parse)(const JsonValue&, SceneDescription&);
  };
  for (const Part& part :
       {Part{"paints", parse_scene_paints}, Part{"view", parse_view}, Part{"lights", parse_scene_lights},
        Part{"show", parse_show}, Part{"strokes", parse_scene_strokes}}) {
    if (!root.has(part.key)) continue;
    if (const auto parsed = part.parse(root[part.key], scene); !parsed) return parsed.error();
  }
  scene.others = without(root.json(), "version", "bodies", "paints", "view", "lights", "show", "strokes");
  return scene;
}

}  // namespace kerf
