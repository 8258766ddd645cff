#include "ui/render/passes/face_numbers.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <tuple>

#include "core/base/assert.h"
#include "ui/render/bodies/piece_looks.h"
#include "ui/render/passes/surface_overlays.h"

namespace kerf {

namespace {

constexpr int kCell = 2;         // pixels of the occupancy grid
constexpr float kMargin = 3;     // pixels between numbers
constexpr float kWithin = 0.6f;  // fraction of a number's box that must be within its face

float cross(const glm::vec2& a, const glm::vec2& b) { return a.x * b.y - a.y * b.x; }

bool contains(const std::array<glm::vec2, 3>& t, const glm::vec2& p) {
  const float area = cross(t[1] - t[0], t[2] - t[0]);
  for (size_t i = 0; i < 3; ++i) {
    if (cross(t[(i + 1) % 3] - t[i], p - t[i]) * area < 0) return false;
  }
  return area != 0;
}

bool holds(const LabelCandidate& face, const glm::vec2& size) {
  const glm::vec2 middle = face.middle(), half = size * (0.5f * kWithin);
  for (int i = 0; i < 4; ++i) {
    const glm::vec2 corner(i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y);
    if (!contains(face.corners, middle + corner)) return false;
  }
  return true;
}

// An occupancy grid of the numbers in the frame.
class TakenPlaces {
 public:
  explicit TakenPlaces(glm::ivec2 picture)
      : size_(picture / kCell + 1), taken_(static_cast<size_t>(size_.x) * static_cast<size_t>(size_.y)) {}

  // Occupies the box if it is free. Returns false otherwise.
  bool take(const glm::vec2& low, const glm::vec2& high) {
    const glm::ivec2 from = glm::clamp(glm::ivec2(low) / kCell, glm::ivec2(0), size_ - 1);
    const glm::ivec2 to = glm::clamp(glm::ivec2(high) / kCell, glm::ivec2(0), size_ - 1);
    for (int y = from.y; y <= to.y; ++y) {
      for (int x = from.x; x <= to.x; ++x) {
        if (taken_[place(x, y)]) return false;
      }
    }
    for (int y = from.y; y <= to.y; ++y) {
      for (int x = from.x; x <= to.x; ++x) taken_[place(x, y)] = true;
    }
    return true;
  }

