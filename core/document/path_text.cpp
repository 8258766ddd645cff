#include "core/document/path_text.h"

#include <nlohmann/json.hpp>

#include "core/document/json_value.h"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

// Numbers that are read back as this unit vector to the bit. To make a unit vector unit again may change its
// last bits; for one of its multiples it does not.
Vec3 readable_direction(const Vec3& unit) {
  constexpr int kTries = 4096;
  for (int i = 0; i < kTries; ++i) {
    const Vec3 multiple = unit * (2.0 * i + 1);
    if (beam_direction(multiple) == unit) return multiple;
  }
  return unit;
}

Json key_json(const StrokePath& stroke, size_t k) {
  return {{"t", stroke.times[k]},
          {"origin", vector_json(stroke.keys[k].origin)},
          {"direction", vector_json(readable_direction(stroke.keys[k].direction))}};
}

Json laser_json(const StrokePath& stroke) {
  Json laser = Json::object();
  if (stroke.radius) laser["radius"] = *stroke.radius;
  if (stroke.range) laser["range"] = {stroke.range->low, stroke.range->high};
  if (stroke.power) laser["power"] = *stroke.power;
  if (stroke.wavelength) laser["wavelength"] = *stroke.wavelength;
  if (stroke.focus) laser["focus"] = *stroke.focus;
  if (stroke.pulse_rate) laser["pulse_rate"] = *stroke.pulse_rate;
  if (stroke.duty) laser["duty"] = *stroke.duty;
  return laser;
}

}  // namespace

Json stroke_json(const StrokePath& stroke) {
  Json keys = Json::array();
  for (size_t k = 0; k < stroke.keys.size(); ++k) keys.push_back(key_json(stroke, k));
  return {{"laser", laser_json(stroke)}, {"keys", keys}};
}

std::string path_file_text(std::span<const StrokePath> strokes) {
  std::string text = "{\"strokes\": [";
  for (size_t i = 0; i < strokes.size(); ++i) {
    text += (i > 0 ? ",\n  " : "\n  ") + ("{\"laser\": " + laser_json(strokes[i]).dump()) + ", \"keys\": [";
    for (size_t k = 0; k < strokes[i].keys.size(); ++k)
      text += (k > 0 ? ",\n    " : "\n    ") + key_json(strokes[i], k).dump();
    text += "]}";
  }
  return text + "]}\n";
}

}  // namespace kerf
