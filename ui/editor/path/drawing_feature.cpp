#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/document/drawing_layers.h"
#include "core/document/job_files.h"
#include "core/document/text/json.h"
#include "ui/editor/path/drawing_placement.h"
#include "ui/editor/path/drawing_preview.h"
#include "ui/editor/path/uncut_lines.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/window/gui.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr const char* kNoDrawing = "Import a drawing first: File > Import Drawing.";
constexpr const char* kDrawingPanel = "path";
constexpr double kSnapAngle = 15;  // degrees
constexpr NumberRange kDrawingSize{1e-9, 1e9, "m"};

class DrawingFeature : public Feature {
 public:
  explicit DrawingFeature(Workspace& workspace) : workspace_(workspace) {
    workspace_.links.file_takers.push_back(
        {is_drawing_file, [this](const std::filesystem::path& file) { waiting_ = file; }});
  }

  std::vector<PanelPart> panel_parts() override {
    return {{"path.drawing", [this] { draw_panel(); }}};
  }
  std::vector<ToolOption> tool_options() override {
    const auto is_loaded = [this] { return drawing_.has_value(); };
    return {{"drawing.mode", 8, [this] { mode_row(); }, is_loaded},
            {"drawing.width", 5, [this] { size_row("Width", drawing_->half().x); }, is_loaded},
            {"drawing.turn", 4, [this] { turn_row(); }, is_loaded},
            {"drawing.with", 5, [this] { with_row(); }, is_loaded}};
  }
  std::vector<UserAction> actions() override {
    UserAction tool = tool_action(workspace_, kDrawingTool, "Drawing", "",
                                  "Shows the imported drawing; drag it, its corners and its knob.", false);
    tool.disabled_reason = [this] { return no_drawing_reason(); };
    return {tool,
            make_action("drawing.import", "Import Drawing...", "",
                        "Lays the lines of an SVG or DXF file onto the surface; you can also drop one on the "
                        "window.",
                        [this] { select_file(); }),
            make_action("drawing.cut", "Cut Drawing", "", "Cuts along the lines of the drawing.",
                        [this] { request_drawing_cut(); },
                        {.disabled_reason = [this] { return no_drawing_reason(); }}),
            make_action("drawing.cancel", "Remove Drawing", "", "Removes the drawing and cuts nothing.",
                        [this] { remove(); }, {.disabled_reason = [this] { return no_drawing_reason(); }})};
  }
  std::vector<Gesture> gestures() const override {
    return {{"place_drawing", "Left drag on a drawing, its corners or its knob",
             "Move it over the surface, scale it or turn it; Shift snaps the angle"}};
  }

  bool handle_event(const InputEvent& event, bool) override {
    const bool is_enter = event.button == GLFW_KEY_ENTER || event.button == GLFW_KEY_KP_ENTER;
    if (event.kind != InputEvent::Kind::kKey || !is_enter || !is_shown()) return false;
    // A key that is still held from the dialog that opened the drawing must not cut it.
    if (event.again || (event.mods & GLFW_MOD_CONTROL) != 0 || !are_keys_free()) return false;
    request_drawing_cut();
    return true;
  }
  std::unique_ptr<Interaction> begin_interaction(const Press& press) override {
    if (!is_shown() || press.control) return nullptr;
    workspace_.view.camera.finish();
    workspace_.message.clear();
    if (workspace_.view.in_second) {
      workspace_.message.error("Place the drawing in the left half.");
      return std::make_unique<ClickOnce>([] {});
    }
    end_exploded_view(workspace_.world(), workspace_.view);
    return std::make_unique<DragOfDrawing>(*this);
  }
  // A drawing cannot be restored, so Esc removes it only if there is nothing to cancel.
  bool clear_selection() override {
    if (!is_shown() || workspace_.input.held) return false;
    remove();
    return true;
  }
  const char* status_hint() const override {
    return is_shown() ? "Drawing: drag it into place, Enter to cut, Esc to remove it" : nullptr;
  }

