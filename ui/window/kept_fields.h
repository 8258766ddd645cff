#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "core/base/result.h"

namespace kerf {

// The fields of settings that a program keeps, while they are visited to read or to write them: a settings
// type has one table of its fields, `void describe(KeptFields& f, X& settings)`, which both go through.
// Unlike in Fields, a value that is missing or of another type leaves the member as it is, and numbers are
// limited to their range: settings are never a reason not to start.
class KeptFields {
 public:
  // Takes what is read out of `json`, an object, or puts what is written into it. It must outlive the fields.
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
  // The value whose number in `names` is that of its name in the file.
  template <typename Enum>
  KeptFields& choice(const char* key, Enum& x, std::span<const char* const> names) {
    return any(key, names[static_cast<size_t>(x)], [&](const nlohmann::json& value) {
      const auto at = std::find(names.begin(), names.end(), value);
      if (at != names.end()) x = static_cast<Enum>(at - names.begin());
    });
  }
  // A field of any type: `written` is its JSON, and `read` is called with the value of the file.
  KeptFields& any(const char* key, const nlohmann::json& written,
                  const std::function<void(const nlohmann::json&)>& read);
  // What is left of the file after reading: keys that this version does not know.
  const nlohmann::json& rest() const { return json_; }

 private:
  nlohmann::json& json_;
  bool reads_;
};

// Reads a file of settings. A missing file gives an empty object. One that cannot be read gives an empty
// object, too, and sets `fault` to a sentence that says why; one that is no JSON object is renamed first,
// with ".bad" appended, so that it is not lost when the settings are written.
nlohmann::json read_kept(const std::filesystem::path& file, std::string& fault);

// Writes a file of settings, whole or not at all, and creates missing folders.
Status write_kept(const nlohmann::json& settings, const std::filesystem::path& file);

}  // namespace kerf
