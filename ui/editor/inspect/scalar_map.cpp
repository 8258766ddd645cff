#include "ui/editor/inspect/scalar_map.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/json.h"
#include "core/base/parallel.h"
#include "core/mesh/face_batches.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/render/bodies/rim_distance.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr size_t kGrain = 1 << 14;
constexpr float kRimReach = 0.5f;  // in the float frame, in which a body is about 2 wide

double min_angle(const Triangle& t) { return std::acos(largest_cosine(t)) * 180 / kPi; }

float local_value(const Body& body, FaceId f, const Triangle& t, FaceQuantity quantity) {
  switch (quantity) {
    case FaceQuantity::kLevel:
      return static_cast<float>(body.mesh.data(f).halvings);
    case FaceQuantity::kLongestEdge:
      return static_cast<float>(std::sqrt(longest_edge2(t)));
    case FaceQuantity::kMinAngle:
      return static_cast<float>(min_angle(t));
    case FaceQuantity::kTemperature:
      return static_cast<float>(
          body.heat.temperature(body.mesh, f, body.sheet.substance, body.sheet.thickness));
    case FaceQuantity::kRimDistance:
    case FaceQuantity::kDeviation:
      break;
  }
  return kNoScalar;
}

template <typename Value>
void fill(FaceScalars& values, const Mesh& mesh, const Value& value) {
  for_each_range(values.size(), kGrain, [&](size_t first, size_t end) {
    for_each_triangle(mesh, first, end, [&](FaceId f, const Triangle& t) { values[f.index] = value(f, t); });
  });
}

// Returns the bases of a body copied from the loaded one; none, with no open sides, without a loaded one.
BaseFaces bases_of(const Body& body, const LoadedShading* loaded) {
  if (loaded == nullptr) return {};
  return body.loaded_faces.empty() ? *loaded->bases : loaded->bases->pick(body.loaded_faces);
}

void fill_rim_distances(FaceScalars& values, const Body& body, const LoadedShading* loaded) {
  const FloatFrame frame =
      loaded != nullptr ? loaded->frame : FloatFrame::around(body.bounds().min, body.bounds().max);
  const BaseFaces bases = bases_of(body, loaded);
  if (bases.are_whole(body.mesh)) return;
  RimDistance rims(kRimReach, 0);
  std::vector<VertexId> all, affected;
  for (uint32_t v = 0; v < body.mesh.vertex_slots(); ++v) all.emplace_back(v);
  rims.update(body.mesh, bases, frame, all, affected);
  if (!rims.any()) return;
  fill(values, body.mesh, [&](FaceId f, const Triangle&) {
    float nearest = RimDistance::kFar;
    for (const VertexId v : body.mesh.corners(f)) nearest = std::min(nearest, rims.of(v));
    return nearest < RimDistance::kFar ? static_cast<float>(nearest / frame.scale) : kNoScalar;
  });
}

template <typename Visit>
void for_each_value(ScalarLists lists, const Visit& visit) {
  for (const auto& list : lists) {
    for (const float value : *list) {
      if (value != kNoScalar) visit(static_cast<double>(value));
    }
  }
}

void find_extent(ScalarLists lists, Histogram& h) {
  h.least = std::numeric_limits<double>::infinity();
  h.most = -h.least;
  for_each_value(lists, [&](double value) {
    h.least = std::min(h.least, value);
    h.most = std::max(h.most, value);
    ++h.faces;
  });
  if (h.faces == 0) h.least = h.most = 0;
}
constexpr size_t kBins = 64;
constexpr double kSplitOftenest =
    0.01;  // of the faces; a few at the rim are split many times more than all others

constexpr float kPlotEms = 5, kStripEms = 0.45f, kGripEms = 0.38f;
constexpr double kMinApart = 0.01;  // of the histogram, between the handles

ImU32 colour_at(ColourScale scale, const ScalarRange& range, double value) {
  const glm::vec3 c = scalar_colour(scale, (value - range.low) / (range.high - range.low));
  return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1});
}

// The plot on the screen.
struct Frame {
  const Histogram& histogram;
  ColourScale scale;
  ImVec2 at, size;

