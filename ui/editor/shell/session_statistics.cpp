#include "ui/editor/shell/session_statistics.h"

#include <imgui.h>
#include <algorithm>
#include <string>
#include <vector>

#include "core/base/assert.h"
#include "core/base/json.h"
#include "core/document/cut_effects.h"
#include "core/document/text/hash.h"
#include "core/world/world.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

nlohmann::ordered_json memory_of(const MemoryStatistics& memory) {
  return {{"meshes", memory.meshes},
          {"trees", memory.trees},
          {"shading", memory.pictures.shading},
          {"shadows", memory.pictures.shadows},
          {"graphics", memory.pictures.graphics},
          {"history", memory.history},
          {"process", process_bytes()}};
}

nlohmann::ordered_json layout_of(const Layout& l) {
  const auto area = [](const Area& a) { return nlohmann::ordered_json{a.at.x, a.at.y, a.size.x, a.size.y}; };
  return {{"viewport", area(l.viewport)},
          {"first", area(l.first)},
          {"second", area(l.second)},
          {"side", area(l.side)},
          {"second_side", area(l.second_side)},
          {"strip", area(l.strip)},
          {"status", area(l.status)}};
}

// Returns the bodies that still have faces.
std::vector<BodyId> bodies_with_faces(const World& world) {
  std::vector<BodyId> ids = world.ids();
  std::erase_if(ids, [&](BodyId id) { return world.body(id).mesh.live_faces() == 0; });
  return ids;
}

nlohmann::ordered_json placements_of(const World& world) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const BodyId id : bodies_with_faces(world)) {
    const auto& [at, turned] = world.body(id).placement;
    all.push_back({{"name", world.body(id).own_name()},
                   {"pinned", world.body(id).pinned},
                   {"solid", world.body(id).solid},
                   {"position", {at.x, at.y, at.z}},
                   {"orientation", {turned.w, turned.x, turned.y, turned.z}}});
  }
  return all;
}

nlohmann::ordered_json times_of(const FrameStatistics& frames) {
  return {{"p50", frames.percentile(0.5)}, {"p99", frames.percentile(0.99)}, {"max", frames.longest()}};
}

nlohmann::ordered_json times_of_cutting(const Statistics& statistics) {
  return {{"frames", statistics.cutting_frames.frames()},
          {"frame_ms", times_of(statistics.cutting_frames)},
          {"between_pictures_ms", times_of(statistics.between_cutting_pictures)},
          {"each_frame_ms", statistics.cutting_frames.each()},
          {"each_between_pictures_ms", statistics.between_cutting_pictures.each()}};
}

nlohmann::ordered_json texts_of(const std::deque<Message::Entry>& log) {
  nlohmann::ordered_json texts = nlohmann::ordered_json::array();
  for (const Message::Entry& said : log) texts.push_back(said.text);
  return texts;
}

// Returns null if nothing is cut.
nlohmann::ordered_json last_stroke_of(const Document& document) {
  const auto last = document.history().last_cut();
  if (!last) return nullptr;
  const HistoryStep& step = document.history().step(*last);
  return {{"radius", document.history().last_settings().laser.radius},
          {"faces_made", step.totals().statistics.faces_made},
          {"faces_removed", step.totals().removed_faces},
          {"removed_area", step.totals().removed_area}};
}

// A text of the status bar in a slot, which never becomes narrower, so that its neighbours stay in place.
struct Slot {
  const char* id;
  std::string text;
  float min_width;  // sizes of the text
  ImU32 colour;
  bool dot = false;  // marks unsaved changes, before the text
};

constexpr float kDotEms = 0.9f;
constexpr size_t kKeptSlots = 3;        // these take precedence over the message
constexpr float kMessageShareEms = 24;  // of the room, for a long message

// "3 pieces, 84 specks".
std::string pieces_text(const ShownStatistics& shown) {
  const std::string pieces = count_text(shown.pieces, "piece");
  return shown.specks == 0 ? pieces : pieces + ", " + count_text(shown.specks, "speck");
}

