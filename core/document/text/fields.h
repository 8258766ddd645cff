#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/number_format.h"
#include "core/base/result.h"
#include "core/mesh/files/mesh_format.h"
#include "core/world/rigid_body.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

class Fields;

void describe(Fields& f, Pose& pose);            // "origin" and "direction", a unit vector
void describe(Fields& f, Placement& placement);  // "position" and "orientation"
// "piece": [slot, generation, label].
void piece_field(Fields& f, PieceId& piece);
// A list of [slot, generation]; not written if it is empty.
void bodies_field(Fields& f, const char* key, std::vector<BodyId>& bodies);

inline constexpr NumberField<Sheet> kThickness{
    "thickness", "thickness", &Sheet::thickness, {1e-9, 1e3, "m", true}, always_written(0.001)};
inline constexpr NumberField<Sheet> kDensity{
    "density", "density", &Sheet::density, {1e-3, 1e6, "kg/m^3", true}, always_written(7850)};

// The sheet in a command, with the constants of its material next to the others.
void describe(Fields& f, Sheet& sheet);

// The sheet in a scene, with the constants in "substance".
void scene_sheet_fields(Fields& f, Sheet& sheet);

// Returns the message about a solid body that a stroke left open, with the name of the body and the unit of
// its place: "car: ...". States that the place is in the frame of the body if that is not the world's.
// `world`: after the step.
std::string left_open_text(const LeftOpen& open, const World& world, FileUnit unit);

class JsonValue;

// Meaning of a missing key.
enum class Presence {
  kNeeded,    // an error; the key is always written
  kOptional,  // the member keeps its value; the key is always written, except that of an empty list
};
inline constexpr Presence kNeeded = Presence::kNeeded, kOptional = Presence::kOptional;

// Meaning of a missing key, which may be a value: the one that reproduces the behaviour of Kerf before the
// key existed. That value never changes, even if new documents get another default. The key is written if the
// member has another value; a key that every version wrote is always written.
template <typename T>
class Missing {
 public:
  Missing(Presence presence) : needed_(presence == kNeeded) {}     // NOLINT: reads as a word of a table
  Missing(T value) : value_(std::move(value)), written_(false) {}  // NOLINT
  Missing(T value, Presence) : value_(std::move(value)) {}         // and the key is always written

  bool needed() const { return needed_; }
  const std::optional<T>& value() const { return value_; }
  bool is_written(const T& x) const { return written_ || x != *value_; }

 private:
  bool needed_ = false;
  std::optional<T> value_;
  bool written_ = true;
};

// Format the limits of a range, "from 1e-09 to 1000 m" or "greater than zero", and the message about a number
// outside the range.
std::string limits_text(const NumberRange& range);
std::string out_of_limits(double number, const NumberRange& range);

// Constraint of a vector field; all vectors are finite.
enum class VectorRule { kAny, kUnit, kNotZero, kNearby };  // nearby: within 100 km of the origin

// The JSON object of a value while its fields are read or written. Each saved type has one table of its
// fields for both directions:
//
//   void describe(Fields& f, Paint& paint) {
//     f.coded("colour", paint.colour, parse_colour, colour_text, "must be a colour", kOptional);
//     f.number("gloss", paint.gloss, kShare, kOptional);
//   }
//
// A line has the key, the member, the constraint, and the meaning of a missing key. A table used by a single
// file is static; in an unnamed namespace, argument-dependent lookup would not find it. Reading stops at the
// first error, which read_fields() returns with the file and the JSON pointer of the wrong value. A key that
// is not in the table is an error, whose message suggests the nearest key; therefore the table must visit
// each key independently of the others (see present()). Keys are written in the order of the table.
class Fields {
 public:
  // State shared by the fields of a file.
  struct Pass {
    const std::filesystem::path& folder;  // of the file, to which its paths are relative
    Status status = Done{};
  };
  // Reads from `in`, which must outlive the fields; fails if it is no object.
  Fields(const JsonValue& in, Pass& pass);
  // Writes to `out`.
  Fields(nlohmann::ordered_json& out, Pass& pass) : out_(&out), pass_(pass) {}

