#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/interval.h"
#include "core/base/result.h"
#include "core/base/vec3.h"

namespace kerf {

// A value inside a JSON file together with where it stands, so that what is wrong with it can be said in one
// sentence: "scene.json: /strokes/0/keys/2/direction: must be three numbers".
class JsonValue {
 public:
  JsonValue(const nlohmann::json& value, std::string file, std::string pointer = "")
      : value_(&value), file_(std::move(file)), pointer_(std::move(pointer)) {}

  const nlohmann::json& json() const { return *value_; }
  const std::string& file() const { return file_; }
  bool has(const std::string& key) const { return value_->is_object() && value_->contains(key); }
  // The member or element; it must be there.
  JsonValue operator[](const std::string& key) const { return {(*value_)[key], file_, pointer_ + "/" + key}; }
  JsonValue operator[](size_t i) const { return {(*value_)[i], file_, pointer_ + "/" + std::to_string(i)}; }

  Error wrong(const std::string& what) const {
    return bad_input(file_ + ": " + (pointer_.empty() ? "" : pointer_ + ": ") + what);
  }

  Result<double> number() const;  // finite
  Result<double> positive_number() const;
  Result<Vec3> vector() const;        // three finite numbers
  Result<Interval> interval() const;  // two finite numbers, the first not above the second
  Result<std::string> text() const;
  Status array(const char* of_what) const;
  Status object() const;

 private:
  const nlohmann::json* value_;
  std::string file_, pointer_;
};

// Parses a whole text; a fault is one sentence with line and column.
Result<nlohmann::json> parse_json(std::string_view text, const std::string& file);

// The bytes of a regular file.
Result<std::string> read_text_file(const std::filesystem::path& file);

}  // namespace kerf