std::string removed_text(const ShownStatistics& shown) {
  const double area = shown.stroke->removed_area;
  return area > 0 ? area_label(area, shown.unit) : "nothing";
}

std::string file_text(const ShownStatistics& shown) {
  if (!shown.unsaved) return shown.file;
  return shown.file + (shown.autosave.empty() ? " unsaved" : " " + shown.autosave);
}

// Listed from the right; the first ones stay longest if there is not enough room.
std::vector<Slot> slots_of(const ShownStatistics& shown) {
  std::vector<Slot> slots{{"faces", count_text(shown.faces, "face"), 6.0f, colours::text()},
                          {"pieces", pieces_text(shown), 4.4f, colours::text()},
                          {"file", file_text(shown), 4.0f, colours::secondary(), shown.unsaved},
                          {"selected", std::to_string(shown.selected) + " selected", 5.0f,
                           shown.selected > 0 ? colours::text() : colours::secondary()}};
  if (!shown.time.empty()) slots.push_back({"time", shown.time, 6.0f, colours::text()});
  if (shown.stroke)
    slots.push_back({"stroke", "last cut removed " + removed_text(shown), 12.4f, colours::secondary()});
  if (shown.cut_by_knife) slots.push_back({"stroke", "last cut by knife", 12.4f, colours::secondary()});
  return slots;
}

// Returns the width of a slot: the largest that its text had for the open file.
float width_of(const Slot& slot, const std::string& file) {
  const float em = ImGui::GetFontSize();
  const float text = ImGui::CalcTextSize(slot.text.c_str()).x / em + (slot.dot ? kDotEms : 0);
  float& kept = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID((slot.id + ("/" + file)).c_str()));
  kept = std::max({kept, text, slot.min_width});
  return (kept + 1.2f) * em;
}

void draw_slot(const Slot& slot, float x) {
  const float em = ImGui::GetFontSize();
  ImGui::SameLine(x);
  if (slot.dot) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddCircleFilled({at.x + 0.35f * em, at.y + 0.5f * ImGui::GetTextLineHeight()},
                                                0.26f * em, colours::accent());
    ImGui::SameLine(x + kDotEms * em);
  }
  ImGui::PushStyleColor(ImGuiCol_Text, slot.colour);
  ImGui::TextUnformatted(slot.text.c_str());
  ImGui::PopStyleColor();
  mark_last_item((std::string("status ") + slot.id).c_str());
}

// Draws them from `from` to `to`, without the less important ones where a message of this width would lack
// room. Returns where they begin.
float draw_statistics(const ShownStatistics& shown, float from, float to, float message) {
  std::vector<Slot> slots = slots_of(shown);
  std::vector<float> widths;
  float width = 0;
  for (size_t i = 0; i < slots.size(); ++i) {
    widths.push_back(width_of(slots[i], shown.file));
    const float room = to - from - (i < kKeptSlots ? 0 : message);
    if (width + widths[i] > room) {
      slots.resize(i);
      break;
    }
    width += widths[i];
  }
  float x = to;
  for (size_t i = 0; i < slots.size(); ++i) {
    x -= widths[i];
    draw_slot(slots[i], x + 1.2f * ImGui::GetFontSize());
  }
  return to - width;
}

// Draws the whole message, wrapped: it may be longer than the window is wide.
void draw_whole(const std::string& text) {
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(std::min(36 * ImGui::GetFontSize(), 0.9f * ImGui::GetIO().DisplaySize.x));
  ImGui::TextUnformatted(text.c_str());
  ImGui::TextDisabled("Click for all messages.");
  ImGui::PopTextWrapPos();
  mark_window("whole message");
  ImGui::EndTooltip();
}

bool draw_message(const Message& message, float from, float to) {
  ImGui::SameLine(from);
  ImGui::PushStyleColor(ImGuiCol_Text, message.is_error ? colours::text() : colours::secondary());
  ImGui::TextUnformatted(fitted_text((message.is_error ? "! " : "") + message.text, to - from).c_str());
  mark_last_item("message");
  ImGui::PopStyleColor();
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) draw_whole(message.text);
  return hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
}

