#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/float_frame.h"
#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/result.h"
#include "core/document/scene.h"
#include "core/joints/piece_groups.h"
#include "core/shadow/shadow_volume.h"
#include "core/world/world.h"
#include "ui/render/view/section_plane.h"

namespace kerf {

// Edges of a surface that pieces may become, to be drawn over the surface that they have.
struct DrawnWire {
  struct Edge {
    glm::vec3 from, to;  // in the float frame
  };
  // The edges of what becomes of one piece, which are drawn as the piece is: displaced, turned or hidden.
  struct Part {
    PieceId piece;
    FloatFrame frame;  // of the coordinates of the world
    std::vector<Edge> edges;
    double mean_edge = 0;  // m
  };
  std::vector<Part> parts;
  double depth = 0;  // m; edges up to so far below a surface are seen
};

// A number for each face slot of a body.
using FaceScalars = std::vector<float>;
// Of faces that have no number; slots behind the last one have none either.
inline constexpr float kNoScalar = std::numeric_limits<float>::max();

// Numbers of faces that colour the bodies instead of their paints: those from `low` to `high` through
// scalar_colour(), those beyond as the ends, and grey what has none.
struct ScalarField {
  std::map<BodyId, std::shared_ptr<const FaceScalars>> of_bodies;  // not null
  float low = 0, high = 1;                                         // low < high
  std::string name;                                                // with the unit, for the legend
  std::array<std::string, 5> labels;  // of numbers evenly spaced from `low` to `high`
};

// A colour of the scale, t = 0 .. 1, from dark violet over blue and green to pale yellow: linear light, or
// sRGB. Equal steps of t look equally large.
glm::dvec3 linear_scalar_colour(double t);
glm::vec3 scalar_colour(double t);

// A box of the tree to be drawn: its corners in the body's float frame, and in `style` 1 if the beam has hit
// it, and its opacity.
struct BoxLine {
  glm::vec3 low, high;
  glm::vec2 style;
};

// Chooses at most `most` of the boxes that may be visible, those that appear largest, in descending order of
// size. Boxes that the beam has hit count as larger than they are, because the user looks for them. A tree
// has far more boxes than a picture can show; small ones matter from near and large ones from afar. O(n),
// plus sorting of the visible boxes.
std::vector<BoxLine> choose_boxes(std::span<const BoxLine> boxes, const glm::mat4& clip_from_body,
                                  size_t most);

// On what surfaces shadows are drawn.
enum class Shadows {
  kNone,
  kGround,  // only on the ground, those of directional lights that shine from above
  kAll,     // on all surfaces
};

// What is drawn in addition to the picture: one flag for each name that `--show` accepts.
struct ShowOptions {
  bool aabb = false;                   // all boxes of the tree
  bool aabb_hit = false;               // only those that the beam has hit
  bool wire = false;                   // edges of the faces
  bool face_numbers = false;           // of live faces, and in red of removed ones
  bool graph = false;                  // nodes and links of ViewOptions::graph
  bool pieces = false;                 // each piece in a colour of its own
  bool sizes = false;                  // small faces warm, as the paper colours them
  bool heat = false;                   // temperatures by a scale, with a bar
  bool section = false;                // only what lies under the section plane
  bool contacts = false;               // where bodies touch, as of the last tick; see BodyMarks
  bool colliders = false;              // points and chords by which bodies touch
  bool centres = false;                // centres of mass, and which bodies sleep or are pinned
  bool joints = false;                 // the joints that hold
  bool normals = false;                // a short line from the middle of every face
  Shadows shadows = Shadows::kGround;  // `--show shadows` asks for kAll
  bool silhouette = false;             // edges of a light's silhouette, coloured by their multiplicity
  bool shadow_volumes = false;         // the volumes, fronts and backs in different colours
  bool shadow_stencil = false;         // number of occluding surfaces as colours, with a legend
  bool shadow_facing = false;          // polygons that face the light and those that face away
  bool shadow_compare = false;         // two methods side by side, and the number of differing pixels
  bool shadow_reference = false;       // ray-traced shadows, and the pixels that differ
  friend bool operator==(const ShowOptions&, const ShowOptions&) = default;
};

// What the editor shows at first, and pictures for which nothing else is asked: shadows on all surfaces.
ShowOptions default_show();

// Parses names separated by commas; blanks around them and an empty list are accepted. The error for an
// unknown name lists the valid ones.
Result<ShowOptions> parse_show_list(std::string_view list);

// The names that parse_show_list accepts, for --help: "aabb, aabb-hit, ...".
std::string offered_show_names();

// The two colours of the tree's boxes: where the beam is or was, and untouched.
enum class BoxPalette {
  kRedAndGreen,    // the paper's: #ff6a4d solid, #3fbf7f dotted
  kOrangeAndBlue,  // for the colour-blind: #e69f00 solid, #56b4e9 dotted
};

// How kRobust draws the near caps of its volumes. A lit surface has to fail the depth test against its own
// cap, which has the same depth. All values but kExact give wrong shadows; tests use them to show that they
// detect such errors.
enum class NearCaps {
  kExact,
  kLessOrEqual,  // equal depths pass
  kDisplaced,    // by one unit of depth towards the eye
};

// How shadows are drawn if ShowOptions enables them.
struct ShadowOptions {
  ShadowMethod method = ShadowMethod::kRobust;
  NearCaps near_caps = NearCaps::kExact;
  // Length of the paper's volumes in diagonals of the world; those of kRobust extend to infinity.
  double extrusion = 4;
  // Whether shadows are drawn as half-transparent black, as in the paper, instead of omitting the light.
  bool paper_look = false;
  // The method to the right of the split if ShowOptions compares two; `split` is a fraction of the picture's
  // width.
  ShadowMethod beside = ShadowMethod::kPaperOneVolume;
  double split = 0.5;
  size_t inspected = 0;  // the light whose silhouette, volumes and counts are shown
  friend bool operator==(const ShadowOptions&, const ShadowOptions&) = default;
};

// Which boxes of the tree are drawn when ShowOptions asks for them.
struct TreeOverlay {
  int deepest = 64;  // levels under the root
  bool leaves_only = false;
  bool hit_only = false;
  std::optional<BodyId> body;  // the only body whose boxes are drawn; nothing: all
  BoxPalette palette = BoxPalette::kRedAndGreen;
  friend bool operator==(const TreeOverlay&, const TreeOverlay&) = default;
};

// How a piece is drawn. This does not change the world.
struct PieceLook {
  bool hidden = false;
  bool selected = false;  // drawn with an outline
  uint32_t number = 0;    // determines its colour; 0: its label does
  // A point p of the world is drawn at turn * p + offset; the offset is in metres, along the axes of the
  // world.
  glm::dquat turn{1, 0, 0, 0};
  Vec3 offset{0};
  bool is_away() const { return offset != Vec3(0) || is_turned(); }
  bool is_turned() const { return turn != glm::dquat(1, 0, 0, 0); }
  friend bool operator==(const PieceLook&, const PieceLook&) = default;
};

struct DrawnGraph;
struct StageMarks;
struct BodyMarks;
struct Effects;
struct DrawnWire;

// A face of a body.
struct FaceOfBody {
  BodyId body;
  FaceId face;
  friend bool operator==(const FaceOfBody&, const FaceOfBody&) = default;
};

// Which normals surfaces are shaded by.
enum class Shading {
  kByAngle,  // smooth where faces meet at less than 35 degrees (see BaseFaces)
  kSmooth,   // smooth everywhere
  kFlat,     // each face by its plane
};

// How the world is drawn.
struct ViewOptions {
  ShowOptions show;
  bool rim_glow = true;     // the rims of cuts glow
  bool sparks = true;       // sparks and smoke fly where the laser of the editor bites
  bool antialias = true;    // four samples per pixel
  bool two_sided = true;    // faces are lit on both sides; otherwise the back is black
  bool cull_backs = false;  // backs are not drawn, as the paper first had it
  bool ghost = false;       // removed faces are drawn as a faint veil
  bool tint_pieces = true;  // what was cut off has a colour of its own; otherwise it keeps its paint
  bool legends = true;      // colours of overlays are explained in the picture, by strips
  Shading shading = Shading::kByAngle;
  double mark_scale = 1;                // of numbers and lines over the picture; 1 is for a screen
  bool by_day = false;                  // the environment are bright, otherwise dark
  std::optional<SectionPlane> section;  // where ShowOptions::section cuts; see shown_section()
  TreeOverlay tree;
  std::vector<Light> lights = std::vector<Light>(1);  // only the first kMaxLights are used
  ShadowOptions shadow;
  std::shared_ptr<const DrawnGraph> graph;    // what ShowOptions::graph draws; null: nothing
  std::shared_ptr<const ScalarField> scalar;  // colours the faces; null: their paints do
  std::optional<FaceOfBody> lit_face;         // outlined, if it is live
  std::shared_ptr<const StageMarks> stage;    // what a stage of a cut did; null: nothing
  std::shared_ptr<const BodyMarks> bodies;    // of the physics; null: nothing
  std::shared_ptr<const Effects> effects;     // of lasers; null: nothing
  std::shared_ptr<const DrawnWire> wire;      // of what pieces may become; null: nothing
  std::map<PieceId, PieceLook> pieces;        // pieces that are not drawn with the default look
  // The groups of faces of bodies whose pieces are drawn apart, for the present world; see spread_pieces().
  // Values are not null.
  std::map<BodyId, std::shared_ptr<const PieceGroups>> groups;
};

// What an option and a file may ask for.
inline constexpr NumberRange kSpread{0, 100};

// Sets the offset of every piece to `spread` (>= 0) times the vector from the centre of the world's bounds to
// the piece's centre of area, and drops looks that are plain then. Loose parts go with the nearest piece (see
// PieceGroups). If the spread is not 0, it costs as much as group_pieces() for each body.
void spread_pieces(const World& world, double spread, ViewOptions& look);

// Does what spread_pieces() does, for a world that has not changed since the last call of either. O(pieces).
void spread_further(const World& world, double spread, ViewOptions& look);

}  // namespace kerf
