#include "ui/render/passes/surface_overlays.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "core/base/assert.h"
#include "ui/render/view/colours.h"

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
      if (body.hidden) return;
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
    const BodyLooks looks(id, body, subject_.options);
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (!body.mesh.is_live(FaceId(f))) continue;
      const FaceData& data = body.mesh.data(FaceId(f));
      const PieceLook& look = looks.of(body.mesh, FaceId(f));
      if (look.hidden) continue;
      const Triangle t = body.mesh.triangle(FaceId(f));
      const FaceCorners corners{frame.to_float(t[0]), frame.to_float(t[1]), frame.to_float(t[2])};
      const LabelCandidate candidate{FaceId(f), data.base, body_, false, {}, 0};
      if (look.is_turned()) {
        add(candidate, corners, subject_.space.from_body(turned_by(look, body.placement), frame),
            glm::vec3(0));
      } else {
        add(candidate, corners, from_body,
            glm::vec3(subject_.space.turned(look.offset) / subject_.space.unit));
      }
    }
  }
  static Placement turned_by(const PieceLook& look, const Placement& placement) {
    return {look.turn * placement.position + look.offset, look.turn * placement.orientation};
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

constexpr float kBoxFade = 0.80f;         // of the opacity, from one depth of the tree to the next
constexpr float kHitFade = 0.87f;         // the same for boxes hit by the beam
constexpr float kFaintest = 0.15f;        // fainter boxes are not drawn
constexpr float kFaintestAsked = 0.10f;   // minimum for boxes of a selected depth
constexpr float kFaintestHit = 0.13f;     // minimum for boxes hit by the beam
constexpr float kOneLevel = 0.75f;        // opacity of boxes that are drawn as the only level
constexpr float kHidden = 0.16f;          // share of the opacity of lines of one level behind surfaces
constexpr float kHiddenOfMany = 0.05f;    // the same if all levels are drawn
constexpr float kUntouched = 0.6f;        // opacity of boxes not hit, relative to those hit
constexpr float kLeafFade = 0.97f;        // from one depth to the next if only leaves are drawn
constexpr float kDarkHalfWidth = 1.3f;    // pixels
constexpr float kColourHalfWidth = 0.6f;  // pixels
constexpr size_t kMaxBoxes = 3500;        // the largest on screen are drawn
constexpr int kVerticesOfBox = 12 * 6;

// Deep boxes fade, to keep the structure of the tree readable; boxes of a selected depth are at least
// faintly visible.
float opacity_of(const AabbTree::Box& box, const TreeOverlay& tree) {
  const auto depth = static_cast<float>(box.depth);
  if (tree.one_level) return box.hit || box.edited ? 1.0f : kOneLevel;
  if (tree.leaves_only) return (box.hit ? 0.9f : 0.5f) * std::max(0.4f, std::pow(kLeafFade, depth));
  if (box.hit) return std::max(kFaintestHit, std::pow(kHitFade, depth));
  float opacity = std::pow(kBoxFade, depth);
  if (opacity < kFaintest) opacity = 0;
  if (tree.deepest < TreeOverlay().deepest) opacity = std::max(kFaintestAsked, opacity);
  return kUntouched * opacity;
}

const glm::vec4 kDarkLine(0.02f, 0.025f, 0.03f, 0.55f);

// Draws each line twice: wide and dark, then thin in its colour.
void draw_twice(const gl::Program& program, const glm::mat4& from_body, int vertices, GLsizei instances,
                const glm::vec4& colour, double scale) {
  if (instances == 0) return;
  program.use();
  program.set("frame_from_body", from_body);
  for (const bool dark : {true, false}) {
    program.set("half_width", static_cast<float>(scale) * (dark ? kDarkHalfWidth : kColourHalfWidth));
    program.set("hit_colour", dark ? kDarkLine : colour);
    glDrawArraysInstanced(GL_TRIANGLES, 0, vertices, instances);
  }
}

// Sets the colours of boxes, their opacity multiplied by `share`.
void set_colours(const gl::Program& program, const BoxColours& colours, float share) {
  program.set("hit_colour", srgb(colours.hit, share));
  program.set("other_colour", srgb(colours.untouched, share));
  program.set("edited_colour", srgb(colours.edited, share));
}

constexpr float kWireHalfWidth = 0.6f, kDarkWireHalfWidth = 1.2f;  // pixels
// Edges at least this long in the frame are opaque; shorter ones fade, so that a fine wire does not hide
// the surface.
constexpr float kPlainEdge = 16, kMinOpacity = 0.12f;  // pixels
constexpr float kEdgeWithDark = 5;                     // pixels; shorter edges have no dark outline

// Returns the usual length of a part's edges in the frame at the middle of the part, in pixels of a frame
// of usual height.
float pixels_of_edge(const DrawnWire::Part& part, const glm::mat4& from_part, const FrameSpace& space,
                     const FrameUniforms& frame) {
  const glm::mat4& m = frame.clip_from_frame;
  const glm::vec4 middle = m * from_part * glm::vec4(0, 0, 0, 1);
  const float height = glm::length(glm::vec3(m[0].y, m[1].y, m[2].y)) / std::max(middle.w, 1e-6f);
  return space.length(part.mean_edge) * height * 0.5f * std::min(frame.viewport.y, 900.0f);
}

constexpr float kSectionWidth = 1.5f;  // see scaled_width

constexpr float kOutlineWidth = 1.6f;  // see scaled_width

constexpr gl::DepthOffset kBehindSurfaces{1.5f, 24};

struct Look {
  glm::vec4 fill, edge;
};
Look look_of(VeilPass::Style style) {
  if (style == VeilPass::Style::kVeil) return {{0.34f, 0.44f, 0.56f, 0.15f}, {0.42f, 0.53f, 0.66f, 0.26f}};
  return {{0.30f, 0.016f, 0.012f, 1}, {0.62f, 0.10f, 0.07f, 1}};
}

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
  const int zoom = std::max(1, static_cast<int>(std::lround(subject.options.mark_scale * of_screen)));
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

LineOverlay::LineOverlay(Shaders& shaders)
    : box_(shaders.load({{"frame.glsl", "line.glsl", "box.vert"}, {"box.frag"}})),
      stick_(shaders.load(
          {{"frame.glsl", "placed.glsl", "line.glsl", "stick.vert"}, {"box.frag"}, {"PLACED"}})) {}

void LineOverlay::gather(Gathered& lines, const Body& body, const FloatFrame& frame,
                         const ViewOptions& options, std::shared_ptr<const PieceGroups> groups) const {
  TreeOverlay tree = options.tree;
  tree.hit_only = tree.hit_only || !options.show.aabb;
  if (options.show.aabb || options.show.aabb_hit) lines.all_boxes = gather_boxes(body, frame, tree);
  if (options.show.normals) lines.sticks.send(gather_normals(body, frame, groups.get()), GL_DYNAMIC_DRAW);
  lines.shown = options.show;
  lines.tree = options.tree;
  lines.groups = std::move(groups);
}

std::vector<BoxLine> LineOverlay::gather_boxes(const Body& body, const FloatFrame& frame,
                                               const TreeOverlay& tree) const {
  std::vector<BoxLine> boxes;
  body.tree.for_each_box(body.mesh, [&](const AabbTree::Box& box) {
    if ((tree.hit_only && !box.hit) || box.depth > tree.deepest || (tree.leaves_only && !box.leaf) ||
        (tree.one_level && box.depth != tree.deepest))
      return;
    const float opacity = opacity_of(box, tree);
    if (opacity <= 0) return;
    const float kind = box.hit ? 1.0f : box.edited ? 2.0f : 0.0f;
    boxes.push_back({frame.to_float(box.min), frame.to_float(box.max), {kind, opacity}});
  });
  return boxes;
}

std::vector<LineOverlay::Stick> LineOverlay::gather_normals(const Body& body, const FloatFrame& frame,
                                                            const PieceGroups* groups) const {
  std::vector<Stick> sticks;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const Triangle t = body.mesh.triangle(FaceId(f));
    const glm::dvec3 a = frame.scaled(t[0]), b = frame.scaled(t[1]), c = frame.scaled(t[2]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double twice_area = glm::length(normal);
    if (!(twice_area > 0)) continue;
    const glm::dvec3 middle = (a + b + c) / 3.0;
    const double length = std::min(0.6 * std::sqrt(twice_area), 0.03);
    const uint32_t group = groups ? groups->of(body.mesh, FaceId(f)) : body.mesh.data(FaceId(f)).piece;
    sticks.push_back({glm::vec3(middle), glm::vec3(middle + normal * (length / twice_area)),
                      static_cast<float>(packed_piece(group))});
  }
  return sticks;
}

// Draws boxes with faint lines where surfaces hide them, then the path to a face over everything.
void LineOverlay::draw_boxes(Gathered& lines, const glm::mat4& from_body, const ViewOptions& options) const {
  const BoxColours colours = colours_of(options.tree.palette);
  box_.use();
  box_.set("frame_from_body", from_body);
  box_.set("half_width", static_cast<float>(options.mark_scale) * kColourHalfWidth);
  lines.boxes.bind();
  for (const bool hidden : {true, false}) {
    const gl::ScopedState state(
        {.depth = hidden ? GLenum{GL_GREATER} : GLenum{GL_LESS}, .writes_depth = false, .blend = gl::kOver});
    set_colours(box_, colours, !hidden ? 1 : options.tree.one_level ? kHidden : kHiddenOfMany);
    glDrawArraysInstanced(GL_TRIANGLES, 0, kVerticesOfBox, lines.boxes.count());
  }
  if (lines.path.count() == 0) return;
  const gl::ScopedState state({.depth = GL_NONE, .blend = gl::kOver});
  lines.path.bind();
  draw_twice(box_, from_body, kVerticesOfBox, lines.path.count(), srgb(colours.path, 1), options.mark_scale);
}

void LineOverlay::draw(BodyId id, const Body& body, const BodyPicture& picture, const FrameSpace& space,
                       const glm::mat4& clip_from_frame, const ViewOptions& options) {
  const ShowOptions& show = options.show;
  const bool boxes = (show.aabb || show.aabb_hit) && options.tree.body.value_or(id) == id;
  if (!boxes && !show.normals) return;
  const FloatFrame& frame = picture.faces().frame();
  const std::shared_ptr<const PieceGroups> groups = BodyLooks(id, body, options).groups();
  const auto [found, fresh] = gathered_.try_emplace(id);
  Gathered& lines = found->second;
  if (fresh || !(lines.shown == show && lines.tree == options.tree && lines.groups == groups))
    gather(lines, body, frame, options, groups);
  const glm::mat4 from_body = space.from_body(body.placement, frame);
  const gl::ScopedState state({.writes_depth = false, .blend = gl::kOver});
  const SectionClip clip(options);
  if (boxes) {
    lines.boxes.send(select_boxes(lines.all_boxes, clip_from_frame * from_body, kMaxBoxes), GL_DYNAMIC_DRAW);
    std::vector<BoxLine> path;
    if (options.tree_path && options.tree_path->body == id) {
      for (const AabbTree::Box& box : body.tree.path_to(body.mesh, options.tree_path->face))
        path.push_back({frame.to_float(box.min), frame.to_float(box.max), {1, 1}});
    }
    lines.path.send(path, GL_DYNAMIC_DRAW);
    draw_boxes(lines, from_body, options);
  }
  if (show.normals) {
    stick_.use();
    picture.looks().bind(stick_);
    lines.sticks.bind();
    draw_twice(stick_, from_body, kVerticesOfLine, lines.sticks.count(), srgb(0x4aa3ff, 0.9f),
               options.mark_scale);
  }
}

WirePass::WirePass(Shaders& shaders)
    : program_(shaders.load({{"frame.glsl", "line.glsl", "stick.vert"}, {"box.frag"}})) {}

void WirePass::send(std::shared_ptr<const DrawnWire> wire) {
  if (sent_ == wire) return;
  sent_ = std::move(wire);
  edges_.clear();
  if (!sent_) return;
  for (const DrawnWire::Part& part : sent_->parts) {
    Edges& edges = edges_.emplace_back(
        gl::ItemsAre::kInstances,
        std::vector<Edges::Floats>{{3, offsetof(DrawnWire::Edge, from)}, {3, offsetof(DrawnWire::Edge, to)}});
    edges.send(part.edges, GL_STATIC_DRAW);
  }
}

void WirePass::draw(const Subject& subject, const FrameUniforms& frame) {
  send(subject.options.wire);
  if (!sent_) return;
  const gl::ScopedState state({.writes_depth = false, .blend = gl::kOver});
  const SectionClip clip(subject.options);
  const auto scale = static_cast<float>(subject.options.mark_scale);
  program_.use();
  program_.set("pulled", subject.space.length(sent_->depth));
  for (size_t i = 0; i < edges_.size(); ++i) {
    const DrawnWire::Part& part = sent_->parts[i];
    const auto found = subject.options.pieces.find(part.piece);
    const PieceLook look = found != subject.options.pieces.end() ? found->second : PieceLook();
    if (look.hidden) continue;
    const glm::mat4 from_part = subject.space.from_body({look.offset, look.turn}, part.frame);
    const float pixels = pixels_of_edge(part, from_part, subject.space, frame);
    const float opacity = std::clamp(pixels / kPlainEdge, kMinOpacity, 1.0f);
    program_.set("frame_from_body", from_part);
    edges_[i].bind();
    for (const bool dark : {true, false}) {
      if (dark && pixels < kEdgeWithDark) continue;
      program_.set("half_width", scale * (dark ? kDarkWireHalfWidth : kWireHalfWidth));
      program_.set("hit_colour", dark ? glm::vec4(0.02f, 0.025f, 0.03f, 0.4f * opacity)
                                      : srgb(overlay_colours::kPreview, 0.8f * opacity));
      glDrawArraysInstanced(GL_TRIANGLES, 0, kVerticesOfLine, edges_[i].count());
    }
  }
}

SectionPass::SectionPass(Shaders& shaders)
    : line_(shaders.load({{"frame.glsl", "placed.glsl", "section.vert"}, {"section.frag"}})) {}

void SectionPass::draw(const Subject& subject, int height) const {
  if (shown_section(subject.options) == nullptr) return;
  KERF_ASSERT(is_frame_bound());
  const SectionClip clip(subject.options);
  const gl::ScopedState state(
      {.depth = GL_EQUAL, .writes_depth = false, .culled = subject.culled(), .blend = gl::kOver});
  line_.use();
  line_.set("wide", scaled_width(kSectionWidth, height));
  draw_bodies(subject, line_);
}

void draw_marked_faces(const Subject& subject, const gl::Program& faces) {
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const gl::ScopedState state({.culled = subject.culled()});
  const SectionClip clip(subject.options);
  faces.use();
  faces.set("only", 0);
  int number = 0;
  for_each_body(subject, [&](BodyId, const Body& body, const BodyPicture& picture) {
    faces.set("body", (number++ % 127) + 1);
    picture.bind(faces, subject.space, body.placement);
    picture.faces().draw_numbered(faces);
  });
}

OutlinePass::OutlinePass(Shaders& shaders)
    : faces_(shaders.load({{"frame.glsl", "placed.glsl", "faces.vert"}, {"mark.frag"}})),
      outline_(shaders.load({{"screen.vert"}, {"frame.glsl", "outline.frag"}})) {}

void OutlinePass::draw_selected(const Subject& subject) const {
  const SectionClip clip(subject.options);
  for_each_body(subject, [&](BodyId, const Body& body, const BodyPicture& p) {
    if (p.looks().any_selected()) p.draw(faces_, subject.space, body.placement);
  });
}

void OutlinePass::draw(const Subject& subject, const gl::Framebuffer& picture) {
  bool any = false;
  for_each_body(subject,
                [&](BodyId, const Body&, const BodyPicture& p) { any = any || p.looks().any_selected(); });
  if (!any) return;
  const gl::Framebuffer::Shape shape{picture.shape().width, picture.shape().height, 1, false};
  if (!mask_ || !(mask_->shape() == shape)) mask_.emplace(shape);
  mask_->bind();
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  gl::ScopedState state({.depth = GL_NONE});
  faces_.use();
  faces_.set("only", 1);
  faces_.set("body", 255);
  draw_selected(subject);

  picture.bind();
  state.set({.depth = GL_NONE, .blend = gl::kOver});
  outline_.use();
  outline_.set_texture("mask", 0, mask_->colour_texture());
  outline_.set("colour", srgb(selection_colour(subject.options.tree.palette)));
  outline_.set("wide", scaled_width(kOutlineWidth, shape.height));
  no_vertices_.draw_screen();
}

void draw_removed(const Subject& subject, const gl::Program& program, gl::State state) {
  state.offset = kBehindSurfaces;
  const gl::ScopedState scope(state);
  const SectionClip clip(subject.options);
  int number = 0;
  for_each_body(subject, [&](BodyId, const Body& body, BodyPicture& picture) {
    program.set("body", (number++ % 127) + 1);
    if (body.hidden) return;
    program.set("frame_from_body", subject.space.from_body(body.placement, picture.faces().frame()));
    picture.faces().draw_removed(body.mesh);
  });
}

VeilPass::VeilPass(Shaders& shaders)
    : veil_(shaders.load({{"frame.glsl", "veil.vert"}, {"frame.glsl", "light.glsl", "veil.frag"}})),
      faces_(shaders.load({{"frame.glsl", "placed.glsl", "faces.vert"}, {"mark.frag"}})) {}

// Writes only depth: hidden or displaced pieces are not removed, so no veil replaces them.
void VeilPass::draw_removed_faces(const Subject& subject) const {
  const gl::ScopedState state({.writes_colour = false, .writes_alpha = false});
  faces_.use();
  faces_.set("only", 2);
  const SectionClip clip(subject.options);
  for_each_body(subject, [&](BodyId, const Body& body, BodyPicture& picture) {
    if (picture.looks().any_away()) picture.draw(faces_, subject.space, body.placement);
  });
}

void VeilPass::draw(const Subject& subject, Style style) const {
  draw_removed_faces(subject);
  const bool opaque = style == Style::kRed;
  const Look look = look_of(style);
  veil_.use();
  veil_.set("fill", look.fill);
  veil_.set("edge", look.edge);
  draw_removed(
      subject, veil_,
      opaque ? gl::State{.writes_alpha = false} : gl::State{.writes_depth = false, .blend = gl::kOver});
}

}  // namespace kerf
