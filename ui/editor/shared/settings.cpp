#include "ui/editor/shared/settings.h"

#include <algorithm>
#include <array>
#include <span>

#include "core/base/assert.h"
#include "core/base/platform.h"
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

void read_recent(const Json& list, std::vector<fs::path>& recent) {
  if (!list.is_array()) return;
  for (const Json& file : list) {
    if (file.is_string() && recent.size() < Settings::kMaxRecent)
      recent.emplace_back(file.get<std::string>());
  }
}

Json frames_json(const Settings& s) {
  Json all = Json::object();
  for (const auto& [kind, frame] : s.frames) all[kind] = frame ? frame_to_json(*frame) : Json("guess");
  return all;
}

struct OldLabel {
  const char *label, *id;
};

constexpr OldLabel kOldActions[] = {
    {"New", "file.new"},
    {"Open...", "file.open"},
    {"Save", "file.save"},
    {"Save as...", "file.save_as"},
    {"Save the picture", "file.save_viewport_image"},
    {"Save the window", "file.save_screenshot"},
    {"Play the game", "file.play_game"},
    {"Quit", "file.quit"},
    {"Undo", "edit.undo"},
    {"Redo", "edit.redo"},
    {"Copy the view", "view.copy_camera"},
    {"Paste the view", "view.paste_camera"},
    {"Choose all pieces", "pieces.select_all"},
    {"Hide the chosen", "pieces.hide"},
    {"Show all pieces", "pieces.show_all"},
    {"Isolate the chosen", "pieces.isolate"},
    {"Rename the chosen", "pieces.rename"},
    {"Delete the chosen", "pieces.delete"},
    {"Export chosen pieces...", "pieces.export"},
    {"Pieces further apart", "pieces.explode_more"},
    {"Pieces nearer together", "pieces.explode_less"},
    {"Move the chosen", "pieces.move"},
    {"Rotate the chosen", "pieces.rotate"},
    {"Duplicate the chosen", "pieces.duplicate"},
    {"Pin the chosen", "pieces.pin"},
    {"Laser", "tool.laser"},
    {"Pick pieces", "tool.pick"},
    {"Inspect and measure", "tool.inspect"},
    {"Ruler", "tool.ruler"},
    {"Path", "tool.path"},
    {"Cut the last stroke again", "laser.recut"},
    {"Wider beam", "laser.wider"},
    {"Narrower beam", "laser.narrower"},
    {"Pattern: volume", "laser.pattern_volume"},
    {"Pattern: four rays", "laser.pattern_rays"},
    {"Finer cut", "resolution.finer"},
    {"Coarser cut", "resolution.coarser"},
    {"Split to edge length", "resolution.by_edge_length"},
    {"Split to tolerance", "resolution.by_tolerance"},
    {"Split to depth", "resolution.by_depth"},
    {"Scheme: one to four", "resolution.one_to_four"},
    {"Scheme: longest edge", "resolution.longest_edge"},
    {"Rim: faces", "resolution.rim_faces"},
    {"Rim: smooth", "resolution.rim_smooth"},
    {"Cut again as the slider moves", "resolution.live"},
    {"Run the path", "path.run"},
    {"Load a path...", "path.load"},
    {"Save the path...", "path.save"},
    {"Clear the path", "path.clear"},
    {"Remove the point", "path.delete_point"},
    {"Undo the edit of the path", "path.undo"},
    {"Redo the edit of the path", "path.redo"},
    {"Place the emitter", "emitter.place"},
    {"Fire the emitter", "emitter.fire"},
    {"Take the emitter away", "emitter.remove"},
    {"Single steps", "stages.step_mode"},
    {"Step through the last stroke", "stages.step_last_cut"},
    {"Play the stages", "stages.play"},
    {"Next stage", "stages.next"},
    {"Stage back", "stages.previous"},
    {"Finish the move", "stages.finish_segment"},
    {"Finish the stroke", "stages.finish_stroke"},
    {"Stages: faster", "stages.faster"},
    {"Stages: slower", "stages.slower"},
    {"Query: next box", "tree.next_node"},
    {"Query: box before", "tree.previous_node"},
    {"Query: show the boxes", "tree.show_query"},
    {"Play", "physics.play"},
    {"One tick", "physics.step"},
    {"Time: slower", "physics.slower"},
    {"Time: faster", "physics.faster"},
    {"Gravity", "physics.gravity"},
    {"Simplify to faces", "prepare.simplify_to_faces"},
    {"Simplify to an error", "prepare.simplify_to_error"},
    {"Subdivide", "prepare.subdivide"},
    {"Smooth", "prepare.smooth"},
    {"Turn inner shells", "prepare.turn_shells"},
    {"Prepare the mesh", "prepare.apply"},
    {"Preview of the preparation", "prepare.preview"},
    {"Frame all", "view.frame_all"},
    {"First view", "view.reset"},
    {"Front", "view.front"},
    {"Back", "view.back"},
    {"Right", "view.right"},
    {"Left", "view.left"},
    {"Top", "view.top"},
    {"Bottom", "view.bottom"},
    {"Orthographic", "view.orthographic"},
    {"Shadows: none, ground, all", "view.shadows"},
    {"Silhouette", "view.silhouette"},
    {"Shadow volumes", "view.shadow_volumes"},
    {"Shadow counts", "view.shadow_counts"},
    {"Facing the light", "view.shadow_facing"},
    {"Compare two shadow methods", "view.shadow_compare"},
    {"Trace shadow rays", "view.shadow_rays"},
    {"Glow of rims", "view.rim_glow"},
    {"Shading: by angle, smooth, flat", "view.shading"},
    {"Wire", "view.wire"},
    {"Section plane", "view.section"},
    {"Boxes of the tree", "view.boxes"},
    {"Piece colours", "view.pieces"},
    {"Level colouring", "view.sizes"},
    {"Temperature", "view.heat"},
    {"Normals", "view.normals"},
    {"Face numbers", "view.face_numbers"},
    {"Component graph", "view.graph"},
    {"Contacts", "view.contacts"},
    {"Colliders", "view.colliders"},
    {"Centres of mass", "view.centres"},
    {"Joints", "view.joints"},
    {"Ghost of what is gone", "view.ghost"},
    {"Two-sided lighting", "view.two_sided"},
    {"Cull backs", "view.cull_backs"},
    {"Sparks and smoke", "view.sparks"},
    {"Anti-aliasing", "view.antialias"},
    {"Split view", "view.split"},
    {"Column of panels", "view.sidebar"},
    {"Light theme", "view.light_theme"},
    {"Larger text", "view.scale_up"},
    {"Smaller text", "view.scale_down"},
    {"Tab: Cut", "tab.cut"},
    {"Tab: Look", "tab.view"},
    {"Tab: Move", "tab.physics"},
    {"Tab: Heat", "tab.thermal"},
    {"Tab: Prepare", "tab.mesh"},
    {"Command palette", "help.palette"},
    {"Settings", "help.settings"},
    {"Shortcuts", "help.shortcuts"},
    {"Messages", "help.messages"},
    {"Welcome", "help.welcome"},
    {"The first five minutes", "help.tour"},
    {"Add a light", "light.add"},
    {"Remove the chosen light", "light.remove"},
    {"Next light", "light.next"},
    {"Shadows: paper look", "light.paper_look"},
    {"Boxes: leaves only", "tree.leaves_only"},
    {"Boxes: only where the beam was", "tree.hit_only"},
    {"Boxes: one level more", "tree.level_more"},
    {"Boxes: one level less", "tree.level_less"},
    {"Boxes: orange and blue", "tree.colours"},
    {"Section plane: flip", "section.flip"},
    {"Section plane: across X", "section.across_x"},
    {"Section plane: across Y", "section.across_y"},
    {"Section plane: across Z", "section.across_z"},
    {"Section plane: parallel to the picture", "section.face_view"},
    {"Section plane: copy", "section.copy"},
    {"Section plane: paste", "section.paste"},
    {"Colour faces by: paint", "scalar_map.paint"},
    {"Colour faces by: level", "scalar_map.level"},
    {"Colour faces by: longest edge", "scalar_map.longest_edge"},
    {"Colour faces by: least angle", "scalar_map.min_angle"},
    {"Colour faces by: temperature", "scalar_map.temperature"},
    {"Colour faces by: distance to the rim", "scalar_map.rim_distance"},
    {"Undo the edit of distances", "ruler.undo"},
    {"Redo the edit of distances", "ruler.redo"},
    {"Export the distances...", "ruler.export"},
};

