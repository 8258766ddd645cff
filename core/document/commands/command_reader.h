#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "core/base/ids.h"
#include "core/cut/cut_step.h"
#include "core/document/beam_at.h"
#include "core/document/json_value.h"
#include "core/world/placement.h"

namespace kerf {

// Reads the keys of a command from its line in a journal, as CommandWriter writes them; numbers come back to
// the bit. Precondition of each function but has(): the line has the keys that it reads. Values that make no
// sense are bad input with a JSON pointer.
class CommandReader {
 public:
  // `folder` is the folder of the journal; `beam` says where the beam of the last stroke is, if there was
  // one.
  CommandReader(const JsonValue& line, const std::filesystem::path& folder, const std::optional<BeamAt>& beam)
      : line_(line), folder_(folder), beam_(beam) {}

  // Whether the line has an optional key.
  bool has(const char* key) const { return line_.has(key); }
  Result<CutSettings> settings() const;
  Result<Pose> pose() const;  // with a unit direction
  // A pose that the beam can move to from where it is: its direction is not opposite.
  Result<Pose> next_pose() const;
  // "t", not before the time of the beam; 0 where the line does not have it.
  Result<double> time() const;
  Result<PieceId> piece() const;
  Result<Placement> placement() const;
  Result<std::filesystem::path> mesh() const;
  Result<std::string> text(const char* key) const { return line_[key].text(); }
  Result<uint64_t> whole_number(const char* key, uint64_t least, uint64_t most) const;
  Result<double> number(const char* key) const { return line_[key].number(); }
  Result<double> positive_number(const char* key) const;
  Result<double> number_within(const char* key, double least, double most) const;
  Result<Vec3> point(const char* key) const { return line_[key].vector(); }
  Result<bool> flag(const char* key) const;
  // Which of these names the text is.
  Result<size_t> choice(const char* key, std::span<const char* const> names) const;

 private:
  const JsonValue& line_;
  const std::filesystem::path& folder_;
  const std::optional<BeamAt>& beam_;
};

}  // namespace kerf
