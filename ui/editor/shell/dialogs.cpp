#include "ui/editor/shell/dialogs.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/base/number_format.h"
#include "core/base/platform.h"
#include "core/document/text/json.h"
#include "ui/editor/shell/keymap.h"
#include "ui/editor/shell/panel_column.h"
#include "ui/gl/context.h"
#include "ui/window/gui.h"
#include "ui/window/layout.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr float kLogEms = 48, kLogHeightEms = 26, kTimeEms = 5;

std::string time_text(std::time_t when) {
  std::tm parts{};
  localtime_r(&when, &parts);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%H:%M:%S", &parts);
  return text.data();
}

std::string as_text(const std::deque<Message::Entry>& log) {
  std::string all;
  for (const Message::Entry& said : log) all += time_text(said.when) + "  " + said.text + "\n";
  return all;
}

void draw_entry(const Message::Entry& said) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, colours::secondary());
  ImGui::TextUnformatted(time_text(said.when).c_str());
  if (said.is_error) ImGui::PopStyleColor();
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s%s", said.is_error ? "! " : "", said.text.c_str());
  if (!said.is_error) ImGui::PopStyleColor();
}

void draw_log(const std::deque<Message::Entry>& log) {
  if (log.empty()) return ImGui::TextDisabled("No messages");
  if (ImGui::SmallButton("Copy All")) ImGui::SetClipboardText(as_text(log).c_str());
  tooltip("Copies the messages as text, oldest first.");
  if (!ImGui::BeginTable("log", 2, ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg)) return;
  ImGui::TableSetupColumn("time", ImGuiTableColumnFlags_WidthFixed, kTimeEms * ImGui::GetFontSize());
  ImGui::TableSetupColumn("sentence", ImGuiTableColumnFlags_WidthStretch);
  for (size_t i = log.size(); i-- > 0;) draw_entry(log[i]);
  ImGui::EndTable();
}

constexpr float kColumnEms = 28, kKeysEms = 10;
constexpr size_t kMaxColumns = 3;
constexpr ImGuiWindowFlags kSheet = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings;

// A row of the sheet; a heading has no meaning.
struct ShortcutRow {
  std::string keys, meaning;
};

// Returns the gestures and the actions with keys that match the query, grouped by menu under headings.
std::vector<ShortcutRow> rows_of_sheet(std::span<const UserAction> actions, std::span<const Gesture> gestures,
                                       const char* query) {
  std::vector<ShortcutRow> rows;
  std::string group;
  const auto add = [&](const std::string& title, const std::string& keys, const std::string& meaning) {
    if (!fuzzy_score(query, keys + " " + meaning)) return;
    if (group != title) rows.push_back({group = title, ""});
    rows.push_back({keys, meaning});
  };
  for (const Gesture& g : gestures) add("Mouse", g.gesture, g.meaning);
  for (const UserAction& a : actions) {
    if (a.shortcut.empty()) continue;
    const std::string also = chord_text(a.also);
    add(a.menu, also.empty() ? a.shortcut : a.shortcut + ", " + also, a.name);
  }
  return rows;
}

// The width of a text column, and the number of lines that a row takes in it.
struct SheetColumn {
  float keys, meaning;
  float lines(const ShortcutRow& row) const {
    const float line = ImGui::GetTextLineHeight();
    return std::max(ImGui::CalcTextSize(row.keys.c_str(), nullptr, false, keys).y,
                    ImGui::CalcTextSize(row.meaning.c_str(), nullptr, false, meaning).y) /
           line;
  }
};

void put_row(const ShortcutRow& row) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const bool heading = row.meaning.empty();
  ImGui::PushStyleColor(ImGuiCol_Text, heading ? colours::accent() : colours::secondary());
  ImGui::TextWrapped("%s", row.keys.c_str());
  ImGui::PopStyleColor();
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s", row.meaning.c_str());
}

// Draws the rows in columns of about equal height.
void draw_rows(std::span<const ShortcutRow> rows, size_t columns) {
  if (rows.empty()) return ImGui::TextDisabled("No shortcut matches.");
  const float em = ImGui::GetFontSize();
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {0.4f * em, 1});
  if (ImGui::BeginTable("shortcuts", static_cast<int>(columns))) {
    const SheetColumn column{kKeysEms * em, (kColumnEms - kKeysEms - 2.5f) * em};
    float left = 0;
    for (const ShortcutRow& row : rows) left += column.lines(row);
    for (size_t c = 0; c < columns && !rows.empty(); ++c) {
      const float share = left / static_cast<float>(columns - c);
      size_t count = 0;
      for (float height = 0; count < rows.size() && height < share; ++count)
        height += column.lines(rows[count]), left -= column.lines(rows[count]);
      ImGui::TableNextColumn();
      ImGui::PushID(static_cast<int>(c));
      if (ImGui::BeginTable("column", 2)) {
        ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, column.keys);
        ImGui::TableSetupColumn("meaning", ImGuiTableColumnFlags_WidthStretch);
        for (const ShortcutRow& row : rows.first(count)) put_row(row);
        ImGui::EndTable();
      }
      ImGui::PopID();
      rows = rows.subspan(count);
    }
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
}