constexpr OldLabel kOldPanels[] = {
    {"Laser", "laser"},
    {"Resolution", "resolution"},
    {"Path", "path"},
    {"Pieces", "pieces"},
    {"History", "history"},
    {"View", "view"},
    {"Tree", "tree"},
    {"Scalar map", "scalar_map"},
    {"Graph", "graph"},
    {"Single step", "single_step"},
    {"Light", "light"},
    {"Ruler", "ruler"},
    {"Statistics", "statistics"},
    {"Display", "display"},
    {"Bodies", "bodies"},
    {"Material", "material"},
    {"Prepare", "prepare"},
    {"File", "file"},
};

constexpr OldLabel kOldTabs[] = {
    {"look", "view"}, {"move", "physics"}, {"heat", "thermal"}, {"prepare", "mesh"}};

std::string id_of_label(std::span<const OldLabel> labels, const std::string& label) {
  for (const OldLabel& old : labels) {
    if (label == old.label) return old.id;
  }
  return label;
}

void convert_keys(Json& settings, const char* field, std::span<const OldLabel> labels) {
  const auto found = settings.find(field);
  if (found == settings.end() || !found->is_object()) return;
  Json converted = Json::object();
  for (const auto& [label, value] : found->items()) converted[id_of_label(labels, label)] = value;
  *found = std::move(converted);
}

