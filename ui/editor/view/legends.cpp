#include "ui/editor/view/legends.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <set>

#include "core/base/assert.h"
#include "ui/render/passes/mark_passes.h"
#include "ui/render/view/colours.h"
#include "ui/render/view/view_switches.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr std::array kMethods{
    MethodWords{ShadowMethod::kRobust, "Robust",
                "Each polygon spans a closed infinite volume, counted from behind. Correct for any mesh and "
                "any eye."},
    MethodWords{ShadowMethod::kPaperOneVolume, "Paper, one volume",
                "Extrudes the silhouette of light-facing polygons, without caps. Correct for closed meshes "
                "while the eye is lit."},
    MethodWords{ShadowMethod::kPaperTwoVolumes, "Paper, two volumes",
                "Adds a volume for the back-facing polygons: the paper's solution for hollow meshes."},
};

}  // namespace

std::span<const MethodWords> shadow_methods() { return kMethods; }

const char* method_name(ShadowMethod method) {
  const auto found =
      std::find_if(kMethods.begin(), kMethods.end(), [&](const auto& m) { return m.method == method; });
  KERF_ASSERT(found != kMethods.end());
  return found->name;
}

namespace {

using namespace overlay_colours;
using Rows = std::vector<Legend::Row>;

Legend::Row sentence(std::string text) { return {0, std::move(text), false, false}; }

Legend legend_of_boxes(const ViewOptions& look) {
  const BoxColours colours = colours_of(look.tree.palette);
  const bool hit_only = look.show.aabb_hit || look.tree.hit_only;
  Legend legend;
  legend.title = look.tree.leaves_only ? "Boxes of single faces" : "AABB Tree";
  legend.rows.push_back({colours.hit, "visited by the beam"});
  if (!hit_only) legend.rows.push_back({colours.untouched, "not visited", true, true});
  if (!look.tree.leaves_only && look.tree.deepest < TreeOverlay().deepest)
    legend.rows.push_back(sentence("down to level " + std::to_string(look.tree.deepest) + " below the root"));
  return legend;
}

Legend legend_of_counts() {
  Legend legend{"Occluders (Shadow Count)", {{kLit, "none"}}};
  for (size_t i = 0; i < kCounts.size(); ++i)
    legend.rows.push_back({kCounts[i], std::to_string(i + 1) + (i + 1 == kCounts.size() ? " or more" : "")});
  return legend;
}

Legend legend_of_comparison(const ViewOptions& look, const ShadowStatistics& shadows) {
  return {"Two shadow methods",
          {sentence("left: " + std::string(method_name(look.shadow.method))),
           sentence("right: " + std::string(method_name(look.shadow.beside))),
           sentence((shadows.differing ? grouped(*shadows.differing) + " pixels" : "counting pixels that") +
                    " are in shadow with"),
           sentence("one of them and lit with the other")}};
}

Legend legend_of_rays(const ShadowStatistics& shadows) {
  return {"Shadow rays",
          {{kTracedLit, "lit"},
           {kTracedShadow, "in shadow"},
           {kWrong, "viewport differs: " +
                        (shadows.wrong ? grouped(*shadows.wrong) + " pixels" : tracing_text(shadows))}}};
}

// Returns the legend of a view; empty if it has no colours of its own.
Legend legend_of(SwitchId view, const ViewOptions& look, const ShadowStatistics& shadows) {
  switch (view) {
    case SwitchId::kSilhouette:
      return {"Silhouette: sides of the volume on an edge",
              {{kOneSide, "one"}, {kTwoSides, "two"}, {kMoreSides, "three or more"}}};
    case SwitchId::kShadowVolumes:
      return {"Shadow Volumes", {{kVolumeFront, "front faces"}, {kVolumeBack, "back faces"}}};
    case SwitchId::kShadowCounts:
      return legend_of_counts();
    case SwitchId::kFacing:
      return {"Light-Facing", {{kFacing, "facing it"}, {kAverted, "facing away"}, {kEdgeOn, "edge-on"}}};
    case SwitchId::kCompare:
      return legend_of_comparison(look, shadows);
    case SwitchId::kTrace:
      return legend_of_rays(shadows);
    case SwitchId::kSizes:
      return {"Size of faces",
              {{0xf5e3a0, "split most often"},
               {0xee8f2e, "split less"},
               {0xa23a36, "split least"},
               {0x48535f, "as loaded"}}};
    case SwitchId::kHeat:
      return {"Temperature in K",
              {sentence("scale at the lower left,"), sentence("up to the melting point")}};
    case SwitchId::kBoxes:
      return legend_of_boxes(look);
    case SwitchId::kBoxesHit:
      return look.show.aabb || !look.show.aabb_hit ? Legend() : legend_of_boxes(look);
    case SwitchId::kPieces:
      return {"Pieces",
              {{0x6f7174, "part of the body"}, sentence("other colours: one separated piece each")}};
    case SwitchId::kFaceNumbers:
      return {"Numbers of faces", {{0xf2f5f7, "there"}, {0xff8a78, "removed"}}};
    case SwitchId::kGraph:
      return {"Component graph around the last cut",
              {{kReached, "connected faces"},
               {kApart, "faces that the cut separated"},
               {kRemoved, "removed faces"},
               {kLoop, "loops of removed faces"}}};
    case SwitchId::kContacts:
      return {"Contacts", {{kHeavyContact, "the largest impulse"}, {kLightContact, "none"}}};
    case SwitchId::kColliders:
      return {"Colliders", {{kColliderPoint, "points"}, {kColliderChord, "chords"}}};
    case SwitchId::kCentres:
      return {"Centres of Mass", {{kAwake, "awake"}, {kAsleep, "asleep"}, {kPinned, "pinned"}}};
    case SwitchId::kJoints:
      return {"Joints", {{kHinge, "hinges"}, {kHub, "hubs"}, {kWeld, "welds"}}};
    case SwitchId::kShadows:
    case SwitchId::kRimGlow:
    case SwitchId::kWire:
    case SwitchId::kShading:
    case SwitchId::kTextures:
    case SwitchId::kSection:
    case SwitchId::kNormals:
    case SwitchId::kGhost:
    case SwitchId::kTwoSided:
    case SwitchId::kCullBacks:
    case SwitchId::kSparks:
    case SwitchId::kAntialias:
      break;
  }
  return {};
}

const char* meaning_of(StageMarks::Kind kind) {
  switch (kind) {
    case StageMarks::Kind::kSwept:
      return "swept volume";
    case StageMarks::Kind::kHit:
      return "hit faces";
    case StageMarks::Kind::kAdded:
      return "new faces";
    case StageMarks::Kind::kRemoved:
      return "removed faces";
    case StageMarks::Kind::kEntered:
      return "boxes entered by the query";
    case StageMarks::Kind::kCulled:
      return "boxes culled";
    case StageMarks::Kind::kMissed:
      return "boxes of missed faces";
    case StageMarks::Kind::kTouched:
      return "boxes of hit faces";
    case StageMarks::Kind::kLast:
      break;
  }
  return "last tested box";
}

Legend legend_of_stage(const StageMarks& marks) {
  std::set<StageMarks::Kind> kinds;
  for (const StageMarks::OfBody& body : marks.bodies) {
    for (const StageMarks::Line& line : body.lines) kinds.insert(line.kind);
  }
  Legend legend{"Single step", {}};
  for (const StageMarks::Kind kind : kinds) legend.rows.push_back({colour_of(kind), meaning_of(kind)});
  if (!marks.came_off.empty()) legend.rows.push_back({kApart, "separated piece"});
  if (!marks.stayed.empty()) legend.rows.push_back({kReached, "remainder"});
  return legend;
}

uint32_t hex_of(const glm::vec3& screen) {
  const glm::uvec3 c(glm::round(255.0f * screen));
  return c.r << 16 | c.g << 8 | c.b;
}

// Lists the largest value first.
Legend legend_of_scalars(const ScalarField& field) {
  Legend legend{field.name, {}};
  for (size_t i = field.labels.size(); i-- > 0;) {
    const double t = static_cast<double>(i) / static_cast<double>(field.labels.size() - 1);
    legend.rows.push_back({hex_of(scalar_colour(t)), field.labels[i]});
  }
  return legend;
}

ImU32 opaque(uint32_t hex) { return IM_COL32(hex >> 16 & 0xffu, hex >> 8 & 0xffu, hex & 0xffu, 255); }

void draw_swatch(const Legend::Row& row, ImVec2 at, float side, ImDrawList& list) {
  const ImU32 colour = opaque(row.colour);
  if (!row.dotted) {
    list.AddRectFilled(at, {at.x + side, at.y + side}, colour, 2);
    list.AddRect(at, {at.x + side, at.y + side}, IM_COL32(255, 255, 255, 70), 2);
    return;
  }
  const float gap = side / 5;
  for (float x = 0; x < side; x += 2 * gap)
    list.AddRectFilled({at.x + x, at.y + 2 * gap}, {at.x + x + gap, at.y + 3 * gap}, colour);
}

float width_of(const Legend& legend, float swatch) {
  float width = ImGui::CalcTextSize(legend.title.c_str()).x;
  for (const Legend::Row& row : legend.rows)
    width = std::max(width, ImGui::CalcTextSize(row.meaning.c_str()).x + (row.swatch ? swatch : 0));
  return width;
}

void draw_legend(const Legend& legend, ImVec2 at, ImVec2 size, ImDrawList& list) {
  const float em = ImGui::GetFontSize(), line = 1.2f * em, side = 0.8f * em;
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, colours::kPictureShade, 3);
  ImVec2 pen{at.x + 0.6f * em, at.y + 0.5f * em};
  list.AddText(pen, colours::kPictureText, legend.title.c_str());
  for (const Legend::Row& row : legend.rows) {
    pen.y += line;
    if (row.swatch) draw_swatch(row, {pen.x, pen.y + 0.5f * (ImGui::GetTextLineHeight() - side)}, side, list);
    list.AddText({pen.x + (row.swatch ? 1.4f * em : 0), pen.y}, colours::kPictureSecondary,
                 row.meaning.c_str());
  }
}

}  // namespace

