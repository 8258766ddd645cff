#include "core/document/colour_text.h"
#include "core/document/hash_text.h"
#include "core/document/json_value.h"
#include "core/document/path_text.h"
#include "core/document/scene_joint_text.h"
#include "core/document/scene_text.h"
#include "core/document/substance_numbers.h"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

// Appends the unknown keys that were kept to `json`.
Json with_others(Json json, const std::string& others) {
  const Json kept = Json::parse(others, nullptr, false);
  if (kept.is_object()) json.update(kept);
  return json;
}

template <typename Items, typename ToJson>
Json list_of(const Items& items, ToJson to_json) {
  Json all = Json::array();
  for (const auto& item : items) all.push_back(to_json(item));
  return all;
}

Json substance_json(Substance substance) {
  Json json;
  for (const SubstanceNumber& constant : substance_numbers(substance)) json[constant.key] = constant.number;
  return json;
}

Json body_json(const SceneBody& body, const fs::path& folder) {
  Json json{{"mesh", path_text(body.mesh, folder)}, {"name", body.name}};
  const Placement none;
  const glm::dquat& q = body.placement.orientation;
  if (body.placement.position != none.position) json["position"] = vector_json(body.placement.position);
  if (q != none.orientation) json["orientation"] = {q.w, q.x, q.y, q.z};
  if (body.hash) json["hash"] = hash_text(*body.hash);
  if (body.sheet.thickness != Sheet{}.thickness) json["thickness"] = body.sheet.thickness;
  if (body.sheet.density != Sheet{}.density) json["density"] = body.sheet.density;
  if (body.sheet.substance != Substance{}) json["substance"] = substance_json(body.sheet.substance);
  if (!body.joints.empty()) json["joints"] = list_of(body.joints, joint_json);
  return with_others(json, body.others);
}

Json light_json(const Light& light) {
  return {{light.kind == Light::Kind::kPoint ? "position" : "direction", vector_json(light.at)},
          {"colour", colour_text(light.colour)},
          {"intensity", light.intensity}};
}

Json show_json(const std::string& show) {
  Json names = Json::array();
  for (size_t at = 0; at < show.size();) {
    const size_t comma = std::min(show.find(',', at), show.size());
    names.push_back(show.substr(at, comma - at));
    at = comma + 1;
  }
  return names;
}

}  // namespace

std::string path_text(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  fs::path whole = fs::weakly_canonical(fs::absolute(file, error), error);
  if (error) whole = file;
  if (folder.empty()) return whole.string();
  const fs::path from = fs::weakly_canonical(fs::absolute(folder, error), error);
  const fs::path relative = error ? fs::path() : whole.lexically_relative(from);
  const auto ups = std::count(relative.begin(), relative.end(), "..");
  const bool beside = ups == 0 || (ups == 1 && from.parent_path() != from.root_path());
  return relative.empty() || !beside ? whole.string() : relative.string();
}

Json scene_json(const SceneDescription& scene, const fs::path& folder) {
  Json json{{"version", kSceneVersion}};
  json["bodies"] = list_of(scene.bodies, [&](const SceneBody& body) { return body_json(body, folder); });
  for (const auto& [name, paint] : scene.paints)
    json["paints"][name] = {{"colour", colour_text(paint.colour)}, {"gloss", paint.gloss}};
  if (scene.view)
    json["view"] = {{"eye", vector_json(scene.view->eye)}, {"target", vector_json(scene.view->target)}};
  if (!scene.lights.empty()) json["lights"] = list_of(scene.lights, light_json);
  if (!scene.show.empty()) json["show"] = show_json(scene.show);
  if (!scene.strokes.empty()) json["strokes"] = list_of(scene.strokes, stroke_json);
  return with_others(json, scene.others);
}

Result<std::string> dump_json(const Json& json, int indent) {
  try {
    return json.dump(indent);
  } catch (const Json::exception&) {
    return bad_input("a name in it is not UTF-8, which JSON cannot hold: rename that file or piece");
  }
}

}  // namespace kerf
