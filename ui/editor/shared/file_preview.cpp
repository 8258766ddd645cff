#include "ui/editor/shared/file_preview.h"

#include <imgui.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <new>
#include <sstream>

#include "core/base/assert.h"
#include "core/document/job_files.h"
#include "core/document/journal.h"
#include "core/document/scene.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/weld.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/window/number_text.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace fs = std::filesystem;

namespace {

constexpr size_t kHeaderBytes = 1 << 16;
constexpr int kSamples = 2;  // of a pixel, along each side
constexpr int kColumns = kSamples * Thumbnails::kWidth, kRows = kSamples * Thumbnails::kHeight;
constexpr double kPictureMargin = 0.06;  // of the width and height, on each side
constexpr uint32_t kBetweenReports = 4096;

// Picture
// --------------------------------------------------------------------------------------------------------

using Colour = std::array<double, 3>;
struct PictureColours {
  Colour stage, face;
};
PictureColours colours_of(Theme theme) {
  if (theme == Theme::kLight) return {{222, 226, 231}, {138, 155, 176}};
  return {{33, 38, 46}, {158, 176, 198}};
}

// An image of triangles with a depth buffer, in an orthographic view.
class Raster {
 public:
  Raster(UpAxis up, const PictureColours& colours) : up_(up), colours_(colours) {
    const Vec3 towards = glm::normalize(Vec3(0.55, 0.45, 0.85));
    axes_[2] = towards;
    axes_[0] = glm::normalize(glm::cross(Vec3(0, 1, 0), towards));
    axes_[1] = glm::cross(towards, axes_[0]);
  }

  void include(const Vec3& point) {
    const Vec3 p = seen(point);
    if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))) return;
    low_ = glm::min(low_, p);
    high_ = glm::max(high_, p);
  }
  // Called after the points of all triangles are included.
  void begin() {
    const double inner = 1 - 2 * kPictureMargin;
    const Vec2 size(std::max(high_.x - low_.x, 1e-300), std::max(high_.y - low_.y, 1e-300));
    scale_ = std::min(inner * kColumns / size.x, inner * kRows / size.y);
    pixels_.width = kColumns;
    pixels_.height = kRows;
    for (int i = 0; i < kColumns * kRows; ++i)
      for (const double c : colours_.stage) pixels_.rgb.push_back(static_cast<uint8_t>(c));
    depth_.assign(static_cast<size_t>(kColumns) * kRows, -std::numeric_limits<double>::infinity());
  }
  void add(const std::array<Vec3, 3>& triangle) {
    std::array<Vec3, 3> at;
    for (size_t i = 0; i < 3; ++i) at[i] = place(triangle[i]);
    const double area = cross(Vec2(at[1] - at[0]), Vec2(at[2] - at[0]));
    if (!std::isfinite(area) || area == 0) return;
    const Vec3 low = glm::min(at[0], glm::min(at[1], at[2])), high = glm::max(at[0], glm::max(at[1], at[2]));
    const int left = first_in(low.x), right = last_in(high.x, kColumns);
    const int top = first_in(low.y), bottom = last_in(high.y, kRows);
    const Colour colour = shade(triangle);
    for (int y = top; y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) put(x, y, at, area, colour);
    }
  }
  Pixels image() const { return shrunk(pixels_, Thumbnails::kWidth, Thumbnails::kHeight); }

 private:
  static double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }
  // The pixels whose middles lie within a range.
  static int first_in(double low) { return std::max(0, static_cast<int>(std::ceil(low - 0.5))); }
  static int last_in(double high, int count) {
    return std::min(count - 1, static_cast<int>(std::floor(high - 0.5)));
  }

  Vec3 seen(const Vec3& point) const {
    const Vec3 p = to_y_up(point, up_);
    return {glm::dot(axes_[0], p), glm::dot(axes_[1], p), glm::dot(axes_[2], p)};
  }
  Vec3 place(const Vec3& point) const {
    const Vec3 p = seen(point) - 0.5 * (low_ + high_);
    return {0.5 * kColumns + scale_ * p.x, 0.5 * kRows - scale_ * p.y, p.z};
  }
  // Both sides are lit alike, because many files have no consistent orientation.
  Colour shade(const std::array<Vec3, 3>& t) const {
    const Vec3 normal = to_y_up(glm::cross(t[1] - t[0], t[2] - t[0]), up_);
    const double length = glm::length(normal);
    Vec3 facing = length > 0 ? normal / length : axes_[2];
    if (glm::dot(facing, axes_[2]) < 0) facing = -facing;
    const double light = std::max(0.0, glm::dot(facing, glm::normalize(Vec3(0.25, 0.85, 0.45))));
    Colour colour = colours_.face;
    for (double& c : colour) c *= 0.42 + 0.58 * light;
    return colour;
  }
  void put(int x, int y, const std::array<Vec3, 3>& at, double area, const Colour& colour) {
    const Vec2 p(x + 0.5, y + 0.5);
    double depth = 0;
    for (size_t i = 0; i < 3; ++i) {
      const Vec2 from(at[(i + 1) % 3]), to(at[(i + 2) % 3]);
      const double share = cross(to - from, p - from) / area;
      if (share < 0) return;
      depth += share * at[i].z;
    }
    const size_t pixel = static_cast<size_t>(y) * kColumns + static_cast<size_t>(x);
    if (depth <= depth_[pixel]) return;
    depth_[pixel] = depth;
    for (size_t c = 0; c < 3; ++c) pixels_.rgb[3 * pixel + c] = static_cast<uint8_t>(colour[c]);
  }

  UpAxis up_;
  PictureColours colours_;
  std::array<Vec3, 3> axes_;  // right, up and towards the eye
  Vec3 low_{std::numeric_limits<double>::infinity()}, high_{-std::numeric_limits<double>::infinity()};
  double scale_ = 1;
  Pixels pixels_;
  std::vector<double> depth_;
};

