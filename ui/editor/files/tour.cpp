#include "ui/editor/files/tour.h"

#include <imgui.h>
#include <algorithm>
#include <span>

#include "core/base/assert.h"
#include "core/base/json.h"
#include "ui/editor/files/file_opener.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/thumbnails.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"
#include "ui/window/window.h"

namespace kerf {

namespace fs = std::filesystem;

namespace {

constexpr Ticks kSeenFalling = kTicksPerSecond;

// Returns "Ctrl+Z undoes the stroke."; the name of the action if no key is bound to it.
std::string by_key(const ViewState& view, const char* id, const std::string& name, const std::string& rest) {
  const std::string key = shortcut_of(view, id);
  return (key.empty() ? "\"" + name + "\"" : key) + rest;
}

constexpr float kWidth = 23, kMargin = 1.2f;  // sizes of the text
constexpr ImGuiWindowFlags kCard = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

// Draws a frame around the part, and a line from there to the card.
void point_at(const Area& part, ImVec2 card_corner) {
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  const float gap = 0.2f * ImGui::GetFontSize();
  const ImVec2 low = to_im(part.at - Vec2(gap)), high = to_im(part.at + part.size + Vec2(gap));
  list.AddRect(low, high, colours::accent(), 3, 0, 2);
  const float y = std::clamp(card_corner.y, low.y, high.y);
  list.AddLine({low.x, y}, card_corner, colours::accent(), 2);
}

TourMove draw_buttons(const Tour& tour) {
  TourMove move = TourMove::kNone;
  ImGui::BeginDisabled(tour.at() == 0);
  if (ImGui::Button("Back")) move = TourMove::kBack;
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button(tour.at() + 1 == tour.count() ? "Done" : "Next")) move = TourMove::kOn;
  mark_last_item("tour next");
  ImGui::SameLine();
  if (ImGui::Button("End Tour")) move = TourMove::kEnd;
  mark_last_item("tour end");
  ImGui::SameLine();
  ImGui::TextDisabled("%zu of %zu", tour.at() + 1, tour.count());
  return move;
}

constexpr double kMaxWait = 2;  // s, maximum wait of a thumbnail for a frame that keeps changing

// Returns the file that the viewport shows, as it was opened; empty if it shows none, or several.
fs::path file_shown(const DocumentSession& session) {
  if (!session.file.empty()) return session.file;
  return session.files.size() == 1 ? session.files.front() : fs::path();
}

// The state of a thumbnail: a file as it was opened or saved.
struct KeptState {
  fs::path file;
  size_t commands = 0;
  friend bool operator==(const KeptState&, const KeptState&) = default;
};

class RecentFeature : public Feature {
 public:
  explicit RecentFeature(Workspace& workspace) : workspace_(workspace) {}

  std::vector<UserAction> actions() override {
    return {UserAction{.id = "file.open_recent", .name = "Open Recent", .items = [this] { return files(); }}};
  }

  void update(double) override {
    std::vector<fs::path> listed = listed_files(workspace_.settings);
    if (recent_ == listed) return;
    recent_ = std::move(listed);
    workspace_.services.thumbnails.keep_only(recent_);
  }

  // A file that is opened again may have changed.
  void on_document_opened() override { wanted_ = taken_ = {}; }
  void on_captured(Captured what) override {
    if (what == Captured::kPicture && is_due()) take();
  }

 private:
  std::vector<UserAction> files();
  UserAction pin_action();
  bool is_due();
  void take();