  double share_of(double value) const {
    return std::clamp((value - histogram.from) / (histogram.to - histogram.from), 0.0, 1.0);
  }
  float x_of(double value) const { return at.x + static_cast<float>(share_of(value)) * size.x; }
  double value_at(float x) const {
    const double share = std::clamp<double>((x - at.x) / size.x, 0, 1);
    return histogram.from + share * (histogram.to - histogram.from);
  }
};

void draw_columns(const Frame& frame, const ScalarRange& range, float height, ImDrawList& list) {
  const Histogram& h = frame.histogram;
  const auto most = static_cast<double>(*std::max_element(h.bins.begin(), h.bins.end()));
  for (size_t i = 0; i < h.bins.size(); ++i) {
    if (h.bins[i] == 0) continue;
    const double begin = h.from + h.width() * static_cast<double>(i);
    const auto tall = static_cast<float>(std::sqrt(static_cast<double>(h.bins[i]) / most)) * height;
    const float left = frame.x_of(begin), right = std::max(left + 1, frame.x_of(begin + h.width()) - 1);
    list.AddRectFilled({left, frame.at.y + height - std::max(1.0f, tall)}, {right, frame.at.y + height},
                       colour_at(frame.scale, range, begin + 0.5 * h.width()));
  }
}

void draw_strip(const Frame& frame, const ScalarRange& range, float top, ImDrawList& list) {
  const float bottom = frame.at.y + frame.size.y;
  for (float x = frame.at.x; x < frame.at.x + frame.size.x; x += 2) {
    const float right = std::min(x + 2, frame.at.x + frame.size.x);
    list.AddRectFilled({x, top}, {right, bottom},
                       colour_at(frame.scale, range, frame.value_at(0.5f * (x + right))));
  }
}

void draw_handle(float x, const Frame& frame, bool held, ImDrawList& list) {
  const float grip = kGripEms * ImGui::GetFontSize(), bottom = frame.at.y + frame.size.y;
  const ImU32 colour = held ? colours::accent() : colours::text();
  list.AddLine({x, frame.at.y}, {x, bottom}, IM_COL32(0, 0, 0, 120), 3);
  list.AddLine({x, frame.at.y}, {x, bottom}, colour, 1);
  list.AddTriangleFilled({x - grip, frame.at.y}, {x + grip, frame.at.y}, {x, frame.at.y + 1.3f * grip},
                         colour);
}

// Drags the handle nearer to the press, as long as the button is held.
bool drag(const Frame& frame, ScalarRange& range) {
  if (!ImGui::IsItemActive()) return false;
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  const ImGuiID held = ImGui::GetID("held handle");
  const float x = ImGui::GetIO().MousePos.x;
  if (ImGui::IsItemActivated())
    storage.SetBool(held, std::abs(x - frame.x_of(range.high)) < std::abs(x - frame.x_of(range.low)));
  const ScalarRange before = range;
  const Histogram& h = frame.histogram;
  const double apart = kMinApart * (h.to - h.from), value = frame.value_at(x);
  if (storage.GetBool(held)) {
    range.high = std::max(value, range.low + apart);
  } else {
    range.low = std::min(value, range.high - apart);
  }
  return !(range == before);
}

}  // namespace

const char* name_of(FaceQuantity quantity) {
  constexpr std::array<const char*, kFaceQuantities> kNames{
      "level",       "longest edge",        "min. angle",
      "temperature", "distance to the rim", "distance to the reference"};
  return kNames[static_cast<size_t>(quantity)];
}

std::string quantity_text(FaceQuantity quantity, double value, FileUnit unit) {
  switch (quantity) {
    case FaceQuantity::kLevel:
      return text_of("%.0f", value);
    case FaceQuantity::kLongestEdge:
    case FaceQuantity::kRimDistance:
    case FaceQuantity::kDeviation:
      return value == 0 ? "0" : length_label(value, unit);
    case FaceQuantity::kMinAngle:
      return text_of("%.1f\u00b0", value);
    case FaceQuantity::kTemperature:
      break;
  }
  return text_of("%.0f K", value);
}

