#pragma once

#include <filesystem>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "core/base/json.h"
#include "core/base/result.h"

namespace kerf {

// Finds the name of a list that is most similar to a misspelt name: the minimum number of letters inserted,
// deleted, replaced or swapped with the next one, ignoring case; a name that the other one begins with counts
// 1 (F. J. Damerau, A technique for computer detection and correction of spelling errors, 1964). In a tie
// returns the first name; for an empty list, an empty text. O(letters^2).
std::string nearest_name(std::string_view name, std::span<const std::string> names);

// Formats a hint for an error message: "; the nearest name is \"radius\"". Empty for an empty list.
std::string nearest_name_hint(std::string_view name, std::span<const std::string> names);

inline nlohmann::ordered_json vector_json(const Vec3& v) { return {v.x, v.y, v.z}; }

// A value in a JSON file with its position, for errors of one sentence: "scene.json:
// /strokes/0/keys/2/direction: must be three numbers". The root value must outlive it.
class JsonValue {
 public:
  JsonValue(const nlohmann::json& value, std::string file, std::string pointer = "")
      : value_(&value), file_(std::move(file)), pointer_(std::move(pointer)) {}

  const nlohmann::json& json() const { return *value_; }
  bool has(const std::string& key) const { return value_->is_object() && value_->contains(key); }
  // The member or element. Precondition: it exists.
  JsonValue operator[](const std::string& key) const {
    KERF_ASSERT(has(key));
    return {(*value_)[key], file_, pointer_ + "/" + key};
  }
  JsonValue operator[](size_t i) const {
    KERF_ASSERT(i < value_->size());
    return {(*value_)[i], file_, pointer_ + "/" + std::to_string(i)};
  }

  // Returns a bad-input error with the message "FILE: POINTER: WHAT", on one line whatever the keys are.
  Error wrong(const std::string& what) const;

  // Convert the value to a type. Fail with wrong() for any other value.
  Result<double> number() const;  // finite
  Result<double> positive_number() const;
  Result<Vec3> vector() const;             // three finite numbers
  Result<glm::dquat> orientation() const;  // four numbers w, x, y, z of length 1
  Result<Interval> pair() const;           // two finite numbers
  Result<Interval> interval() const;       // two finite numbers, 0 <= first <= second
  Result<std::string> text() const;
  Result<bool> flag() const;
  // Returns a list of indices (see kNoIndex) of one of these lengths; nullopt for any other value.
  std::optional<std::vector<uint32_t>> whole_numbers(std::initializer_list<size_t> lengths) const;
  // Checks that the value is a list, or an object. `of_what` names the elements in the error.
  Status array(const char* of_what) const;
  Status object() const;

 private:
  const nlohmann::json* value_;
  std::string file_, pointer_;
};

template <typename T, typename Target>
Status assign(const Result<T>& result, Target& target) {
  if (!result) return result.error();
  target = *result;
  return Done{};
}

// Parses a text. The error names `file` and the line.
Result<nlohmann::json> parse_json(std::string_view text, const std::string& file);

// Fails with bad input if an object has a duplicate key, of which parse_json() keeps the last one. The error
// names `file` and the line. Keys are compared as written. Precondition: parse_json() succeeds. O(n log n).
Status check_unique_keys(std::string_view text, const std::string& file);

// Reads a regular file. The error names the file.
Result<std::string> read_text_file(const std::filesystem::path& file);

// Appends the shortest decimal number that reads back as the same double, including the sign of zero. It
// always has a point or an exponent, so that JSON does not read an integer. Precondition: x is finite.
void append_number(std::string& text, double x);

// Serialises JSON. Fails if a string in it is not UTF-8.
Result<std::string> dump_json(const nlohmann::ordered_json& json, int indent = -1);

// Serialises JSON in one line, as in journals, with numbers as written by append_number().
Result<std::string> exact_text(const nlohmann::ordered_json& json);

// Returns the path of a file as stored in a file in `folder`: relative if the former is in or below the
// folder or its parent, else absolute; for an empty `folder` always absolute.
std::string path_text(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace kerf