 private:
  size_t place(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(size_.x) + static_cast<size_t>(x);
  }
  glm::ivec2 size_;
  std::vector<bool> taken_;
};

}  // namespace

std::vector<FaceLabel> place_labels(std::vector<LabelCandidate> candidates, glm::ivec2 picture,
                                    const DigitShape& digit,
                                    const std::function<bool(const LabelCandidate&)>& seen) {
  const auto size_of = [&](const LabelCandidate& c) {
    return glm::vec2(static_cast<float>(std::to_string(c.face.index).size()) * digit.width, digit.height);
  };
  std::erase_if(candidates, [&](const LabelCandidate& c) { return !holds(c, size_of(c)); });
  std::sort(candidates.begin(), candidates.end(), [](const LabelCandidate& a, const LabelCandidate& b) {
    return std::tie(a.depth, a.body, a.face) < std::tie(b.depth, b.body, b.face);
  });
  std::vector<FaceLabel> labels;
  TakenPlaces places(picture);
  for (const LabelCandidate& c : candidates) {
    const glm::vec2 size = size_of(c), low = glm::floor(c.middle() - 0.5f * size), high = low + size;
    if (low.x < 0 || low.y < 0 || high.x >= static_cast<float>(picture.x) ||
        high.y >= static_cast<float>(picture.y)) {
      continue;
    }
    if (!seen(c) || !places.take(low - kMargin, high + kMargin)) continue;
    labels.push_back({c.face.index, c.removed, low, size});
  }
  return labels;
}

namespace {

// The ten digits as bitmaps made for this program, rows from the top.
constexpr int kDigitWidth = 5, kDigitHeight = 8;
constexpr std::array<std::array<std::string_view, kDigitHeight>, 10> kDigits{{
    {" ### ", "#   #", "#   #", "#   #", "#   #", "#   #", "#   #", " ### "},
    {"  #  ", " ##  ", "# #  ", "  #  ", "  #  ", "  #  ", "  #  ", "#####"},
    {" ### ", "#   #", "    #", "    #", "  ## ", " #   ", "#    ", "#####"},
    {" ### ", "#   #", "    #", "  ## ", "    #", "    #", "#   #", " ### "},
    {"   # ", "  ## ", " # # ", "#  # ", "#  # ", "#####", "   # ", "   # "},
    {"#####", "#    ", "#    ", "#### ", "    #", "    #", "#   #", " ### "},
    {" ### ", "#   #", "#    ", "#### ", "#   #", "#   #", "#   #", " ### "},
    {"#####", "    #", "    #", "   # ", "   # ", "  #  ", "  #  ", "  #  "},
    {" ### ", "#   #", "#   #", " ### ", "#   #", "#   #", "#   #", " ### "},
    {" ### ", "#   #", "#   #", "#   #", " ####", "    #", "#   #", " ### "},
}};

constexpr int kCellWidth = kDigitWidth + 2, kCellHeight = kDigitHeight + 2;  // with a border
constexpr int kAdvance = kDigitWidth + 1;
constexpr int kHeightOfOneZoom = 1000;  // pixels of a frame with unscaled digits

// The visible faces of all bodies, live and removed.
class Candidates {
 public:
  Candidates(const Subject& subject, const FrameUniforms& frame)
      : subject_(subject),
        clip_(frame.clip_from_frame),
        half_(0.5f * glm::vec2(frame.viewport.x, frame.viewport.y)) {
    int number = 0;
    for_each_body(subject, [&](BodyId id, const Body& body, const BodyPicture& picture) {
      body_ = (number++ % 127) + 1;
      const glm::mat4 from_body = subject.space.from_body(body.placement, picture.faces().frame());
      add_live(id, body, picture.faces().frame(), from_body);
      for (const RemovedFace& f : picture.faces().removed(body.mesh)) {
        add({f.face, f.base, body_, true, {}, 0}, f.corners, from_body, glm::vec3(0));
      }
    });
  }
  std::vector<LabelCandidate> take() { return std::move(all_); }

 private:
  void add_live(BodyId id, const Body& body, const FloatFrame& frame, const glm::mat4& from_body) {
    const BodyLooks looks(id, subject_.options);
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (!body.mesh.is_live(FaceId(f))) continue;
      const FaceData& data = body.mesh.data(FaceId(f));
      const PieceLook& look = looks.of(body.mesh, FaceId(f));
      if (look.hidden) continue;
      const glm::vec3 offset(subject_.space.turned(look.offset) / subject_.space.unit);
      const Triangle t = body.mesh.triangle(FaceId(f));
      add({FaceId(f), data.base, body_, false, {}, 0},
          {frame.to_float(t[0]), frame.to_float(t[1]), frame.to_float(t[2])}, from_body, offset);
    }
  }
  void add(LabelCandidate c, const FaceCorners& corners, const glm::mat4& from_body,
           const glm::vec3& offset) {
    for (size_t i = 0; i < 3; ++i) {
      const glm::vec3 at = glm::vec3(from_body * glm::vec4(corners[i], 1)) + offset;
      const glm::vec4 p = clip_ * glm::vec4(at, 1);
      if (!(p.w > 0)) return;
      c.corners[i] = (glm::vec2(p) / p.w + 1.0f) * half_;
      c.depth += p.z;
    }
    all_.push_back(c);
  }

