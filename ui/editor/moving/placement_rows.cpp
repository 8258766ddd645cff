#include "ui/editor/moving/placement_rows.h"

#include <imgui.h>

#include <array>
#include <cmath>

#include "core/base/angle.h"
#include "ui/editor/moving/moving.h"
#include "ui/editor/shared/panels/panel_rows.h"
#include "ui/editor/shared/pieces/piece_set.h"
#include "ui/window/property.h"

namespace kerf {

namespace {

constexpr double kRadiansOfDegree = kPi / 180;
constexpr double kHalfTurn = 180;  // degrees

// Angles are shown without the rounding of sines and cosines, and without a sign at zero.
double tidy(double degrees) { return std::round(degrees * 1e9) / 1e9 + 0.0; }

}  // namespace

Vec3 angles_of(const glm::dquat& orientation) {
  const glm::dvec3 radians = glm::eulerAngles(orientation);
  return {tidy(radians.x / kRadiansOfDegree), tidy(radians.y / kRadiansOfDegree),
          tidy(radians.z / kRadiansOfDegree)};
}

glm::dquat orientation_of(const Vec3& angles) {
  return glm::normalize(glm::dquat(angles * kRadiansOfDegree));
}

std::optional<Command> PlacementRows::draw(const World& world, const ViewState& view) {
  if (!begin_properties("placement")) return std::nullopt;
  const char* why_not = why_no_move(view.look.pieces);
  std::optional<Command> command;
  if (why_not == nullptr) {
    command = draw_fields(world, view, *first_chosen(view.look.pieces));
  } else {
    draw_empty(why_not);
  }
  end_properties();
  return command;
}

std::optional<Command> PlacementRows::draw_fields(const World& world, const ViewState& view,
                                                  const PieceId& piece) {
  const Body& body = world.body(piece.body);
  Placement to = body.placement;
  const Vec3 before = pivot_of(body, piece.label), centre_in_body = to.to_body(before);
  Vec3 centre = before, angles = angles_of(to.orientation);
  if (fields_.vector("Centre", centre, "%.5g",
                     "X, Y and Z of the chosen piece's centre of area, in the unit of the file.",
                     file_unit(view.frame.unit), world.loaded_bounds().diagonal()))
    to.position += centre - before;
  if (fields_.vector("Rotation", angles, "%.4g",
                     "Degrees about X, then Y, then Z, about its centre: 0 is as it was loaded.", kDegrees,
                     kHalfTurn)) {
    to.orientation = orientation_of(angles);
    to.position = before - to.orientation * centre_in_body;
  }
  return to != body.placement ? std::optional<Command>(MovePiece{piece, to}) : std::nullopt;
}

void PlacementRows::draw_empty(const char* why) {
  ImGui::BeginDisabled();
  for (const char* name : {"Centre", "Rotation"}) {
    property(name);
    std::array<char, 2> text{"-"};
    ImGui::InputText((std::string("##") + name).c_str(), text.data(), text.size(),
                     ImGuiInputTextFlags_ReadOnly);
    tooltip(why);
  }
  ImGui::EndDisabled();
}

}  // namespace kerf
