#include "ui/editor/shared/settings.h"

#include <algorithm>
#include <array>
#include <span>

#include "core/base/assert.h"
#include "core/base/platform.h"
#include "ui/editor/shared/old_labels.h"
#include "ui/window/kept_fields.h"

namespace kerf {

using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

constexpr int kVersion = 2;
constexpr int kMinWindow = 480, kMaxWindow = 16384;
constexpr std::array kThemes{"dark", "light"};
constexpr std::array kPalettes{"red-green", "orange-blue"};
constexpr std::array kTabs{"cut", "view", "physics", "thermal", "mesh"};
constexpr std::array kDocks{"column", "second column", "strip", "window"};

// Paths may hold any bytes, but JSON only UTF-8; other paths are left out.
bool is_utf8(const std::string& text) {
  try {
    return !Json(text).dump().empty();
  } catch (const Json::exception&) {
    return false;
  }
}

// The entries of an object whose values are of one type.
template <typename T>
KeptFields& entries(KeptFields& f, const char* key, std::map<std::string, T>& of) {
  return f.any(key, of, [&](const Json& value) {
    if (!value.is_object()) return;
    for (const auto& [name, entry] : value.items()) {
      if (entry.type() == Json(T()).type()) of[name] = entry.template get<T>();
    }
  });
}

// Returns the value whose index in `names` is that of its name in the file.
template <typename Enum>
std::optional<Enum> named(std::span<const char* const> names, const Json& value) {
  const auto at = std::find(names.begin(), names.end(), value);
  return at != names.end() ? std::optional(static_cast<Enum>(at - names.begin())) : std::nullopt;
}

Json docks_json(const Settings& s) {
  Json all = Json::object();
  for (const auto& [id, dock] : s.docks) all[id] = kDocks.at(static_cast<size_t>(dock));
  return all;
}

Json windows_json(const Settings& s) {
  Json all = Json::object();
  for (const auto& [id, area] : s.windows) all[id] = {area.at.x, area.at.y, area.size.x, area.size.y};
  return all;
}

void read_windows(const Json& windows, Settings& s) {
  if (!windows.is_object()) return;
  for (const auto& [id, area] : windows.items()) {
    const bool is_area = area.is_array() && area.size() == 4 &&
                         std::all_of(area.begin(), area.end(), [](const Json& x) { return x.is_number(); });
    if (is_area) s.windows[id] = {{area[0], area[1]}, {area[2], area[3]}};
  }
}

Json recent_json(const std::vector<fs::path>& recent) {
  Json list = Json::array();
  for (const fs::path& file : recent) {
    if (is_utf8(file.string())) list.push_back(file.string());
  }
  return list;
}

Json frames_json(const Settings& s) {
  Json all = Json::object();
  for (const auto& [kind, frame] : s.frames) all[kind] = frame ? frame_to_json(*frame) : Json("guess");
  return all;
}

}  // namespace

static void describe(KeptFields& f, Settings& s) {
  f.any("version", kVersion, [](const Json&) {});
  f.choice("theme", s.theme, kThemes);
  f.choice("palette", s.palette, kPalettes);
  f.number("ui_scale", s.ui_scale, Settings::kMinScale, Settings::kMaxScale);
  f.number("side_width", s.side_ems, Settings::kMinSide, Settings::kMaxSide);
  f.number("second_width", s.second_ems, Settings::kMinSide, Settings::kMaxSide);
  f.number("strip_height", s.strip_ems, Settings::kMinStrip, Settings::kMaxStrip);
  f.number("width", s.width, kMinWindow, kMaxWindow);
  f.number("height", s.height, kMinWindow, kMaxWindow);
  f.number("split_share", s.split_share, 0, 1);
  f.flag("side_shown", s.side_shown);
  f.flag("antialias", s.antialias);
  f.flag("live_recut", s.live_recut);
  f.flag("prepare_preview", s.prepare_preview);
  f.flag("heat_held", s.heat_held);
  f.flag("welcomed", s.welcomed);
  f.number("history_mb", s.history_megabytes, Settings::kMinHistory, Settings::kMaxHistory);
  f.number("threads", s.threads, 0, Settings::kMaxThreads);
  f.number("drag_speed", s.drag_speed, Settings::kMinSpeed, Settings::kMaxSpeed);
  f.number("wheel_speed", s.wheel_speed, Settings::kMinSpeed, Settings::kMaxSpeed);
  entries(f, "bindings", s.bindings);
  entries(f, "panels", s.panels);
  f.any("tab", s.tab ? Json(kTabs.at(static_cast<size_t>(*s.tab))) : Json(),
        [&](const Json& tab) { s.tab = named<Tab>(kTabs, tab); });
  f.any("docks", docks_json(s), [&](const Json& docks) {
    if (!docks.is_object()) return;
    for (const auto& [id, place] : docks.items()) {
      if (const auto dock = named<Dock>(kDocks, place)) s.docks[id] = *dock;
    }
  });
  f.any("windows", windows_json(s), [&](const Json& windows) { read_windows(windows, s); });
  f.any("recent", recent_json(s.recent), [&](const Json& list) {
    if (!list.is_array()) return;
    for (const Json& file : list) {
      if (file.is_string() && s.recent.size() < Settings::kMaxRecent)
        s.recent.emplace_back(file.get<std::string>());
    }
  });
  f.any("frames", frames_json(s), [&](const Json& frames) {
    if (!frames.is_object()) return;
    for (const auto& [kind, frame] : frames.items()) s.frames[kind] = frame_from_json(frame);
  });
  f.any("folder", is_utf8(s.folder.string()) ? s.folder.string() : "", [&](const Json& folder) {
    if (folder.is_string()) s.folder = folder.get<std::string>();
  });
}

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