  const Subject& subject_;
  glm::mat4 clip_;
  glm::vec2 half_;
  int body_ = 0;
  std::vector<LabelCandidate> all_;
};

// Returns true if the ID buffer contains this face at its middle, which is in the frame.
bool shows(const std::vector<uint8_t>& which, int width, const LabelCandidate& c) {
  const glm::ivec2 p(c.middle());
  const size_t at = 4 * (static_cast<size_t>(p.y) * static_cast<size_t>(width) + static_cast<size_t>(p.x));
  KERF_ASSERT(p.x >= 0 && p.x < width && p.y >= 0 && at + 3 < which.size());
  const uint8_t* mark = &which[at];
  const uint32_t slot = mark[0] | static_cast<uint32_t>(mark[1]) << 8 | static_cast<uint32_t>(mark[2]) << 16;
  return slot == ((c.removed ? c.base : c.face).index & 0xffffffu) &&
         mark[3] == (c.body | (c.removed ? 128 : 0));
}

}  // namespace

FaceNumbers::FaceNumbers(Shaders& shaders)
    : faces_(shaders.load({{"frame.glsl", "placed.glsl", "faces.vert"}, {"mark.frag"}})),
      removed_(shaders.load({{"frame.glsl", "veil.vert"}, {"mark.frag"}})),
      numbers_(shaders.load({{"frame.glsl", "number.vert"}, {"number.frag"}})) {
  make_bitmaps();
}

void FaceNumbers::make_bitmaps() {
  constexpr size_t kRow = 10 * kCellWidth;
  std::vector<uint8_t> pixels(kRow * kCellHeight);
  for (size_t d = 0; d < kDigits.size(); ++d) {
    for (size_t y = 0; y < kDigitHeight; ++y) {
      for (size_t x = 0; x < kDigitWidth; ++x) {
        const size_t row = kDigitHeight - y;  // from below, over the border
        if (kDigits[d][y][x] == '#') pixels[row * kRow + d * kCellWidth + x + 1] = 255;
      }
    }
  }
  glBindTexture(GL_TEXTURE_2D, bitmaps_.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, kRow, kCellHeight, 0, GL_RED, GL_UNSIGNED_BYTE, pixels.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

std::vector<uint8_t> FaceNumbers::look_which(const Subject& subject, int width, int height) {
  const gl::Framebuffer::Shape shape{width, height, 1, true};
  if (!which_ || !(which_->shape() == shape)) which_.emplace(shape);
  which_->bind();
  draw_marked_faces(subject, faces_);
  removed_.use();
  draw_removed(subject, removed_, {});
  std::vector<uint8_t> marks(4 * static_cast<size_t>(width) * static_cast<size_t>(height));
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, marks.data());
  return marks;
}

void FaceNumbers::draw(const Subject& subject, const FrameUniforms& frame, const gl::Framebuffer& picture) {
  const int w = picture.shape().width, h = picture.shape().height;
  const std::vector<uint8_t> which = look_which(subject, w, h);
  const double of_screen = 1 + h / kHeightOfOneZoom;
  const int zoom = static_cast<int>(std::lround(subject.options.mark_scale * of_screen));
  const auto scaled = [&](int pixels) { return static_cast<float>(pixels * zoom); };
  const std::vector<FaceLabel> labels =
      place_labels(Candidates(subject, frame).take(), {w, h}, {scaled(kAdvance), scaled(kDigitHeight)},
                   [&](const LabelCandidate& c) { return shows(which, w, c); });
  picture.bind();
  draw_labels(labels, zoom);
}

void FaceNumbers::draw_labels(const std::vector<FaceLabel>& labels, int zoom) {
  std::vector<Glyph> glyphs;
  for (const FaceLabel& label : labels) {
    glm::vec2 at = label.at - static_cast<float>(zoom);
    for (const char digit : std::to_string(label.number)) {
      glyphs.push_back({at, {static_cast<float>(digit - '0'), label.removed ? 1.0f : 0.0f}});
      at.x += static_cast<float>(kAdvance * zoom);
    }
  }
  if (glyphs.empty()) return;
  glyphs_.send(glyphs);
  const gl::ScopedState state({.depth = GL_NONE, .blend = gl::kOver});
  numbers_.use();
  numbers_.set_texture("digits", 0, bitmaps_.name());
  numbers_.set("zoom", static_cast<float>(zoom));
  numbers_.set("cell", glm::vec4(kCellWidth, kCellHeight, 0, 0));
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, glyphs_.count());
}

}  // namespace kerf
