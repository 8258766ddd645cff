#include "ui/editor/prepare/prepare_panel.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/json.h"
#include "core/mesh/measures.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/window/layout.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr size_t kMaxFaces = 16'000'000;  // after a subdivision

// Returns the share of a piece in the target number of faces of all pieces.
size_t share_of_faces(const PieceRow& piece, const FaceForecast& all, size_t faces) {
  const double share = static_cast<double>(piece.faces) / static_cast<double>(all.before);
  return std::max<size_t>(1, static_cast<size_t>(std::floor(share * static_cast<double>(faces))));
}

// Returns the commands for one piece. The caller renames it in each command after the previous ones (see
// rename()).
std::vector<Command> commands_for(const PieceRow& row, const FaceForecast& all, const Preparation& p) {
  using Tool = Preparation::Tool;
  switch (p.tool) {
    case Tool::kSimplifyToFaces:
      return {SimplifyPiece{row.id, {.faces = share_of_faces(row, all, p.faces)}}};
    case Tool::kSimplifyToError:
      return {SimplifyPiece{row.id, {.error = p.error}}};
    case Tool::kSubdivide:
      return std::vector<Command>(p.times, SubdividePiece{row.id, p.scheme});
    case Tool::kTurnShells:
      return {TurnShells{row.id}};
    case Tool::kSmooth:
      break;
  }
  return {SmoothPiece{row.id, p.times}};
}

void rename(Command& command, const Delta& delta) {
  std::visit(
      [&](auto& c) {
        if constexpr (requires { c.piece; }) c.piece = named_after(delta, c.piece);
      },
      command);
}

constexpr double kMaxDepth =
    0.008;  // of the world size, max. depth behind a surface at which a wire is visible

std::vector<FaceId> faces_of_label(const Body& body, uint32_t label) {
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (body.mesh.is_live(FaceId(f)) && body.mesh.data(FaceId(f)).piece == label) faces.emplace_back(f);
  }
  return faces;
}

std::vector<Triangle> surface_of(const World& world, const PieceId& piece) {
  const Body& body = world.body(piece.body);
  std::vector<Triangle> surface;
  for (const FaceId f : faces_of_label(body, piece.label)) {
    Triangle t = body.mesh.triangle(f);
    for (Vec3& corner : t) corner = body.placement.to_world(corner);
    surface.push_back(t);
  }
  return surface;
}

void add_statistics(std::span<const Triangle> surface, Preview::Statistics& statistics) {
  double largest = std::cos(radians_of(statistics.min_angle));
  if (statistics.faces == 0) largest = -1;
  for (const Triangle& t : surface) largest = std::max(largest, largest_cosine(t));
  statistics.faces += surface.size();
  statistics.min_angle = degrees_of(std::acos(std::clamp(largest, -1.0, 1.0)));
}

// Returns the edges of the faces of a piece as pairs of vertices, each once.
std::vector<std::pair<uint32_t, uint32_t>> sides_of(const Body& body, uint32_t label) {
  std::vector<std::pair<uint32_t, uint32_t>> sides;
  for (const FaceId f : faces_of_label(body, label)) {
    const auto corners = body.mesh.corners(f);
    for (size_t i = 0; i < 3; ++i)
      sides.push_back(std::minmax({corners[i].index, corners[(i + 1) % 3].index}));
  }
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  return sides;
}

// Returns the wireframe of `made`, drawn with the placement of `shown`.
DrawnWire::Part wire_of(const World& world, const PieceId& made, const PieceId& shown) {
  const Body& body = world.body(made.body);
  DrawnWire::Part part{.piece = shown, .frame = {}, .edges = {}};
  const auto sides = sides_of(body, made.label);
  KERF_ASSERT(!sides.empty());
  const Positions positions = body.mesh.positions();
  const auto at = [&](uint32_t v) { return body.placement.to_world(positions[v]); };
  Vec3 low = at(sides[0].first), high = low;
  for (const auto& [from, to] : sides) {
    for (const uint32_t v : {from, to}) {
      low = glm::min(low, at(v));
      high = glm::max(high, at(v));
    }
  }
  part.frame = FloatFrame::around(low, high);
  for (const auto& [from, to] : sides) {
    const Vec3 a = at(from), b = at(to);
    part.edges.push_back({part.frame.to_float(a), part.frame.to_float(b)});
    part.mean_edge += glm::length(b - a) / static_cast<double>(sides.size());
  }
  return part;
}

