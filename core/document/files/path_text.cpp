#include "core/document/files/path_text.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/unit_vector.h"
#include "core/document/text/fields.h"

namespace kerf {

namespace {

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

void laser_fields(Fields& f, StrokePath& stroke) {
  f.number("radius", stroke.radius, kPositive);
  f.interval("range", stroke.range);
  f.number("power", stroke.power, kPositive);
  f.number("wavelength", stroke.wavelength, kPositive);
  f.number("focus", stroke.focus, kPositive);
  f.number("pulse_rate", stroke.pulse_rate, kPositive);
  f.number("duty", stroke.duty, kPositiveShare);
}

void key_fields(Fields& f, StrokePath& stroke, size_t k) {
  stroke.times.resize(stroke.keys.size());
  const double &t = stroke.times[k], before = k > 0 ? stroke.times[k - 1] : 0;
  Pose& pose = stroke.keys[k];
  f.number("t", stroke.times[k], kFinite);
  f.check(k == 0 || t > before, "t", "must be greater than the one before: keys go forward in time");
  f.check(k == 0 || std::isfinite(t - stroke.times.front()), "t", "is too far from the first one");
  f.vector("origin", pose.origin);
  Vec3 direction = f.reading() ? pose.direction : readable_direction(pose.direction);
  f.vector("direction", direction, VectorRule::kNotZero);
  if (!f.reading()) return;
  pose.direction = beam_direction(direction);
  f.check(k == 0 || !are_opposite(stroke.keys[k - 1].direction, pose.direction), "direction",
          "is opposite to the one before: put a key between them");
}

}  // namespace

void describe(Fields& f, StrokePath& stroke) {
  f.member("laser", kOptional, [&](Fields& laser) { laser_fields(laser, stroke); });
  f.elements("keys", "keys", kNeeded, stroke.keys,
             [&](size_t k, Fields& key) { key_fields(key, stroke, k); });
  f.check(!stroke.keys.empty(), "keys", "must hold one key or more");
}

std::string path_file_text(std::span<const StrokePath> strokes) {
  std::string text = "{\"strokes\": [";
  for (size_t i = 0; i < strokes.size(); ++i) {
    const nlohmann::ordered_json stroke = fields_json(strokes[i], {});
    text += (i > 0 ? ",\n  " : "\n  ") + ("{\"laser\": " + stroke["laser"].dump()) + ", \"keys\": [";
    for (size_t k = 0; k < strokes[i].keys.size(); ++k)
      text += (k > 0 ? ",\n    " : "\n    ") + stroke["keys"][k].dump();
    text += "]}";
  }
  return text + "]}\n";
}

}  // namespace kerf