// Draws triangles; `for_each` calls a function with each of them until that returns false.
template <typename ForEach>
Pixels draw_triangles(UpAxis up, Theme theme, const ForEach& for_each, const Progress& progress) {
  Raster raster(up, colours_of(theme));
  uint32_t left = kBetweenReports;
  const auto goes_on = [&] {
    if (--left > 0) return true;
    left = kBetweenReports;
    return progress.report(1);
  };
  for_each([&](const std::array<Vec3, 3>& t) {
    for (const Vec3& corner : t) raster.include(corner);
    return goes_on();
  });
  raster.begin();
  for_each([&](const std::array<Vec3, 3>& t) {
    raster.add(t);
    return goes_on();
  });
  return raster.image();
}

// Facts
// --------------------------------------------------------------------------------------------------------

void add_count(FilePreview& preview, const char* name, size_t count) {
  preview.facts.emplace_back(name, grouped(count));
}

std::string megabytes_text(uintmax_t bytes) { return grouped(static_cast<size_t>(bytes >> 20)) + " MB"; }

FileFrame frame_of(const PreviewRequest& request, MeshFormat format, const Vec3& low, const Vec3& high) {
  const auto known = request.frames.find(std::string(format_row(format).ending));
  if (known != request.frames.end() && known->second) return *known->second;
  return guess_frame(format, low, high);
}

// Counts the positions that are welded to no earlier one.
size_t distinct_positions(std::span<const uint32_t> welded) {
  size_t count = 0;
  for (size_t i = 0; i < welded.size(); ++i) count += welded[i] == i;
  return count;
}

FilePreview preview_of_mesh(const PreviewRequest& request, const Progress& progress) {
  FilePreview preview;
  const Result<Soup> soup = read_mesh(request.file, &progress);
  if (!soup) {
    preview.note = soup.error().message;
    return preview;
  }
  const MeshFormat format =
      mesh_format("." + soup->format)
          .value_or(mesh_format(request.file.extension().string()).value_or(MeshFormat::kObj));
  add_count(preview, "Faces", soup->triangles.size());
  const Result<std::vector<uint32_t>> welded = weld_positions(soup->positions, &progress);
  if (!welded) return preview;
  add_count(preview, "Vertices", distinct_positions(*welded));
  if (soup->material_names.size() > 1) add_count(preview, "Materials", soup->material_names.size());
  Vec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vec3& p : soup->positions) {
    if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))) continue;
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  if (!(low.x <= high.x)) return preview;
  const FileFrame frame = frame_of(request, format, low, high);
  preview.facts.emplace_back("Size", extents_label(high - low, frame.unit));
  const auto for_each = [&](const auto& use) {
    for (const Soup::Triangle& t : soup->triangles) {
      if (!use({soup->positions[t[0]], soup->positions[t[1]], soup->positions[t[2]]})) return;
    }
  };
  preview.picture = draw_triangles(frame.up, request.theme, for_each, progress);
  return preview;
}