  Workspace& workspace_;
  std::vector<fs::path> recent_;
  KeptState wanted_, taken_;
  double wanted_at_ = 0;  // s of the clock
};

std::vector<UserAction> RecentFeature::files() {
  std::vector<UserAction> actions;
  for (const fs::path& file : listed_files(workspace_.settings)) {
    actions.push_back({.name = file.filename().string(), .tip = file.string()});
    actions.back().run = [this, file] { workspace_.links.open({file}); };
    actions.back().disabled_reason = [file]() -> const char* {
      std::error_code error;
      return fs::exists(file, error) ? nullptr : "This file no longer exists.";
    };
    actions.back().tip_picture = [this, file] { return workspace_.services.thumbnails.find(file); };
    actions.back().checked = [this, file] { return is_pinned(workspace_.settings, file); };
    actions.back().ends_group = actions.size() == workspace_.settings.pinned.size();
  }
  if (!actions.empty()) actions.back().ends_group = true;
  actions.push_back(pin_action());
  actions.push_back(
      {.name = "Clear Recent Files", .tip = "Removes all entries that are not pinned; the files are kept."});
  actions.back().run = [this] { workspace_.settings.recent.clear(); };
  actions.back().disabled_reason = [this] {
    return workspace_.settings.recent.empty() ? "No recent files." : nullptr;
  };
  return actions;
}

UserAction RecentFeature::pin_action() {
  const fs::path open = file_shown(workspace_.session);
  const bool full = workspace_.settings.pinned.size() >= Settings::kMaxRecent;
  UserAction action{.name = "Pin Current File", .tip = "Keeps the open file at the top of this list."};
  action.run = [this, open] { pin_recent(workspace_.settings, open, !is_pinned(workspace_.settings, open)); };
  action.checked = [this, open] { return !open.empty() && is_pinned(workspace_.settings, open); };
  action.disabled_reason = [checked = action.checked, open, full]() -> const char* {
    if (open.empty()) return "Open a single file first.";
    return full && !checked() ? "Unpin another file first." : nullptr;
  };
  return action;
}

// Returns true if the viewport shows a file as it was opened or saved, and is complete.
bool RecentFeature::is_due() {
  const KeptState now{file_shown(workspace_.session), workspace_.session.saved_commands};
  if (now == taken_ || now.file.empty()) return false;
  if (is_unsaved(workspace_.session, workspace_.view.look.lights)) return false;
  if (now != wanted_) {
    wanted_ = now;
    wanted_at_ = workspace_.screen.clock->seconds();
  }
  if (!workspace_.screen.window->draws() || workspace_.opening.loader.busy() ||
      workspace_.screen.picture->first().is_sending())
    return false;
  return !workspace_.screen.picture->busy() || workspace_.screen.clock->seconds() - wanted_at_ > kMaxWait;
}

// A file that is not recent, such as the default scene, has no thumbnail. Write failures are ignored.
void RecentFeature::take() {
  taken_ = wanted_;
  const fs::path file = whole_path(taken_.file);
  if (std::ranges::find(recent_, file) == recent_.end()) return;
  const Area part = pixels_of(workspace_.view.layout.first, *workspace_.screen.window);
  (void)workspace_.services.thumbnails.keep(file,
                                            window_pixels(workspace_.screen.window->pixel_size(), part));
}

}  // namespace

TourMoment tour_moment(const Workspace& workspace) {
  const Document& document = workspace.session.document;
  const ShowOptions& show = workspace.view.look.show;
  return {.position = document.history().position(),
          .cuts = workspace.cutting(),
          .eye = workspace.view.seen_first().eye,
          .clock = document.world().clock(),
          .plays = workspace.links.plays,
          .shows_edges = show.wire,
          .shows_boxes = show.aabb || show.aabb_hit,
          .edge = workspace.laser.resolution.edge_fraction * workspace.laser.radius,
          .saved = !workspace.session.file.empty() &&
                   workspace.session.saved_commands == document.journal().size()};
}

std::vector<TourStep> first_five_minutes(const ViewState& view) {
  using M = TourMoment;
  return {
      {"Cut",
       "Hold the left button on one side of the mesh, drag across it past the other side, and release.", "",
       [](const M& begin, const M& now) { return now.position > begin.position && !now.cuts; }},
      {"Undo", by_key(view, "edit.undo", "Undo", " undoes the stroke and restores the mesh."),
       "panel history", [](const M& begin, const M& now) { return now.position < begin.position; }},
      {"Redo",
       by_key(view, "edit.redo", "Redo",
              " redoes the stroke. Click a row in the History panel to jump to that step."),
       "panel history", [](const M& begin, const M& now) { return now.position > begin.position; }},
      {"Orbit", "Drag with the middle button, or with Alt and the left one, to orbit; scroll to zoom.", "",
       [](const M& begin, const M& now) { return now.eye != begin.eye; }},
      {"Play",
       by_key(view, "physics.play", "Play",
              " starts the simulation: separated pieces fall. The Physics tab sets the speed."),
       "tab physics",
       [](const M& begin, const M& now) { return now.plays && now.clock >= begin.clock + kSeenFalling; }},
      {"Pause",
       by_key(view, "physics.play", "Play", " again pauses it; ") +
           by_key(view, "edit.undo", "Undo", " puts the pieces back."),
       "", [](const M&, const M& now) { return !now.plays; }},
      {"Wireframe",
       by_key(view, "view.wire", "Wireframe", " shows the edges: only faces under the beam are refined."),
       "tab view", [](const M& begin, const M& now) { return now.shows_edges != begin.shows_edges; }},
      {"Refine", "Drag the Edge slider in the Resolution panel: the last stroke is recut while it moves.",
       "resolution size", [](const M& begin, const M& now) { return now.edge != begin.edge; }},
      {"AABB Tree",
       by_key(view, "view.boxes", "AABB Tree",
              " shows the boxes of the tree that finds the faces: red if the beam hit them."),
       "tab view", [](const M& begin, const M& now) { return now.shows_boxes != begin.shows_boxes; }},
      {"Save",
       by_key(
           view, "file.save", "Save",
           " writes the document with its history. The tour ends here; Help has the tour and all shortcuts."),
       "", [](const M& begin, const M& now) { return now.saved && !begin.saved; }},
  };
}

