#include "ui/editor/view/camera_text.h"

#include "core/document/text/json_value.h"

namespace kerf {

std::string view_text(const View& view) {
  const auto list = [](const Vec3& v) { return nlohmann::json{v.x, v.y, v.z}; };
  return nlohmann::ordered_json{{"eye", list(view.eye)}, {"target", list(view.target)}}.dump();
}

Result<View> parse_view_text(const std::string& text) {
  constexpr const char* kNone = "The clipboard holds no view: copy one first";
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return bad_input(kNone);
  JsonValue root(json, "The clipboard");
  if (root.has("view")) root = root["view"];
  if (!root.has("eye") || !root.has("target")) return bad_input(kNone);
  const auto eye = root["eye"].vector(), target = root["target"].vector();
  if (!eye || !target || *eye == *target) return bad_input(kNone);
  return View{*eye, *target};
}

}  // namespace kerf
