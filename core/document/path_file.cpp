#include "core/document/path_file.h"

#include <cmath>

#include "core/base/assert.h"
#include "core/base/unit_vector.h"
#include "core/document/json_value.h"
#include "core/document/parse_strokes.h"

namespace kerf {

namespace {

Result<Vec3> direction(const JsonValue& value) {
  const auto v = value.vector();
  if (!v) return v;
  if (*v == Vec3(0)) return value.wrong("must not be zero");
  return beam_direction(*v);
}

Status parse_key(const JsonValue& key, StrokePath& stroke) {
  if (const auto object = key.object(); !object) return object;
  for (const char* name : {"t", "origin", "direction"}) {
    if (!key.has(name)) return key.wrong(std::string("needs \"") + name + "\"");
  }
  const auto t = key["t"].number();
  if (!t) return t.error();
  if (!stroke.times.empty() && !(*t > stroke.times.back())) {
    return key["t"].wrong("must be greater than the one before: keys go forward in time");
  }
  if (!stroke.times.empty() && !std::isfinite(*t - stroke.times.front()))
    return key["t"].wrong("is too far from the first one");
  const auto origin = key["origin"].vector();
  if (!origin) return origin.error();
  const auto unit = direction(key["direction"]);
  if (!unit) return unit.error();
  if (!stroke.keys.empty() && are_opposite(stroke.keys.back().direction, *unit)) {
    return key["direction"].wrong("is opposite to the one before: put a key between them");
  }
  stroke.times.push_back(*t);
  stroke.keys.push_back({*origin, *unit});
  return Done{};
}

Status parse_laser(const JsonValue& laser, StrokePath& stroke) {
  if (const auto object = laser.object(); !object) return object;
  if (laser.has("radius")) {
    const auto radius = laser["radius"].positive_number();
    if (!radius) return radius.error();
    stroke.radius = *radius;
  }
  if (laser.has("range")) {
    const auto range = laser["range"].interval();
    if (!range) return range.error();
    stroke.range = *range;
  }
  struct Key {
    const char* name;
    std::optional<double>& number;
  };
  for (const Key& key :
       {Key{"power", stroke.power}, Key{"wavelength", stroke.wavelength}, Key{"focus", stroke.focus},
        Key{"pulse_rate", stroke.pulse_rate}, Key{"duty", stroke.duty}}) {
    if (!laser.has(key.name)) continue;
    const auto number = laser[key.name].positive_number();
    if (!number) return number.error();
    key.number = *number;
  }
  if (stroke.duty && *stroke.duty > 1) return laser["duty"].wrong("must be at most 1");
  return Done{};
}

Result<StrokePath> parse_stroke(const JsonValue& value) {
  if (const auto object = value.object(); !object) return object.error();
  StrokePath stroke;
  if (value.has("laser")) {
    if (const auto laser = parse_laser(value["laser"], stroke); !laser) return laser.error();
  }
  if (!value.has("keys")) return value.wrong("needs \"keys\"");
  const JsonValue keys = value["keys"];
  if (const auto array = keys.array("keys"); !array) return array.error();
  if (keys.json().empty()) return keys.wrong("must hold one key or more");
  for (size_t i = 0; i < keys.json().size(); ++i) {
    if (const auto key = parse_key(keys[i], stroke); !key) return key.error();
  }
  return stroke;
}

}  // namespace

Vec3 beam_direction(const Vec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  KERF_ASSERT(largest > 0);
  return glm::normalize(v / largest);
}

Result<std::vector<StrokePath>> parse_strokes(const JsonValue& strokes) {
  if (const auto array = strokes.array("strokes"); !array) return array.error();
  std::vector<StrokePath> all;
  for (size_t i = 0; i < strokes.json().size(); ++i) {
    auto stroke = parse_stroke(strokes[i]);
    if (!stroke) return stroke.error();
    all.push_back(std::move(*stroke));
  }
  return all;
}

Result<std::vector<StrokePath>> read_path_file(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return parse_path(*text, file.string());
}

Result<std::vector<StrokePath>> parse_path(std::string_view text, const std::string& file) {
  const auto json = parse_json(text, file);
  if (!json) return json.error();
  const JsonValue root(*json, file);
  if (const auto object = root.object(); !object) return object.error();
  if (!root.has("strokes")) return root.wrong("needs \"strokes\"");
  return parse_strokes(root["strokes"]);
}

bool is_path_file(const std::filesystem::path& file) {
  if (file.extension() != ".json") return false;
  const auto text = read_text_file(file);
  if (!text) return false;
  const auto json = parse_json(*text, file.string());
  return json && json->is_object() && json->contains("strokes") && !json->contains("bodies");
}

}  // namespace kerf