FaceScalars face_scalars(const Body& body, FaceQuantity quantity, const LoadedShading* loaded,
                         const ReferenceMesh* reference) {
  FaceScalars values(body.mesh.face_slots(), kNoScalar);
  if (quantity == FaceQuantity::kRimDistance) {
    fill_rim_distances(values, body, loaded);
  } else if (quantity == FaceQuantity::kDeviation) {
    if (reference == nullptr) return values;
    fill(values, body.mesh, [&](FaceId, const Triangle& t) {
      return static_cast<float>(reference->distance(body.placement.to_world((t[0] + t[1] + t[2]) / 3.0)));
    });
  } else {
    fill(values, body.mesh, [&](FaceId f, const Triangle& t) { return local_value(body, f, t, quantity); });
  }
  return values;
}

ScalarRange range_between(double low, double high) {
  constexpr double kMinShare = 1e-4;
  const double apart = std::max(kMinShare * std::max(std::abs(low), std::abs(high)), 1e-30);
  return {low, std::max(high, low + apart)};
}

double Histogram::quantile(double share) const {
  const double wanted = share * static_cast<double>(faces);
  double below = 0;
  for (size_t i = 0; i < bins.size(); ++i) {
    const auto here = static_cast<double>(bins[i]);
    if (here > 0 && below + here >= wanted) {
      const double at = from + width() * (static_cast<double>(i) + std::max(0.0, wanted - below) / here);
      return std::clamp(at, least, most);
    }
    below += here;
  }
  return most;
}

Histogram histogram_of(ScalarLists lists, size_t bins, bool whole) {
  KERF_ASSERT(bins > 0);
  Histogram h;
  find_extent(lists, h);
  const ScalarRange range = range_between(h.least, h.most);
  h.from = range.low;
  h.to = range.high;
  if (whole && h.most - h.least < static_cast<double>(bins)) {
    h.from = h.least - 0.5;
    h.to = h.most + 0.5;
    bins = static_cast<size_t>(h.most - h.least) + 1;
  }
  h.bins.assign(bins, 0);
  const double per_bin = h.width();
  for_each_value(lists, [&](double value) {
    const auto bin = static_cast<size_t>(std::max(0.0, (value - h.from) / per_bin));
    ++h.bins[std::min(bin, bins - 1)];
  });
  return h;
}

void ScalarMap::show(std::optional<FaceQuantity> quantity) {
  if (shown_ == quantity) return;
  shown_ = quantity;
  fit_ = quantity == FaceQuantity::kLevel ? kSplitOftenest : 0.0;
  histogram_ = {.bins = {0}};
  forget();
}

void ScalarMap::set_reference(std::shared_ptr<const ReferenceMesh> reference) {
  reference_ = std::move(reference);
  if (shown_ == FaceQuantity::kDeviation) forget();
}

ColourScale ScalarMap::scale() const {
  const bool is_signed = shown_ == FaceQuantity::kDeviation && reference_ != nullptr && reference_->closed;
  return is_signed ? ColourScale::kDiverging : ColourScale::kSequential;
}

void ScalarMap::forget() {
  values_.clear();
  old_.clear();
  counts_.clear();
  all_old_ = true;
}

void ScalarMap::follow(const World& world, const Delta& delta) {
  if (!shown_ || delta.empty()) return;
  if (delta.replaced || !delta.created.empty() || !delta.destroyed.empty() || !delta.detached.empty() ||
      !delta.visibility_changed.empty())
    return forget();
  for (const BodyDelta& body : delta.bodies) {
    if (world.contains(body.body)) old_.insert(body.body);
  }
  if (shown_ == FaceQuantity::kDeviation) old_.insert(delta.moved.begin(), delta.moved.end());
}

void ScalarMap::follow_steps(const World& world, bool any_waits) {
  if (!shown_) return;
  for (const BodyId id : world.ids()) {
    const Mesh& mesh = world.body(id).mesh;
    const FaceCount now{mesh.face_slots(), mesh.live_faces()};
    if (std::exchange(counts_[id], now) != now) old_.insert(id);
  }
  if (std::exchange(any_waited_, any_waits) && !any_waits) all_old_ = true;
}

void ScalarMap::follow_heat(const World& world) {
  if (shown_ != FaceQuantity::kTemperature) return;
  const HeatMoment now{world.clock(), world.energy()};
  if (now == heat_) return;
  heat_ = now;
  all_old_ = true;
}