constexpr float kPageWidthEms = 40, kPageHeightEms = 36, kKeyEms = 9;

// Returns the actions that can have a key, with their current keys.
std::vector<UserAction> bindable(std::span<const UserAction> usual, const Bindings& bindings) {
  std::vector<UserAction> actions = bind_keys({usual.begin(), usual.end()}, bindings);
  std::erase_if(actions, [](const UserAction& action) { return action.items != nullptr; });
  return actions;
}

void stop_waiting(SettingsPage& page) {
  page.waits_for.clear();
  page.clashes.reset();
}

void take_clashing_key(SettingsPage& page, Settings& settings, std::span<const UserAction> usual) {
  KERF_ASSERT(page.clashes && !page.waits_for.empty());
  rebind(settings.bindings, usual, page.waits_for, *page.clashes);
  stop_waiting(page);
}

// Binds the key to the action that the page waits for.
void bind_pressed(SettingsPage& page, Settings& settings, std::span<const UserAction> usual, int key,
                  int mods) {
  constexpr int kCounted = GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_ALT;
  const KeyChord chord{key, mods & kCounted};
  if (is_modifier(key) || chord_text(chord).empty()) return;
  const std::vector<UserAction> actions = bindable(usual, settings.bindings);
  const UserAction* action = find_action(actions, page.waits_for);
  if (action != nullptr && clash_of(actions, *action, chord) != nullptr) {
    page.clashes = chord;
    return;
  }
  rebind(settings.bindings, usual, page.waits_for, chord);
  stop_waiting(page);
}

void speed_row(const char* name, double& speed, const char* meaning) {
  property(name);
  const std::string id = std::string("##") + name;
  real_slider({name, id.c_str(), meaning, true}, speed, Settings::kMinSpeed, Settings::kMaxSpeed, "%.2f x");
  mark_last_item(name);
}

bool page_button(const char* label, const char* landmark, const char* meaning) {
  ImGui::SameLine();
  const bool pressed = ImGui::Button(label);
  mark_last_item(landmark);
  tooltip(meaning);
  return pressed;
}

// Draws the buttons next to the presets.
void draw_keymap_buttons(SettingsPage& page, Settings& settings) {
  if (page_button("Import...", "import keymap", "Reads the shortcuts of all actions from a file (.json)."))
    page.asks_for = SettingsPage::KeymapFile::kImport;
  if (page_button("Export...", "export keymap", "Writes the shortcuts of all actions to a file (.json)."))
    page.asks_for = SettingsPage::KeymapFile::kExport;
  const bool is_default = settings.bindings.empty();
  ImGui::BeginDisabled(is_default);
  if (page_button("Reset", "reset keymap",
                  is_default ? "All shortcuts are the default ones." : "Restores the default shortcuts."))
    settings.bindings.clear();
  ImGui::EndDisabled();
}

void draw_mouse(SettingsPage& page, Settings& settings) {
  if (!begin_properties("mouse")) return;
  speed_row("Orbit", settings.drag_speed, "Rotation of the view per drag of the mouse.");
  speed_row("Zoom", settings.wheel_speed, "Zoom per notch of the wheel.");
  property("Keymap");
  for (const BindingPreset& preset : binding_presets()) {
    if (&preset != binding_presets().data()) ImGui::SameLine();
    if (ImGui::RadioButton(preset.name, settings.bindings == preset.bindings))
      settings.bindings = preset.bindings;
    mark_last_item(preset.name);
    tooltip(preset.meaning);
  }
  draw_keymap_buttons(page, settings);
  end_properties();
}

void draw_machine(Settings& settings) {
  if (!begin_properties("machine")) return;
  property("Threads");
  const int most =
      std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, Settings::kMaxThreads);
  whole_slider(
      {"Threads", "##Threads", "Maximum threads for loading, measuring and saving. Cutting always uses one."},
      settings.threads, 0, most, settings.threads == 0 ? "all" : std::to_string(settings.threads));
  mark_last_item("Threads");
  end_properties();
}

