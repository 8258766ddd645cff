#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "ui/render/view/view_options.h"

namespace kerf {

// Colours in OKLab, where equal distances look equally different (B. Ottosson: A perceptual color space for
// image processing, 2020): lightness from 0 to 1, then green to red, then blue to yellow.

glm::dvec3 oklab_from_linear(const glm::dvec3& rgb);
// Clamps colours outside the gamut of the screen.
glm::dvec3 linear_from_oklab(const glm::dvec3& lab);
// Returns a colour of this hue [degrees].
glm::dvec3 oklab_of(double lightness, double chroma, double hue);

// Converts linear light to sRGB, 0 .. 1.
glm::dvec3 screen_from_linear(const glm::dvec3& rgb);

// A path through OKLab for s = 0 .. 1.
using OklabPath = std::function<glm::dvec3(double s)>;
// Returns the linear light of the path at the fraction t of its length, so that equal steps of t look
// equally large.
glm::dvec3 linear_along(const OklabPath& path, double t);

// The colour 0xRRGGBB in sRGB with an opacity from 0 to 1.
inline glm::vec4 srgb(uint32_t hex, float opacity = 1) {
  const auto part = [&](int shift) { return static_cast<float>(hex >> shift & 0xffu) / 255.0f; };
  return {part(16), part(8), part(0), opacity};
}

// A line is drawn as two triangles.
inline constexpr int kVerticesOfLine = 6;

}  // namespace kerf

namespace kerf::overlay_colours {

// The colours of the shadow views and their legends: 0xrrggbb (sRGB).

// Silhouette edges with one volume side, two sides, or more.
inline constexpr uint32_t kOneSide = 0xa8d4ff, kTwoSides = 0x4aa3ff, kMoreSides = 0xb07cff;

// Sides of the volumes, seen from outside and from inside.
inline constexpr uint32_t kVolumeFront = 0x4aa3ff, kVolumeBack = 0xff8a3d;

// Light-facing, back-facing and edge-on polygons.
inline constexpr uint32_t kFacing = 0xf2dc9a, kAverted = 0x2c4a8c, kEdgeOn = 0x808890;

// Lit; from one occluder to the size of the array, and more: dark blue over violet and orange to pale
// yellow.
inline constexpr uint32_t kLit = 0x20303a;
inline constexpr std::array<uint32_t, 9> kCounts{0x1f4fa8, 0x5b3fb5, 0x93329f, 0xc23a7c, 0xe25a51,
                                                 0xf58233, 0xfbad2c, 0xf8d84e, 0xfffbd0};

// Nodes of the component graph: the set reached by a traversal, the other set, removed faces, and nodes not
// yet visited.
inline constexpr uint32_t kReached = 0x4aa3ff, kApart = 0xf2dc9a, kRemoved = 0xff5a48, kUnmarked = 0x7d8896;

// Marks of a stage of a cut: the volume swept by the beam, touched faces, and faces created by a split;
// removed faces have the colour of the graph.
inline constexpr uint32_t kSwept = 0xa8d4ff, kHit = 0xffd27a, kAdded = 0x4aa3ff;

// Boxes visited by a tree query: entered and culled ones; of single faces those missed and touched by the
// beam; and the last visited one.
inline constexpr uint32_t kEntered = 0xb99aff, kCulled = 0x7d8896, kMissed = 0xf2dc9a, kTouched = 0xff6a4d,
                          kLast = 0xffffff;

// Contacts, from no impulse to the largest; points and chords of colliders; centres of mass of awake,
// sleeping and pinned bodies.
inline constexpr uint32_t kLightContact = 0xf2dc9a, kHeavyContact = 0xff4a38, kColliderPoint = 0xb99aff,
                          kColliderChord = 0x56d0c8, kAwake = 0x5fd38a, kAsleep = 0x4aa3ff,
                          kPinned = 0xf4f7fb;

// Active joints.
inline constexpr uint32_t kHinge = 0xffd27a, kHub = 0x56d0c8, kWeld = 0xd27aff;

// The preview wire of the tools of the Prepare panel.
inline constexpr uint32_t kPreview = 0x8fe3cf;

// Loops closed by removed faces.
inline constexpr uint32_t kLoop = 0xf4f7fb;

// Pixels where a traced ray contradicts the frame; of the other traced pixels, lit ones and those in shadow.
inline constexpr uint32_t kWrong = 0xff28dc, kTracedLit = 0xece2be, kTracedShadow = 0x080c16;

}  // namespace kerf::overlay_colours

namespace kerf {

// The two colours of a palette as 0xrrggbb (sRGB).
struct BoxColours {
  uint32_t hit = 0;
  uint32_t untouched = 0;
  uint32_t edited = 0;  // leaves with AabbTree::Box::edited
  uint32_t path = 0;    // boxes from the root to the face under the pointer
};

constexpr BoxColours colours_of(BoxPalette palette) {
  return palette == BoxPalette::kRedAndGreen ? BoxColours{0xff6a4d, 0x3fbf7f, 0x6fb7ff, 0xffd84a}
                                             : BoxColours{0xe69f00, 0x56b4e9, 0xffffff, 0xf0e442};
}

// The colour of the selection: amber, or blue in the palette that uses orange for hit boxes.
constexpr uint32_t selection_colour(BoxPalette palette) {
  return palette == BoxPalette::kRedAndGreen ? 0xff9d2e : 0x4aa3ff;
}

// Returns `count` colours for pieces, in linear light: each is as far as possible, in OKLab, from all of
// `paints` and from the colours before it. They are cool and not bright, because warm colours mean heat.
// Deterministic. O(count^2).
std::vector<glm::dvec3> piece_palette(std::span<const glm::dvec3> paints, size_t count);

}  // namespace kerf