FilePreview preview_of_scene(const PreviewRequest& request, const Progress& progress) {
  FilePreview preview;
  const auto description = read_description(request.file);
  if (!description) {
    preview.note = description.error().message;
    return preview;
  }
  add_count(preview, "Bodies", description->bodies.size());
  if (!description->strokes.empty()) add_count(preview, "Strokes", description->strokes.size());
  uintmax_t bytes = 0;
  for (const SceneBody& body : description->bodies) {
    std::error_code error;
    const uintmax_t size = fs::file_size(body.mesh, error);
    bytes += error ? 0 : size;
  }
  if (bytes > kMaxPreviewBytes) {
    preview.note = "Meshes of " + megabytes_text(bytes) + " are too large for a preview.";
    return preview;
  }
  const Result<Scene> scene = load_scene(*description, &progress);
  if (!scene) {
    preview.note = scene.error().message;
    return preview;
  }
  const World& world = scene->world;
  add_count(preview, "Faces", world.live_faces());
  const World::Bounds bounds = world.loaded_bounds();
  const FileFrame frame = select_frame(*description, false, bounds, Settings()).frame;
  preview.facts.emplace_back("Size", extents_label(bounds.max - bounds.min, frame.unit));
  const auto for_each = [&](const auto& use) {
    for (const BodyId id : world.ids()) {
      const Body& body = world.body(id);
      for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
        if (!body.mesh.is_live(FaceId(f))) continue;
        const Triangle t = body.mesh.triangle(FaceId(f));
        const auto placed = [&](size_t i) { return body.placement.to_world(t[i]); };
        if (!use({placed(0), placed(1), placed(2)})) return;
      }
    }
  };
  preview.picture = draw_triangles(frame.up, request.theme, for_each, progress);
  return preview;
}

FilePreview preview_of_journal(const PreviewRequest& request) {
  FilePreview preview;
  const auto journal = read_journal(request.file);
  if (!journal) {
    preview.note = journal.error().message;
    return preview;
  }
  const auto strokes = std::ranges::count_if(
      journal->commands, [](const Command& c) { return std::holds_alternative<BeginStroke>(c); });
  add_count(preview, "Bodies", journal->scene.bodies.size());
  add_count(preview, "Strokes", static_cast<size_t>(strokes));
  add_count(preview, "Commands", journal->commands.size());
  preview.note = journal->damage;
  return preview;
}

FilePreview preview_of_job(const fs::path& file, JobFile::Kind kind) {
  constexpr double kTolerance = 1e-3;  // m, of curves, which are only counted
  FilePreview preview;
  const Result<JobFile> job = read_job(file, kind, kTolerance);
  if (!job) {
    preview.note = job.error().message;
  } else if (job->is_drawing()) {
    add_count(preview, "Lines", job->drawing.lines.size());
  } else {
    add_count(preview, "Strokes",
              kind == JobFile::Kind::kPath ? job->path.size() : job->program.strokes.size());
  }
  return preview;
}

// Header
// --------------------------------------------------------------------------------------------------------

std::string header_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string head(kHeaderBytes, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return head;
}