struct PreviewRow {
  const char* name;
  std::string before, after;
  const char* meaning;
};

void draw_row(const PreviewRow& row) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(row.name);
  tooltip(row.meaning);
  for (const std::string& text : {row.before, row.after}) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
  }
}

std::string angle_text(double degrees) { return text_of("%.3g\u00b0", degrees); }

void draw_statistics(const Preview& preview, FileUnit unit) {
  if (!ImGui::BeginTable("preview", 3, ImGuiTableFlags_SizingStretchProp)) return;
  for (const char* heading : {"", "Before", "After"}) ImGui::TableSetupColumn(heading);
  ImGui::TableNextRow();
  for (const char* heading : {"", "Before", "After"}) {
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", heading);
  }
  const Preview::Statistics &before = preview.before, &after = preview.after;
  draw_row({"Faces", grouped(before.faces), grouped(after.faces), "Number of faces of the pieces."});
  draw_row({"Min. Angle", angle_text(before.min_angle), angle_text(after.min_angle),
            "Smallest angle of all these faces."});
  draw_row({"Distance", "", preview.distance > 0 ? length_label(preview.distance, unit) : "none",
            "Maximum distance between the old and the new surface, measured both ways."});
  ImGui::EndTable();
  mark_last_item("preview figures");
}

using PrepareTool = Preparation::Tool;

constexpr size_t kMaxSubdivisions = 4;
constexpr size_t kMaxTyped = 1'000'000'000'000;  // faces
constexpr double kUsualError = 0.001;            // of the world size

// In the order of Preparation::Tool and Subdivision.
constexpr std::array kTools{"Simplify to Face Count", "Simplify by Tolerance", "Subdivide", "Smooth",
                            "Turn Inner Shells"};

constexpr std::array kSchemes{"Loop", "Square Root of 3", "Midpoint"};

const char* button_name(PrepareTool tool) {
  if (tool == PrepareTool::kSubdivide) return "Subdivide###prepare";
  if (tool == PrepareTool::kTurnShells) return "Turn Inner Shells###prepare";
  return tool == PrepareTool::kSmooth ? "Smooth###prepare" : "Simplify###prepare";
}

}  // namespace

std::vector<PieceRow> pieces_to_prepare(const World& world, const PieceMap& looks) {
  std::vector<PieceRow> rows = list_pieces(world, looks);
  if (selected_count(looks) == 0) return rows;
  std::erase_if(rows, [&](const PieceRow& row) {
    const auto look = looks.find(row.id);
    return look == looks.end() || !look->second.selected;
  });
  return rows;
}

FaceForecast forecast(std::span<const PieceRow> pieces, const Preparation& p) {
  FaceForecast faces;
  for (const PieceRow& row : pieces) faces.before += row.faces;
  switch (p.tool) {
    case Preparation::Tool::kSimplifyToFaces:
      faces.after = std::min(faces.before, std::max(p.faces, pieces.size()));
      break;
    case Preparation::Tool::kSimplifyToError:
      break;
    case Preparation::Tool::kSubdivide:
      faces.after = faces.before;
      for (size_t i = 0; i < p.times && *faces.after <= kMaxFaces; ++i)
        *faces.after *= parts_of_face(p.scheme);
      break;
    case Preparation::Tool::kSmooth:
    case Preparation::Tool::kTurnShells:
      faces.after = faces.before;
      break;
  }
  return faces;
}

const char* preparation_title(Preparation::Tool tool) {
  if (tool == Preparation::Tool::kSubdivide) return "Subdividing";
  if (tool == Preparation::Tool::kTurnShells) return "Turning inner shells";
  return tool == Preparation::Tool::kSmooth ? "Smoothing" : "Simplifying";
}

const char* prepare_disabled_reason(std::span<const PieceRow> pieces, const Preparation& p) {
  const FaceForecast faces = forecast(pieces, p);
  if (faces.before == 0) return "There are no faces.";
  if (p.tool == Preparation::Tool::kSubdivide && *faces.after > kMaxFaces)
    return "The result would exceed 16 million faces.";
  if (p.tool == Preparation::Tool::kSimplifyToFaces && p.faces >= faces.before)
    return "The mesh already has no more faces than that.";
  return nullptr;
}