// Draws the prompt for a key, or the clash to confirm.
void draw_prompt(SettingsPage& page, Settings& settings, std::span<const UserAction> usual,
                 std::span<const UserAction> actions) {
  const UserAction* action = find_action(actions, page.waits_for);
  if (action == nullptr)
    return ImGui::TextDisabled("Up/Down select - Enter or click rebinds - Del clears the shortcut");
  if (!page.clashes)
    return ImGui::TextUnformatted(
        ("Press a new shortcut for \"" + action->name + "\"; Esc to cancel.").c_str());
  const UserAction* other = clash_of(actions, *action, *page.clashes);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(
      (chord_text(*page.clashes) + " is assigned to \"" + (other ? other->name : "") + "\".").c_str());
  ImGui::SameLine();
  if (ImGui::Button("Reassign (Enter)")) return take_clashing_key(page, settings, usual);
  mark_last_item("take the key");
  ImGui::SameLine();
  if (ImGui::Button("Cancel (Esc)")) stop_waiting(page);
}

void draw_row(SettingsPage& page, const UserAction& action, size_t place) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(static_cast<int>(place));
  const bool waits = page.waits_for == action.id;
  if (ImGui::Selectable(action.name.c_str(), page.cursor == place, ImGuiSelectableFlags_SpanAllColumns)) {
    stop_waiting(page);
    page.cursor = place;
    page.waits_for = action.id;
  }
  mark_last_item(("key of " + action.id).c_str());
  if (!action.tip.empty()) tooltip(action.tip.c_str());
  if (page.cursor == place && std::exchange(page.show_cursor, false)) ImGui::SetScrollHereY();
  ImGui::PopID();
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, waits ? colours::accent() : colours::secondary());
  ImGui::TextUnformatted(waits ? "press a key" : action.shortcut.c_str());
  ImGui::PopStyleColor();
}

void draw_list(SettingsPage& page, std::span<const UserAction> actions) {
  if (!ImGui::BeginTable("keys", 2, ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg)) return;
  ImGui::TableSetupColumn("action", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, kKeyEms * ImGui::GetFontSize());
  for (size_t i = 0; i < actions.size(); ++i) draw_row(page, actions[i], i);
  ImGui::EndTable();
}

// The libraries of the program, with their licences; the README lists them, too.
constexpr std::array<std::pair<const char*, const char*>, 15> kLibraries{
    {{"Bullet", "zlib"},
     {"OpenMesh", "BSD, 3 clauses"},
     {"lib3mf", "BSD, 2 clauses"},
     {"zlib", "zlib"},
     {"oneTBB", "Apache 2.0"},
     {"GLM", "MIT"},
     {"JSON for Modern C++", "MIT"},
     {"CLI11", "BSD, 3 clauses"},
     {"Dear ImGui", "MIT"},
     {"GLFW", "zlib"},
     {"libepoxy", "MIT"},
     {"stb", "MIT or public domain"},
     {"OpenAL Soft", "LGPL 2 or later"},
     {"pybind11 and NumPy", "BSD, 3 clauses"},
     {"Roboto (font)", "Apache 2.0"}}};
constexpr float kAboutWidthEms = 30, kAboutHeightEms = 26;

void draw_about(bool& shown, const std::string& version) {
  if (!shown) return;
  if (begin_centred_window("About Kerf", "about", shown, kAboutWidthEms, kAboutHeightEms)) {
    ImGui::TextUnformatted(version.c_str());
    ImGui::TextWrapped("Graphics: %s", gl::renderer_name().c_str());
    ImGui::TextWrapped("The owner has not selected a licence for Kerf yet. It uses these libraries:");
    if (ImGui::BeginTable("libraries", 2, ImGuiTableFlags_RowBg)) {
      for (const auto& [library, licence] : kLibraries) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(library);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(licence);
      }
      ImGui::EndTable();
    }
  }
  end_centred_window();
}

class Dialogs : public Feature {
 public:
  Dialogs(Workspace& workspace, const Catalogue& catalogue) : workspace_(workspace), catalogue_(catalogue) {}

  std::vector<UserAction> actions() override { return joined({column_actions(), help_actions()}); }
  std::vector<Gesture> gestures() const override {
    return {{"orbit", "Middle drag, Alt+left drag", "Orbit"},
            {"pan", "Shift+middle drag, right drag", "Pan"},
            {"context", "Right click", "Select the piece under the pointer and open the context menu"},
            {"zoom", "Wheel", "Zoom to the pointer"},
            {"escape", "Esc",
             "Close a menu; end the cut, even after release; stop opening a file; clear the selection"}};
  }

