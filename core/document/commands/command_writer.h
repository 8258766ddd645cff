#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>

#include "core/base/ids.h"
#include "core/base/result.h"
#include "core/cut/cut_step.h"
#include "core/world/placement.h"

namespace kerf {

// Writes one command as one line of a journal: {"do": NAME, ...}, without the line's end. Each function
// appends a key with its value; numbers are exact.
class CommandWriter {
 public:
  // `folder` is the folder of the journal (see path_text).
  CommandWriter(const char* name, const std::filesystem::path& folder);

  void settings(const CutSettings& settings);  // "settings"
  void pose(const Pose& pose);                 // "origin" and "direction"
  void piece(const PieceId& piece);            // "piece"
  void placement(const Placement& placement);  // "position" and "orientation"
  void point(const char* key, const Vec3& point);
  void mesh(const std::filesystem::path& file);
  void text(const char* key, const std::string& value);
  void number(const char* key, double value);
  void whole_number(const char* key, uint64_t value);
  void flag(const char* key, bool value);

  // The finished line; bad input where a text is not UTF-8.
  Result<std::string> end() const;

 private:
  void key(const char* name);
  void numbers(const char* key, std::initializer_list<double> values);

  const std::filesystem::path& folder_;
  std::string line_;
  Status status_ = Done{};
};

}  // namespace kerf