std::vector<Legend> legends_of(const ViewOptions& look, const ShadowStatistics& shadows) {
  std::vector<Legend> legends;
  for (const ViewSwitch& s : view_switches()) {
    if (s.get(look) == 0) continue;
    if (Legend legend = legend_of(s.id, look, shadows); !legend.title.empty())
      legends.push_back(std::move(legend));
  }
  if (look.scalar) legends.push_back(legend_of_scalars(*look.scalar));
  if (look.stage) {
    if (Legend legend = legend_of_stage(*look.stage); !legend.rows.empty())
      legends.push_back(std::move(legend));
  }
  return legends;
}

Area draw_legends(const std::vector<Legend>& legends, const Area& picture) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float em = ImGui::GetFontSize();
  const auto x = static_cast<float>(picture.at.x) + em,
             bottom = static_cast<float>(picture.at.y + picture.size.y) - em;
  auto y = static_cast<float>(picture.at.y) + em;
  Area taken{picture.at + Vec2(em), Vec2(0)};
  for (size_t i = 0; i < legends.size(); ++i) {
    const ImVec2 size{width_of(legends[i], 1.4f * em) + 1.2f * em,
                      (1.2f * static_cast<float>(legends[i].rows.size() + 1) + 0.8f) * em};
    if (y + size.y > bottom) break;
    draw_legend(legends[i], {x, y}, size, list);
    mark_area(("legend " + legends[i].title).c_str(), {{x, y}, {size.x, size.y}});
    taken.size.x = std::max<double>(taken.size.x, size.x);
    taken.size.y = y + size.y - taken.at.y;
    y += size.y + 0.5f * em;
  }
  return taken;
}

}  // namespace kerf