  bool handle_event(const InputEvent& event, bool) override {
    if (event.kind != InputEvent::Kind::kKey) return false;
    if (workspace_.services.browser.open) {
      browser_key(workspace_.services.browser, event.button);
    } else if (palette_.open) {
      palette_key(palette_, event.button);
    } else if (page_.shown && !is_text_field_active()) {
      settings_page_key(page_, workspace_.settings, catalogue_.usual, event.button, event.mods);
    } else {
      return false;
    }
    return true;
  }
  Status on_start(const EditorOptions& options) override {
    version_ = options.version;
    return Done{};
  }
  bool clear_selection() override {
    const bool shown = about_shown_ || sheet_.shown || workspace_.services.messages_shown;
    about_shown_ = sheet_.shown = workspace_.services.messages_shown = false;
    return shown;
  }
  bool awaits_focus() const override { return workspace_.services.browser.open || palette_.open; }
  void draw_windows() override {
    draw_shortcut_sheet(sheet_, catalogue_.actions, catalogue_.gestures);
    draw_message_log(workspace_.services.messages_shown, workspace_.message);
    draw_about(about_shown_, version_);
    draw_settings_page(page_, workspace_.settings, catalogue_.usual);
    open_keymap_dialog(std::exchange(page_.asks_for, SettingsPage::KeymapFile::kNone));
    const Area& picture = workspace_.view.layout.viewport;
    draw_palette(palette_, catalogue_.actions, static_cast<float>(picture.at.x + 0.5 * picture.size.x),
                 static_cast<float>(picture.at.y + ImGui::GetFontSize()));
    const bool was_open = workspace_.services.browser.open;
    draw_file_browser(workspace_.services.browser);
    if (was_open && !workspace_.services.browser.open)
      workspace_.settings.folder = workspace_.services.browser.folder;
  }
  void add_landmarks(Landmarks& landmarks) const override {
    if (workspace_.services.browser.open) landmarks.mark("browser", {workspace_.input.pointer, Vec2(1)});
  }

 private:
  std::vector<UserAction> column_actions() {
    bool& shown = workspace_.settings.side_shown;
    std::vector<UserAction> actions = tab_actions(workspace_.services.panels);
    actions.push_back({.id = "view.panels", .name = "Panels", .items = [this] {
                         return panel_actions(catalogue_.panels, workspace_.services.panels);
                       }});
    actions.push_back(make_action("view.sidebar", "Sidebar", "F4",
                                  "Hides the sidebar, so that the viewport fills the window.",
                                  [&shown] { shown = !shown; }, {.checked = [&shown] { return shown; }}));
    bool& toolbar = workspace_.settings.toolbar_shown;
    actions.push_back(make_action(
        "view.toolbar", "Toolbar", "",
        "Shows the tools at the edge of the viewport, and the options of the active one at its top.",
        [&toolbar] { toolbar = !toolbar; }, {.checked = [&toolbar] { return toolbar; }}));
    return actions;
  }
  std::vector<UserAction> help_actions() {
    return {
        make_action("help.palette", "Command Palette", "Ctrl+P",
                    "Finds any action by parts of its name and shows its shortcut.",
                    [this] { open_palette(palette_); }),
        make_action("help.settings", "Settings", "Ctrl+,",
                    "Sets mouse speed, threads, and the shortcuts of all actions.",
                    [this] { page_.shown = !page_.shown; }, {.checked = [this] { return page_.shown; }}),
        make_action("help.shortcuts", "Shortcuts", "F1", "Lists all keys and mouse gestures.",
                    [this] { sheet_ = {.shown = !sheet_.shown}; },
                    {.checked = [this] { return sheet_.shown; }}),
        make_action("help.about", "About Kerf", "", "Shows version, graphics driver and libraries.",
                    [this] { about_shown_ = !about_shown_; }, {.checked = [this] { return about_shown_; }}),
        make_action("help.messages", "Messages", "",
                    "Lists all messages of the status bar in full; a click on the status bar does the same.",
                    [this] { workspace_.services.messages_shown = !workspace_.services.messages_shown; },
                    {.checked = [this] { return workspace_.services.messages_shown; }}),
    };
  }