Outcome prepare_pieces(Document& document, std::span<const PieceRow> pieces, const Preparation& preparation,
                       const Progress* progress) {
  KERF_ASSERT(prepare_disabled_reason(pieces, preparation) == nullptr);
  const FaceForecast faces = forecast(pieces, preparation);
  std::vector<Command> commands;
  std::vector<double> shares;  // of the run time
  for (const PieceRow& row : pieces) {
    const std::vector<Command> own = commands_for(row, faces, preparation);
    commands.insert(commands.end(), own.begin(), own.end());
    const double share = static_cast<double>(row.faces) / static_cast<double>(faces.before);
    shares.insert(shares.end(), own.size(), share / static_cast<double>(own.size()));
  }
  Outcome all = document.run_whole({});  // executes the queue
  if (!all.ok()) return all;
  Outcome undone(all.delta);
  ProgressShares progress_shares(progress);
  for (Command& command : commands) rename(command, all.delta);
  const Status done = document.all_or_nothing([&]() -> Status {
    for (size_t i = 0; i < commands.size() && all.ok(); ++i) {
      const Progress own = progress_shares.next(shares[i]);
      Outcome one = document.apply(commands[i], progress ? &own : nullptr);
      for (Command& command : commands) rename(command, one.delta);
      all.append(std::move(one));
    }
    return all.ok() ? Status(Done{}) : Status(all.error());
  });
  if (done) return all;
  const Error why = all.ok() ? done.error() : all.error();
  undone.delta.replaced = true;
  undone.fail(why.message == cancelled().message ? failed("Stopped; nothing was changed.") : why);
  return undone;
}

const char* preview_disabled_reason(const World& world, std::span<const PieceRow> pieces,
                                    const Preparation& p) {
  if (const char* why = prepare_disabled_reason(pieces, p)) return why;
  if (world.live_faces() > kMaxFacesToPreview) return "No preview: the scene has more than 400 000 faces.";
  if (forecast(pieces, p).after.value_or(0) > kMaxFacesPreviewed)
    return "No preview: the result would exceed 1 600 000 faces.";
  return nullptr;
}

Result<Preview> make_preview(const World& world, std::span<const PieceRow> pieces, const Preparation& p,
                             const Progress& progress) {
  KERF_ASSERT(preview_disabled_reason(world, pieces, p) == nullptr);
  ProgressShares shares(&progress);
  const Progress preparing = shares.next(0.6), measuring = shares.next(0.4);
  Document document(world);
  document.set_window(0);
  const Outcome outcome = prepare_pieces(document, pieces, p, &preparing);
  if (!outcome) return outcome.error();
  Preview preview;
  auto wire = std::make_shared<DrawnWire>();
  ProgressShares of_pieces(&measuring);
  for (const PieceRow& row : pieces) {
    const Progress own = of_pieces.next(1 / static_cast<double>(pieces.size()));
    const PieceId made = named_after(outcome.delta, row.id);
    const std::vector<Triangle> old = surface_of(world, row.id), now = surface_of(document.world(), made);
    add_statistics(old, preview.before);
    add_statistics(now, preview.after);
    const auto distance = surface_distance(old, now, &own);
    if (!distance) return distance.error();
    preview.distance = std::max(preview.distance, *distance);
    wire->parts.push_back(wire_of(document.world(), made, row.id));
  }
  wire->depth = std::min(preview.distance, kMaxDepth * world.loaded_bounds().diagonal());
  preview.wire = std::move(wire);
  return preview;
}

LivePreview::~LivePreview() {
  if (job_) job_->stopped = true;
}

void LivePreview::follow(const World& world, const std::vector<PieceRow>& pieces, const Preparation& wanted) {
  KERF_ASSERT(preview_disabled_reason(world, pieces, wanted) == nullptr);
  wait(0);
  Wanted now{{}, wanted};
  for (const PieceRow& row : pieces) now.pieces.push_back(row.id);
  if (wanted_ == now && !waits_) return;
  if (wanted_ && (wanted_->pieces != now.pieces || wanted_->preparation.tool != wanted.tool ||
                  wanted_->preparation.scheme != wanted.scheme))
    shown_.reset();
  wanted_ = std::move(now);
  waits_ = job_ != nullptr;
  if (job_) job_->stopped = true;
  if (waits_) return;
  if (!copy_) copy_ = std::make_shared<const World>(world);
  begin(pieces, wanted);
}