void Tour::begin(std::vector<TourStep> steps, const TourMoment& now) {
  KERF_ASSERT(!steps.empty());
  steps_ = std::move(steps);
  go_to(0, now);
}

void Tour::follow(const TourMoment& now) {
  if (is_on() && step().done(begin_, now)) skip(now);
}

void Tour::skip(const TourMoment& now) {
  KERF_ASSERT(is_on());
  if (at_ + 1 == steps_.size()) return end();
  go_to(at_ + 1, now);
}

void Tour::go_back(const TourMoment& now) {
  KERF_ASSERT(is_on());
  if (at_ > 0) go_to(at_ - 1, now);
}

const TourStep& Tour::step() const {
  KERF_ASSERT(is_on());
  return steps_[at_];
}

void Tour::go_to(size_t step, const TourMoment& now) {
  at_ = step;
  begin_ = now;
}

TourMove draw_tour_card(const Tour& tour, const Area& picture, const std::optional<Area>& part) {
  const float em = ImGui::GetFontSize(), margin = kMargin * em;
  // Next to what it points at, which is right of the viewport, else in the upper left corner of the
  // viewport, where it hides neither the mesh nor the hints.
  const auto left = static_cast<float>(picture.at.x) + margin;
  const auto right = static_cast<float>(picture.at.x + picture.size.x) - margin;
  const float top =
      part ? static_cast<float>(part->at.y) + margin : static_cast<float>(picture.at.y) + 4 * em;
  const auto lowest = static_cast<float>(picture.at.y + picture.size.y) - 9 * em;
  const ImVec2 corner(part ? right : left, std::min(top, lowest));
  ImGui::SetNextWindowPos(corner, ImGuiCond_Always, {part ? 1.0f : 0.0f, 0});
  ImGui::SetNextWindowSize({std::min(kWidth * em, static_cast<float>(picture.size.x) - 2 * margin), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 3);
  TourMove move = TourMove::kNone;
  if (ImGui::Begin("##tour", nullptr, kCard)) {
    mark_window("tour");
    ImGui::PushStyleColor(ImGuiCol_Text, colours::accent());
    ImGui::TextUnformatted(tour.step().title.c_str());
    ImGui::PopStyleColor();
    ImGui::TextWrapped("%s", tour.step().text.c_str());
    ImGui::Spacing();
    move = draw_buttons(tour);
  }
  ImGui::End();
  ImGui::PopStyleVar();
  if (part) point_at(*part, {corner.x, corner.y + 0.5f * em});
  return move;
}

std::unique_ptr<Feature> recent_feature(Workspace& workspace) {
  return std::make_unique<RecentFeature>(workspace);
}

namespace {

constexpr size_t kMaxRecent = 4;

// Draws a file row over the last item: its thumbnail, or an empty frame of that size, its name and folder.
void draw_file_row(const std::filesystem::path& file, const std::optional<TipPicture>& thumbnail, Vec2 size) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float em = ImGui::GetFontSize();
  const ImVec2 row = ImGui::GetItemRectMin(), row_end = ImGui::GetItemRectMax();
  const ImVec2 at(row.x + 0.25f * em, row.y + 0.25f * em);
  const ImVec2 end(at.x + static_cast<float>(size.x), at.y + static_cast<float>(size.y));
  if (thumbnail)
    list.AddImageRounded(to_im_texture(thumbnail->texture), at, end, {0, 0}, {1, 1}, IM_COL32_WHITE, 3);
  list.AddRect(at, end, ImGui::GetColorU32(ImGuiCol_Border), 3);
  const float text = end.x + 0.6f * em, middle = (at.y + end.y) / 2;
  list.PushClipRect(row, row_end, true);
  list.AddText({text, middle - 1.1f * em}, colours::text(), file.filename().c_str());
  list.AddText({text, middle + 0.1f * em}, colours::secondary(), file.parent_path().filename().c_str());
  list.PopClipRect();
}

class WelcomeFeature : public Feature {
 public:
  explicit WelcomeFeature(Workspace& workspace) : workspace_(workspace) {}

  std::vector<UserAction> actions() override {
    return {
        make_action("help.welcome", "Welcome", "", "Opens the start page: recent files, scenes and the tour.",
                    [this] { shown_ = true; }),
        make_action("help.tour", "Guided Tour", "", "Explains the editor; each step waits for you.",
                    [this] { begin_tour(); }, {.checked = [this] { return tour_.is_on(); }})};
  }

  Status on_start(const EditorOptions& options) override {
    car_ = options.default_scene;
    shown_ = options.files.empty() && !options.events && !workspace_.settings.welcomed;
    workspace_.settings.welcomed = workspace_.settings.welcomed || shown_;
    return Done{};
  }

  // Events that close the welcome reach the rest of the editor as well.
  bool handle_event(const InputEvent& event, bool in_picture) override {
    const bool pressed = event.kind == InputEvent::Kind::kPress && in_picture;
    if (pressed || event.kind == InputEvent::Kind::kKey) shown_ = false;
    return false;
  }
  bool clear_selection() override {
    const bool was_on = tour_.is_on();
    tour_.end();
    return was_on;
  }

  void update(double) override { tour_.follow(tour_moment(workspace_)); }
  void on_document_opened() override { shown_ = false; }
  void draw_windows() override {
    if (shown_) draw_welcome();
    if (tour_.is_on()) draw_tour();
  }
  void write_session_log(nlohmann::ordered_json& report) const override {
    report["welcome"] = shown_;
    report["tour"] = tour_.is_on() ? nlohmann::ordered_json(tour_.at()) : nlohmann::ordered_json(nullptr);
  }

 private:
  void begin_tour() {
    shown_ = false;
    tour_.begin(first_five_minutes(workspace_.view), tour_moment(workspace_));
  }
  void open_car() {
    shown_ = false;
    if (workspace_.session.files != std::vector{car_}) workspace_.links.open({car_});
  }
  // At the left, where it hides least of the scene in the middle.
  void draw_welcome() {
    const float em = ImGui::GetFontSize();
    const Area picture = workspace_.view.below_header();
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                        ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
    ImGui::SetNextWindowPos(to_im(picture.at + Vec2(1.2 * em)));
    ImGui::SetNextWindowSize({15 * em, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 3);
    if (ImGui::Begin("##welcome", nullptr, kFlags)) {
      mark_window("welcome");
      ImGui::TextUnformatted("Kerf");
      ImGui::TextDisabled("Laser-cut any triangle mesh");
      ImGui::Spacing();
      if (ImGui::Button("Guided Tour", {-1, 0})) begin_tour();
      mark_last_item("welcome tour");
      if (ImGui::Button("Cut the Car", {-1, 0})) open_car();
      mark_last_item("welcome car");
      draw_recent();
      draw_scenes();
      ImGui::Spacing();
      ImGui::PushTextWrapPos(0);
      ImGui::TextDisabled("Press any key to close. Reopen from Help > Welcome.");
      ImGui::PopTextWrapPos();
    }
    ImGui::End();
    ImGui::PopStyleVar();
  }
  void draw_recent() {
    const std::vector<std::filesystem::path> listed = listed_files(workspace_.settings);
    if (listed.empty()) return;
    ImGui::Spacing();
    ImGui::TextDisabled("Recent");
    const float em = ImGui::GetFontSize();
    const Vec2 picture(4.8 * em, 3 * em);
    for (const std::filesystem::path& file : std::span(listed).first(std::min(kMaxRecent, listed.size()))) {
      ImGui::PushID(file.c_str());
      open_by(file, "##recent", {0, 3.5f * em});
      mark_last_item(("welcome " + file.filename().string()).c_str());
      draw_file_row(file, workspace_.services.thumbnails.find(file), picture);
      tooltip(file.c_str());
      ImGui::PopID();
    }
  }
  void draw_scenes() {
    ImGui::Spacing();
    ImGui::TextDisabled("Scenes");
    for (const std::filesystem::path& scene : example_scenes()) {
      const std::string title = title_of_scene(scene);
      open_by(scene, title.c_str(), {0, 0});
      mark_last_item(("welcome " + title).c_str());
    }
  }
  void open_by(const std::filesystem::path& file, const char* label, ImVec2 size) {
    if (ImGui::Selectable(label, false, ImGuiSelectableFlags_None, size)) {
      shown_ = false;
      workspace_.links.open({file});
    }
  }
  void draw_tour() {
    const char* name = tour_.step().part;
    std::optional<Area> part = *name != '\0' ? workspace_.screen.landmarks->find(name) : std::nullopt;
    const Area& status = workspace_.view.layout.status;
    if (part && part->at.y + part->size.y > status.at.y) part.reset();  // scrolled out of the column
    const TourMoment now = tour_moment(workspace_);
    switch (draw_tour_card(tour_, workspace_.view.layout.viewport, part)) {
      case TourMove::kNone:
        return;
      case TourMove::kBack:
        return tour_.go_back(now);
      case TourMove::kOn:
        return tour_.skip(now);
      case TourMove::kEnd:
        return tour_.end();
    }
  }

  Workspace& workspace_;
  fs::path car_;  // the default scene
  bool shown_ = false;
  Tour tour_;
};

}  // namespace

std::unique_ptr<Feature> welcome_feature(Workspace& workspace) {
  return std::make_unique<WelcomeFeature>(workspace);
}

}  // namespace kerf