  void update(double) override {
    load_waiting();
    uncut_.update(workspace_);
    if (!is_shown() || workspace_.cutting()) return;
    invalidate_old_preview();
    preview_.update(*drawing_, placement_, workspace_.world(), PrimaryViewport(workspace_.view));
  }
  void on_world_changed(const Delta&) override {
    preview_.invalidate();
    uncut_.clear();
  }
  void on_document_opened() override {
    uncut_ = UncutMarks();
    if (drawing_) remove();
  }

  void draw_overlay(ImDrawList& list) override {
    uncut_.draw(workspace_, list);
    if (!is_shown() || workspace_.cutting() || !preview_.is_valid()) return;
    const PrimaryViewport picture(workspace_.view);
    const Area& first = workspace_.view.layout.first;
    list.PushClipRect(to_im(first.at), to_im(first.at + first.size), true);
    preview_.draw(*drawing_, layers_, with_knife_ ? 0 : workspace_.laser.radius, picture, list);
    draw_drawing_frame(picture, plane(), drawing_->half(), workspace_.input.pointer_in_viewport(), list);
    list.PopClipRect();
  }
  void add_landmarks(Landmarks& landmarks) const override {
    if (!is_shown()) return;
    const PrimaryViewport picture(workspace_.view);
    mark_handles(drawing_handles(picture, plane(), drawing_->half()), landmarks);
    if (const auto middle = picture.place_of(plane().at)) landmarks.mark("drawing", {*middle, Vec2(0)});
  }
  void write_session_log(nlohmann::ordered_json& report) const override {
    if (uncut_.size() > 0) report["uncut_lines"] = uncut_.size();
    if (!drawing_) return;
    size_t hits = 0, points = 0;
    for (const ProjectedLine& line : preview_.lines()) {
      points += line.points.size();
      if (line.on_surface) hits += line.points.size();
    }
    report["drawing"] = {{"file", drawing_->file.filename().string()},
                         {"lines", drawing_->job.drawing.lines.size()},
                         {"at", vector_json(plane().at)},
                         {"width", 2 * placement_.scale * drawing_->half().x},
                         {"turn", degrees_of(placement_.turn)},
                         {"points", points},
                         {"points_on_surface", hits}};
  }

 private:
  // The left button: a handle scales or turns; elsewhere the drawing follows the pointer over the surface,
  // from a press outside the frame after a jump to the pointer.
  class DragOfDrawing : public Interaction {
   public:
    explicit DragOfDrawing(DrawingFeature& feature) : feature_(feature), before_(feature.placement_) {
      const Vec2 pointer = feature_.workspace_.input.pointer;
      const PrimaryViewport picture(feature_.workspace_.view);
      const auto handle =
          handle_under(drawing_handles(picture, feature_.plane(), feature_.drawing_->half()), pointer);
      if (handle) kind_ = handle->kind;
      if (handle) return;
      const auto middle = picture.place_of(feature_.placement_.anchor.at);
      if (feature_.is_inside(picture, pointer) && middle) {
        offset_ = *middle - pointer;
      } else {
        feature_.move_to(pointer);
      }
    }
    void move(const InputEvent& event) override {
      if (over()) return;
      const Vec2 pointer = feature_.workspace_.input.pointer;
      if (kind_) return feature_.drag_handle(*kind_, pointer, (event.mods & GLFW_MOD_SHIFT) != 0);
      feature_.move_to(pointer + offset_);
    }
    bool cancel() override {
      feature_.placement_ = before_;
      feature_.preview_.invalidate();
      return true;
    }
    // An action may remove the drawing.
    bool over() const override { return !feature_.drawing_; }
    const char* words() const override {
      if (!kind_) return "Moving the drawing";
      return *kind_ == DrawingHandle::Kind::kSize ? "Scaling the drawing"
                                                  : "Turning the drawing; Shift snaps the angle";
    }

   private:
    DrawingFeature& feature_;
    DrawingPlacement before_;
    std::optional<DrawingHandle::Kind> kind_;  // nullopt: moves
    Vec2 offset_{0};                           // of the middle from the pointer, screen coordinates
  };

