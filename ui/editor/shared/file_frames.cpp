#include "ui/editor/shared/file_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/base/assert.h"
#include "core/base/json.h"
#include "core/document/commands.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/document_session.h"
#include "ui/window/number_text.h"

namespace kerf {

namespace {

constexpr const char* kKey = "shown";  // in a scene: {"unit": "mm", "up": "z"}

bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void turn_lights(std::vector<Light>& lights, UpAxis from, UpAxis to) {
  for (Light& light : lights) light.at = from_y_up(to_y_up(light.at, from), to);
}

constexpr size_t kMaxNames = 2;

// Returns the names of the cut bodies, by descending removal.
std::string names_of(const HistoryStep& step) {
  std::vector<std::pair<std::string, size_t>> names(step.totals().cut_names.begin(),
                                                    step.totals().cut_names.end());
  if (names.empty()) return step.done() ? "nothing, " : "";
  std::stable_sort(names.begin(), names.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (size_t i = 0; i < std::min(names.size(), kMaxNames); ++i) text += names[i].first + ", ";
  if (names.size() > kMaxNames) text += std::to_string(names.size() - kMaxNames) + " more, ";
  return text;
}

// Returns the number of the stroke in the whole history, from 1.
size_t number_of(const UndoStack& history, size_t stroke) {
  size_t number = 0;
  for (size_t i = 0; i <= stroke; ++i) number += history.step(i).kind() == HistoryStep::Kind::kStroke;
  return number;
}

}  // namespace

std::string mesh_kind(const SceneDescription& scene) {
  if (scene.bodies.size() != 1) return "";
  const auto format = mesh_format(scene.bodies.front().mesh.extension().string());
  return format ? std::string(format_row(*format).ending) : "";
}

FrameChoice select_frame(const SceneDescription& scene, bool is_mesh_file, const World::Bounds& bounds,
                         const Settings& settings) {
  if (const auto noted = frame_from_json(head_entry(scene, kKey))) return {*noted};
  const std::string kind = mesh_kind(scene);
  if (!is_mesh_file || kind.empty()) return {};
  const auto known = settings.frames.find(kind);
  if (known != settings.frames.end() && known->second) return {*known->second};
  const bool sound = is_finite(bounds.min) && is_finite(bounds.max) && bounds.diagonal() > 0;
  const FileFrame guess = sound ? guess_frame(*mesh_format(kind), bounds.min, bounds.max) : FileFrame();
  // A glTF file is in metres with +Y up by its specification.
  const bool is_certain = guess.is_default() && (kind == "glb" || kind == "gltf");
  return {guess, known == settings.frames.end() && !is_certain};
}

void record_frame(SceneDescription& scene, const FileFrame& frame) {
  if (frame.is_default() && head_entry(scene, kKey).is_null()) return;
  set_head_entry(scene, kKey, frame_to_json(frame));
}

void show_in_frame(ViewState& view, const FileFrame& frame) {
  turn_lights(view.look.lights, view.camera.up_axis(), frame.up);
  view.camera.set_up_axis(frame.up);
  view.frame = frame;
  view.picture_old = true;
}

void change_frame(const FileFrame& frame, DocumentSession& session, ViewState& view) {
  turn_lights(session.saved_lights, view.camera.up_axis(), frame.up);
  show_in_frame(view, frame);
}

void set_frame(const FileFrame& frame, DocumentSession& session, ViewState& view, Settings& settings) {
  const std::string kind = mesh_kind(session.scene);
  const bool is_mesh_file = session.file.empty() && !kind.empty() && session.files.size() == 1 &&
                            mesh_format(session.files.front().extension().string()).has_value();
  if (frame != view.frame && !is_mesh_file) set_head_entry(session.scene, kKey, frame_to_json(frame));
  change_frame(frame, session, view);
  view.frame_asked_for.clear();
  if (!kind.empty()) settings.frames[kind] = frame;
}

std::string extents_label(const Vec3& size, FileUnit unit) {
  const Vec3 metres = metres_per_unit(unit) * size;
  const LengthUnit shown = unit_for(std::max({metres.x, metres.y, metres.z}));
  return text_of("%.3g x %.3g x %.3g ", metres.x / shown.metres, metres.y / shown.metres,
                 metres.z / shown.metres) +
         shown.name;
}

std::string area_label(double area, FileUnit unit) {
  const double metres = metres_per_unit(unit);
  if (unit != FileUnit::kInch || area == 0) return area_text(area * metres * metres);
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.3g in\xc2\xb2", area);
  return text.data();
}

std::string volume_label(double volume, FileUnit unit) {
  const double metres = metres_per_unit(unit);
  if (unit == FileUnit::kInch) return text_of("%.4g in\u00b3", volume);
  const double cubic = volume * metres * metres * metres;
  const LengthUnit shown = unit_for(std::cbrt(std::abs(cubic)));
  return text_of("%.4g ", cubic / (shown.metres * shown.metres * shown.metres)) + shown.name + "\u00b3";
}

std::string step_words(const UndoStack& history, size_t step, FileUnit unit) {
  KERF_ASSERT(step < history.size());
  const HistoryStep& of = history.step(step);
  if (!history.cuts(step)) return command_label(of.commands().front(), unit, of.piece_name);
  const std::string number = std::to_string(number_of(history, history.base_of(step)));
  const CutSettings& settings = history.settings_of(step);
  if (of.kind() == HistoryStep::Kind::kStroke)
    return "Cut " + number + ": " + names_of(of) + beam_label(settings.laser, unit);
  return "Recut " + number + ": " + names_of(of) + resolution_label(settings.resolution, unit);
}

}  // namespace kerf
