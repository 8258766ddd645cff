#include "ui/editor/path/drawing_preview.h"

#include <imgui.h>
#include <algorithm>
#include <cstdio>

#include "core/document/text/json.h"
#include "ui/render/passes/beam_effects.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr double kPreviewTolerance = 1e-5;  // m, of curves
constexpr ImU32 kFrameShade = IM_COL32(10, 12, 16, 150);

// Draws a visible run of a line over the width that the beam removes, in pixels.
void draw_run(const std::vector<ImVec2>& run, ImU32 colour, double width, ImDrawList& list) {
  const auto count = static_cast<int>(run.size());
  const ImU32 band = (colour & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 70);
  if (width > 3) list.AddPolyline(run.data(), count, band, 0, static_cast<float>(width));
  list.AddPolyline(run.data(), count, kFrameShade, 0, 3.2f);
  list.AddPolyline(run.data(), count, colour, 0, 1.6f);
}

// Draws the line in runs of visible and of hidden parts, and faintly where the beam hits nothing.
void draw_projected(const ProjectedLine& line, const std::vector<char>& hidden, ImU32 colour, double radius,
                    const PrimaryViewport& picture, ImDrawList& list) {
  const ImU32 faint = (colour & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 90);
  std::vector<ImVec2> run;
  size_t begin = 0;  // index of its first point
  bool run_hidden = false;
  const auto add = [&](size_t i, const Vec2& place) {
    if (run.empty()) begin = i;
    run.push_back(to_im(place));
  };
  const auto end_run = [&] {
    if (run.size() < 2) return;
    const Vec3& middle = line.points[begin + run.size() / 2];
    const double width = 2 * radius * picture.em() / picture.metres_of_em(middle);
    if (line.on_surface && !run_hidden) return draw_run(run, colour, width, list);
    list.AddPolyline(run.data(), static_cast<int>(run.size()), faint, 0, 1.2f);
  };
  for (size_t i = 0; i < line.points.size(); ++i) {
    const auto place = picture.place_of(line.points[i]);
    if (place) add(i, *place);
    if (place && (run.size() == 1 || (hidden[i] != 0) == run_hidden)) {
      run_hidden = hidden[i] != 0;
      continue;
    }
    end_run();
    run.clear();
    if (place) add(i, *place);
    run_hidden = hidden[i] != 0;
  }
  end_run();
}

}  // namespace

Result<ImportedDrawing> import_drawing(const std::filesystem::path& file) {
  ImportedDrawing drawing;
  drawing.file = file;
  if (const Status read = unpack(read_text_file(file), drawing.text); !read) return read.error();
  auto job = read_job_text(drawing.text, file.filename().string(), *job_kind(file), kPreviewTolerance);
  if (!job) return job.error();
  drawing.job = std::move(*job);
  drawing.box = *bounds_of(drawing.job.drawing.lines);
  for (const DrawnLine& line : drawing.job.drawing.lines) {
    const auto known = std::ranges::find(drawing.layers, line.layer, &std::pair<std::string, size_t>::first);
    if (known == drawing.layers.end()) {
      drawing.layers.emplace_back(line.layer, 1);
    } else {
      ++known->second;
    }
  }
  return drawing;
}

double smallest_radius(const ImportedDrawing& drawing, const LayerTable& layers, double radius) {
  std::optional<double> smallest;
  for (const auto& [name, lines] : drawing.layers) {
    const auto found = layers.layers.find(name);
    const LayerSettings settings = found != layers.layers.end() ? found->second : LayerSettings();
    const double own = settings.radius.value_or(radius);
    if (!settings.skip) smallest = std::min(own, smallest.value_or(own));
  }
  return smallest.value_or(radius);
}

LayerTable with_speed(const ImportedDrawing& drawing, LayerTable layers, double speed) {
  for (const auto& [name, lines] : drawing.layers) {
    LayerSettings& layer = layers.layers[name];
    layer.speed = layer.speed.value_or(speed);
  }
  return layers;
}