  bool is_shown() const { return drawing_ && workspace_.input.tool == kDrawingTool; }
  const char* no_drawing_reason() const { return drawing_ ? nullptr : kNoDrawing; }
  JobPlane plane() const { return placement_.plane(workspace_.world().bounds()); }
  double world_units() const { return 1 / metres_per_unit(workspace_.view.frame.unit); }
  double default_speed() const { return kDrawingSpeed * world_units(); }

  // Cuts change faces without on_world_changed().
  void invalidate_old_preview() {
    const Document& document = workspace_.session.document;
    if (document.waiting() > 0 && !document.queue().only_cools()) return;
    const std::pair<size_t, size_t> now{document.revision(), workspace_.world().live_faces()};
    if (std::exchange(projected_at_, now) != now) preview_.invalidate();
  }

  // Import
  // ------------------------------------------------------------------------------------------------------

  void select_file() {
    browse(workspace_.services.browser,
           {.title = "Import Drawing",
            .verb = "Import",
            .hint = "Filter, or paste a full path",
            .only = FileKind::kDrawings,
            .take =
                [this](const std::filesystem::path& file) {
                  if (is_drawing_file(file)) return load(file);
                  return file.filename().string() + ": must end in .svg or .dxf";
                }},
           workspace_.settings.folder, "");
  }
  // A drawing dropped while a document is opened belongs to that document.
  void load_waiting() {
    if (waiting_.empty() || workspace_.opening.loader.busy()) return;
    if (const std::string why = load(std::exchange(waiting_, {})); !why.empty())
      workspace_.message.error(why);
  }
  // Returns the reason on failure, else an empty text.
  std::string load(const std::filesystem::path& file) {
    auto drawing = import_drawing(file);
    if (!drawing) return drawing.error().message;
    end_exploded_view(workspace_.world(), workspace_.view);
    drawing_ = std::move(*drawing);
    layers_ = {};
    selected_layer_ = 0;
    if (workspace_.input.tool != kDrawingTool) tool_before_ = workspace_.input.tool;
    workspace_.input.tool = kDrawingTool;
    workspace_.services.panels.show(kDrawingPanel);
    const bool fits = place();
    report_import(fits);
    return "";
  }
  // Places the drawing in the middle of the viewport, at its true size if that is comparable with the size of
  // the world. Returns true if it is.
  bool place() {
    placement_ = {};
    placement_.view = workspace_.view.seen_first();
    placement_.anchor = first_anchor();
    placement_.beam = downward_beam(workspace_.view.frame.up);
    const Vec3 size = workspace_.world().bounds().max - workspace_.world().bounds().min;
    placement_.axis = size.x >= std::max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
    placement_.scale = world_units();
    preview_.invalidate();
    constexpr double kLargest = 2, kSmallest = 1.0 / 200, kFitted = 0.25;
    const double diagonal = workspace_.world().bounds().diagonal();
    const double share = placement_.scale * drawing_->extent() / diagonal;
    if (!(diagonal > 0) || (share <= kLargest && share >= kSmallest)) return true;
    placement_.scale *= kFitted / share;
    return false;
  }
  SurfacePoint first_anchor() const {
    const CameraView& camera = placement_.view;
    const Bounds bounds = workspace_.world().bounds();
    if (const auto seen = surface_point(workspace_.world(), workspace_.view.look, camera.ray(0, 0)))
      return *seen;
    const Vec3 way = bounds.centre() - camera.eye;
    if (glm::length(way) > 0) {
      const Pose ray{camera.eye, glm::normalize(way)};
      if (const auto seen = surface_point(workspace_.world(), workspace_.view.look, ray)) return *seen;
    }
    return {bounds.centre(), -camera.forward};
  }
  void report_import(bool fits) {
    const FileUnit unit = workspace_.view.frame.unit;
    const Vec2 size = 2 * placement_.scale * drawing_->half();
    std::string text = "Drawing: " + drawing_->file.filename().string() + ", " +
                       count_text(drawing_->job.drawing.lines.size(), "line") + ", " +
                       length_label(size.x, unit) + " x " + length_label(size.y, unit);
    if (!fits) text += ", scaled to fit";
    for (const std::string& note : drawing_->job.notes) text += "; " + note;
    workspace_.message.info(text);
  }
  void remove() {
    drawing_.reset();
    preview_ = DrawingPreview();
    if (workspace_.input.tool == kDrawingTool) workspace_.input.tool = tool_before_;
  }