bool draw_contents(const char* button, const Message& message, const ShownStatistics& shown) {
  // An error takes precedence over the action of the button if there is no room for both.
  const float em = ImGui::GetFontSize(), left = ImGui::GetStyle().WindowPadding.x;
  const float end = ImGui::GetWindowWidth() - left;
  const float hint = ImGui::CalcTextSize(button).x + 1.6f * em;
  const float wanted = message.text.empty() ? 0 : ImGui::CalcTextSize(message.text.c_str()).x + em;
  const float right = draw_statistics(shown, left + hint, end, std::min(wanted, kMessageShareEms * em));
  const bool crowded = message.is_error && left + hint + wanted > right;
  if (!crowded) {
    ImGui::SameLine(left);
    ImGui::TextUnformatted(button);
  }
  const float message_at = crowded ? left : left + hint;
  return !message.text.empty() && right > message_at && draw_message(message, message_at, right);
}

}  // namespace

nlohmann::ordered_json session_report(const Workspace& workspace) {
  const Document& document = workspace.session.document;
  const Statistics& statistics = workspace.services.statistics;
  return {
      {"frames", statistics.frames.frames()},
      {"frame_ms", times_of(statistics.frames)},
      {"between_pictures_ms", times_of(statistics.between_pictures)},
      {"while_cutting", times_of_cutting(statistics)},
      {"process_bytes", process_bytes()},
      {"memory_bytes", memory_of(statistics.shown.memory)},
      {"strokes", document.history().totals().strokes},
      {"waiting", document.waiting()},
      {"state_hash", hash_text(state_hash(document.world()))},
      {"faces", document.world().live_faces()},
      {"faces_removed", document.history().totals().removed_faces},
      {"removed_area", document.history().totals().removed_area},
      {"last_stroke", last_stroke_of(document)},
      {"pieces", document.world().live_pieces()},
      {"specks", specks(document).size()},
      {"recuts", statistics.recuts},
      {"bodies", bodies_with_faces(document.world()).size()},
      {"placements", placements_of(document.world())},
      {"message", workspace.message.text},
      {"messages", texts_of(workspace.message.log)},
      {"layout", layout_of(workspace.view.layout)},
  };
}

void bring_up_to_date(Workspace& workspace) {
  Statistics& statistics = workspace.services.statistics;
  ShownStatistics& shown = statistics.shown;
  shown.unit = workspace.view.frame.unit;
  shown.selected = selected_count(workspace.view.look.pieces);
  const World* as_loaded = workspace.session.as_loaded ? &*workspace.session.as_loaded : nullptr;
  shown.frame_ms = 1000 * workspace.screen.picture->seconds();
  shown.memory =
      memory_statistics(std::array{&workspace.world(), workspace.view.second_world, as_loaded},
                        workspace.session.document.history().bytes(), workspace.screen.picture->memory());
  const bool tree_missing = statistics.tree_wanted && !shown.tree;
  if (!std::exchange(statistics.world_changed, false) && !tree_missing) return;
  count_world(shown, workspace.session.document, statistics.tree_wanted);
  record_stroke(shown, workspace.session.document.history(), workspace.changes.groups());
}

bool draw_status_bar(const Area& area, const char* button, const Message& message,
                     const ShownStatistics& shown) {
  KERF_ASSERT(button != nullptr);
  ImGui::SetNextWindowPos({static_cast<float>(area.at.x), static_cast<float>(area.at.y)});
  ImGui::SetNextWindowSize({static_cast<float>(area.size.x), static_cast<float>(area.size.y)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImGui::GetStyle().FramePadding);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNavFocus |
                                      ImGuiWindowFlags_NoFocusOnAppearing;
  const bool clicked = ImGui::Begin("##status", nullptr, kFixed) && draw_contents(button, message, shown);
  ImGui::End();
  ImGui::PopStyleVar(2);
  return clicked;
}

}  // namespace kerf