uint32_t layer_colour(const std::string& layer) {
  unsigned rgb = 0;
  if (layer.size() != 7 || std::sscanf(layer.c_str(), "#%6x", &rgb) != 1) return colours::accent();
  const unsigned red = rgb >> 16, green = rgb >> 8 & 255, blue = rgb & 255;
  constexpr unsigned kLegible = 70'000;
  if (299 * red + 587 * green + 114 * blue < kLegible) return colours::accent();
  return IM_COL32(red, green, blue, 255);
}

void DrawingPreview::update(const ImportedDrawing& drawing, const DrawingPlacement& placement,
                            const World& world, const PrimaryViewport& picture) {
  const bool is_new = !is_valid_;
  if (is_new)
    lines_ = project_lines(drawing.job.drawing.lines, drawing.middle(), drawing.extent(), placement, world);
  is_valid_ = true;
  if (is_new || !(seen_from_ == picture.camera())) find_hidden(world, picture);
}

void DrawingPreview::find_hidden(const World& world, const PrimaryViewport& picture) {
  constexpr double kNearEnough = 0.998;  // of the depth of a point
  seen_from_ = picture.camera();
  hidden_.clear();
  for (const ProjectedLine& line : lines_) {
    std::vector<char>& own = hidden_.emplace_back();
    for (const Vec3& p : line.points) {
      const auto place = picture.place_of(p);
      if (!place) {
        own.push_back(true);
        continue;
      }
      const Pose ray = picture.ray(*place);
      const auto hit = first_hit(world, ray);
      own.push_back(hit && *hit < kNearEnough * glm::dot(p - ray.origin, ray.direction));
    }
  }
}

void DrawingPreview::draw(const ImportedDrawing& drawing, const LayerTable& layers, double radius,
                          const PrimaryViewport& picture, ImDrawList& list) const {
  for (size_t i = 0; i < lines_.size(); ++i) {
    const std::string& layer = drawing.job.drawing.lines[lines_[i].line].layer;
    const auto found = layers.layers.find(layer);
    const LayerSettings settings = found != layers.layers.end() ? found->second : LayerSettings();
    if (settings.skip) continue;
    const double own = radius > 0 ? settings.radius.value_or(radius) : 0;
    draw_projected(lines_[i], hidden_[i], layer_colour(layer), own, picture, list);
  }
}

void draw_drawing_frame(const PrimaryViewport& picture, const JobPlane& plane, Vec2 half, Vec2 pointer,
                        ImDrawList& list) {
  std::vector<ImVec2> line;
  for (const Vec2& p : drawing_frame(picture, plane, half)) line.push_back(to_im(p));
  const auto count = static_cast<int>(line.size());
  list.AddPolyline(line.data(), count, kFrameShade, ImDrawFlags_Closed, 2.6f);
  list.AddPolyline(line.data(), count, colours::kPictureSecondary, ImDrawFlags_Closed, 1.2f);
  const std::vector<DrawingHandle> handles = drawing_handles(picture, plane, half);
  const auto under = handle_under(handles, pointer);
  for (const DrawingHandle& handle : handles) {
    if (handle.places.empty()) continue;
    const ImVec2 at = to_im(handle.places.front());
    const ImU32 colour = under && under->name == handle.name ? colours::accent() : colours::kPictureText;
    if (handle.kind == DrawingHandle::Kind::kTurn) {
      list.AddCircleFilled(at, 6.5f, kFrameShade);
      list.AddCircleFilled(at, 5, colour);
      continue;
    }
    list.AddRectFilled({at.x - 5.5f, at.y - 5.5f}, {at.x + 5.5f, at.y + 5.5f}, kFrameShade);
    list.AddRectFilled({at.x - 4, at.y - 4}, {at.x + 4, at.y + 4}, colour);
  }
}

}  // namespace kerf