  void open_keymap_dialog(SettingsPage::KeymapFile asked) {
    FileBrowser& browser = workspace_.services.browser;
    if (asked == SettingsPage::KeymapFile::kImport) {
      browse(browser,
             {.title = "Import Keymap",
              .verb = "Import",
              .hint = "Filter, or paste a full path",
              .listed = ".json",
              .take = [this](const std::filesystem::path& file) { return import_keymap(file); }},
             workspace_.settings.folder, "");
    } else if (asked == SettingsPage::KeymapFile::kExport) {
      browse(browser,
             {.title = "Export Keymap",
              .verb = "Export",
              .hint = "File name (.json)",
              .listed = ".json",
              .endings = {".json"},
              .take = [this](const std::filesystem::path& file) { return export_keymap(file); },
              .inputs = [this] { return inputs_of(workspace_.session); }},
             workspace_.settings.folder, "keymap.json");
    }
  }
  // Both return the reason on failure, else an empty text.
  std::string export_keymap(const std::filesystem::path& file) {
    const auto text = keymap_text(catalogue_.usual, workspace_.settings.bindings);
    if (!text) return text.error().message;
    const Status written = write_file_atomically(file, *text);
    if (!written) return written.error().message;
    workspace_.message.info("Exported: " + file.string());
    return "";
  }
  std::string import_keymap(const std::filesystem::path& file) {
    const auto text = read_text_file(file);
    if (!text) return text.error().message;
    auto bindings = parse_keymap(*text, file.string(), catalogue_.usual);
    if (!bindings) return bindings.error().message;
    workspace_.settings.bindings = std::move(*bindings);
    workspace_.message.info("Imported: " + file.string() + ", " +
                            count_text(workspace_.settings.bindings.size(), "shortcut") +
                            " other than the default");
    return "";
  }

  Workspace& workspace_;
  const Catalogue& catalogue_;
  CommandPalette palette_;
  SettingsPage page_;
  ShortcutSheet sheet_;
  bool about_shown_ = false;
  std::string version_;
};

}  // namespace

void draw_message_log(bool& shown, const Message& message) {
  if (!shown) return;
  if (begin_centred_window("Messages", "messages", shown, kLogEms, kLogHeightEms)) {
    draw_log(message.log);
  }
  end_centred_window();
}

void draw_shortcut_sheet(ShortcutSheet& sheet, std::span<const UserAction> actions,
                         std::span<const Gesture> gestures) {
  if (!sheet.shown) return;
  const float em = ImGui::GetFontSize();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float room = window.x - 2 * em;
  const size_t columns = std::clamp(static_cast<size_t>(room / (kColumnEms * em)), size_t(1), kMaxColumns);
  const float width = std::min(room, static_cast<float>(columns) * kColumnEms * em);
  ImGui::SetNextWindowPos({0.5f * window.x, 2 * em}, ImGuiCond_Always, {0.5f, 0});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, window.y - 3 * em});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 3);
  if (ImGui::Begin("Shortcuts", &sheet.shown, kSheet)) {
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##query", "Search shortcuts", sheet.query.data(), sheet.query.size());
    mark_last_item("shortcut search");
    draw_rows(rows_of_sheet(actions, gestures, sheet.query.data()), columns);
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
}

void settings_page_key(SettingsPage& page, Settings& settings, std::span<const UserAction> usual, int key,
                       int mods) {
  const bool enter = key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER;
  const bool waits = !page.waits_for.empty();
  if (key == GLFW_KEY_ESCAPE) {
    page.shown = waits;
    return stop_waiting(page);
  }
  if (page.clashes && enter) return take_clashing_key(page, settings, usual);
  if (waits) return bind_pressed(page, settings, usual, key, mods);
  const std::vector<UserAction> actions = bindable(usual, settings.bindings);
  if (key == GLFW_KEY_UP && page.cursor > 0) --page.cursor;
  if (key == GLFW_KEY_DOWN && page.cursor + 1 < actions.size()) ++page.cursor;
  page.show_cursor = true;
  KERF_ASSERT(page.cursor < actions.size());
  if (enter) page.waits_for = actions[page.cursor].id;
  if (key == GLFW_KEY_DELETE) rebind(settings.bindings, usual, actions[page.cursor].id, {});
}

void draw_settings_page(SettingsPage& page, Settings& settings, std::span<const UserAction> usual) {
  if (!page.shown) return;
  if (begin_centred_window("Settings", "settings", page.shown, kPageWidthEms, kPageHeightEms)) {
    const std::vector<UserAction> actions = bindable(usual, settings.bindings);
    draw_mouse(page, settings);
    draw_machine(settings);
    draw_prompt(page, settings, usual, actions);
    draw_list(page, actions);
  }
  end_centred_window();
  if (!page.shown) stop_waiting(page);
}

std::unique_ptr<Feature> dialogs(Workspace& workspace, const Catalogue& catalogue) {
  return std::make_unique<Dialogs>(workspace, catalogue);
}

}  // namespace kerf