  // Handles
  // ------------------------------------------------------------------------------------------------------

  bool is_inside(const PrimaryViewport& picture, Vec2 place) const {
    const auto p = drawing_point(plane(), picture.ray(place));
    return p && std::abs(p->x) <= drawing_->half().x && std::abs(p->y) <= drawing_->half().y;
  }
  // Moves the middle to the surface at a place of the window.
  void move_to(Vec2 place) {
    const PrimaryViewport picture(workspace_.view);
    if (placement_.mode == DrawingMode::kView) placement_.view = picture.camera();
    preview_.invalidate();
    const auto surface = surface_point(workspace_.world(), workspace_.view.look, picture.ray(place));
    if (surface) {
      placement_.anchor = *surface;
    } else if (placement_.mode != DrawingMode::kWrap) {
      placement_.anchor.at = picture.at_depth_of(placement_.anchor.at, place);
    }
  }
  void drag_handle(DrawingHandle::Kind kind, Vec2 place, bool snaps) {
    JobPlane upright = plane();
    upright.turn = 0;
    const auto at = drawing_point(upright, PrimaryViewport(workspace_.view).ray(place));
    if (!at || *at == Vec2(0)) return;
    preview_.invalidate();
    if (kind == DrawingHandle::Kind::kSize) {
      set_scale(placement_.scale * glm::length(*at) / glm::length(drawing_->half()));
      return;
    }
    double angle = degrees_of(std::atan2(-at->x, at->y));
    if (snaps) angle = kSnapAngle * std::round(angle / kSnapAngle);
    placement_.turn = radians_of(angle);
  }
  void set_scale(double scale) {
    constexpr double kLargest = 1e12;  // of the true size; meshes may be a micrometre wide
    placement_.scale = std::clamp(scale, world_units() / kLargest, world_units() * kLargest);
  }

  // Rows
  // ------------------------------------------------------------------------------------------------------

