#include "ui/editor/shell/editor_screen.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <glm/geometric.hpp>
#include <utility>

#include "core/base/json.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/user_input.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/editor/shell/panel_column.h"
#include "ui/editor/shell/session_statistics.h"
#include "ui/editor/shell/toolbar.h"
#include "ui/render/view/view_options.h"
#include "ui/window/gui.h"
#include "ui/window/number_text.h"
#include "ui/window/widgets.h"

namespace kerf {

bool is_popup_open() {
  constexpr ImGuiPopupFlags kAny = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;
  return ImGui::IsPopupOpen(nullptr, kAny) && ImGui::GetTopMostPopupModal() == nullptr;
}

void close_popups() {
  KERF_ASSERT(ImGui::GetCurrentContext()->WithinFrameScope);
  ImGui::ClosePopupToLevel(0, true);
}

bool pointer_is_over_panel() {
  KERF_ASSERT(ImGui::GetCurrentContext()->WithinFrameScope);
  return ImGui::IsWindowHovered(ImGuiHoveredFlags_AnyWindow | ImGuiHoveredFlags_AllowWhenBlockedByPopup |
                                ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
}

std::optional<InputEvent> DeferredPress::press_of(const InputEvent& event) {
  if (!held_) return std::nullopt;
  switch (event.kind) {
    case InputEvent::Kind::kMove:
      if (glm::length(event.at - held_->at) <= kClickReach) return std::nullopt;
      return std::exchange(held_, std::nullopt);
    case InputEvent::Kind::kPress:
    case InputEvent::Kind::kRelease:
      held_.reset();
      break;
    case InputEvent::Kind::kWheel:
    case InputEvent::Kind::kKey:
    case InputEvent::Kind::kKeyUp:
    case InputEvent::Kind::kText:
      break;
  }
  return std::nullopt;
}

namespace {

// The right button: a drag pans; a click selects the piece under the pointer and opens the context menu.
class PanOrMenu : public Pan {
 public:
  explicit PanOrMenu(Workspace& workspace)
      : Pan(workspace), workspace_(workspace), pressed_(workspace.input.pointer) {}
  void move(const InputEvent& event) override {
    pans_ = pans_ || glm::length(workspace_.input.pointer - pressed_) > kClickReach;
    if (pans_) Pan::move(event);
  }
  void release(const InputEvent&) override {
    if (pans_) return;
    if (!selected_under_pointer(workspace_)) select_under_pointer(workspace_, false);
    workspace_.input.asks_for_menu = true;
  }
  const char* words() const override { return pans_ ? Pan::words() : nullptr; }

 private:
  Workspace& workspace_;
  Vec2 pressed_;
  bool pans_ = false;
};

std::unique_ptr<Interaction> begin(Workspace& workspace, const Features& features, const InputEvent& event) {
  const bool alt = (event.mods & GLFW_MOD_ALT) != 0, left = event.button == GLFW_MOUSE_BUTTON_LEFT;
  const Press press{event, (event.mods & GLFW_MOD_SHIFT) != 0, (event.mods & GLFW_MOD_CONTROL) != 0};
  if (event.button == GLFW_MOUSE_BUTTON_RIGHT) return std::make_unique<PanOrMenu>(workspace);
  if (event.button == GLFW_MOUSE_BUTTON_MIDDLE && press.shift) return std::make_unique<Pan>(workspace);
  if (event.button == GLFW_MOUSE_BUTTON_MIDDLE || (left && alt)) return std::make_unique<Orbit>(workspace);
  for (size_t i = 0; left && i < features.size(); ++i) {
    if (auto claimed = features[i]->begin_interaction(press)) return claimed;
  }
  return nullptr;
}

constexpr std::chrono::seconds kSoon{1};
constexpr std::chrono::milliseconds kUnseen{300};  // a bar that appears only briefly is a distraction

constexpr uint32_t kFacesSent = 50'000;   // of a new scene, sent at a time
constexpr double kSendingSeconds = 0.06;  // of a frame, for sending them
constexpr double kMissable = 0.05;        // s; a missed frame this long is not noticed
constexpr double kLongest = 1e6;          // s; a script waits for background work
constexpr double kCutSeconds = 0.020;     // s of cutting per frame, or the time of drawing if that is more
constexpr double kFigureSeconds = 0.25;

// Returns the look of the right half, without the selected and hidden pieces of the open document.
ViewOptions look_of_second(const ViewOptions& first, double spread, const World& second) {
  ViewOptions look = first;
  look.pieces.clear();
  look.stage.reset();
  look.wire.reset();
  look.bodies.reset();
  look.scalar.reset();
  spread_pieces(second, spread, look);
  return look;
}

// Uploads the changes, or as much of a new scene as there is time for. In a script, whose clock stands during
// a frame, that is one part; if it leaves frames undrawn, changes are sent with the next drawn one.
void send(Workspace& workspace, bool in_script) {
  if (!workspace.view.picture_old && !workspace.view.heat_old) return;
  Renderer& renderer = workspace.screen.picture->first();
  if (!workspace.screen.window->draws() && !renderer.is_sending() && !workspace.links.cools) return;
  const size_t before = renderer.uploaded_bytes();
  const double until = workspace.screen.clock->seconds() + kSendingSeconds;
  while (!in_script && renderer.is_sending() && workspace.screen.clock->seconds() < until)
    renderer.send_faces(workspace.shown_world());
  renderer.catch_up(workspace.shown_world());
  if (renderer.uploaded_bytes() > before)
    workspace.services.statistics.chart.record_sent(renderer.uploaded_bytes() - before);
}

}  // namespace

void handle_mouse(Workspace& workspace, const Features& features, const InputEvent& event, bool free) {
  PointerInput& input = workspace.input;
  input.pointer = event.at;
  input.viewport_hovered = free && workspace.view.layout.viewport.contains(event.at);
  if (!input.held) workspace.view.in_second = workspace.view.layout.second.contains(event.at);
  switch (event.kind) {
    case InputEvent::Kind::kPress:
      if (input.held || !input.viewport_hovered) break;
      input.held = begin(workspace, features, event);
      input.held_button = event.button;
      break;
    case InputEvent::Kind::kMove:
      if (input.held) input.held->move(event);
      break;
    case InputEvent::Kind::kRelease:
      if (!input.held || event.button != input.held_button) break;
      input.held->release(event);
      if (!input.held->cuts()) input.held.reset();
      break;
    case InputEvent::Kind::kWheel:
      if (input.viewport_hovered && !(input.held && input.held->cuts())) zoom(workspace, event.wheel);
      break;
    case InputEvent::Kind::kKey:
    case InputEvent::Kind::kKeyUp:
    case InputEvent::Kind::kText:
      break;
  }
  if (input.held && input.held->over()) input.held.reset();
}

void BusyWindow::keep(const Vec2& pixels) {
  began_ = Clock::now();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glBindTexture(GL_TEXTURE_2D, kept_.name());
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 0, 0, static_cast<GLsizei>(pixels.x),
                   static_cast<GLsizei>(pixels.y), 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glBindTexture(GL_TEXTURE_2D, 0);
}

bool BusyWindow::handle_input(const Input& input, ChangeThread& change) {
  KERF_ASSERT(change.busy());
  for (const InputEvent& event : input.events) {
    if (event.kind == InputEvent::Kind::kKey && event.button == GLFW_KEY_ESCAPE) {
      change.stop();
    } else {
      deferred_events_.push_back(event);
    }
  }
  if (input.close) change.stop();
  return input.close;
}

void BusyWindow::draw(const Vec2& window, const Area& picture, ChangeThread& change) const {
  keep_active_item();
  const auto texture = to_im_texture(kept_.name());
  ImGui::GetBackgroundDrawList()->AddImage(
      texture, {0, 0}, {static_cast<float>(window.x), static_cast<float>(window.y)}, {0, 1}, {1, 0});
  const bool lasts = Clock::now() - began_ > kUnseen;
  if (lasts && draw_progress(picture, change.title(), change.fraction(), change.can_stop())) change.stop();
}

std::vector<InputEvent> BusyWindow::take_deferred_events() {
  std::vector<InputEvent> events = std::exchange(deferred_events_, {});
  if (events.empty() || Clock::now() - began_ < kSoon) return events;
  std::erase_if(events, [](const InputEvent& event) {
    return event.kind == InputEvent::Kind::kPress || event.kind == InputEvent::Kind::kWheel;
  });
  return events;
}

EditorScreen::EditorScreen(Window& window, LivePicture picture, LoadedSettings loaded,
                           const EditorOptions& options)
    : window_(window), options_(options), landmarks_(options.landmarks), picture_(std::move(picture)) {
  workspace_.screen.picture = &picture_;
  workspace_.screen.window = &window;
  workspace_.screen.clock = &window.clock();
  if (window.script() != nullptr) workspace_.screen.background_wait = kLongest;
  workspace_.settings = std::move(loaded.settings);
  workspace_.view.look.antialias = workspace_.settings.antialias;
  workspace_.view.look.show = default_show();
  threads_.follow(workspace_.settings.threads);
  features_ = make_features(workspace_, catalogue_);
  saved_ = workspace_.settings;
  catalogue_.gather(features_, workspace_.services.panels);
  header_.gather(features_);
  workspace_.changes.followed = [this](const Delta& delta) {
    for (const auto& feature : features_) feature->on_world_changed(delta);
  };
  workspace_.links.replaced = [this] {
    workspace_.input.held.reset();
    statistics_at_.reset();
    for (const auto& feature : features_) feature->on_document_opened();
  };
  workspace_.screen.landmarks = &landmarks_;
  keep_landmarks(&landmarks_);
  report_entries_to(&workspace_.message);
}

Status EditorScreen::open() {
  lay_out_window();
  picture_.first().limit_sending(kFacesSent);
  for (const auto& feature : features_) {
    if (Status started = feature->on_start(options_); !started) return started;
  }
  return Done{};
}

void EditorScreen::rest() {
  for (const auto& feature : features_) feature->on_idle();
}

void EditorScreen::report_error(const std::string& fault) {
  if (!fault.empty() && !workspace_.message.is_error) workspace_.message.error(fault);
}

void EditorScreen::resume_from_game(const GuiLook& look, const std::filesystem::path& scene) {
  KERF_ASSERT(wants_game());
  workspace_.links.leaves = Leaves::kNot;
  workspace_.settings.palette = look.palette;
  workspace_.view.picture_old = true;
  title_.clear();
  keep_landmarks(&landmarks_);
  report_entries_to(&workspace_.message);
  if (!scene.empty()) workspace_.links.open({scene});
}

void EditorScreen::close(bool left_by_user) {
  if (thread_.busy()) {
    thread_.stop();
    finish_change();
  }
  workspace_.beam.release(workspace_.session.document);
  workspace_.input.held.reset();
  for (const auto& feature : features_) feature->on_exit(left_by_user);
  report_entries_to(nullptr);
  save_settings();
}

GuiLook EditorScreen::look() const {
  const Settings& s = workspace_.settings;
  return {s.theme, s.palette, window_.scale() * static_cast<float>(s.ui_scale), options_.own_font};
}

bool EditorScreen::moving() const {
  if (thread_.busy() || easing_ || workspace_.view.picture_old || workspace_.view.heat_old || picture_.busy())
    return true;
  if (workspace_.changes.has_requests()) return true;
  return std::any_of(features_.begin(), features_.end(),
                     [](const auto& feature) { return feature->needs_redraw(); });
}

double EditorScreen::min_frame_seconds() const {
  constexpr double kProgress = 0.1;
  const bool still =
      !easing_ && !workspace_.view.picture_old && !picture_.busy() && !workspace_.changes.has_requests();
  return still && workspace_.opening.loader.busy() ? kProgress : 0;
}

// Input
// --------------------------------------------------------------------------------------------------------

KeyboardHold EditorScreen::keyboard_hold() const {
  if (thread_.busy()) return KeyboardHold::kForWork;
  const bool opens = std::any_of(features_.begin(), features_.end(),
                                 [](const auto& feature) { return feature->awaits_focus(); });
  return opens && !is_text_field_active() ? KeyboardHold::kForFocus : KeyboardHold::kNone;
}

void EditorScreen::handle_input(const Input& input) {
  if (!input.drops.empty()) deferred_drops_.push_back(input.drops);
  if (thread_.busy()) {
    if (busy_.handle_input(input, thread_)) workspace_.links.quit();
    return;
  }
  lay_out_window();
  catalogue_.bind(workspace_.settings, workspace_.view.shortcuts);
  std::vector<InputEvent> events = busy_.take_deferred_events();
  events.insert(events.end(), input.events.begin(), input.events.end());
  for (const InputEvent& event : events) handle_input_event(event);
  for (auto& files : std::exchange(deferred_drops_, {})) workspace_.links.open(std::move(files));
  if (input.close) workspace_.links.quit();
}

// Releases of keys, and characters, are handled by ImGui alone.
void EditorScreen::handle_input_event(const InputEvent& event) {
  switch (event.kind) {
    case InputEvent::Kind::kMove:
    case InputEvent::Kind::kPress:
    case InputEvent::Kind::kRelease:
    case InputEvent::Kind::kWheel:
      return handle_pointer(event);
    case InputEvent::Kind::kKey:
      return handle_key(event);
    case InputEvent::Kind::kKeyUp:
    case InputEvent::Kind::kText:
      break;
  }
}

void EditorScreen::handle_pointer(const InputEvent& event) {
  const bool in_picture = workspace_.view.layout.viewport.contains(event.at) && !pointer_is_over_panel();
  if (event.kind == InputEvent::Kind::kPress) workspace_.message.drop_objection();
  if (event.kind == InputEvent::Kind::kPress && is_popup_open() && in_picture) {
    close_popups();
    return deferred_press_.hold(event);
  }
  if (const auto press = deferred_press_.press_of(event)) handle_mouse(workspace_, features_, *press, true);
  const bool taken = std::any_of(features_.begin(), features_.end(), [&](const auto& feature) {
    return feature->handle_event(event, in_picture);
  });
  if (!taken)
    handle_mouse(workspace_, features_, event, !ImGui::GetIO().WantCaptureMouse && !is_popup_open());
}

void EditorScreen::handle_key(const InputEvent& event) {
  const bool taken = std::any_of(features_.begin(), features_.end(),
                                 [&](const auto& feature) { return feature->handle_event(event, false); });
  if (taken || is_text_field_active() || event.again) return;
  if (event.button == GLFW_KEY_ESCAPE) return is_popup_open() ? close_popups() : escape();
  run_shortcut(catalogue_.actions, event.button, event.mods, workspace_.message);
}

void EditorScreen::escape() {
  bool stopped = false;
  for (const auto& feature : features_) stopped = feature->cancel() || stopped;
  if (workspace_.input.held && workspace_.input.held->over()) workspace_.input.held.reset();
  if (stopped) return;
  if (workspace_.input.held && workspace_.input.held->cancel()) return workspace_.input.held.reset();
  for (const auto& feature : features_) {
    if (feature->discard_draft()) return;
  }
  for (const auto& feature : features_) {
    if (feature->clear_selection()) return;
  }
}

// Update
// --------------------------------------------------------------------------------------------------------

void EditorScreen::advance() {
  threads_.follow(workspace_.settings.threads);
  if (window_.script() != nullptr && workspace_.opening.loader.busy())
    workspace_.opening.loader.is_over(kLongest);
  if (thread_.busy() && !thread_.is_over(0)) return;
  if (thread_.busy()) finish_change();
  const double seconds = ImGui::GetIO().DeltaTime;
  workspace_.changes.process_requests();
  easing_ = workspace_.view.camera.advance(std::min(seconds, Workspace::kLongestStep));
  if (easing_) workspace_.view.picture_old = true;
  workspace_.screen.cut_until = window_.clock().seconds() + std::max(kCutSeconds, picture_.seconds());
  workspace_.screen.cut_seconds = 0;
  for (const auto& feature : features_) feature->update(seconds);
  workspace_.changes.cut();
  if (!workspace_.changes.is_pending()) workspace_.changes.report_done();
  for (const auto& feature : features_) feature->after_queue(seconds);
  if (workspace_.input.held && workspace_.input.held->over()) workspace_.input.held.reset();
  send(workspace_, window_.script() != nullptr);
}

void EditorScreen::finish_change() {
  thread_.finish();
  workspace_.changes.end_pending();
}

void EditorScreen::lay_out_window() {
  const double em = ImGui::GetFontSize(), bar = ImGui::GetFrameHeight();
  const Settings& settings = workspace_.settings;
  Layout layout = lay_out(window_.size(), em, bar, bar, panel_sizes(workspace_.services.panels, settings));
  if (workspace_.view.second_world != nullptr) layout = split_in_two(layout, settings.split_share);
  ViewState& view = workspace_.view;
  if (layout.first.size != view.layout.first.size || layout.second.size != view.layout.second.size)
    view.picture_old = true;
  view.layout = layout;
}

void EditorScreen::save_settings() {
  Settings& now = workspace_.settings;
  now.antialias = workspace_.view.look.antialias;
  if (options_.width == 0) {  // a size set for this session alone is not kept
    now.width = static_cast<int>(window_.size().x);
    now.height = static_cast<int>(window_.size().y);
  }
  if (now == saved_) return;
  const Settings before = std::exchange(saved_, now);
  const Status written = write_settings(now, settings_file(), settings_written_ ? &before : nullptr);
  settings_written_ = written.ok();
  if (!written) workspace_.message.error(written.error().message);
}

// Draw
// --------------------------------------------------------------------------------------------------------

void EditorScreen::draw() {
  busy_frame_ = thread_.busy();
  if (busy_frame_) return busy_.draw(window_.size(), workspace_.view.layout.viewport, thread_);
  const double began = window_.clock().seconds();
  if (!statistics_at_ || began - *statistics_at_ >= kFigureSeconds) {
    statistics_at_ = began;
    save_settings();
    bring_up_to_date(workspace_);
  }
  landmarks_.begin_frame();
  draw_panels();
  const double picture_began = window_.clock().seconds();
  draw_picture();
  picture_seconds_ = window_.clock().seconds() - picture_began;
  for (const auto& feature : features_) feature->on_captured(Feature::Captured::kPicture);
}

void EditorScreen::draw_panels() {
  const Layout& layout = workspace_.view.layout;
  draw_menu_bar(catalogue_.actions);
  draw_context_menu(catalogue_.actions, std::exchange(workspace_.input.asks_for_menu, false),
                    selected_count(workspace_.view.look.pieces) > 0);
  workspace_.view.header = workspace_.view.toolbar = {};
  if (workspace_.settings.toolbar_shown) {
    workspace_.view.header = header_.draw(layout, workspace_.input.tool, catalogue_.actions);
    workspace_.view.toolbar = toolbar_area(layout.viewport);
  }
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect(to_im(layout.viewport.at), to_im(layout.viewport.at + layout.viewport.size));
  workspace_.services.badges.begin_frame();
  for (const auto& feature : features_) feature->draw_overlay(list);
  if (workspace_.input.held) workspace_.input.held->draw(list);
  list.PopClipRect();
  draw_panel_areas(workspace_.view, catalogue_.panels, workspace_.services.panels, workspace_.settings);
  draw_splitters(workspace_.view, workspace_.settings);
  if (workspace_.settings.toolbar_shown) draw_toolbar(layout.viewport, catalogue_.actions);
  const char* hint = workspace_.input.held ? workspace_.input.held->words() : nullptr;
  for (size_t i = 0; hint == nullptr && i < features_.size(); ++i) hint = features_[i]->status_hint();
  if (!workspace_.input.held && !workspace_.services.statistics.shown.work.empty())
    hint = workspace_.services.statistics.shown.work.c_str();
  if (draw_status_bar(layout.status, hint, workspace_.message, workspace_.services.statistics.shown))
    workspace_.services.messages_shown = true;
  for (const auto& feature : features_) feature->draw_windows();
}

void EditorScreen::draw_picture() {
  ViewState& view = workspace_.view;
  const Layout& layout = view.layout;
  view.look.tree.palette = workspace_.settings.palette;
  view.look.by_day = workspace_.settings.theme == Theme::kLight;
  std::optional<BeamPicture> beam;  // its glare would hide the effect of a stage
  if (!view.look.stage && !workspace_.stroke_waits())
    beam = workspace_.beam.picture(workspace_.session.document);
  const Shot first{workspace_.shown_world(), view.seen_first(), view.look, beam, layout.first};
  const PictureChange change = view.picture_old ? PictureChange::kAll
                               : view.heat_old  ? PictureChange::kHeat
                                                : PictureChange::kNothing;
  ShadowStatistics& shadows = workspace_.services.statistics.shadows;
  if (layout.split() && workspace_.view.second_world != nullptr) {
    const ViewOptions look = look_of_second(view.look, view.spread, *workspace_.view.second_world);
    const double aspect = layout.second.size.x / layout.second.size.y;
    const Shot second{*workspace_.view.second_world, view.camera.view(aspect), look, beam, layout.second};
    new_picture_ = picture_.draw(first, &second, change, window_, shadows);
  } else {
    new_picture_ = picture_.draw(first, nullptr, change, window_, shadows);
  }
  view.picture_old = picture_.shows_dead_beam();
  view.heat_old = false;
}

// Comes last in a frame, because the window keeps showing it until the pending change is done.
void EditorScreen::drawn() {
  if (busy_frame_) return;
  for (const auto& feature : features_) feature->on_captured(Feature::Captured::kWindow);
  if (workspace_.screen.title != title_) window_.set_title(title_ = workspace_.screen.title);
  if (!workspace_.changes.is_pending()) return;
  busy_.keep(window_.pixel_size());
  thread_.start(workspace_.session.document, *workspace_.changes.take_pending());
  if (thread_.is_over(window_.script() != nullptr ? kLongest : kMissable)) finish_change();
}

// Landmarks are written after the frame, when it is known whether another one follows without input.
void EditorScreen::took(const FrameTime& time) {
  Statistics& statistics = workspace_.services.statistics;
  const double beside = busy_frame_ ? time.whole : time.before - picture_seconds_;
  statistics.frames.add(1000 * time.whole);
  statistics.between_pictures.add(1000 * beside);
  if (busy_frame_) return;
  const Renderer& renderer = picture_.first();
  if (renderer.is_sending() || renderer.is_loading_images()) workspace_.view.picture_old = true;
  if (workspace_.screen.cut_seconds > 0) {
    statistics.cutting_frames.add(1000 * time.whole);
    statistics.between_cutting_pictures.add(1000 * beside);
  }
  if (new_picture_) picture_.took(time.whole - workspace_.screen.cut_seconds);
  const ImVec2 at = ImGui::GetIO().MousePos;
  landmarks_.mark(workspace_.view.layout);
  if (is_popup_open()) landmarks_.mark("popup", {{at.x, at.y}, Vec2(1)});
  for (size_t i = 0; i < features_.size() && !thread_.busy(); ++i) features_[i]->add_landmarks(landmarks_);
  if (const Status written = landmarks_.finish(moving(), {at.x, at.y}); !written)
    workspace_.message.error(written.error().message);
}

// Report
// --------------------------------------------------------------------------------------------------------

std::optional<std::string> EditorScreen::answer(const std::string& what) const {
  if (what == "landmarks") return landmarks_.text();
  if (what == "report")
    return report().dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  return std::nullopt;
}

nlohmann::ordered_json EditorScreen::report() const {
  nlohmann::ordered_json report = session_report(workspace_);
  for (const auto& feature : features_) feature->write_session_log(report);
  return report;
}

}  // namespace kerf
