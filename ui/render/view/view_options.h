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

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/result.h"
#include "core/document/scene.h"
#include "core/joints/joined_parts.h"
#include "core/shadow/shadow_volume.h"
#include "core/world/world.h"

namespace kerf {

struct ViewOptions;

// A plane through a point [m] of the world. The side to which the normal points is not drawn; the plane
// affects neither cuts nor shadows.
struct SectionPlane {
  Vec3 point{0};
  Vec3 normal{0, 0, 1};  // unit

  // Returns the plane facing along a vector of any non-zero length.
  static SectionPlane facing(const Vec3& point, const Vec3& way);

  // The height of a point over the plane [m], positive on the side not drawn.
  double height_of(const Vec3& p) const { return glm::dot(normal, p - point); }
  // The lengths along a ray, from 0 on, at which it is on the drawn side.
  Interval kept_along(const Pose& ray) const;
  friend bool operator==(const SectionPlane&, const SectionPlane&) = default;
};

// Returns the plane through the middle of a box that removes the half towards the eye; its normal is the
// axis of the world closest to the direction to the eye.
SectionPlane section_through(const World::Bounds& bounds, const Vec3& to_eye);

// The section plane that the options enable, or null.
const SectionPlane* shown_section(const ViewOptions& options);

// Formats a plane as "x,y,z x,y,z", the point and the normal. Reading the numbers gives the same doubles.
std::string section_text(const SectionPlane& plane);
// Reads such a text; the normal may have any non-zero length. The text may be quoted and preceded by
// "--section", as on the command line. The error does not name the source of the text.
Result<SectionPlane> parse_section(std::string_view text);

// A preview of the new edges of pieces, drawn over their current surface.
struct DrawnWire {
  struct Edge {
    glm::vec3 from, to;  // in the float frame
  };
  // The edges of one piece, displaced, turned or hidden like the piece.
  struct Part {
    PieceId piece;
    FloatFrame frame;  // of the coordinates of the world
    std::vector<Edge> edges;
    double mean_edge = 0;  // m
  };
  std::vector<Part> parts;
  double depth = 0;  // m; edges up to this depth below a surface are visible
};

// A number for each face slot of a body.
using FaceScalars = std::vector<float>;
// The value of faces without a number; slots behind the last one have none either.
inline constexpr float kNoScalar = std::numeric_limits<float>::max();

// The colours of a scale, t = 0 .. 1, of which equal steps look equally large.
enum class ColourScale {
  kSequential,  // from dark violet over blue and green to pale yellow
  kDiverging,   // from blue over light grey, at the middle, to orange
};
// Returns a colour of a scale: in linear light, or in sRGB.
glm::dvec3 linear_scalar_colour(ColourScale scale, double t);
glm::vec3 scalar_colour(ColourScale scale, double t);

// A scalar field on the faces, which replaces the paints of bodies: numbers from `low` to `high` map to the
// colours of the scale, those beyond are clamped, and faces without a number are grey.
struct ScalarField {
  std::map<BodyId, std::shared_ptr<const FaceScalars>> of_bodies;  // not null
  float low = 0, high = 1;                                         // low < high
  std::string name;                                                // with the unit, for the legend
  std::array<std::string, 5> labels;  // of numbers evenly spaced from `low` to `high`
  ColourScale scale = ColourScale::kSequential;
};

// A box of the AABB tree to draw: its corners in the body's float frame; `style` holds 1 if the beam has
// hit it, and its opacity.
struct BoxLine {
  glm::vec3 low, high;
  glm::vec2 style;
};

// Selects at most `most` possibly visible boxes, the largest on screen, in descending order of size. Boxes
// that the beam has hit count as larger, because they are of interest. A tree has far more boxes than fit a
// frame; small ones matter from near and large ones from afar. O(n), plus sorting of the visible boxes.
std::vector<BoxLine> select_boxes(std::span<const BoxLine> boxes, const glm::mat4& clip_from_body,
                                  size_t most);

// The surfaces that receive shadows.
enum class Shadows {
  kNone,
  kGround,  // only the ground, from directional lights above it
  kAll,     // all surfaces
};

// Overlays: one flag for each name that `--show` accepts.
struct ShowOptions {
  bool aabb = false;                   // all boxes of the AABB tree
  bool aabb_hit = false;               // only those that the beam has hit
  bool wire = false;                   // edges of the faces
  bool face_numbers = false;           // of live faces, and in red of removed ones
  bool graph = false;                  // nodes and links of ViewOptions::graph
  bool pieces = false;                 // each piece in its own colour
  bool sizes = false;                  // small faces in warm colours, as in the paper
  bool heat = false;                   // temperatures by a scale, with a bar
  bool section = false;                // only the kept side of the section plane
  bool contacts = false;               // contacts of bodies, as of the last tick; see BodyMarks
  bool colliders = false;              // points and chords of colliders
  bool centres = false;                // centres of mass, and which bodies sleep or are pinned
  bool joints = false;                 // active joints
  bool normals = false;                // a short line from the middle of every face
  Shadows shadows = Shadows::kGround;  // `--show shadows` sets kAll
  bool silhouette = false;             // edges of a light's silhouette, coloured by their multiplicity
  bool shadow_volumes = false;         // the volumes, fronts and backs in different colours
  bool shadow_stencil = false;         // number of occluding surfaces as colours, with a legend
  bool shadow_facing = false;          // light-facing and back-facing polygons
  bool shadow_compare = false;         // two methods side by side, and the number of differing pixels
  bool shadow_reference = false;       // ray-traced shadows, and the pixels that differ
  friend bool operator==(const ShowOptions&, const ShowOptions&) = default;
};

// The default overlays of the editor and of images: shadows on all surfaces.
ShowOptions default_show();

// Parses names separated by commas; blanks around them and an empty list are accepted. The error for an
// unknown name lists the valid ones; the caller prepends the option or key of the list.
Result<ShowOptions> parse_show_list(std::string_view list);

// The names that parse_show_list accepts, for --help: "aabb, aabb-hit, ...".
std::string offered_show_names();

// The two colours of the tree's boxes: hit by the beam, and untouched.
enum class BoxPalette {
  kRedAndGreen,    // the paper's: #ff6a4d and #3fbf7f
  kOrangeAndBlue,  // for the colour-blind: #e69f00 and #56b4e9
};

// Depth test of near caps with ShadowMethod::kRobust. A lit surface must fail the depth test against its own
// cap, which has the same depth. All values except kExact cause wrong shadows; tests use them to verify that
// such errors are detected.
enum class NearCaps {
  kExact,
  kLessOrEqual,  // equal depths pass
  kDisplaced,    // by one unit of depth towards the eye
};

// Options of shadows, if ShowOptions enables them.
struct ShadowOptions {
  ShadowMethod method = ShadowMethod::kRobust;
  NearCaps near_caps = NearCaps::kExact;
  // Length of the paper's volumes in diagonals of the world; those of kRobust extend to infinity.
  double extrusion = 4;
  // Draws shadows as half-transparent black, as in the paper, instead of omitting the light.
  bool paper_look = false;
  // The method to the right of the split if ShowOptions compares two; `split` is a fraction of the frame's
  // width.
  ShadowMethod beside = ShadowMethod::kPaperOneVolume;
  double split = 0.5;
  size_t inspected = 0;  // the light with visible silhouette, volumes and counts
  friend bool operator==(const ShadowOptions&, const ShadowOptions&) = default;
};

// Selects the boxes of the AABB tree that are drawn if ShowOptions enables them.
struct TreeOverlay {
  int deepest = 64;        // levels below the root
  bool one_level = false;  // only the boxes at the level `deepest`
  bool leaves_only = false;
  bool hit_only = false;
  std::optional<BodyId> body;  // the only body whose boxes are drawn; nullopt: all
  BoxPalette palette = BoxPalette::kRedAndGreen;
  friend bool operator==(const TreeOverlay&, const TreeOverlay&) = default;
};

// Drawing attributes of a piece; they do not change the world.
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

struct FaceOfBody {
  BodyId body;
  FaceId face;
  friend bool operator==(const FaceOfBody&, const FaceOfBody&) = default;
};

// The normals that surfaces are shaded by.
enum class Shading {
  kByAngle,  // smooth where faces meet at less than 35 degrees (see BaseFaces)
  kSmooth,   // smooth everywhere
  kFlat,     // each face by its plane
};

struct ViewOptions {
  ShowOptions show;
  bool rim_glow = true;     // glow of the rims of cuts
  bool sparks = true;       // sparks and smoke of the editor's laser
  bool antialias = true;    // four samples per pixel
  bool two_sided = true;    // lights both sides of faces; otherwise the back is black
  bool cull_backs = false;  // culls back faces, as the paper did at first
  bool ghost = false;       // removed faces as a faint veil
  bool tint_pieces = true;  // cut-off pieces have their own colour; otherwise they keep their paint
  bool textures = true;     // maps of materials
  bool legends = true;      // legends of overlay colours as strips
  Shading shading = Shading::kByAngle;
  double mark_scale = 1;                // of numbers and lines; 1 suits a screen
  bool by_day = false;                  // bright environment, otherwise dark
  std::optional<SectionPlane> section;  // plane of ShowOptions::section; see shown_section()
  TreeOverlay tree;
  std::optional<FaceOfBody> tree_path;  // the boxes that contain this face are drawn; nullopt: none
  std::vector<Light> lights = std::vector<Light>(1);  // only the first kMaxLights are used
  ShadowOptions shadow;
  std::shared_ptr<const DrawnGraph> graph;    // for ShowOptions::graph; null: nothing
  std::shared_ptr<const ScalarField> scalar;  // colours the faces; null: their paints do
  std::optional<FaceOfBody> lit_face;         // outlined, if it is live
  std::shared_ptr<const StageMarks> stage;    // of a stage of a cut; null: nothing
  std::shared_ptr<const BodyMarks> bodies;    // of the physics; null: nothing
  std::shared_ptr<const Effects> effects;     // of lasers; null: nothing
  std::shared_ptr<const DrawnWire> wire;      // preview of pieces; null: nothing
  std::map<PieceId, PieceLook> pieces;        // pieces with a look other than the default
  // The face groups of bodies with displaced pieces, for the current world; see spread_pieces(). Values are
  // not null.
  std::map<BodyId, std::shared_ptr<const PieceGroups>> groups;
};

// The valid range in options and files.
inline constexpr NumberRange kSpread{0, 100};

// Sets the offset of every piece to `spread` (>= 0) times the vector from the centre of the world's bounds
// to the piece's centre of area, and drops looks that become default. Loose parts move with the nearest
// piece (see PieceGroups). For a non-zero spread, costs group_pieces() for each body.
void spread_pieces(const World& world, double spread, ViewOptions& look);

// Like spread_pieces(), for a world that has not changed since the last call of either. O(pieces).
void spread_further(const World& world, double spread, ViewOptions& look);

// The switches of the view, in the order of panels.
enum class SwitchId {
  kShadows,
  kSilhouette,
  kShadowVolumes,
  kShadowCounts,
  kFacing,
  kCompare,
  kTrace,
  kRimGlow,
  kShading,
  kTextures,
  kWire,
  kSection,
  kBoxes,
  kBoxesHit,
  kPieces,
  kSizes,
  kHeat,
  kNormals,
  kFaceNumbers,
  kGraph,
  kContacts,
  kColliders,
  kCentres,
  kJoints,
  kGhost,
  kTwoSided,
  kCullBacks,
  kSparks,
  kAntialias
};

inline constexpr std::array kOffAndOn{"off", "on"};

// A switch of the view, as used by menus, keys, panels, `--show` and the editor's report. Most have two
// states, off and on; the key of others cycles through their states.
struct ViewSwitch {
  SwitchId id;
  const char* show = "";      // name in `--show`; empty: none of its overlays
  const char* report = "";    // key in the editor's report, and id of its action; empty: not in it
  const char* label = "";     // in menus and panels; empty: in neither
  char key = 0;               // capital letter of its key; 0: none
  const char* tip = "";       // tooltip
  bool in_view_panel = true;  // false: in another panel
  std::span<const char* const> states = kOffAndOn;  // display names, off first; `--show` sets the last
  size_t (*get)(const ViewOptions&) = nullptr;      // the state, an index of `states`
  void (*set)(ViewOptions&, size_t) = nullptr;

  bool is_two_state() const { return states.size() == 2; }
  // Advances to the next state, cyclically. Shadow volumes and stencil counts switch each other off.
  void flip(ViewOptions& look) const;
};

// Sets all switches that draw overlays (those with a name in `--show`) to their initial states.
void reset_overlays(ViewOptions& look);

// The id of its action: "view.wire".
std::string action_id(const ViewSwitch& s);
// The name of its action: "Cycle Shadows", or its label for the states off and on.
std::string action_name(const ViewSwitch& s);

// All switches, indexed by their ids.
std::span<const ViewSwitch> view_switches();
const ViewSwitch& view_switch(SwitchId id);

}  // namespace kerf