  void mode_row() {
    const DrawingMode before = placement_.mode;
    choice_row("Placement", "##mode", placement_.mode, "Plane\0Axis\0Along View\0Wrap\0", "drawing mode",
               "On the plane of the surface, along an axis, as seen on the screen, or round a cylinder.");
    if (placement_.mode == before) return;
    placement_.view = workspace_.view.seen_first();
    if (!(placement_.view.project(placement_.anchor.at).z > 0)) placement_.anchor = first_anchor();
    preview_.invalidate();
  }
  void size_row(const char* name, double half) {
    if (!(half > 0)) return;
    double size = 2 * placement_.scale * half;
    if (!length_field(fields_, name, size, label_unit(size, workspace_.view.frame.unit),
                      "Size of the drawing; width and height keep their ratio.", "", kDrawingSize))
      return;
    set_scale(0.5 * size / half);
    preview_.invalidate();
  }
  void turn_row() {
    double degrees = degrees_of(placement_.turn);
    if (!fields_.number("Angle", degrees, "%.4g\u00b0", "Turn of the drawing, counter-clockwise.", kDegrees))
      return;
    placement_.turn = radians_of(degrees);
    preview_.invalidate();
  }
  void with_row() {
    choice_row("Cut With", "##with", with_knife_, "Laser\0Knife\0", "drawing with",
               "Cuts with the laser of the Laser panel, or with a knife of no width.");
  }
  void axis_row() {
    bool is_changed = false;
    if (placement_.mode == DrawingMode::kAxis) {
      is_changed = choice_row("Beam", "##beam", placement_.beam, "+X\0-X\0+Y\0-Y\0+Z\0-Z\0", "drawing beam",
                              "Direction of the beam.");
    } else if (placement_.mode == DrawingMode::kWrap) {
      is_changed = choice_row("Axis", "##axis", placement_.axis, "X\0Y\0Z\0", "drawing axis",
                              "Axis of the cylinder, which goes through the middle of the scene.");
      double radius = plane().wrap;
      if (length_field(fields_, "Wrap Radius", radius, label_unit(radius, workspace_.view.frame.unit),
                       "Radius of the cylinder around which the drawing is wrapped.", "", kPositive)) {
        placement_.radius = radius;
        is_changed = true;
      }
    }
    if (is_changed) preview_.invalidate();
  }
  void position_row() {
    if (fields_.vector("Position", placement_.anchor.at, "%.5g", "Position of the middle of the drawing.",
                       file_unit(workspace_.view.frame.unit), workspace_.world().loaded_bounds().diagonal()))
      preview_.invalidate();
  }
  void draw_panel() {
    if (!drawing_) {
      if (row_button("Import Drawing...", 1, nullptr,
                     "Lays the lines of an SVG or DXF file onto the surface; you can also drop one on the "
                     "window."))
        select_file();
      return;
    }
    ImGui::Separator();
    secondary_text(drawing_->file.filename().string() + ", " +
                   count_text(drawing_->job.drawing.lines.size(), "line"));
    for (const std::string& note : drawing_->job.notes) secondary_text(note);
    if (begin_properties("drawing")) {
      mode_row();
      axis_row();
      size_row("Width", drawing_->half().x);
      size_row("Height", drawing_->half().y);
      turn_row();
      position_row();
      with_row();
      choice_row("Depth", "##depth", first_surface_, "All Surfaces\0First Surface\0", "drawing depth",
                 "Cuts everything along the beam, or only as deep as the lines of the preview.");
      end_properties();
    }
    draw_layers();
    if (row_button("Cut Drawing", 2, nullptr, "Cuts along the lines of the drawing (Enter)."))
      request_drawing_cut();
    ImGui::SameLine();
    if (row_button("Remove", 2, nullptr, "Removes the drawing and cuts nothing (Esc).")) return remove();
    uncut_.draw_list();
  }
  void draw_layers() {
    for (size_t i = 0; i < drawing_->layers.size(); ++i) {
      const auto& [name, count] = drawing_->layers[i];
      ImGui::PushID(static_cast<int>(i));
      LayerSettings& layer = layers_.layers[name];
      bool is_cut = !layer.skip;
      if (ImGui::Checkbox("##cut", &is_cut)) layer.skip = !is_cut;
      mark_last_item("drawing layer", static_cast<int>(i));
      tooltip("Cuts the lines of this layer or colour.");
      ImGui::SameLine();
      ImGui::PushStyleColor(ImGuiCol_Text, layer_colour(name));
      ImGui::Bullet();
      ImGui::PopStyleColor();
      ImGui::SameLine();
      const std::string label = (name.empty() ? "No layer" : name) + ", " + count_text(count, "line");
      const std::string shown = whole_label(fitted_text(label, ImGui::GetContentRegionAvail().x));
      if (ImGui::Selectable((shown + "###name").c_str(), selected_layer_ == i)) selected_layer_ = i;
      mark_last_item("drawing layer name", static_cast<int>(i));
      ImGui::PopID();
    }
    draw_selected_layer();
  }
  void draw_selected_layer() {
    LayerSettings& layer = layers_.layers[drawing_->layers[selected_layer_].first];
    if (layer.skip || with_knife_ || !begin_properties("layer")) return;
    const FileUnit unit = workspace_.view.frame.unit;
    double radius = layer.radius.value_or(workspace_.laser.radius);
    if (length_field(fields_, "Beam Radius", radius, label_unit(radius, unit),
                     "Beam radius of the selected layer; that of the Laser panel until it is typed.", "",
                     kPositive))
      layer.radius = radius;
    double power = layer.power.value_or(workspace_.laser.power);
    if (fields_.number("Power", power, "%.5g W",
                       "Power for the selected layer; that of the Laser panel until it is typed.", kWatts,
                       kPositive))
      layer.power = power;
    double speed = layer.speed.value_or(default_speed());
    if (length_field(fields_, "Speed", speed, label_unit(speed, unit),
                     "Speed of the beam along the selected layer.", "/s", kPositive))
      layer.speed = speed;
    auto order = static_cast<size_t>(layer.order);
    if (fields_.count("Order", order, "Layers with a lower order are cut first.", 0, 1000))
      layer.order = static_cast<int64_t>(order);
    end_properties();
  }