void LivePreview::begin(const std::vector<PieceRow>& pieces, const Preparation& preparation) {
  fault_.clear();
  job_ = std::make_unique<Job>();
  job_->world = copy_;
  job_->pieces = pieces;
  job_->preparation = preparation;
  job_->result = std::async(std::launch::async, [job = job_.get()] {
    const Progress progress{[job](double fraction) {
      job->fraction = fraction;
      return !job->stopped;
    }};
    return make_preview(*job->world, job->pieces, job->preparation, progress);
  });
}

void LivePreview::drop() {
  if (job_) job_->stopped = true;
  wait(0);
  waits_ = false;
  wanted_.reset();
  copy_.reset();
  shown_.reset();
  fault_.clear();
}

void LivePreview::wait(double seconds) {
  if (!job_) return;
  const auto limit = std::chrono::duration<double>(seconds);
  if (job_->result.wait_for(limit) != std::future_status::ready) return;
  const std::unique_ptr<Job> job = std::move(job_);
  Result<Preview> made = job->result.get();
  if (job->stopped) return;
  shown_.reset();
  if (made) {
    shown_ = std::move(*made);
  } else {
    fault_ = made.error().message;
  }
}

void draw_preview(const LivePreview& preview, const char* disabled_reason, FileUnit unit, bool& previewed) {
  ImGui::Checkbox("Preview", &previewed);
  mark_last_item("preview");
  tooltip("Draws the edges of the new mesh over the current surface, without changing it.");
  if (!previewed || disabled_reason != nullptr) {
    if (previewed) secondary_text(disabled_reason);
    return;
  }
  if (preview.busy()) {
    ImGui::SameLine();
    ImGui::TextDisabled("%s", progress_text(preview.fraction()).c_str());
  }
  if (const Preview* shown = preview.shown()) draw_statistics(*shown, unit);
  if (!preview.fault().empty()) secondary_text(preview.fault());
}

std::string prepared_text(std::span<const PieceRow> pieces, const PieceMap& looks) {
  if (selected_count(looks) == 0) return "All pieces";
  return pieces.size() == 1 ? pieces[0].name : std::to_string(pieces.size()) + " selected pieces";
}

std::string forecast_text(std::span<const PieceRow> pieces, const Preparation& preparation, FileUnit unit) {
  const FaceForecast faces = forecast(pieces, preparation);
  const std::string now = count_text(faces.before, "face");
  if (preparation.tool == PrepareTool::kTurnShells)
    return "Closed parts inside others that face the same way become cavities.";
  const std::string become = now + (faces.before == 1 ? " becomes " : " become ");
  if (!faces.after)
    return now + (faces.before == 1 ? " is" : " are") + " simplified to a tolerance of " +
           length_label(preparation.error, unit) + ".";
  if (preparation.tool == PrepareTool::kSmooth) return now + (faces.before == 1 ? " moves." : " move.");
  if (*faces.after == faces.before) return "The mesh has " + now + " already.";
  return become + "about " + grouped(*faces.after) + ".";
}

Preparation with_numbers(const Preparation& preparation, std::span<const PieceRow> pieces,
                         const World& world) {
  Preparation p = preparation;
  size_t faces = 0;
  for (const PieceRow& row : pieces) faces += row.faces;
  if (p.faces == 0) p.faces = std::max<size_t>(1, faces / 2);
  if (!(p.error > 0)) p.error = kUsualError * world.loaded_bounds().diagonal();
  return p;
}

void PreparePanel::draw_times(Preparation& preparation, const char* meaning, size_t most) {
  size_t times = std::min(preparation.times, most);
  if (fields_.count("Iterations", times, meaning, 1, most)) preparation.times = times;
}