fs::path whole_path(const fs::path& file) {
  std::error_code error;
  fs::path whole = fs::weakly_canonical(fs::absolute(file, error), error);
  return error ? file : whole;
}

void remember_recent(Settings& settings, const fs::path& file) {
  const fs::path whole = whole_path(file);
  std::erase(settings.recent, whole);
  settings.recent.insert(settings.recent.begin(), whole);
  if (settings.recent.size() > Settings::kMaxRecent) settings.recent.resize(Settings::kMaxRecent);
}

fs::path settings_file() { return settings_folder() / "settings.json"; }

LoadedSettings read_settings(const fs::path& file) {
  LoadedSettings loaded;
  Json json = read_kept(file, loaded.fault);
  if (!json.contains("version") || json["version"] == Json(1)) convert_labels(json);
  KeptFields fields(json, KeptFields::Way::kRead);
  describe(fields, loaded.settings);
  loaded.settings.others = fields.rest().dump();
  return loaded;
}

Status write_settings(const Settings& settings, const fs::path& file) {
  Json json = Json::parse(settings.others, nullptr, false);
  if (!json.is_object()) json = Json::object();
  Settings written = settings;
  KeptFields fields(json, KeptFields::Way::kWrite);
  describe(fields, written);
  return write_kept(json, file);
}

void PanelPlaces::add(const std::string& id, Tab tab, Dock dock, bool unfolded) {
  known_.push_back({id, tab});
  settings_.panels.try_emplace(id, unfolded);
  if (dock != Dock::kColumn) settings_.docks.try_emplace(id, dock);
}

void PanelPlaces::choose_tab() {
  if (settings_.tab) return;
  const auto first = std::find_if(known_.begin(), known_.end(), [this](const Known& k) {
    return is_unfolded(k.id) && dock_of(k.id) == Dock::kColumn;
  });
  settings_.tab = first != known_.end() ? first->tab : Tab::kCut;
}

void PanelPlaces::show_tab(Tab tab) {
  settings_.tab = tab;
  settings_.side_shown = true;
}

Tab PanelPlaces::tab_of(const std::string& id) const {
  const auto found = std::find_if(known_.begin(), known_.end(), [&](const Known& k) { return k.id == id; });
  KERF_ASSERT(found != known_.end());
  return found != known_.end() ? found->tab : Tab::kCut;
}

Dock PanelPlaces::dock_of(const std::string& id) const {
  const auto found = settings_.docks.find(id);
  return found != settings_.docks.end() ? found->second : Dock::kColumn;
}

bool PanelPlaces::is_unfolded(const std::string& id) const {
  const auto found = settings_.panels.find(id);
  return found != settings_.panels.end() && found->second;
}

bool PanelPlaces::shows(const std::string& id) const {
  if (!is_unfolded(id)) return false;
  return dock_of(id) != Dock::kColumn || (settings_.side_shown && tab_of(id) == tab());
}

void PanelPlaces::show(const std::string& id) {
  settings_.panels[id] = true;
  if (dock_of(id) == Dock::kColumn) show_tab(tab_of(id));
}

void PanelPlaces::reveal(const std::string& id) {
  show(id);
  revealed_ = id;
}

bool PanelPlaces::take_revealed(const std::string& id) {
  if (revealed_ != id) return false;
  revealed_.clear();
  return true;
}

void PanelPlaces::fold(const std::string& id) { settings_.panels[id] = false; }

void PanelPlaces::dock(const std::string& id, Dock dock) {
  settings_.docks[id] = dock;
  show(id);
}

bool PanelPlaces::has_any(Dock dock) const {
  return std::any_of(known_.begin(), known_.end(),
                     [&](const Known& k) { return is_unfolded(k.id) && dock_of(k.id) == dock; });
}

}  // namespace kerf
