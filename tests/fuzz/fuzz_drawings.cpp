#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/document/job_files.h"

namespace kerf::fuzz {
namespace {

void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "kerf: broken: %s\n", what.c_str());
  std::abort();
}

void check_error(const Error& error) {
  require(!error.message.empty(), "an error without a sentence");
  require(error.message.find_first_of("\r\n") == std::string::npos, "an error of several lines");
  require(error.code == ErrorCode::kBadInput, "an error that is not of the input: " + error.message);
}

// Each stroke of a file is accepted as a path file.
void check_strokes(const std::vector<StrokePath>& strokes) {
  if (strokes.empty()) return;
  const auto back = read_path_text(path_file_text(strokes), "strokes");
  require(back.ok(), "a path that is not read back: " + (back ? "" : back.error().message));
  require(back->size() == strokes.size(), "strokes lost in a path");
}

void check_program(const std::vector<StrokePath>& strokes) {
  const auto text = strokes_gcode(strokes, std::nullopt);
  if (!text) return check_error(text.error());
  const auto back = read_gcode(*text, "program", 1e-5);
  require(back.ok(), "a program that is not read back: " + (back ? "" : back.error().message));
  require(back->strokes.size() == strokes.size(), "strokes lost in a program");
}

void check_compensation(const Drawing& drawing) {
  size_t points = 0;
  for (const DrawnLine& line : drawing.lines) points += line.points.size();
  if (points > 2000) return;
  const auto made = make_toolpath(drawing.lines, {PathSide::kLeft, 1e-4, 1e-3, 2, 1e-4});
  if (!made) return check_error(made.error());
  for (const DrawnLine& stroke : made->strokes) require(stroke.points.size() > 1, "a stroke of one point");
}

void check(std::string_view text, JobFile::Kind kind) {
  const auto job = read_job_text(text, "file", kind, 1e-4);
  if (!job) return check_error(job.error());
  const JobPlane plane = *plane_onto("-y");
  std::vector<StrokePath> strokes = job->path;
  if (kind == JobFile::Kind::kProgram) strokes = program_strokes(job->program, plane, 1000);
  if (job->is_drawing()) {
    for (const DrawnLine& line : job->drawing.lines) require(line.points.size() > 1, "a line of one point");
    strokes = drawing_strokes(job->drawing.lines, job->drawing.middle, plane);
    check_compensation(job->drawing);
  }
  check_strokes(strokes);
  if (kind == JobFile::Kind::kProgram) check_program(strokes);
}

}  // namespace
}  // namespace kerf::fuzz

// The first byte selects the kind of file.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {  // NOLINT: libFuzzer's name
  using Kind = kerf::JobFile::Kind;
  constexpr std::array<Kind, 3> kKinds{Kind::kSvg, Kind::kDxf, Kind::kProgram};
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
  kerf::fuzz::check(text, kKinds[static_cast<uint8_t>(data[0] - '0') % kKinds.size()]);
  return 0;
}
