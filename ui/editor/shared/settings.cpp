#include "ui/editor/shared/settings.h"

#include <cstdlib>

#include "core/base/atomic_file.h"
#include "core/document/text/json_value.h"

namespace kerf {

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr int kVersion = 1;
constexpr int kLeastWindow = 480, kMostWindow = 16384;

// Takes a key out of the object; null where it is missing.
Json take(Json& from, const char* key) {
  const auto found = from.find(key);
  if (found == from.end()) return nullptr;
  Json value = std::move(*found);
  from.erase(found);
  return value;
}

void take_flag(Json& from, const char* key, bool& flag) {
  const Json value = take(from, key);
  if (value.is_boolean()) flag = value.get<bool>();
}

template <typename Number>
void take_number(Json& from, const char* key, Number& number, double low, double high) {
  const Json value = take(from, key);
  if (value.is_number()) number = static_cast<Number>(std::clamp(value.get<double>(), low, high));
}

Settings from_json(Json json) {
  Settings s;
  take(json, "version");
  if (take(json, "theme") == Json("light")) s.theme = Theme::kLight;
  if (take(json, "palette") == Json("orange-blue")) s.palette = BoxPalette::kOrangeAndBlue;
  take_number(json, "ui_scale", s.ui_scale, Settings::kLeastScale, Settings::kMostScale);
  take_number(json, "side_width", s.side_ems, Settings::kLeastSide, Settings::kMostSide);
  take_number(json, "width", s.width, kLeastWindow, kMostWindow);
  take_number(json, "height", s.height, kLeastWindow, kMostWindow);
  take_number(json, "split_share", s.split_share, 0.0, 1.0);
  take_flag(json, "side_shown", s.side_shown);
  take_flag(json, "antialias", s.antialias);
  take_flag(json, "live_recut", s.live_recut);
  take_flag(json, "heat_held", s.heat_held);
  take_number(json, "history_mb", s.history_megabytes, Settings::kLeastHistory, Settings::kMostHistory);
  take_number(json, "threads", s.threads, 0, Settings::kMostThreads);
  take_number(json, "drag_speed", s.drag_speed, Settings::kLeastSpeed, Settings::kMostSpeed);
  take_number(json, "wheel_speed", s.wheel_speed, Settings::kLeastSpeed, Settings::kMostSpeed);
  const Json bindings = take(json, "bindings");
  if (bindings.is_object()) {
    for (const auto& [action, key] : bindings.items()) {
      if (key.is_string()) s.bindings[action] = key.get<std::string>();
    }
  }
  const Json panels = take(json, "panels");
  if (panels.is_object()) {
    for (const auto& [panel, unfolded] : panels.items()) {
      if (unfolded.is_boolean()) s.panels[panel] = unfolded.get<bool>();
    }
  }
  const Json recent = take(json, "recent");
  if (recent.is_array()) {
    for (const Json& file : recent) {
      if (file.is_string() && s.recent.size() < Settings::kMostRecent)
        s.recent.emplace_back(file.get<std::string>());
    }
  }
  const Json frames = take(json, "frames");
  if (frames.is_object()) {
    for (const auto& [kind, frame] : frames.items()) s.frames[kind] = frame_from_json(frame);
  }
  const Json folder = take(json, "folder");
  if (folder.is_string()) s.folder = folder.get<std::string>();
  s.others = json.dump();
  return s;
}

// Paths may hold any bytes; JSON holds UTF-8 only. One that is not is left out.
bool is_utf8(const std::string& text) {
  try {
    return !Json(text).dump().empty();
  } catch (const Json::exception&) {
    return false;
  }
}

Json to_json(const Settings& s) {
  Json json = Json::parse(s.others, nullptr, false);
  if (!json.is_object()) json = Json::object();
  json["version"] = kVersion;
  json["theme"] = s.theme == Theme::kLight ? "light" : "dark";
  json["palette"] = s.palette == BoxPalette::kOrangeAndBlue ? "orange-blue" : "red-green";
  json["ui_scale"] = s.ui_scale;
  json["side_width"] = s.side_ems;
  json["width"] = s.width;
  json["height"] = s.height;
  json["split_share"] = s.split_share;
  json["side_shown"] = s.side_shown;
  json["antialias"] = s.antialias;
  json["live_recut"] = s.live_recut;
  json["heat_held"] = s.heat_held;
  json["history_mb"] = s.history_megabytes;
  json["threads"] = s.threads;
  json["drag_speed"] = s.drag_speed;
  json["wheel_speed"] = s.wheel_speed;
  json["bindings"] = s.bindings;
  json["panels"] = s.panels;
  json["recent"] = Json::array();
  for (const fs::path& file : s.recent) {
    if (is_utf8(file.string())) json["recent"].push_back(file.string());
  }
  json["frames"] = Json::object();
  for (const auto& [kind, frame] : s.frames)
    json["frames"][kind] = frame ? frame_to_json(*frame) : Json("guess");
  json["folder"] = is_utf8(s.folder.string()) ? s.folder.string() : "";
  return json;
}

LoadedSettings set_aside(const fs::path& file) {
  fs::path bad = file;
  bad += ".bad";
  std::error_code error;
  fs::rename(file, bad, error);
  return {Settings(), error
                          ? file.string() + ": cannot be read and cannot be set aside: the defaults are used"
                          : "The settings could not be read: they were set aside as " + bad.string()};
}

}  // namespace

Json frame_to_json(const FileFrame& frame) {
  return {{"unit", unit_symbol(frame.unit)}, {"up", frame.up == UpAxis::kZ ? "z" : "y"}};
}

std::optional<FileFrame> frame_from_json(const Json& json) {
  if (!json.is_object()) return std::nullopt;
  const Json unit = json.value("unit", Json()), up = json.value("up", Json());
  for (const FileUnit u : {FileUnit::kMillimetre, FileUnit::kCentimetre, FileUnit::kMetre, FileUnit::kInch}) {
    if (unit == Json(unit_symbol(u)) && (up == Json("y") || up == Json("z")))
      return FileFrame{u, up == Json("z") ? UpAxis::kZ : UpAxis::kY};
  }
  return std::nullopt;
}

void remember_recent(Settings& settings, const fs::path& file) {
  std::error_code error;
  fs::path whole = fs::weakly_canonical(fs::absolute(file, error), error);
  if (error) whole = file;
  std::erase(settings.recent, whole);
  settings.recent.insert(settings.recent.begin(), whole);
  if (settings.recent.size() > Settings::kMostRecent) settings.recent.resize(Settings::kMostRecent);
}

fs::path settings_file() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  if (config != nullptr && fs::path(config).is_absolute()) return fs::path(config) / "kerf" / "settings.json";
  const char* home = std::getenv("HOME");
  return fs::path(home != nullptr ? home : "/") / ".config" / "kerf" / "settings.json";
}

LoadedSettings read_settings(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) return {};
  const auto text = read_text_file(file);
  if (!text) return {Settings(), text.error().message};
  const auto json = parse_json(*text, file.string());
  if (!json || !json->is_object()) return set_aside(file);
  return {from_json(*json), ""};
}

Status write_settings(const Settings& settings, const fs::path& file) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) return failed(file.parent_path().string() + ": the folder for the settings cannot be made");
  return write_file_atomically(file, to_json(settings).dump(2) + "\n");
}

}  // namespace kerf
