#include "ui/editor/shared/viewport.h"

#include <imgui.h>
#include <algorithm>

#include "core/document/text/json.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

Vec2 ViewState::in_picture(Vec2 at) const {
  const Vec2 p = (at - pane().at) / pane().size;
  return {2 * p.x - 1, 1 - 2 * p.y};
}

Vec2 ViewState::in_first(Vec2 at) const {
  const Vec2 p = (at - layout.first.at) / layout.first.size;
  return {2 * p.x - 1, 1 - 2 * p.y};
}

void go_home(ViewState& view, const World::Bounds& bounds) {
  if (view.home) {
    view.camera.look(view.home->eye, view.home->target);
  } else {
    view.camera.frame_default(bounds, view.aspect());
  }
}

std::string view_text(const View& view) {
  const auto list = [](const Vec3& v) { return nlohmann::json{v.x, v.y, v.z}; };
  return nlohmann::ordered_json{{"eye", list(view.eye)}, {"target", list(view.target)}}.dump();
}

Result<View> parse_view_text(const std::string& text) {
  constexpr const char* kNone = "No camera on the clipboard: use Copy Camera first";
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return bad_input(kNone);
  JsonValue root(json, "The clipboard");
  if (root.has("view")) root = root["view"];
  if (!root.has("eye") || !root.has("target")) return bad_input(kNone);
  const auto eye = root["eye"].vector(), target = root["target"].vector();
  if (!eye || !target || *eye == *target) return bad_input(kNone);
  return View{*eye, *target};
}

std::optional<Vec2> PrimaryViewport::place_of(const Vec3& p) const {
  const Vec3 seen = camera_.project(p);
  if (seen.z <= 0) return std::nullopt;
  return area_.at + Vec2(0.5 + 0.5 * seen.x, 0.5 - 0.5 * seen.y) * area_.size;
}

double PrimaryViewport::metres_of_em(const Vec3& p) const {
  const double depth = camera_.parallel ? camera_.focus : camera_.project(p).z;
  return 2 * depth * camera_.tan_half_fov / area_.size.y * em_;
}

Pose PrimaryViewport::ray(Vec2 place) const {
  const Vec2 p = (place - area_.at) / area_.size;
  return camera_.ray(2 * p.x - 1, 1 - 2 * p.y);
}

Vec3 PrimaryViewport::at_depth_of(const Vec3& p, Vec2 place) const {
  const Pose through = ray(place);
  const double depth = glm::dot(p - through.origin, camera_.forward);
  return through.origin + through.direction * (depth / glm::dot(through.direction, camera_.forward));
}

namespace {

constexpr float kBadgeHeight = 1.8f, kBadgesApart = 0.4f, kBadgeMargin = 0.7f;  // sizes of the text

// Draws a triangle (running), two bars (paused) or a disc (mode) in a square of this side.
void draw_badge_sign(Badges::Sign sign, ImVec2 at, float side, ImDrawList& list) {
  if (sign == Badges::Sign::kPlaying)
    return list.AddTriangleFilled(at, {at.x, at.y + side}, {at.x + 0.9f * side, at.y + 0.5f * side},
                                  colours::kPictureText);
  if (sign == Badges::Sign::kMode)
    return list.AddCircleFilled({at.x + 0.5f * side, at.y + 0.5f * side}, 0.42f * side, colours::accent());
  const float bar = 0.3f * side;
  for (const float x : {at.x, at.x + side - bar})
    list.AddRectFilled({x, at.y}, {x + bar, at.y + side}, colours::kPictureText);
}

}  // namespace

void Badges::draw(const ViewState& view, Sign sign, const std::string& text, const char* landmark,
                  float min_ems) {
  const Area picture = view.below_header();
  const float em = ImGui::GetFontSize(), side = 0.62f * em, gap = 0.5f * em;
  const float room = static_cast<float>(picture.size.x) - 2 * kBadgeMargin * em - side - gap;
  const std::string fitted = fitted_text(text, room);
  const float width = side + gap + std::max(width_of_text(fitted), std::min(room, min_ems * em));
  const float left = static_cast<float>(picture.at.x + 0.5 * picture.size.x) - 0.5f * width;
  const float top = static_cast<float>(picture.at.y) + em +
                    static_cast<float>(drawn_++) * (kBadgeHeight + kBadgesApart) * em;
  const ImVec2 low{left - kBadgeMargin * em, top - 0.4f * em},
      high{left + width + kBadgeMargin * em, top + 1.4f * em};
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled(low, high, colours::kPictureShade, 3);
  draw_badge_sign(sign, {left, top + 0.5f * (ImGui::GetTextLineHeight() - side)}, side, list);
  list.AddText({left + side + gap, top}, colours::kPictureText, fitted.c_str());
  mark_area(landmark, {{low.x, low.y}, {high.x - low.x, high.y - low.y}});
}

}  // namespace kerf
