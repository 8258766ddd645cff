#include "ui/editor/shell/dialogs.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/base/number_format.h"
#include "core/base/platform.h"
#include "core/document/text/json.h"
#include "ui/editor/shell/command_palette.h"
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

// The libraries of the program, with their licences; the README lists them, too.
constexpr std::array<std::pair<const char*, const char*>, 16> kLibraries{
    {{"Bullet", "zlib"},
     {"OpenMesh", "BSD, 3 clauses"},
     {"lib3mf", "BSD, 2 clauses"},
     {"pugixml", "MIT"},
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

bool is_enter(int key) { return key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER; }

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

  // A key that is held confirms nothing by its repetitions, and is not bound by them.
  bool handle_event(const InputEvent& event, bool) override {
    if (event.kind != InputEvent::Kind::kKey) return false;
    const bool repeats = event.again && (is_enter(event.button) || !page_.waits_for.empty());
    if (workspace_.services.browser.open) {
      if (!repeats) browser_key(workspace_.services.browser, event.button);
    } else if (palette_.open) {
      if (!repeats) palette_key(palette_, event.button);
    } else if (page_.shown && (page_.in_search || !is_text_field_active())) {
      if (!repeats) settings_page_key(page_, workspace_.settings, catalogue_.usual, event.button, event.mods);
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
  void update(double) override {
    FileBrowser& browser = workspace_.services.browser;
    if (browser.preview) browser.preview->update(workspace_.screen.background_wait);
  }
  bool needs_redraw() const override {
    const FileBrowser& browser = workspace_.services.browser;
    return browser.open && browser.preview && browser.preview->busy();
  }
  bool awaits_focus() const override {
    return workspace_.services.browser.open || palette_.open || (page_.shown && page_.take_focus);
  }
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
    const FileBrowser& browser = workspace_.services.browser;
    if (was_open && !browser.open && browser.fault.empty())
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
    actions.push_back(make_action("view.sidebar", "Sidebar", "F4", "Shows the panels at the right.",
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
                    "Sets theme, units, undo memory, autosave, mouse, and the shortcuts of all actions.",
                    [this] { toggle_settings_page(page_); }, {.checked = [this] { return page_.shown; }}),
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

std::unique_ptr<Feature> dialogs(Workspace& workspace, const Catalogue& catalogue) {
  return std::make_unique<Dialogs>(workspace, catalogue);
}

}  // namespace kerf