// Replaces the labels in settings of version 1, whose keys they were, by the ids of actions, panels and tabs.
// Keys that are not labels of that version stay.
void convert_labels(Json& settings) {
  convert_keys(settings, "bindings", kOldActions);
  for (const char* field : {"panels", "docks", "windows"}) convert_keys(settings, field, kOldPanels);
  const auto tab = settings.find("tab");
  if (tab != settings.end() && tab->is_string()) *tab = id_of_label(kOldTabs, *tab);
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
  f.number("width", s.width, 0, kMaxWindow);
  f.number("height", s.height, 0, kMaxWindow);
  for (int* size : {&s.width, &s.height}) *size = *size == 0 ? 0 : std::max(*size, kMinWindow);
  f.number("split_share", s.split_share, 0, 1);
  f.flag("side_shown", s.side_shown);
  f.flag("toolbar_shown", s.toolbar_shown);
  f.flag("antialias", s.antialias);
  f.flag("live_recut", s.live_recut);
  f.flag("prepare_preview", s.prepare_preview);
  f.flag("heat_held", s.heat_held);
  f.flag("welcomed", s.welcomed);
  f.number("history_mb", s.history_megabytes, Settings::kMinHistory, Settings::kMaxHistory);
  f.number("autosave_seconds", s.autosave_seconds, 0, Settings::kMaxAutosave);
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
  f.any("recent", recent_json(s.recent), [&](const Json& list) { read_recent(list, s.recent); });
  f.any("pinned", recent_json(s.pinned), [&](const Json& list) { read_recent(list, s.pinned); });
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
  if (is_pinned(settings, whole)) return;
  std::erase(settings.recent, whole);
  settings.recent.insert(settings.recent.begin(), whole);
  if (settings.recent.size() > Settings::kMaxRecent) settings.recent.resize(Settings::kMaxRecent);
}

void pin_recent(Settings& settings, const fs::path& file, bool pinned) {
  const fs::path whole = whole_path(file);
  std::erase(settings.pinned, whole);
  std::erase(settings.recent, whole);
  if (pinned) {
    settings.pinned.push_back(whole);
  } else {
    remember_recent(settings, whole);
  }
}

bool is_pinned(const Settings& settings, const fs::path& file) {
  return std::ranges::find(settings.pinned, whole_path(file)) != settings.pinned.end();
}

std::vector<fs::path> listed_files(const Settings& settings) {
  std::vector<fs::path> files = settings.pinned;
  files.insert(files.end(), settings.recent.begin(), settings.recent.end());
  return files;
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

static Json settings_json(const Settings& settings) {
  Json json = Json::parse(settings.others, nullptr, false);
  if (!json.is_object()) json = Json::object();
  Settings written = settings;
  KeptFields fields(json, KeptFields::Way::kWrite);
  describe(fields, written);
  return json;
}

Status write_settings(const Settings& settings, const fs::path& file, const Settings* before) {
  Json json = settings_json(settings);
  const auto text = before != nullptr ? read_text_file(file) : Result<std::string>("");
  const Json others = text ? Json::parse(*text, nullptr, false) : Json();
  if (others.is_object() && others.value("version", Json()) == Json(kVersion)) {
    const Json unchanged = settings_json(*before);
    for (const auto& [key, value] : unchanged.items()) {
      if (json[key] == value && others.contains(key)) json[key] = others[key];
    }
  }
  return write_kept(json, file);
}

void PanelPlaces::add(const std::string& id, Tab tab, Dock dock, bool unfolded) {
  known_.push_back({id, tab});
  settings_.panels.try_emplace(id, unfolded);
  if (dock != Dock::kColumn) settings_.docks.try_emplace(id, dock);
}

void PanelPlaces::select_tab() {
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