void PreparePanel::draw_numbers(Preparation& preparation, const Preparation& shown, const World& world,
                                FileUnit unit) {
  switch (shown.tool) {
    case PrepareTool::kSimplifyToFaces: {
      size_t faces = shown.faces;
      if (fields_.count("Faces", faces, "Target number of faces of all these pieces in total.", 1, kMaxTyped))
        preparation.faces = faces;
      break;
    }
    case PrepareTool::kSimplifyToError: {
      double error = shown.error;
      const LengthUnit shown_unit = label_unit(kUsualError * world.loaded_bounds().diagonal(), unit);
      const char* meaning = "Maximum distance between the new and the old surface.";
      if (length_field(fields_, "Max. Error", error, shown_unit, meaning, "", kPositive))
        preparation.error = error;
      break;
    }
    case PrepareTool::kSubdivide:
      marked_choice_row("Scheme", "##scheme", preparation.scheme, kSchemes, "scheme",
                        "Loop and Square Root of 3 round the surface; Midpoint keeps it. Each face becomes "
                        "four (Square Root of 3: three).");
      draw_times(preparation, "Number of times that each face is subdivided.", kMaxSubdivisions);
      break;
    case PrepareTool::kSmooth:
      draw_times(preparation, "Number of times that vertices move halfway to the mean of their neighbours.",
                 kMaxSmoothing);
      break;
    case PrepareTool::kTurnShells:
      break;
  }
}

bool PreparePanel::draw(const World& world, const ViewState& view, Preparation& preparation,
                        const LivePreview& preview, bool& previewed) {
  const std::vector<PieceRow> pieces = pieces_to_prepare(world, view.look.pieces);
  if (pieces.empty()) {
    ImGui::TextDisabled("No file is open.");
    return false;
  }
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  draw_fitted_text(prepared_text(pieces, view.look.pieces),
                   "Applies to the selected pieces, or to all if none is selected.");
  ImGui::PopStyleColor();
  if (begin_properties("preparation")) {
    const char* meaning =
        "Operation on the mesh. Keeps boundaries, edges of three or more faces, and edges between materials.";
    if (marked_choice_row("Tool", "##preparation", preparation.tool, kTools, "preparation", meaning))
      preparation.times = 1;
    draw_numbers(preparation, with_numbers(preparation, pieces, world), world, view.frame.unit);
    end_properties();
  }
  const Preparation wanted = with_numbers(preparation, pieces, world);
  draw_preview(preview, preview_disabled_reason(world, pieces, wanted), view.frame.unit, previewed);
  ImGui::TextWrapped("%s", forecast_text(pieces, wanted, view.frame.unit).c_str());
  const bool pressed = row_button(button_name(wanted.tool), 1, prepare_disabled_reason(pieces, wanted),
                                  "Replaces the mesh of each piece, as one undo entry.");
  mark_last_item("prepare");
  return pressed;
}

namespace {

constexpr const char* kPreparePanel = "prepare";

class PrepareFeature : public Feature {
 public:
  explicit PrepareFeature(Workspace& workspace) : workspace_(workspace) {}

  std::vector<PanelPart> panel_parts() override {
    return {{kPreparePanel, [this] {
               if (panel_.draw(workspace_.world(), workspace_.view, preparation_, preview_,
                               workspace_.settings.prepare_preview))
                 request_preparation();
             }}};
  }
  std::vector<UserAction> actions() override {
    using Kind = Preparation::Tool;
    return {
        tool_action("prepare.simplify_to_faces", "Simplify to Face Count",
                    "Reduces the number of faces to the number in the Prepare panel.",
                    Kind::kSimplifyToFaces),
        tool_action("prepare.simplify_to_error", "Simplify by Tolerance",
                    "Reduces the number of faces within a maximum error.", Kind::kSimplifyToError),
        tool_action("prepare.subdivide", "Subdivide",
                    "Splits each face into three or four; can round the surface.", Kind::kSubdivide),
        tool_action("prepare.smooth", "Smooth", "Moves vertices towards the mean of their neighbours.",
                    Kind::kSmooth),
        tool_action("prepare.turn_shells", "Turn Inner Shells",
                    "Makes cavities of closed parts inside others that face the same way.",
                    Kind::kTurnShells),
        make_action("prepare.apply", "Prepare Mesh", "",
                    "Applies the Prepare panel to the selected pieces, or to all.",
                    [this] { request_preparation(); },
                    {.disabled_reason = [this] { return prepare_disabled_reason(pieces(), wanted()); }}),
        make_action("prepare.preview", "Preview Preparation", "",
                    "Draws the edges of the new mesh over the current surface.",
                    [this] { workspace_.settings.prepare_preview = !workspace_.settings.prepare_preview; },
                    {.checked = [this] { return workspace_.settings.prepare_preview; }})};
  }