  // Cut
  // ------------------------------------------------------------------------------------------------------

  void request_drawing_cut() {
    if (workspace_.opening.loader.busy())
      return workspace_.message.info("Cannot cut until " + workspace_.opening.loader.order().name() +
                                     " is open.");
    workspace_.changes.enqueue(
        {.name = "Cut drawing", .run = [this] { return cut_drawing(), true; }, .is_one = true});
  }
  // Returns the strokes, with curves flattened for the beam and the size.
  Result<std::vector<StrokePath>> strokes() const {
    constexpr double kOfRadius = 50;
    const double radius = smallest_radius(*drawing_, layers_, workspace_.laser.radius);
    const double tolerance = radius / kOfRadius / placement_.scale;
    auto job = read_job_text(drawing_->text, drawing_->file.filename().string(), *job_kind(drawing_->file),
                             std::max(tolerance, 1e-9));
    if (!job) return job.error();
    std::vector<DrawnLine>& lines = job->drawing.lines;
    arrange_layers(layers_, lines, job->notes);
    if (lines.empty()) return bad_input("All layers are switched off: tick one in the Path panel.");
    const Bounds bounds = workspace_.world().bounds();
    std::vector<StrokePath> all = drawing_strokes(
        lines, drawing_->middle(), placement_.start(bounds, placement_.scale * drawing_->extent()));
    set_lasers(with_speed(*drawing_, layers_, default_speed()), lines, all);
    if (first_surface_)
      end_behind_surface(lines, drawing_->middle(), drawing_->extent(), placement_, workspace_.world(), all);
    return all;
  }
  // Cuts all lines on another thread, or none if the user stops it. The drawing stays, hidden, for its tool.
  void cut_drawing() {
    if (!drawing_) return;
    const auto all = strokes();
    if (!all) return workspace_.message.error(all.error().message);
    if (const auto why = rejection_reason(*all)) return workspace_.message.error(*why);
    cancel_stroke(workspace_);
    LaserControls laser = workspace_.laser;
    if (with_knife_) laser.model = Model::kGeometric;
    const double diagonal = workspace_.world().bounds().diagonal();
    std::vector<Command> commands = laser.commands_of(*all, diagonal, with_knife_);
    uncut_.begin(workspace_, with_knife_ ? std::vector<StrokePath>() : *all);
    workspace_.changes.change("Cutting the drawing", false, cut_along(std::move(commands), "Drawing"),
                              "Drawing cut. Tool > Drawing shows it again.");
    workspace_.links.cut_once = true;
    if (workspace_.input.tool == kDrawingTool) workspace_.input.tool = tool_before_;
  }

  Workspace& workspace_;
  std::optional<ImportedDrawing> drawing_;
  DrawingPlacement placement_;
  LayerTable layers_;
  size_t selected_layer_ = 0;
  UncutMarks uncut_;
  bool with_knife_ = false, first_surface_ = false;
  DrawingPreview preview_;
  std::pair<size_t, size_t> projected_at_;  // revision of the document and number of faces
  NumberFields fields_;
  std::string tool_before_ = kLaserTool;  // active before the drawing was imported
  std::filesystem::path waiting_;         // a dropped file, until a document is open
};

}  // namespace

std::unique_ptr<Feature> drawing_feature(Workspace& workspace) {
  return std::make_unique<DrawingFeature>(workspace);
}

}  // namespace kerf