void ScalarMap::update(const World& world, const LoadedShadings& loaded) {
  if (!is_old()) return;
  std::erase_if(values_, [&](const auto& entry) { return !world.contains(entry.first); });
  for (const BodyId id : world.ids()) {
    if (all_old_ || old_.contains(id)) renew(id, world.body(id), loaded);
  }
  all_old_ = false;
  old_.clear();
  take_histogram();
}

// Equal values keep the same list, so that they are not sent again.
void ScalarMap::renew(BodyId id, const Body& body, const LoadedShadings& loaded) {
  if (body.hidden) {
    values_.erase(id);
    return;
  }
  const auto found = loaded.find(body.loaded_as);
  FaceScalars values =
      face_scalars(body, *shown_, found != loaded.end() ? &found->second : nullptr, reference_.get());
  std::shared_ptr<const FaceScalars>& kept = values_[id];
  if (kept == nullptr || *kept != values) kept = std::make_shared<const FaceScalars>(std::move(values));
}

void ScalarMap::take_histogram() {
  std::vector<std::shared_ptr<const FaceScalars>> lists;
  for (const auto& [id, values] : values_) lists.push_back(values);
  histogram_ = histogram_of(lists, kBins, shown_ == FaceQuantity::kLevel);
  if (fit_) fit(*fit_);
}

void ScalarMap::set_range(const ScalarRange& range) {
  KERF_ASSERT(range.low < range.high);
  range_ = range;
  fit_.reset();
}

void ScalarMap::fit(double share) {
  KERF_ASSERT(share >= 0 && share < 0.5);
  fit_ = share;
  const Histogram& h = histogram_;
  range_ = share > 0
               ? range_between(std::max(h.least, h.quantile(share)), std::min(h.most, h.quantile(1 - share)))
               : range_between(h.least, h.most);
  if (scale() != ColourScale::kDiverging) return;
  const double reach = std::max(std::abs(range_.low), std::abs(range_.high));
  range_ = {-reach, reach};
}

std::shared_ptr<const ScalarField> ScalarMap::field(FileUnit unit) const {
  if (!shown_ || values_.empty() || histogram_.faces == 0) return nullptr;
  ScalarField field{
      values_, static_cast<float>(range_.low), static_cast<float>(range_.high), name_of(*shown_), {},
      scale()};
  if (!(field.low < field.high)) return nullptr;
  field.name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(field.name[0])));
  for (size_t i = 0; i < field.labels.size(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(field.labels.size() - 1);
    field.labels[i] = quantity_text(*shown_, glm::mix(range_.low, range_.high, t), unit);
  }
  return std::make_shared<const ScalarField>(std::move(field));
}

bool draw_histogram(const Histogram& histogram, ColourScale scale, ScalarRange& range) {
  const float em = ImGui::GetFontSize(), grip = kGripEms * em;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 whole{std::max(4 * em, ImGui::GetContentRegionAvail().x), kPlotEms * em};
  ImGui::InvisibleButton("histogram", whole);
  const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemActive();
  // The grips of handles at the ends stand out by half.
  const Frame frame{histogram, scale, {corner.x + grip, corner.y}, {whole.x - 2 * grip, whole.y}};
  const bool changed = drag(frame, range);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float strip = kStripEms * em, height = whole.y - strip - 2;
  list.AddRectFilled(corner, {corner.x + whole.x, corner.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg),
                     3);
  draw_columns(frame, range, height, list);
  draw_strip(frame, range, corner.y + height + 2, list);
  for (const auto& [name, value] :
       {std::pair("scalar low", range.low), std::pair("scalar high", range.high)}) {
    const float x = frame.x_of(value);
    draw_handle(x, frame, hovered, list);
    mark_area(name, {{x - grip, corner.y}, {2 * grip, whole.y}});
  }
  tooltip(
      "Number of faces by value (square-root columns). Drag a handle to set where the colours begin or end.");
  return changed;
}

