#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "core/base/json.h"
#include "core/base/result.h"

namespace kerf {

// Reads or writes the persistent fields of settings. A settings type has one table of its fields, `void
// describe(KeptFields& f, X& settings)`, for both directions. Unlike Fields, a missing value or one of
// another type leaves the member unchanged, and numbers are clamped to their range, so faulty settings
// never prevent a start.
class KeptFields {
 public:
  // `json` is the object to read from or to write to; reading removes the fields from it. It must outlive
  // this object.
  enum class Way { kRead, kWrite };
  KeptFields(nlohmann::json& json, Way way) : json_(json), reads_(way == Way::kRead) {}

  bool reading() const { return reads_; }
  template <typename Number>
  KeptFields& number(const char* key, Number& x, double low, double high) {
    return any(key, x, [&](const nlohmann::json& value) {
      if (value.is_number()) x = static_cast<Number>(std::clamp(value.get<double>(), low, high));
    });
  }
  KeptFields& flag(const char* key, bool& x);
  // An enum value, stored as its name in `names`.
  template <typename Enum>
  KeptFields& choice(const char* key, Enum& x, std::span<const char* const> names) {
    return any(key, names[static_cast<size_t>(x)], [&](const nlohmann::json& value) {
      const auto at = std::find(names.begin(), names.end(), value);
      if (at != names.end()) x = static_cast<Enum>(at - names.begin());
    });
  }
  // A field of any type: `written` is its JSON, and `read` is called with the value in the file.
  KeptFields& any(const char* key, const nlohmann::json& written,
                  const std::function<void(const nlohmann::json&)>& read);
  // The rest of the object after reading: keys unknown to this version.
  const nlohmann::json& rest() const { return json_; }

 private:
  nlohmann::json& json_;
  bool reads_;
};

// Renames a file with ".bad" appended, so that it is not overwritten. Returns false if that fails.
bool set_aside(const std::filesystem::path& file);

// Reads a settings file. Returns an empty object if the file is missing or cannot be read; in the latter case
// `fault` is set to the reason. A file that cannot be read or is not a JSON object is set aside.
nlohmann::json read_kept(const std::filesystem::path& file, std::string& fault);

// Writes a settings file atomically and creates missing folders.
Status write_kept(const nlohmann::json& settings, const std::filesystem::path& file);

}  // namespace kerf