  bool reading() const { return in_ != nullptr; }
  const std::filesystem::path& folder() const { return pass_.folder; }
  // When reading, returns true if the key is in the file; when writing, returns `written`. For fields that
  // depend on others.
  bool present(const char* key, bool written);

  void number(const char* key, double& x, const NumberRange& range, const Missing<double>& missing = kNeeded);
  void number(const char* key, std::optional<double>& x, const NumberRange& range);
  template <typename Whole>
  void whole(const char* key, Whole& n, uint64_t least, uint64_t most,
             const Missing<uint64_t>& missing = kNeeded) {
    uint64_t number = static_cast<uint64_t>(n);
    whole_number(key, number, least, most, missing);
    n = static_cast<Whole>(number);
  }
  void flag(const char* key, bool& flag, const Missing<bool>& missing = kNeeded);
  // An enumerator, stored as the name at its index in `names`.
  template <typename Enum>
  void choice(const char* key, Enum& x, std::span<const char* const> names,
              const std::type_identity_t<std::optional<Enum>>& missing = std::nullopt) {
    uint64_t number = static_cast<uint64_t>(x);
    one_of(key, number, names, missing ? Missing(static_cast<uint64_t>(*missing)) : kNeeded);
    x = static_cast<Enum>(number);
  }
  void text(const char* key, std::string& text, const Missing<std::string>& missing = kNeeded);
  void filled_text(const char* key, std::string& text, const Missing<std::string>& missing = kNeeded);
  // A file, named as in path_text(); not empty.
  void path(const char* key, std::filesystem::path& path, Presence presence = kNeeded);
  void vector(const char* key, Vec3& v, VectorRule rule = VectorRule::kAny,
              const Missing<Vec3>& missing = kNeeded);
  void orientation(const char* key, glm::dquat& turn, const Missing<glm::dquat>& missing = kNeeded);
  // Two numbers, 0 <= first <= second.
  void interval(const char* key, Interval& range, const NumberRange& within = kFinite,
                Presence presence = kNeeded);
  void interval(const char* key, std::optional<Interval>& range);
  // An angle, or two ascending ones, in degrees in the file and radians in memory.
  void angle(const char* key, double& radians, const NumberRange& degrees, Presence presence);
  void angles(const char* key, Interval& radians, const NumberRange& degrees, Presence presence);

  // A value stored as text; `wrong` is the error message for a text that cannot be parsed.
  template <typename T, typename Text>
  void coded(const char* key, T& x, std::optional<T> (*parse)(std::string_view), Text to_text,
             const char* wrong, const Missing<T>& missing = kNeeded) {
    if (!reading() && !missing.is_written(x)) return;
    std::string code = reading() ? "" : std::string(to_text(x));
    text(key, code, missing.needed() ? kNeeded : kOptional);
    if (!reading() || !good()) return;
    const std::optional<T> parsed = has(key) ? parse(code) : missing.value();
    if (parsed) x = *parsed;
    check(parsed || !has(key), key, wrong);
  }
  template <typename T, typename Text>
  void coded(const char* key, std::optional<T>& x, std::optional<T> (*parse)(std::string_view), Text to_text,
             const char* wrong) {
    if (present(key, x.has_value())) coded(key, reading() ? x.emplace() : *x, parse, to_text, wrong);
  }
  void value(const char* key, const std::function<Status(const JsonValue&)>& read,
             const std::function<nlohmann::ordered_json()>& write, Presence presence = kNeeded);