namespace {

constexpr const char* kScalarPanel = "scalar_map";
constexpr double kRestShare = 10;    // computing takes a tenth of the time at most
constexpr double kOutermost = 0.01;  // of the faces at each end, which the narrower fit leaves out
constexpr const char* kCompareTip = "Colours the pieces by their distance from the surface of a mesh file.";
constexpr const char* kTip = "Colours every face by a quantity, with a legend in the viewport.";

const char* action_id(std::optional<FaceQuantity> quantity) {
  constexpr std::array<const char*, kFaceQuantities> kIds{
      "scalar_map.level",       "scalar_map.longest_edge", "scalar_map.min_angle",
      "scalar_map.temperature", "scalar_map.rim_distance", "scalar_map.deviation"};
  return quantity ? kIds.at(static_cast<size_t>(*quantity)) : "scalar_map.paint";
}

const char* label_of(std::optional<FaceQuantity> quantity) {
  constexpr std::array<const char*, kFaceQuantities> kLabels{
      "Level", "Longest Edge", "Min. Angle", "Temperature", "Distance to Rim", "Distance to Reference"};
  return quantity ? kLabels.at(static_cast<size_t>(*quantity)) : "Paint";
}

class ScalarMapFeature : public Feature {
 public:
  explicit ScalarMapFeature(Workspace& workspace)
      : session_(workspace.session),
        view_(workspace.view),
        services_(workspace.services),
        screen_(workspace.screen),
        settings_(workspace.settings),
        message_(workspace.message) {}

  std::vector<PanelPart> panel_parts() override {
    return {{kScalarPanel, [this] { draw(); }}};
  }
  std::vector<UserAction> actions() override {
    std::vector<UserAction> actions{action(std::nullopt)};
    for (size_t i = 0; i < kFaceQuantities; ++i) actions.push_back(action(static_cast<FaceQuantity>(i)));
    actions.push_back(make_action("scalar_map.compare", "Compare with File...", "", kCompareTip,
                                  [this] { select_reference(); }));
    return actions;
  }
  void on_world_changed(const Delta& delta) override { map_.follow(session_.world(), delta); }
  void on_document_opened() override {
    map_.forget();
    view_.look.scalar.reset();
    loader_.cancel();
    if (map_.shown() == FaceQuantity::kDeviation) map_.show(std::nullopt);
    map_.set_reference(nullptr);
  }
  bool cancel() override {
    if (!loader_.busy()) return false;
    loader_.cancel();
    alignment_ = reference_alignment_;
    message_.info("The comparison was cancelled.");
    return true;
  }
  // Ends when another colouring of faces is switched on.
  void after_queue(double) override {
    if (auto loaded = loader_.take()) on_loaded(*loaded);
    if (!map_.shown()) return;
    const ShowOptions& others = view_.look.show;
    if (others.pieces || others.sizes || others.heat) return show(std::nullopt);
    map_.follow_steps(session_.world(), session_.document.waiting() > 0);
    map_.follow_heat(session_.world());
    if (map_.is_old()) update_map();
    if (unit_ != view_.frame.unit) hand_over();
  }
  bool needs_redraw() const override { return map_.is_old() || loader_.busy(); }
  void write_session_log(nlohmann::ordered_json& report) const override {
    nlohmann::ordered_json& all = report["scalar_map"];
    all["quantity"] = nullptr;
    if (!map_.shown()) return;
    all["quantity"] = name_of(*map_.shown());
    all["faces"] = map_.histogram().faces;
    all["low"] = map_.range().low;
    all["high"] = map_.range().high;
    all["fits"] = map_.fits();
    if (map_.shown() != FaceQuantity::kDeviation) return;
    const SurfaceComparison& found = map_.reference()->found;
    all["reference"] = {{"max", found.max}, {"mean", found.mean}, {"p95", found.p95}};
  }