  void after_queue(double) override {
    const bool seen = workspace_.settings.prepare_preview &&
                      workspace_.services.panels.shows(kPreparePanel) && world_rests();
    // A shot of the emitter may begin and end within a frame, without any other sign of a change.
    const size_t revision = workspace_.session.document.revision();
    if (std::exchange(revision_, revision) != revision) preview_.drop();
    const std::vector<PieceRow> pieces = seen ? this->pieces() : std::vector<PieceRow>();
    const Preparation preparation = with_numbers(preparation_, pieces, workspace_.world());
    if (!seen || preview_disabled_reason(workspace_.world(), pieces, preparation) != nullptr) {
      preview_.drop();
    } else {
      preview_.follow(workspace_.world(), pieces, preparation);
      preview_.wait(workspace_.screen.background_wait);
    }
    const auto wire = preview_.shown() != nullptr ? preview_.shown()->wire : nullptr;
    if (workspace_.view.look.wire == wire) return;
    workspace_.view.look.wire = wire;
    workspace_.view.picture_old = true;
  }
  bool needs_redraw() const override { return preview_.busy(); }
  void on_world_changed(const Delta& delta) override {
    if (!delta.empty()) preview_.drop();
  }
  void on_document_opened() override {
    preview_.drop();
    preparation_.faces = 0;
    preparation_.error = 0;
  }
  void write_session_log(nlohmann::ordered_json& report) const override {
    const Preview* shown = preview_.shown();
    if (shown == nullptr) return;
    report["preview"] = {{"faces", shown->after.faces},
                         {"least_angle", shown->after.min_angle},
                         {"distance", shown->distance},
                         {"edges", 0}};
    size_t edges = 0;
    for (const DrawnWire::Part& part : shown->wire->parts) edges += part.edges.size();
    report["preview"]["edges"] = edges;
  }

 private:
  UserAction tool_action(const char* id, const char* name, const char* tip, Preparation::Tool tool) {
    return make_action(id, name, "", tip,
                       [this, tool] {
                         workspace_.services.panels.show(kPreparePanel);
                         preparation_.tool = tool;
                         preparation_.times = 1;
                       },
                       {.checked = [this, tool] {
                         return workspace_.services.panels.shows(kPreparePanel) && preparation_.tool == tool;
                       }});
  }

  std::vector<PieceRow> pieces() const {
    return pieces_to_prepare(workspace_.world(), workspace_.view.look.pieces);
  }
  Preparation wanted() const { return with_numbers(preparation_, pieces(), workspace_.world()); }

  void request_preparation() {
    workspace_.changes.enqueue({.name = preparation_title(preparation_.tool),
                                .run = [this, wanted = wanted()] { return prepare(wanted), true; },
                                .is_one = true});
  }
  // Prepares all pieces, or none if one fails or the user stops it.
  void prepare(const Preparation& wanted) {
    const std::vector<PieceRow> pieces = this->pieces();
    if (prepare_disabled_reason(pieces, wanted) != nullptr) return;  // the selection has changed since
    cancel_stroke(workspace_);
    const FaceForecast faces = forecast(pieces, wanted);
    const bool quick = std::max(faces.before, faces.after.value_or(0)) <= kQuickToPrepare;
    workspace_.changes.change(preparation_title(wanted.tool), quick,
                              [pieces, wanted](Document& d, const Progress* progress) {
                                return prepare_pieces(d, pieces, wanted, progress);
                              });
  }

  // Returns true if the world is at rest, so that a copy is worth its time.
  bool world_rests() const {
    const Document& document = workspace_.session.document;
    const bool queued = document.waiting() > 0 && !document.queue().only_cools();
    return !workspace_.links.plays && !workspace_.cutting() && !queued && !workspace_.changes.is_pending() &&
           !workspace_.changes.has_requests() && !workspace_.opening.loader.busy();
  }

  Workspace& workspace_;
  Preparation preparation_;
  PreparePanel panel_;
  LivePreview preview_;
  size_t revision_ = 0;  // of the document, in the last frame
};

}  // namespace

std::unique_ptr<Feature> prepare_feature(Workspace& workspace) {
  return std::make_unique<PrepareFeature>(workspace);
}

}  // namespace kerf
