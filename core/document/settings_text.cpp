#include "core/document/settings_text.h"

#include <span>

#include "core/document/exact_number.h"

namespace kerf {

namespace {

constexpr std::array kPatterns{"volume", "rays4"};
constexpr std::array kSchemes{"one-to-four", "longest-edge"};
constexpr std::array kRules{"target-edge", "tolerance", "depth"};
constexpr std::array kRims{"faces", "smooth"};
constexpr std::array kModels{"geometric", "thermal"};

void add_number(std::string& text, const char* key, double x) {
  text += std::string(",\"") + key + "\":";
  append_number(text, x);
}

void add_name(std::string& text, const char* key, const char* name) {
  text += std::string(",\"") + key + "\":\"" + name + '"';
}

Status take_number(const JsonValue& value, double& number) {
  const auto n = value.positive_number();
  if (!n) return n.error();
  number = *n;
  return Done{};
}

Status take_share(const JsonValue& value, double& share) {
  if (const Status taken = take_number(value, share); !taken) return taken;
  return share <= 1 ? Status(Done{}) : value.wrong("must be at most 1");
}

template <typename Choice>
Status take_name(const JsonValue& value, std::span<const char* const> names, Choice& choice) {
  const auto text = value.text();
  if (!text) return text.error();
  for (size_t i = 0; i < names.size(); ++i) {
    if (*text != names[i]) continue;
    choice = static_cast<Choice>(i);
    return Done{};
  }
  std::string all;
  for (const char* name : names) all += (all.empty() ? "" : ", ") + std::string(name);
  return value.wrong("is none of " + all);
}

template <typename Number>
Status take_whole(const JsonValue& value, int64_t low, int64_t high, Number& number) {
  const std::string range = std::to_string(low) + " to " + std::to_string(high);
  if (!value.json().is_number_integer()) return value.wrong("must be a whole number from " + range);
  const auto n = value.json().get<int64_t>();
  if (n < low || n > high) return value.wrong("must be from " + range);
  number = static_cast<Number>(n);
  return Done{};
}

Status take_key(const std::string& key, const JsonValue& value, CutSettings& s) {
  if (key == "radius") return take_number(value, s.laser.radius);
  if (key == "range") {
    const auto range = value.interval();
    if (!range) return range.error();
    s.laser.range = *range;
    return Done{};
  }
  if (key == "pattern") return take_name(value, kPatterns, s.laser.pattern);
  if (key == "power") return take_number(value, s.laser.power);
  if (key == "model") return take_name(value, kModels, s.model);
  if (key == "heat-width") return take_number(value, s.heat_width);
  if (key == "wavelength") return take_number(value, s.laser.wavelength);
  if (key == "focus") return take_number(value, s.laser.focus.emplace());
  if (key == "pulse-rate") return take_number(value, s.laser.pulse_rate);
  if (key == "duty") return take_share(value, s.laser.duty);
  if (key == "scheme") return take_name(value, kSchemes, s.resolution.scheme);
  if (key == "rule") return take_name(value, kRules, s.resolution.rule);
  if (key == "target-edge") return take_number(value, s.resolution.target_edge);
  if (key == "tolerance") return take_number(value, s.resolution.tolerance);
  if (key == "depth") return take_whole(value, 0, Resolution::kLargestDepth, s.resolution.depth);
  if (key == "rim") return take_name(value, kRims, s.resolution.rim);
  if (key == "most-faces") return take_whole(value, 1, int64_t{1} << 32, s.most_faces);
  return value.wrong("is not a setting that this version has");
}

// What differs from the defaults.
void add_heat(std::string& text, const CutSettings& s) {
  if (s.model != Model::kGeometric) add_name(text, "model", kModels[static_cast<size_t>(s.model)]);
  if (s.heat_width > 0) add_number(text, "heat-width", s.heat_width);
  if (s.laser.wavelength > 0) add_number(text, "wavelength", s.laser.wavelength);
  if (s.laser.focus) add_number(text, "focus", *s.laser.focus);
  if (s.laser.pulse_rate > 0) add_number(text, "pulse-rate", s.laser.pulse_rate);
  if (s.laser.duty < 1) add_number(text, "duty", s.laser.duty);
}

}  // namespace

std::string settings_text(const CutSettings& s) {
  std::string text = "{\"radius\":";
  append_number(text, s.laser.radius);
  text += ",\"range\":[";
  append_number(text, s.laser.range.low);
  text += ',';
  append_number(text, s.laser.range.high);
  text += ']';
  add_name(text, "pattern", kPatterns[static_cast<size_t>(s.laser.pattern)]);
  add_number(text, "power", s.laser.power);
  add_name(text, "scheme", kSchemes[static_cast<size_t>(s.resolution.scheme)]);
  add_name(text, "rule", kRules[static_cast<size_t>(s.resolution.rule)]);
  add_number(text, "target-edge", s.resolution.target_edge);
  add_number(text, "tolerance", s.resolution.tolerance);
  text += ",\"depth\":" + std::to_string(s.resolution.depth);
  add_name(text, "rim", kRims[static_cast<size_t>(s.resolution.rim)]);
  add_heat(text, s);
  if (s.most_faces != CutSettings().most_faces) text += ",\"most-faces\":" + std::to_string(s.most_faces);
  return text + '}';
}

Result<CutSettings> parse_settings(const JsonValue& value) {
  if (const auto object = value.object(); !object) return object.error();
  CutSettings settings;
  for (const auto& item : value.json().items()) {
    if (const auto s = take_key(item.key(), value[item.key()], settings); !s) return s.error();
  }
  for (const char* key : {"radius", "range", "pattern", "power", "scheme", "rule", "target-edge", "tolerance",
                          "depth", "rim"}) {
    if (!value.has(key)) return value.wrong(std::string("needs \"") + key + "\"");
  }
  return settings;
}

}  // namespace kerf
