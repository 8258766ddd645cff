#include <imgui.h>

#include "ui/editor/editor_screen.h"
#include "ui/editor/file_choice.h"
#include "ui/editor/frame/frame_question.h"
#include "ui/editor/frame/load_bar.h"
#include "ui/editor/frame/menu_bar.h"
#include "ui/editor/frame/message_log.h"
#include "ui/editor/frame/shortcut_sheet.h"
#include "ui/editor/frame/status_bar.h"
#include "ui/editor/marks/picture_marks.h"
#include "ui/editor/path/path_marks.h"
#include "ui/editor/section/section_handles.h"
#include "ui/editor/tools/axes_gizmo.h"
#include "ui/editor/tools/light_handle.h"
#include "ui/editor/tools/piece_handles.h"
#include "ui/editor/tools/popups.h"
#include "ui/editor/view/piece_set.h"
#include "ui/editor/work/save_work.h"
#include "ui/render/spread.h"
#include "ui/window/progress_bar.h"
#include "ui/window/screenshot.h"

namespace kerf {

namespace {

constexpr double kFigureSeconds = 0.25;

// Empty while time stands still.
std::string time_text(const PlayState& play) {
  return play.playing ? std::string("playing ") + play.speed().name : "";
}

// How the right half is looked at. What was chosen or hidden are pieces of the open document, not of its
// twin.
ViewOptions look_of_twin(const ViewOptions& first, double spread, const World& twin) {
  ViewOptions look = first;
  look.pieces.clear();
  look.stage.reset();
  look.bodies.reset();
  spread_pieces(twin, spread, look);
  return look;
}

}  // namespace

void EditorScreen::draw() {
  busy_frame_ = thread_.busy();
  if (busy_frame_) return busy_.draw(window_.size(), state_.view.layout.viewport, thread_);
  update_figures();
  if (landmarks_) landmarks_->begin_frame();
  draw_panels();
  const double began = window_.clock().seconds();
  draw_picture();
  picture_seconds_ = window_.clock().seconds() - began;
  if (state_.requests.screenshot != Requests::Screenshot::kPicture) return;
  take_picture(std::exchange(state_.requests.screenshot, Requests::Screenshot::kNone));
}

void EditorScreen::drawn() {
  if (busy_frame_) return;
  const auto screenshot = std::exchange(state_.requests.screenshot, Requests::Screenshot::kNone);
  if (screenshot != Requests::Screenshot::kNone) take_picture(screenshot);
  show_title();
  begin_pending_change();
}

void EditorScreen::took(const FrameTime& time) {
  Figures& figures = state_.figures;
  const double beside = busy_frame_ ? time.whole : time.before - picture_seconds_;
  figures.frames.add(1000 * time.whole);
  figures.between_pictures.add(1000 * beside);
  if (busy_frame_) return;
  if (picture_.first().is_sending()) state_.view.picture_old = true;
  if (cut_.seconds() > 0) {
    figures.cutting_frames.add(1000 * time.whole);
    figures.between_cutting_pictures.add(1000 * beside);
  }
  if (new_picture_) picture_.took(time.whole - cut_.seconds());
  show_landmarks();
}

void EditorScreen::draw_panels() {
  const Layout& layout = state_.view.layout;
  draw_menu_bar(actions_);
  draw_picture_marks({state_.work.document, state_.view, state_.hand, state_.split, state_.stages,
                      state_.settings, state_.figures.shown, state_.figures.shadows, state_.lasers,
                      state_.play, state_.probe});
  draw_panel_column(layout.side, panels_, state_.settings);
  draw_splitters(layout, state_.settings);
  if (draw_status_bar(layout.status, state_.hand, state_.message, state_.figures.shown))
    state_.messages_shown = true;
  draw_frame_question(state_.view, state_.settings, state_.hand.cut_once);
  draw_load_bar(layout.viewport, state_.opening, state_.message);
  if (picture_.first().is_sending() && !state_.opening.loader.busy())
    draw_progress(layout.viewport, "Sending faces to the graphics card", picture_.first().sent_share(),
                  false);
  draw_shortcut_sheet(state_.shortcuts_shown, actions_, gestures());
  draw_message_log(state_.messages_shown, state_.message);
  draw_settings_page(state_.settings_page, state_.settings, usual_actions_);
  const Area& picture = layout.viewport;
  draw_palette(state_.palette, actions_, static_cast<float>(picture.at.x + 0.5 * picture.size.x),
               static_cast<float>(picture.at.y + ImGui::GetFontSize()));
  draw_file_choice(state_);
  draw_question(state_.decisions.question);
}

void EditorScreen::draw_picture() {
  ViewState& view = state_.view;
  const Document& document = state_.work.document;
  const Layout& layout = view.layout;
  view.look.tree.palette = state_.settings.palette;
  view.look.by_day = state_.settings.theme == Theme::kLight;
  std::optional<BeamPicture> beam;  // its glare would hide what a stage did
  if (!view.look.stage) beam = state_.hand.beam.picture(document);
  const Shot first{document.world(), view.seen_first(), view.look, beam, layout.first};
  const PictureChange change = view.picture_old ? PictureChange::kAll
                               : view.heat_old  ? PictureChange::kHeat
                                                : PictureChange::kNothing;
  ShadowFigures& shadows = state_.figures.shadows;
  if (layout.split()) {
    const World& twin = state_.split.twin.world();
    const ViewOptions look = look_of_twin(view.look, view.spread, twin);
    const double aspect = layout.second.size.x / layout.second.size.y;
    const Shot second{twin, view.camera.view(aspect), look, beam, layout.second};
    new_picture_ = picture_.draw(first, &second, change, window_, shadows);
  } else {
    new_picture_ = picture_.draw(first, nullptr, change, window_, shadows);
  }
  view.picture_old = picture_.shows_dead_beam();
  view.heat_old = false;
}

void EditorScreen::update_figures() {
  const double now = window_.clock().seconds();
  if (now - figures_at_ < kFigureSeconds) return;
  figures_at_ = now;
  save_settings();
  Figures& figures = state_.figures;
  figures.shown.unit = state_.view.frame.unit;
  const World& world = state_.work.document.world();
  const World& twin = state_.split.twin.world();
  const World* as_loaded = state_.work.as_loaded ? &*state_.work.as_loaded : nullptr;
  figures.shown.frame_ms = 1000 * picture_.seconds();
  figures.shown.time = time_text(state_.play);
  figures.shown.memory = memory_figures(std::array{&world, &twin, as_loaded},
                                        state_.work.document.history().bytes(), picture_.memory());
  const bool depth_shown = state_.settings.shows(PanelId::kTree);
  const bool depth_missing = depth_shown && !figures.shown.tree_depth;
  if (!std::exchange(figures.world_changed, false) && !depth_missing) return;
  count_world(figures.shown, world, depth_shown);
  note_stroke(figures.shown, state_.work.document);
  figures.shown.twin_faces = twin.live_faces();
}

void EditorScreen::take_picture(Requests::Screenshot what) {
  const bool window = what == Requests::Screenshot::kWindow;
  const Vec2 pixels = window_.pixel_size();
  const Area part = window ? Area{Vec2(0), pixels} : pixels_of(state_.view.layout.viewport, window_);
  const auto file = take_screenshot(pixels, part);
  state_.message.say(file ? "Saved: " + file->string() : file.error().message, !file.ok());
}

// After the frame, when it is known whether another one follows without input.
void EditorScreen::show_landmarks() {
  if (!landmarks_) return;
  const ImVec2 at = ImGui::GetIO().MousePos;
  const ViewState& view = state_.view;
  landmarks_->mark(view.layout);
  if (is_popup_open()) landmarks_->mark("popup", {{at.x, at.y}, Vec2(1)});
  if (state_.decisions.question.open()) landmarks_->mark("question", {{at.x, at.y}, Vec2(1)});
  if (state_.browser.open) landmarks_->mark("browser", {{at.x, at.y}, Vec2(1)});
  for (size_t i = 0; i < view.look.lights.size() && shows_light_handles(state_.settings); ++i) {
    if (const auto handle = light_handle(view, i))
      landmarks_->mark("light " + std::to_string(i), {*handle, Vec2(0)});
  }
  for (const PieceHandle& handle : piece_handles(view, state_.hand, state_.work.document.world()))
    landmarks_->mark(name_of(handle), {grip_of(handle), Vec2(0)});
  mark_lasers();
  for (const SectionHandle& handle : section_handles(view))
    landmarks_->mark(name_of(handle), {grip_of(handle), Vec2(0)});
  for (const AxisEnd& end : axis_ends(view)) landmarks_->mark(name_of(end), {end.at, Vec2(0)});
  if (const Status written = landmarks_->finish(moving(), {at.x, at.y}); !written)
    state_.message.say(written.error().message, true);
}

void EditorScreen::mark_lasers() {
  const FirstPicture picture(state_.view);
  const PathWork& path = state_.lasers.path;
  if (shows_path(state_.hand, state_.settings)) {
    for (const PathMark& mark : path_marks(path, state_.work.document.world(), picture))
      landmarks_->mark("path point " + std::to_string(mark.number), {mark.target, Vec2(0)});
    if (const auto knob = path_knob(path, picture)) landmarks_->mark("path knob", {knob->place, Vec2(0)});
  }
  for (const EmitterHandle& handle : emitter_handles(state_.lasers.emitter, picture))
    landmarks_->mark(name_of(handle), {handle.to, Vec2(0)});
}

void EditorScreen::show_title() {
  const std::string title = window_title(state_.work, state_.view.look.lights);
  if (title == title_) return;
  title_ = title;
  window_.set_title(title);
}

}  // namespace kerf
