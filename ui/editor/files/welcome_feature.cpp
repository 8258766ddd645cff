#include "core/base/json.h"
#include "ui/editor/shared/features.h"

#include <imgui.h>
#include <algorithm>
#include <span>

#include "ui/editor/files/tour.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/thumbnails.h"
#include "ui/window/property_rows.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"
#include "ui/window/window.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;

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
    if (recent_ == workspace_.settings.recent) return;
    recent_ = workspace_.settings.recent;
    workspace_.services.thumbnails.keep_only(recent_);
  }

  void on_captured(Captured what) override {
    if (what == Captured::kPicture && is_due()) take();
  }

 private:
  std::vector<UserAction> files();
  bool is_due();
  void take();

  Workspace& workspace_;
  std::vector<fs::path> recent_;
  KeptState wanted_, taken_;
  double wanted_at_ = 0;  // s of the clock
};

std::vector<UserAction> RecentFeature::files() {
  std::vector<UserAction> actions;
  for (const fs::path& file : workspace_.settings.recent) {
    actions.push_back({.name = file.filename().string(), .tip = file.string()});
    actions.back().run = [this, file] { workspace_.links.open({file}); };
    actions.back().disabled_reason = [file]() -> const char* {
      std::error_code error;
      return fs::exists(file, error) ? nullptr : "This file no longer exists.";
    };
    actions.back().tip_picture = [this, file] { return workspace_.services.thumbnails.find(file); };
  }
  if (!actions.empty()) actions.back().ends_group = true;
  actions.push_back({.name = "Clear Recent Files", .tip = "Empties this list; the files stay."});
  actions.back().run = [this] { workspace_.settings.recent.clear(); };
  actions.back().disabled_reason = [this] {
    return workspace_.settings.recent.empty() ? "Nothing was opened yet." : nullptr;
  };
  return actions;
}

// Returns true if the viewport shows a file as it was opened or saved, and is complete.
bool RecentFeature::is_due() {
  const KeptState now{file_shown(workspace_.session), workspace_.session.saved_commands};
  if (now == taken_ || now.file.empty()) return false;
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
    return {UserAction{.id = "help.welcome",
                       .name = "Welcome",
                       .tip = "Recent files, scenes, and the tour.",
                       .run = [this] { shown_ = true; }},
            UserAction{.id = "help.tour",
                       .name = "Guided Tour",
                       .tip = "A tour of the car that goes on when a step is done.",
                       .run = [this] { begin_tour(); },
                       .checked = [this] { return tour_.is_on(); }}};
  }

  Status on_start(const EditorOptions& options) override {
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
  void draw_windows() override;
  void write_session_log(nlohmann::ordered_json& report) const override {
    report["welcome"] = shown_;
    report["tour"] = tour_.is_on() ? nlohmann::ordered_json(tour_.at()) : nlohmann::ordered_json(nullptr);
  }

 private:
  void begin_tour() {
    shown_ = false;
    tour_.begin(first_five_minutes(workspace_.view), tour_moment(workspace_));
  }
  void draw_welcome();
  void draw_recent();
  void draw_scenes();
  void open_by(const std::filesystem::path& file, const char* label, ImVec2 size);
  void draw_tour();

  Workspace& workspace_;
  bool shown_ = false;
  Tour tour_;
};

void WelcomeFeature::draw_windows() {
  if (shown_) draw_welcome();
  if (tour_.is_on()) draw_tour();
}

void WelcomeFeature::open_by(const std::filesystem::path& file, const char* label, ImVec2 size) {
  if (ImGui::Selectable(label, false, ImGuiSelectableFlags_None, size)) {
    shown_ = false;
    workspace_.links.open({file});
  }
}

void WelcomeFeature::draw_recent() {
  if (workspace_.settings.recent.empty()) return;
  ImGui::Spacing();
  ImGui::TextDisabled("Recent");
  const float em = ImGui::GetFontSize();
  const Vec2 picture(4.8 * em, 3 * em);
  for (const std::filesystem::path& file :
       std::span(workspace_.settings.recent).first(std::min(kMaxRecent, workspace_.settings.recent.size()))) {
    ImGui::PushID(file.c_str());
    open_by(file, "##recent", {0, 3.5f * em});
    mark_last_item(("welcome " + file.filename().string()).c_str());
    draw_file_row(file, workspace_.services.thumbnails.find(file), picture);
    tooltip(file.c_str());
    ImGui::PopID();
  }
}

void WelcomeFeature::draw_scenes() {
  ImGui::Spacing();
  ImGui::TextDisabled("Scenes");
  for (const std::filesystem::path& scene : example_scenes()) {
    const std::string title = title_of_scene(scene);
    open_by(scene, title.c_str(), {0, 0});
    mark_last_item(("welcome " + title).c_str());
  }
}

// At the left, where it hides least of the scene in the middle.
void WelcomeFeature::draw_welcome() {
  const float em = ImGui::GetFontSize();
  const Area& picture = workspace_.view.layout.viewport;
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
    if (ImGui::Button("Cut the Car", {-1, 0})) shown_ = false;
    mark_last_item("welcome car");
    draw_recent();
    draw_scenes();
    ImGui::Spacing();
    ImGui::TextDisabled("Press any key to close. Reopen from Help > Welcome.");
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

void WelcomeFeature::draw_tour() {
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

}  // namespace

std::unique_ptr<Feature> welcome_feature(Workspace& workspace) {
  return std::make_unique<WelcomeFeature>(workspace);
}

}  // namespace kerf
