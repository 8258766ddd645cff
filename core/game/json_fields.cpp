#include "core/game/json_fields.h"

#include "core/game/angle.h"

namespace kerf {

namespace {

std::string number_text(double x) {
  const auto whole = static_cast<long long>(x);
  return static_cast<double>(whole) == x ? std::to_string(whole) : std::to_string(x);
}

}  // namespace

bool JsonFields::has(const char* key, bool required) {
  if (!status_) return false;
  const bool there = object_.has(key);
  if (!there && required) note(object_.wrong("needs \"" + std::string(key) + "\""));
  return there;
}

JsonFields& JsonFields::text(const char* key, std::string& out, bool required) {
  if (!has(key, required)) return *this;
  const auto text = object_[key].text();
  if (!text) {
    note(text.error());
  } else if (text->empty()) {
    note(object_[key].wrong("must not be empty"));
  } else {
    out = *text;
  }
  return *this;
}

JsonFields& JsonFields::vector(const char* key, Vec3& out, bool required) {
  if (!has(key, required)) return *this;
  const auto v = object_[key].vector();
  if (!v) {
    note(v.error());
  } else if (!(glm::length(*v) < 1e5)) {
    note(object_[key].wrong("is farther than 100000 m away"));
  } else {
    out = *v;
  }
  return *this;
}

JsonFields& JsonFields::number(const char* key, double& out, Interval allowed, bool required) {
  if (!has(key, required)) return *this;
  const auto n = object_[key].number();
  if (!n) {
    note(n.error());
  } else if (*n < allowed.low || *n > allowed.high) {
    note(object_[key].wrong("must be from " + number_text(allowed.low) + " to " + number_text(allowed.high)));
  } else {
    out = *n;
  }
  return *this;
}

JsonFields& JsonFields::count(const char* key, size_t& out, size_t least, size_t most, bool required) {
  double n = static_cast<double>(out);
  number(key, n, {static_cast<double>(least), static_cast<double>(most)}, required);
  if (!status_) return *this;
  const auto whole = static_cast<size_t>(n);
  if (static_cast<double>(whole) != n) {
    note(object_[key].wrong("must be a whole number"));
  } else {
    out = whole;
  }
  return *this;
}

JsonFields& JsonFields::flag(const char* key, bool& out) {
  if (!has(key, false)) return *this;
  const nlohmann::json& json = object_[key].json();
  if (json.is_boolean()) {
    out = json.get<bool>();
  } else {
    note(object_[key].wrong("must be true or false"));
  }
  return *this;
}

JsonFields& JsonFields::angles(const char* key, Interval& out, Interval allowed) {
  if (!has(key, false)) return *this;
  const JsonValue pair = object_[key];
  const bool two = pair.json().is_array() && pair.json().size() == 2;
  const auto low = two ? pair[size_t{0}].number() : Result<double>(pair.wrong("must be two numbers"));
  const auto high = two ? pair[size_t{1}].number() : low;
  if (!low) {
    note(low.error());
  } else if (!high) {
    note(high.error());
  } else if (*low > *high || *low < allowed.low || *high > allowed.high) {
    note(pair.wrong("must be two angles in degrees, ascending, from " + number_text(allowed.low) + " to " +
                    number_text(allowed.high)));
  } else {
    out = {radians_of(*low), radians_of(*high)};
  }
  return *this;
}

}  // namespace kerf