  // An object whose fields `visit` describes, or the table of its type.
  void member(const char* key, Presence presence, const std::function<void(Fields&)>& visit);
  template <typename T>
  void object(const char* key, T& x, Presence presence = kNeeded) {
    member(key, presence, [&](Fields& f) { describe(f, x); });
  }
  template <typename T>
  void object(const char* key, std::optional<T>& x) {
    if (present(key, x.has_value())) object(key, reading() ? x.emplace() : *x);
  }
  // A list of objects with the table of their type; errors call the elements `of_what`.
  template <typename T>
  void list(const char* key, const char* of_what, std::vector<T>& all, Presence presence = kNeeded) {
    elements(key, of_what, presence, all, [&](size_t i, Fields& f) { describe(f, all[i]); });
  }
  // A list of objects; the visit of element i can read the elements before it.
  template <typename T>
  void elements(const char* key, const char* of_what, Presence presence, std::vector<T>& all,
                const std::function<void(size_t, Fields&)>& visit) {
    each(
        key, of_what, presence, all.size(), [&](size_t size) { all.resize(size); }, visit);
  }
  template <typename T>
  void by_name(const char* key, std::map<std::string, T>& all) {
    std::vector<std::string> names;
    for (const auto& entry : all) names.push_back(entry.first);
    named(key, names, [&](const std::string& name, Fields& f) { describe(f, all[name]); });
  }

  // The version of the format of a file, 1 to `newest`. Rejects a file of a newer version with an error
  // that states this.
  void version(const char* key, uint64_t& version, uint64_t newest, Presence presence = kNeeded);
  // The keys of a journal or recording: "format", the number of its format, and "program", the version of
  // Kerf that wrote it. Rejects a file of a later format than `newest`, and one without a format, which
  // Kerf wrote before 0.2.
  void format(uint64_t newest);
  // Rejects the value of a key when reading, or the object if the key is null or missing, unless `holds`.
  void check(bool holds, const char* key, const std::string& wrong);
  // Keeps the values of these keys in a JSON object.
  void kept(std::span<const char* const> keys, std::string& json);
  // At the end of an object: rejects the keys that were not visited.
  void end();

  bool good() const { return pass_.status.ok(); }

 private:
  bool has(const char* key) const;
  bool take(const char* key, bool needed);
  void note(const Status& status) {
    if (good() && !status) pass_.status = status;
  }
  template <typename T, typename Read, typename Write>
  void field(const char* key, T& x, const Missing<T>& missing, Read read, Write write);
  void whole_number(const char* key, uint64_t& n, uint64_t least, uint64_t most,
                    const Missing<uint64_t>& missing);
  void one_of(const char* key, uint64_t& number, std::span<const char* const> names,
              const Missing<uint64_t>& missing);
  void each(const char* key, const char* of_what, Presence presence, size_t size,
            const std::function<void(size_t)>& resize, const std::function<void(size_t, Fields&)>& visit);
  void named(const char* key, const std::vector<std::string>& names,
             const std::function<void(const std::string&, Fields&)>& visit);

  const JsonValue* in_ = nullptr;
  nlohmann::ordered_json* out_ = nullptr;
  Pass& pass_;
  std::vector<std::string> keys_;  // visited while reading
};

// Reads the fields of a value. `folder` is the folder of the file.
template <typename T>
Status read_fields(const JsonValue& value, const std::filesystem::path& folder, T& x) {
  Fields::Pass pass{folder};
  Fields fields(value, pass);
  describe(fields, x);
  fields.end();
  return pass.status;
}

// Reads a JSON text, or a file. `where` is the name of the text in errors.
Status read_text_fields(std::string_view text, const std::string& where, const std::filesystem::path& folder,
                        const std::function<void(Fields&)>& visit);
Status read_file_fields(const std::filesystem::path& file, const std::function<void(Fields&)>& visit);
template <typename T>
Result<T> read_described(const std::filesystem::path& file, T x = {}) {
  const Status status = read_file_fields(file, [&](Fields& f) { describe(f, x); });
  if (!status) return status.error();
  return x;
}

// Returns the JSON of a value for a file in `folder`.
nlohmann::ordered_json visited_json(const std::filesystem::path& folder,
                                    const std::function<void(Fields&)>& visit);
template <typename T, typename Json = nlohmann::ordered_json>
Json fields_json(T x, const std::filesystem::path& folder) {
  return visited_json(folder, [&](Fields& f) { describe(f, x); });
}

}  // namespace kerf