void add_header_counts(FilePreview& preview, const std::string& head, uintmax_t bytes) {
  constexpr size_t kStlHeader = 80, kStlFace = 50;
  if (head.starts_with("ply")) {
    std::istringstream lines(head);
    std::string line, word, element;
    for (size_t count = 0; std::getline(lines, line) && !line.starts_with("end_header");) {
      std::istringstream words(line);
      if (!(words >> word >> element >> count) || word != "element") continue;
      if (element == "face") add_count(preview, "Faces", count);
      if (element == "vertex") add_count(preview, "Vertices", count);
    }
  } else if (head.starts_with("OFF")) {
    std::istringstream words(head.substr(3));
    size_t vertices = 0, faces = 0;
    if (!(words >> vertices >> faces)) return;
    add_count(preview, "Faces", faces);
    add_count(preview, "Vertices", vertices);
  } else if (head.size() >= kStlHeader + 4) {
    uint32_t faces = 0;
    std::memcpy(&faces, head.data() + kStlHeader, sizeof faces);
    if (kStlHeader + 4 + kStlFace * uintmax_t(faces) == bytes) add_count(preview, "Faces", faces);
  }
}

FilePreview preview_of_large(const fs::path& file, uintmax_t bytes) {
  FilePreview preview;
  add_header_counts(preview, header_of(file), bytes);
  preview.note = "A file of " + megabytes_text(bytes) + " is too large for a preview.";
  return preview;
}

}  // namespace

FilePreview preview_of(const PreviewRequest& request, const Progress& progress) {
  std::error_code error;
  const uintmax_t bytes = fs::file_size(request.file, error);
  if (error) return {.note = request.file.string() + ": cannot read this file: " + error.message()};
  try {
    if (bytes > kMaxPreviewBytes) return preview_of_large(request.file, bytes);
    if (is_journal(request.file)) return preview_of_journal(request);
    const auto job = job_kind(request.file);
    if (job && (*job != JobFile::Kind::kPath || is_path_file(request.file)))
      return preview_of_job(request.file, *job);
    if (request.file.extension() == ".json") return preview_of_scene(request, progress);
    return preview_of_mesh(request, progress);
  } catch (const std::bad_alloc&) {
    return {.note = "There is not enough memory for a preview."};
  }
}

FilePreviewer::~FilePreviewer() {
  if (job_) job_->cancelled = true;
}

void FilePreviewer::select(const std::optional<PreviewRequest>& request) {
  if (selected_ == request) return;
  selected_ = request;
  shown_.reset();
  is_sent_ = false;
  if (job_) {
    job_->cancelled = true;
  } else {
    start();
  }
}

void FilePreviewer::start() {
  KERF_ASSERT(!job_);
  if (!selected_) return;
  job_ = std::make_unique<Job>();
  job_->request = *selected_;
  job_->result = std::async(std::launch::async, [job = job_.get()] {
    return preview_of(job->request, {[job](double) { return !job->cancelled; }});
  });
}

void FilePreviewer::update(double seconds) {
  while (job_ && job_->result.wait_for(std::chrono::duration<double>(seconds)) == std::future_status::ready) {
    const std::unique_ptr<Job> done = std::move(job_);
    FilePreview preview = done->result.get();
    if (!done->cancelled) {
      shown_ = std::move(preview);
      return;
    }
    start();
  }
}

TipPicture FilePreviewer::picture() {
  KERF_ASSERT(shown_);
  if (!texture_) texture_.emplace();
  if (!std::exchange(is_sent_, true)) send_picture(shown_->picture, *texture_);
  return {texture_->name(), {shown_->picture.width, shown_->picture.height}};
}

void FilePreviewer::draw(const std::optional<TipPicture>& thumbnail) {
  if (!selected_) return ImGui::TextDisabled("No file selected");
  const bool has_picture = shown_ && !shown_->picture.rgb.empty();
  const std::optional<TipPicture> image = has_picture ? picture() : thumbnail;
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 size(width, width * Thumbnails::kHeight / Thumbnails::kWidth);
  if (image) {
    ImGui::Image(to_im_texture(image->texture), size);
    mark_last_item("preview image");
  } else if (!shown_) {
    ImGui::Dummy(size);
  }
  ImGui::TextWrapped("%s", selected_->file.filename().string().c_str());
  if (!shown_) return ImGui::TextDisabled("Reading...");
  for (const auto& [name, value] : shown_->facts) {
    ImGui::TextDisabled("%s", name.c_str());
    ImGui::SameLine(5 * ImGui::GetFontSize());
    ImGui::TextWrapped("%s", value.c_str());
  }
  if (!shown_->note.empty()) ImGui::TextWrapped("%s", shown_->note.c_str());
}

}  // namespace kerf
