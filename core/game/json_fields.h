#pragma once

#include <string>
#include <vector>

#include "core/base/interval.h"
#include "core/document/json_value.h"

namespace kerf {

// Reads the members of a JSON object one after the other. Every reader leaves its target as it was if the
// member is optional and missing, and does nothing after the first error, which status() returns.
class JsonFields {
 public:
  explicit JsonFields(const JsonValue& object) : object_(object) { note(object.object()); }

  JsonFields& text(const char* key, std::string& out, bool required = false);
  JsonFields& vector(const char* key, Vec3& out, bool required = false);
  // A number within a closed range.
  JsonFields& number(const char* key, double& out, Interval allowed, bool required = false);
  // A whole number within a closed range.
  JsonFields& count(const char* key, size_t& out, size_t least, size_t most, bool required = false);
  JsonFields& flag(const char* key, bool& out);
  // Two numbers of degrees, ascending and within `allowed` (degrees); `out` is in radians.
  JsonFields& angles(const char* key, Interval& out, Interval allowed);
  // Calls read(element) for each element of a list, which returns a Status.
  template <typename Read>
  JsonFields& list(const char* key, const char* of_what, Read read, bool required = false) {
    if (!has(key, required)) return *this;
    const JsonValue list = object_[key];
    note(list.array(of_what));
    for (size_t i = 0; status_ && i < list.json().size(); ++i) note(read(list[i]));
    return *this;
  }
  // Calls read(member), which returns a Status.
  template <typename Read>
  JsonFields& member(const char* key, Read read, bool required = false) {
    if (has(key, required)) note(read(object_[key]));
    return *this;
  }

  const Status& status() const { return status_; }

 private:
  bool has(const char* key, bool required);
  void note(Status status) {
    if (status_) status_ = std::move(status);
  }

  JsonValue object_;
  Status status_ = Done{};
};

}  // namespace kerf
