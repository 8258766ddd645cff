#include "core/document/scene.h"

#include <cmath>

#include "core/document/json_value.h"
#include "core/document/parse_strokes.h"
#include "core/mesh/load_mesh.h"

namespace kerf {

namespace {

// Linear light from one of the 256 steps of sRGB (IEC 61966-2-1). Colours are for eyes, so pow() may differ
// between machines.
double linear(int step) {
  const double s = step / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

Result<Vec3> colour(const JsonValue& value) {
  const auto text = value.text();
  if (!text) return text.error();
  if (text->size() != 7 || (*text)[0] != '#' ||
      text->find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos) {
    return value.wrong("must be a colour like \"#3a6f8f\"");
  }
  const auto channel = [&](size_t at) { return linear(std::stoi(text->substr(at, 2), nullptr, 16)); };
  return Vec3(channel(1), channel(3), channel(5));
}

Status add_mesh(World& world, const std::filesystem::path& file, const std::string& name,
                const Progress* progress) {
  auto built = load_mesh(file, progress);
  if (!built) return built.error();
  world.add(make_body(name, std::move(*built)));
  return Done{};
}

Status parse_body(const JsonValue& value, const std::filesystem::path& folder, const Progress& progress,
                  Scene& scene) {
  if (const auto object = value.object(); !object) return object;
  if (!value.has("mesh")) return value.wrong("needs \"mesh\"");
  const auto mesh = value["mesh"].text();
  if (!mesh) return mesh.error();
  std::string name = std::filesystem::path(*mesh).stem().string();
  if (value.has("name")) {
    const auto given = value["name"].text();
    if (!given) return given.error();
    name = *given;
  }
  return add_mesh(scene.world, folder / *mesh, name, &progress);
}

Status parse_paints(const JsonValue& value, Scene& scene) {
  if (const auto object = value.object(); !object) return object;
  for (const auto& [name, json] : value.json().items()) {
    const JsonValue entry = value[name.c_str()];
    if (const auto object = entry.object(); !object) return object;
    Paint& paint = scene.paints[name];
    if (entry.has("colour")) {
      const auto c = colour(entry["colour"]);
      if (!c) return c.error();
      paint.colour = *c;
    }
    if (entry.has("gloss")) {
      const auto gloss = entry["gloss"].number();
      if (!gloss) return gloss.error();
      if (*gloss < 0 || *gloss > 1) return entry["gloss"].wrong("must be between 0 and 1");
      paint.gloss = *gloss;
    }
  }
  return Done{};
}

Status parse_view(const JsonValue& value, Scene& scene) {
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

Status parse_lights(const JsonValue& value, Scene& scene) {
  if (const auto array = value.array("lights"); !array) return array;
  if (value.json().size() > kMostLights)
    return value.wrong("must hold no more than " + std::to_string(kMostLights) + " lights");
  for (size_t i = 0; i < value.json().size(); ++i) {
    if (const auto light = parse_light(value[i], scene.lights.emplace_back()); !light) return light;
  }
  return Done{};
}

Status parse_show(const JsonValue& value, Scene& scene) {
  if (const auto array = value.array("names"); !array) return array;
  for (size_t i = 0; i < value.json().size(); ++i) {
    const auto name = value[i].text();
    if (!name) return name.error();
    scene.show += (i > 0 ? "," : "") + *name;
  }
  return Done{};
}

Result<Scene> parse_scene(const JsonValue& root, const std::filesystem::path& folder,
                          const Progress* progress) {
  if (const auto object = root.object(); !object) return object.error();
  if (!root.has("bodies")) return root.wrong("needs \"bodies\"");
  const JsonValue bodies = root["bodies"];
  if (const auto array = bodies.array("bodies"); !array) return array.error();
  if (bodies.json().empty()) return bodies.wrong("must hold one body or more");
  Scene scene;
  const double share = 1 / static_cast<double>(bodies.json().size());
  for (size_t i = 0; i < bodies.json().size(); ++i) {
    const double before = share * static_cast<double>(i);
    const Progress loading = share_of(progress, before, before + share);
    if (const auto body = parse_body(bodies[i], folder, loading, scene); !body) return body.error();
  }
  if (root.has("paints")) {
    if (const auto paints = parse_paints(root["paints"], scene); !paints) return paints.error();
  }
  if (root.has("view")) {
    if (const auto view = parse_view(root["view"], scene); !view) return view.error();
  }
  if (root.has("lights")) {
    if (const auto lights = parse_lights(root["lights"], scene); !lights) return lights.error();
  }
  if (root.has("show")) {
    if (const auto show = parse_show(root["show"], scene); !show) return show.error();
  }
  if (root.has("strokes")) {
    auto strokes = parse_strokes(root["strokes"]);
    if (!strokes) return strokes.error();
    scene.strokes = std::move(*strokes);
  }
  return scene;
}

}  // namespace

Result<Scene> read_scene(const std::filesystem::path& file, const Progress* progress) {
  if (file.extension() != ".json") {
    Scene scene;
    if (const auto added = add_mesh(scene.world, file, file.stem().string(), progress); !added)
      return added.error();
    return scene;
  }
  const auto text = read_text_file(file);
  if (!text) return text.error();
  const auto json = parse_json(*text, file.string());
  if (!json) return json.error();
  return parse_scene(JsonValue(*json, file.string()), file.parent_path(), progress);
}

}  // namespace kerf
