#include "core/document/commands/command_writer.h"

#include "core/document/exact_number.h"
#include "core/document/scene_text.h"
#include "core/document/settings_text.h"

namespace kerf {

CommandWriter::CommandWriter(const char* name, const std::filesystem::path& folder) : folder_(folder) {
  line_ = std::string("{\"do\":\"") + name + '"';
}

void CommandWriter::key(const char* name) { line_ += std::string(",\"") + name + "\":"; }

void CommandWriter::numbers(const char* name, std::initializer_list<double> values) {
  key(name);
  char before = '[';
  for (const double x : values) {
    line_ += before;
    append_number(line_, x);
    before = ',';
  }
  line_ += ']';
}

void CommandWriter::settings(const CutSettings& settings) {
  key("settings");
  line_ += settings_text(settings);
}

void CommandWriter::pose(const Pose& pose) {
  numbers("origin", {pose.origin.x, pose.origin.y, pose.origin.z});
  numbers("direction", {pose.direction.x, pose.direction.y, pose.direction.z});
}

void CommandWriter::piece(const PieceId& piece) {
  key("piece");
  line_ += '[' + std::to_string(piece.body.slot) + ',';
  if (piece.body.generation != BodyId::kUnknownGeneration)
    line_ += std::to_string(piece.body.generation) + ',';
  line_ += std::to_string(piece.label) + ']';
}

void CommandWriter::placement(const Placement& placement) {
  numbers("position", {placement.position.x, placement.position.y, placement.position.z});
  const glm::dquat& q = placement.orientation;
  numbers("orientation", {q.w, q.x, q.y, q.z});
}

void CommandWriter::point(const char* name, const Vec3& point) { numbers(name, {point.x, point.y, point.z}); }

void CommandWriter::mesh(const std::filesystem::path& file) { text("mesh", path_text(file, folder_)); }

void CommandWriter::text(const char* name, const std::string& value) {
  const auto quoted = dump_json(nlohmann::ordered_json(value));
  if (!quoted) {
    status_ = quoted.error();
    return;
  }
  key(name);
  line_ += *quoted;
}

void CommandWriter::number(const char* name, double value) {
  key(name);
  append_number(line_, value);
}

void CommandWriter::whole_number(const char* name, uint64_t value) {
  key(name);
  line_ += std::to_string(value);
}

void CommandWriter::flag(const char* name, bool value) {
  key(name);
  line_ += value ? "true" : "false";
}

Result<std::string> CommandWriter::end() const {
  if (!status_) return status_.error();
  return line_ + '}';
}

}  // namespace kerf