 private:
  // Switches off the other colourings of faces. Asks for a file if a reference is needed and none is loaded.
  void show(std::optional<FaceQuantity> quantity) {
    if (quantity == FaceQuantity::kDeviation && map_.reference() == nullptr) return select_reference();
    ShowOptions& others = view_.look.show;
    if (quantity) others.pieces = others.sizes = others.heat = false;
    map_.show(quantity);
    next_ = 0;
    if (!quantity) hand_over();
  }
  void update_map() {
    const auto now = [this] { return screen_.clock != nullptr ? screen_.clock->seconds() : 0.0; };
    const double began = now();
    if (began < next_) return;
    const bool shown_before = view_.look.scalar != nullptr, changed_before = view_.picture_old;
    map_.update(session_.world(),
                screen_.picture != nullptr ? screen_.picture->first().loaded_shadings() : LoadedShadings());
    next_ = now() + kRestShare * (now() - began);
    hand_over();
    // Heat alone moves no shape.
    if (shown_before && map_.shown() == FaceQuantity::kTemperature) {
      view_.picture_old = changed_before;
      view_.heat_old = true;
    }
  }
  void hand_over() {
    unit_ = view_.frame.unit;
    view_.look.scalar = map_.field(unit_);
    view_.picture_old = true;
  }
  void select_reference() {
    browse(services_.browser,
           {.title = "Compare with File",
            .verb = "Compare",
            .hint = "Filter, or paste a full path",
            .take =
                [this](const std::filesystem::path& file) {
                  load_reference_from(file);
                  return "";
                }},
           settings_.folder, "");
    services_.browser.kind = FileKind::kMeshes;
  }
  // Reads the file in the unit of the first mesh of the document, if the file states none.
  void load_reference_from(const std::filesystem::path& file) {
    ReferenceRequest request{.file = file, .alignment = alignment_, .document_unit = view_.frame.unit};
    if (!session_.scene.bodies.empty()) request.unit = session_.scene.bodies.front().unit;
    if (const auto format = mesh_format(file.extension().string())) {
      const auto usual = settings_.frames.find(std::string(format_row(*format).ending));
      if (usual != settings_.frames.end() && usual->second) request.usual_unit = usual->second->unit;
    }
    loader_.begin(session_.world(), std::move(request));
    services_.panels.show(kScalarPanel);
  }
  void on_loaded(const Result<std::shared_ptr<const ReferenceMesh>>& loaded) {
    if (!loaded) {
      alignment_ = reference_alignment_;
      return message_.error(loaded.error().message);
    }
    reference_alignment_ = alignment_;
    const SurfaceComparison& found = (*loaded)->found;
    const auto length = [this](double d) {
      return quantity_text(FaceQuantity::kDeviation, d, view_.frame.unit);
    };
    map_.set_reference(*loaded);
    show(FaceQuantity::kDeviation);
    message_.info("Distance from " + (*loaded)->file.filename().string() + ": at most " + length(found.max) +
                  ", 95 % within " + length(found.p95));
  }
  void draw() {
    draw_choice();
    draw_comparison();
    if (!map_.shown()) return;
    if (map_.histogram().faces == 0 && map_.is_old()) return;
    if (map_.histogram().faces == 0)
      return secondary_text(*map_.shown() == FaceQuantity::kRimDistance ? "No cut has left a rim yet."
                                                                        : "No face is shown.");
    draw_range();
  }
  void draw_choice() {
    if (!begin_properties("scalar map")) return;
    std::string names{"Paint", 6};
    for (size_t i = 0; i < kFaceQuantities; ++i) {
      names += std::string(label_of(static_cast<FaceQuantity>(i))) + '\0';
    }
    int choice = map_.shown() ? 1 + static_cast<int>(*map_.shown()) : 0;
    if (choice_row("Colour By", "##quantity", choice, names.c_str(), "Colour by", kTip))
      show(choice > 0 ? std::optional(static_cast<FaceQuantity>(choice - 1)) : std::nullopt);
    end_properties();
  }
  void draw_comparison() {
    if (loader_.busy()) {
      secondary_text("Comparing with " + loader_.file().filename().string() +
                     text_of(": %.0f %%", 99 * loader_.fraction()));
      return;
    }
    if (map_.shown() != FaceQuantity::kDeviation || !begin_properties("reference")) return;
    const ReferenceMesh& reference = *map_.reference();
    const auto row = [this](const char* name, double length, const char* meaning) {
      figure_row(name, quantity_text(FaceQuantity::kDeviation, length, view_.frame.unit), meaning);
    };
    figure_row("Reference", reference.file.filename().string(), "The mesh file of the comparison.");
    if (choice_row("Align", "##align", alignment_, "As Placed\0Centroids\0Best Fit\0", "align reference",
                   "Motion of the visible pieces before distances are measured; nothing in the scene moves."))
      load_reference_from(reference.file);
    row("Maximum", reference.found.max, "Largest distance of the pieces visible when compared.");
    row("95 % Within", reference.found.p95, "Distance that 95 % of their area does not exceed.");
    row("Mean", reference.found.mean, "Mean distance over their area.");
    end_properties();
    if (ImGui::Button("Compare with File...")) select_reference();
    mark_last_item("compare with file");
    tooltip(kCompareTip);
  }
  void draw_range() {
    ScalarRange range = map_.range();
    bool changed = draw_histogram(map_.histogram(), map_.scale(), range);
    if (begin_properties("range")) {
      const bool typed_low = draw_end("From", range.low, "Value of the first colour; lower values share it.");
      const bool typed_high = draw_end("To", range.high, "Value of the last colour; higher values share it.");
      if ((typed_low || typed_high) && !(range.low < range.high)) refuse_end(typed_low);
      changed = changed || typed_low || typed_high;
      figure_row("Faces", grouped(map_.histogram().faces), "Number of faces with a value.");
      end_properties();
    }
    if (changed && range.low < range.high) map_.set_range(range), hand_over();
    for (const auto& [name, share, tip] :
         {std::tuple("Fit", 0.0, "Fits the colours to the minimum and maximum, also after cuts."),
          std::tuple("Fit 1-99 %", kOutermost,
                     "Fits the colours to the values without the lowest and the highest 1 % of faces.")}) {
      if (share > 0) ImGui::SameLine();
      if (ImGui::Button(name)) map_.fit(share), hand_over();
      mark_last_item((std::string("scalar ") + name).c_str());
      tooltip(tip);
    }
  }
  void refuse_end(bool low) const {
    const ScalarRange& range = map_.range();
    const std::string shown = quantity_text(*map_.shown(), low ? range.low : range.high, view_.frame.unit);
    report_refused_entry(low ? "From stays " + shown + ": it must be less than To"
                             : "To stays " + shown + ": it must be more than From");
  }
  bool draw_end(const char* name, double& end, const char* meaning) {
    const ScalarRange& range = map_.range();
    const double largest = std::max(std::abs(range.low), std::abs(range.high));
    switch (*map_.shown()) {
      case FaceQuantity::kLongestEdge:
      case FaceQuantity::kRimDistance:
      case FaceQuantity::kDeviation:
        return length_field(fields_, name, end, label_unit(largest, view_.frame.unit), meaning);
      case FaceQuantity::kMinAngle:
        return fields_.number(name, end, "%.1f", meaning, {Quantity::kAngle, kDegrees.size, "\u00b0"});
      case FaceQuantity::kTemperature:
        return fields_.number(name, end, "%.0f K", meaning);
      case FaceQuantity::kLevel:
        break;
    }
    return fields_.number(name, end, "%.3g", meaning);
  }
  UserAction action(std::optional<FaceQuantity> quantity) {
    const std::string name = std::string("Colour by ") + label_of(quantity);
    UserAction action = picture_action(view_, action_id(quantity), name.c_str(), kTip, [this, quantity] {
      show(quantity);
      if (quantity) services_.panels.show(kScalarPanel);
    });
    action.checked = [this, quantity] { return map_.shown() == quantity; };
    return action;
  }

  const DocumentSession& session_;
  ViewState& view_;
  Services& services_;
  const ScreenContext& screen_;
  const Settings& settings_;
  Message& message_;
  ScalarMap map_;
  ReferenceLoader loader_;
  Alignment alignment_ = Alignment::kNone;            // selected
  Alignment reference_alignment_ = Alignment::kNone;  // of the last completed comparison
  NumberFields fields_;
  FileUnit unit_ = FileUnit::kMetre;  // of the labels in the viewport
  double next_ = 0;                   // s of the clock, before which no values are computed
};

}  // namespace

std::unique_ptr<Feature> scalar_map_feature(Workspace& workspace) {
  return std::make_unique<ScalarMapFeature>(workspace);
}

}  // namespace kerf
