#include "core/document/text/fields.h"

#include <algorithm>
#include <cmath>

#include "core/base/deterministic_math.h"
#include "core/base/json.h"
#include "core/base/version.h"
#include "core/document/text/json.h"

namespace kerf {

namespace {

Status read_piece(const JsonValue& value, PieceId& piece) {
  const auto n = value.whole_numbers({3});
  if (!n) return value.wrong("must be three whole numbers: a body's slot, its generation and a label");
  piece = {{n->front(), (*n)[1]}, n->back()};
  return Done{};
}

Status read_bodies(const JsonValue& value, std::vector<BodyId>& bodies) {
  if (const Status list = value.array("bodies"); !list) return list;
  bodies.clear();
  for (size_t i = 0; i < value.json().size(); ++i) {
    const auto numbers = value[i].whole_numbers({2});
    if (!numbers) return value[i].wrong("must be [slot, generation]");
    bodies.push_back({(*numbers)[0], (*numbers)[1]});
  }
  return Done{};
}

nlohmann::ordered_json piece_json(const PieceId& piece) {
  return {piece.body.slot, piece.body.generation, piece.label};
}

// `always`: the meaning of a missing key that every version wrote.
template <typename Owner>
void number_field(Fields& f, const NumberField<Owner>& field, Owner& owner, const Missing<double>& always) {
  f.number(field.key, owner.*field.member, field.range,
           field.missing.always_written ? always : Missing<double>(field.missing.value));
}

using Json = nlohmann::ordered_json;

constexpr double kFarthest = 1e5;  // m

std::string number_text(double x) { return general_text(x, 10); }

std::string span_text(const NumberRange& range) {
  return "from " + number_text(range.least) + " to " + number_text(range.most) + (*range.unit ? " " : "") +
         range.unit;
}

Result<double> number_within(const JsonValue& value, const NumberRange& range) {
  const auto number = value.number();
  if (!number || range.contains(*number)) return number;
  return value.wrong(out_of_limits(*number, range));
}

Result<uint64_t> whole_within(const JsonValue& value, uint64_t least, uint64_t most) {
  const nlohmann::json& json = value.json();
  const double number = json.is_number_float() ? json.get<double>() : -1;
  const bool whole = number >= 0 && number <= 1e15 && std::floor(number) == number;
  if (json.is_number_unsigned() || whole) {
    const uint64_t n = whole ? static_cast<uint64_t>(number) : json.get<uint64_t>();
    if (n >= least && n <= most) return n;
  }
  return value.wrong("must be a whole number from " + std::to_string(least) + " to " + std::to_string(most));
}

Result<Vec3> vector_by(const JsonValue& value, VectorRule rule) {
  const auto v = value.vector();
  if (!v) return v;
  if (rule == VectorRule::kUnit && !is_unit_length2(glm::dot(*v, *v)))
    return value.wrong("must have length 1");
  if (rule == VectorRule::kNotZero && *v == Vec3(0)) return value.wrong("must not be zero");
  if (rule == VectorRule::kNearby && !(glm::length(*v) < kFarthest))
    return value.wrong("is more than 100000 m from the origin");
  return v;
}

Result<Interval> ascending_angles(const JsonValue& value, const NumberRange& degrees) {
  const auto two = value.pair();
  if (!two) return two.error();
  if (two->low > two->high || !degrees.contains(two->low) || !degrees.contains(two->high))
    return value.wrong("must be two angles in degrees, ascending, " + span_text(degrees));
  return Interval{radians_of(two->low), radians_of(two->high)};
}

// "a", "b" or "c"
std::string list_text(std::span<const char* const> names) {
  std::string all;
  for (size_t i = 0; i < names.size(); ++i)
    all += (i == 0 ? "\"" : i + 1 == names.size() ? " or \"" : ", \"") + std::string(names[i]) + '"';
  return all;
}

Result<uint64_t> index_of(const JsonValue& value, std::span<const char* const> names) {
  const auto text = value.text();
  if (!text) return text.error();
  const auto found = std::find(names.begin(), names.end(), *text);
  if (found == names.end()) return value.wrong("must be " + list_text(names));
  return static_cast<uint64_t>(found - names.begin());
}

constexpr auto kAsItIs = [](const auto& x) { return x; };

}  // namespace

void describe(Fields& f, Pose& pose) {
  f.vector("origin", pose.origin);
  f.vector("direction", pose.direction, VectorRule::kUnit);
}

void describe(Fields& f, Placement& placement) {
  f.vector("position", placement.position);
  f.orientation("orientation", placement.orientation);
}

void piece_field(Fields& f, PieceId& piece) {
  f.value(
      "piece", [&](const JsonValue& value) { return read_piece(value, piece); },
      [&] { return piece_json(piece); });
}

void bodies_field(Fields& f, const char* key, std::vector<BodyId>& bodies) {
  if (!f.present(key, !bodies.empty())) return;
  f.value(
      key, [&](const JsonValue& value) { return read_bodies(value, bodies); },
      [&] {
        Json list = Json::array();
        for (const BodyId& id : bodies) list.push_back({id.slot, id.generation});
        return list;
      });
}

static void describe(Fields& f, Substance& substance) {
  if (f.reading()) substance = substance_without_keys();
  for (const auto& field : kSubstanceFields) number_field(f, field, substance, kOptional);
}

void describe(Fields& f, Sheet& sheet) {
  number_field(f, kThickness, sheet, kNeeded);
  number_field(f, kDensity, sheet, kNeeded);
  for (const auto& field : kSubstanceFields) number_field(f, field, sheet.substance, kNeeded);
}

void scene_sheet_fields(Fields& f, Sheet& sheet) {
  number_field(f, kThickness, sheet, kThickness.missing.value);
  number_field(f, kDensity, sheet, kDensity.missing.value);
  if (f.reading()) sheet.substance = Substance();
  if (f.present("substance", sheet.substance != Substance())) f.object("substance", sheet.substance);
}

std::string left_open_text(const LeftOpen& open, const World& world, FileUnit unit) {
  const Body* body = world.contains(open.body) ? &world.body(open.body) : nullptr;
  const bool is_placed = body != nullptr && body->placement != Placement();
  return (body != nullptr ? body->own_name() + ": " : "") + open.why + " " + std::string(unit_symbol(unit)) +
         (is_placed ? " in the frame of the body" : "");
}

std::string limits_text(const NumberRange& range) {
  if (range.least == kFinite.least && range.most == kFinite.most) return "any number";
  if (range.least == kPositive.least && range.most == kPositive.most) return "greater than zero";
  if (range.least == kPositiveShare.least) return "greater than zero, at most " + number_text(range.most);
  return span_text(range);
}

std::string out_of_limits(double number, const NumberRange& range) {
  if (!std::isfinite(number)) return "must be a finite number";
  if (range.positive && number <= 0) return "must be greater than zero";
  if (range.least == 0 && range.most == kFinite.most) return "must not be negative";
  if (range.least == kPositiveShare.least) return "must be at most " + number_text(range.most);
  return "must be " + span_text(range);
}

Fields::Fields(const JsonValue& in, Pass& pass) : in_(&in), pass_(pass) { note(in.object()); }

bool Fields::has(const char* key) const { return in_->has(key); }

bool Fields::take(const char* key, bool needed) {
  keys_.push_back(key);
  if (!good()) return false;
  const bool there = has(key);
  if (!there && needed) note(in_->wrong("needs \"" + std::string(key) + "\""));
  return there;
}

bool Fields::present(const char* key, bool written) { return reading() ? take(key, false) : written; }

template <typename T, typename Read, typename Write>
void Fields::field(const char* key, T& x, const Missing<T>& missing, Read read, Write write) {
  if (!reading()) {
    if (missing.is_written(x)) (*out_)[key] = write(x);
  } else if (take(key, missing.needed())) {
    note(assign(std::invoke(read, (*in_)[key]), x));
  } else if (missing.value()) {
    x = *missing.value();
  }
}

void Fields::number(const char* key, double& x, const NumberRange& range, const Missing<double>& missing) {
  field(
      key, x, missing, [&](const JsonValue& value) { return number_within(value, range); }, kAsItIs);
}

void Fields::number(const char* key, std::optional<double>& x, const NumberRange& range) {
  if (present(key, x.has_value())) number(key, reading() ? x.emplace() : *x, range);
}

void Fields::whole_number(const char* key, uint64_t& n, uint64_t least, uint64_t most,
                          const Missing<uint64_t>& missing) {
  field(
      key, n, missing, [&](const JsonValue& value) { return whole_within(value, least, most); }, kAsItIs);
}

void Fields::one_of(const char* key, uint64_t& number, std::span<const char* const> names,
                    const Missing<uint64_t>& missing) {
  field(
      key, number, missing, [&](const JsonValue& value) { return index_of(value, names); },
      [&](uint64_t i) { return names[i]; });
}

void Fields::flag(const char* key, bool& flag, const Missing<bool>& missing) {
  field(key, flag, missing, &JsonValue::flag, kAsItIs);
}

void Fields::text(const char* key, std::string& text, const Missing<std::string>& missing) {
  field(key, text, missing, &JsonValue::text, kAsItIs);
}

void Fields::filled_text(const char* key, std::string& text, const Missing<std::string>& missing) {
  this->text(key, text, missing);
  check(!text.empty() || !reading() || !has(key), key, "must not be empty");
}

void Fields::path(const char* key, std::filesystem::path& path, Presence presence) {
  std::string name = reading() ? "" : path_text(path, pass_.folder);
  filled_text(key, name, presence);
  if (reading() && !name.empty()) path = pass_.folder / name;
}

void Fields::vector(const char* key, Vec3& v, VectorRule rule, const Missing<Vec3>& missing) {
  field(
      key, v, missing, [&](const JsonValue& value) { return vector_by(value, rule); }, vector_json);
}

void Fields::orientation(const char* key, glm::dquat& turn, const Missing<glm::dquat>& missing) {
  field(key, turn, missing, &JsonValue::orientation, [](const glm::dquat& q) {
    return Json{q.w, q.x, q.y, q.z};
  });
}

void Fields::interval(const char* key, Interval& range, const NumberRange& within, Presence presence) {
  value(
      key,
      [&](const JsonValue& value) -> Status {
        if (const Status read = assign(value.interval(), range); !read) return read;
        const bool inside = within.contains(range.low) && within.contains(range.high);
        return inside ? Status(Done{}) : value.wrong("must be " + span_text(within));
      },
      [&] {
        return Json{range.low, range.high};
      },
      presence);
}

void Fields::interval(const char* key, std::optional<Interval>& range) {
  if (present(key, range.has_value())) interval(key, reading() ? range.emplace() : *range);
}

void Fields::angle(const char* key, double& radians, const NumberRange& degrees, Presence presence) {
  double angle = degrees_of(radians);
  number(key, angle, degrees, presence);
  if (reading()) radians = radians_of(angle);
}

void Fields::angles(const char* key, Interval& radians, const NumberRange& degrees, Presence presence) {
  value(
      key, [&](const JsonValue& value) { return assign(ascending_angles(value, degrees), radians); },
      [&] {
        return Json{degrees_of(radians.low), degrees_of(radians.high)};
      },
      presence);
}

void Fields::value(const char* key, const std::function<Status(const JsonValue&)>& read,
                   const std::function<Json()>& write, Presence presence) {
  if (!reading()) {
    (*out_)[key] = write();
  } else if (take(key, presence == kNeeded)) {
    note(read((*in_)[key]));
  }
}

void Fields::member(const char* key, Presence presence, const std::function<void(Fields&)>& visit) {
  if (!reading()) {
    Json& out = (*out_)[key] = Json::object();
    Fields fields(out, pass_);
    visit(fields);
  } else if (take(key, presence == kNeeded)) {
    const JsonValue value = (*in_)[key];
    Fields fields(value, pass_);
    visit(fields);
    fields.end();
  }
}

void Fields::each(const char* key, const char* of_what, Presence presence, size_t size,
                  const std::function<void(size_t)>& resize,
                  const std::function<void(size_t, Fields&)>& visit) {
  if (!reading()) {
    if (size == 0 && presence == kOptional) return;
    Json& list = (*out_)[key] = Json::array();
    for (size_t i = 0; i < size; ++i) {
      Fields fields(list.emplace_back(Json::object()), pass_);
      visit(i, fields);
    }
  } else if (take(key, presence == kNeeded)) {
    const JsonValue list = (*in_)[key];
    note(list.array(of_what));
    if (good()) resize(list.json().size());
    for (size_t i = 0; good() && i < list.json().size(); ++i) {
      const JsonValue element = list[i];
      Fields fields(element, pass_);
      visit(i, fields);
      fields.end();
    }
  }
}

void Fields::named(const char* key, const std::vector<std::string>& names,
                   const std::function<void(const std::string&, Fields&)>& visit) {
  if (!reading()) {
    for (const std::string& name : names) {
      Fields fields((*out_)[key][name] = Json::object(), pass_);
      visit(name, fields);
    }
  } else if (take(key, false)) {
    const JsonValue objects = (*in_)[key];
    note(objects.object());
    if (!good()) return;
    for (const auto& item : objects.json().items()) {
      const JsonValue object = objects[item.key()];
      Fields fields(object, pass_);
      if (good()) visit(item.key(), fields);
      fields.end();
    }
  }
}

void Fields::version(const char* key, uint64_t& version, uint64_t newest, Presence presence) {
  value(
      key,
      [&](const JsonValue& value) -> Status {
        if (value.json().is_number_unsigned() && value.json() > newest)
          return value.wrong("the file is of a newer version of Kerf: this one reads version " +
                             std::to_string(newest));
        return assign(whole_within(value, 1, newest), version);
      },
      [&] { return Json(version); }, presence);
}

void Fields::format(uint64_t newest) {
  check(
      present("format", true), nullptr,
      "the file was made before Kerf 0.2, in a format that is no longer read: open it with the version that "
      "made it");
  uint64_t format = newest;
  version("format", format, newest);
  std::string program = kVersion;
  text("program", program);
}

void Fields::check(bool holds, const char* key, const std::string& wrong) {
  if (!reading() || !good() || holds) return;
  note((key != nullptr && has(key) ? (*in_)[key] : *in_).wrong(wrong));
}

void Fields::kept(std::span<const char* const> keys, std::string& json) {
  if (!reading()) {
    const Json entries = Json::parse(json, nullptr, false);
    if (entries.is_object()) out_->update(entries);
    return;
  }
  nlohmann::json entries = nlohmann::json::object();
  for (const char* const key : keys) {
    if (take(key, false)) entries[key] = (*in_)[key].json();
  }
  if (good()) json = entries.dump();
}

void Fields::end() {
  if (!reading() || !good()) return;
  for (const auto& item : in_->json().items()) {
    if (std::find(keys_.begin(), keys_.end(), item.key()) != keys_.end()) continue;
    return note((*in_)[item.key()].wrong("is not a valid key here in this version" +
                                         nearest_name_hint(item.key(), keys_)));
  }
}

Status read_text_fields(std::string_view text, const std::string& where, const std::filesystem::path& folder,
                        const std::function<void(Fields&)>& visit) {
  const auto json = parse_json(text, where);
  if (!json) return json.error();
  if (const Status unique = check_unique_keys(text, where); !unique) return unique;
  const JsonValue root(*json, where);
  Fields::Pass pass{folder};
  Fields fields(root, pass);
  visit(fields);
  fields.end();
  return pass.status;
}

Status read_file_fields(const std::filesystem::path& file, const std::function<void(Fields&)>& visit) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return read_text_fields(*text, file.string(), file.parent_path(), visit);
}

Json visited_json(const std::filesystem::path& folder, const std::function<void(Fields&)>& visit) {
  Json json = Json::object();
  Fields::Pass pass{folder};
  Fields fields(json, pass);
  visit(fields);
  return json;
}

}  // namespace kerf
