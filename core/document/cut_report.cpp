#include "core/document/cut_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/deterministic_math.h"
#include "core/base/parallel.h"
#include "core/cut/thermal_step.h"
#include "core/document/text/fields.h"
#include "core/document/text/hash.h"
#include "core/document/text/json.h"
#include "core/mesh/face_batches.h"

namespace kerf {

namespace {

struct Extremes {
  double largest_cosine = -1;  // of an angle
  int deepest_level = 0;

  void add(const Extremes& other) {
    largest_cosine = std::max(largest_cosine, other.largest_cosine);
    deepest_level = std::max(deepest_level, other.deepest_level);
  }
};

void add_faces(const Mesh& mesh, Extremes& extremes) {
  constexpr size_t kSlots = 1 << 14;  // per range
  std::vector<Extremes> parts(range_count(mesh.face_slots(), kSlots));
  for_each_range(mesh.face_slots(), kSlots, [&](size_t first, size_t end) {
    Extremes part;
    for_each_triangle(mesh, first, end, [&](FaceId f, const Triangle& t) {
      part.add({largest_cosine(t), (mesh.data(f).halvings + 1) / 2});
    });
    parts[first / kSlots] = part;
  });
  for (const Extremes& part : parts) extremes.add(part);
}

Extremes extremes_of(const World& world) {
  Extremes extremes;
  for (const BodyId id : world.ids()) add_faces(world.body(id).mesh, extremes);
  return extremes;
}

double degrees(double cosine) {
  return degrees_of(det::atan2(std::sqrt(std::max(0.0, 1 - cosine * cosine)), cosine));
}

// The quantile of sorted values: the value that this fraction of them does not exceed.
double percentile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0;
  const auto rank = static_cast<size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::min(sorted.size(), std::max<size_t>(rank, 1)) - 1];
}

nlohmann::ordered_json timing(const CutJob& job) {
  std::vector<double> sorted = job.step_s;
  std::sort(sorted.begin(), sorted.end());
  const auto ms = [](double seconds) { return 1000 * seconds; };
  return {{"load", ms(job.load_s)},
          {"build_tree", ms(job.build_tree_s)},
          {"cut", ms(job.cut_s)},
          {"query", ms(job.statistics.query_s)},
          {"refine", ms(job.statistics.refine_s)},
          {"remove", ms(job.statistics.remove_s)},
          {"update_tree", ms(job.statistics.update_tree_s)},
          {"separate", ms(job.statistics.separate_s)},
          {"step_p50", ms(percentile(sorted, 0.50))},
          {"step_p99", ms(percentile(sorted, 0.99))},
          {"step_max", sorted.empty() ? 0.0 : ms(sorted.back())},
          {"save", ms(job.save_s)}};
}

nlohmann::ordered_json to_json(const WrittenPiece& p) {
  const glm::dmat3& i = p.mass.inertia;
  nlohmann::ordered_json piece = {{"file", p.file},
                                  {"faces", p.faces},
                                  {"vertices", p.vertices},
                                  {"area", p.area},
                                  {"centroid", vector_json(p.centroid)},
                                  {"boundary_edges", p.boundary_edges},
                                  {"closed", p.volume.has_value()}};
  if (!p.outline.empty()) piece["outline"] = p.outline;
  if (p.volume) piece["volume"] = *p.volume;
  piece["mass"] = p.mass.mass;
  piece["inertia"] = {i[0][0], i[1][1], i[2][2], i[0][1], i[0][2], i[1][2]};
  if (p.asleep) piece["asleep"] = *p.asleep;
  const glm::dquat& q = p.placement.orientation;
  piece["pose"] = {{"position", vector_json(p.placement.position)}, {"orientation", {q.w, q.x, q.y, q.z}}};
  return piece;
}

nlohmann::ordered_json to_json(const CutSegment& s) {
  nlohmann::ordered_json json = {{"stroke", s.stroke}, {"segment", s.segment}};
  if (s.line) json["line"] = *s.line;
  return json;
}

nlohmann::ordered_json to_json(const ScrapCut& s, const std::vector<WrittenPiece>& pieces, bool has_segment) {
  nlohmann::ordered_json json = to_json(s.at);
  if (!has_segment) json.erase("segment");
  json["freed_by"] = s.freed_by;
  json["area"] = s.area;
  json["at"] = vector_json(s.area > 0 ? s.moment / s.area : s.moment);
  const auto piece = std::ranges::find(pieces, PieceId{s.body, s.piece}, &WrittenPiece::piece);
  if (piece != pieces.end()) json["piece"] = piece->file;
  return json;
}

nlohmann::ordered_json to_json(const NozzleSegment& s) {
  nlohmann::ordered_json json = to_json(s.at);
  if (s.standoff) json["standoff"] = {s.standoff->low, s.standoff->high};
  json["collides"] = s.collides;
  return json;
}

nlohmann::ordered_json to_json(const FittedStrokes& fit) {
  const glm::dquat& q = fit.motion.rotation;
  nlohmann::ordered_json json = {
      {"motion", {{"position", vector_json(fit.motion.translation)}, {"orientation", {q.w, q.x, q.y, q.z}}}},
      {"residuals", {{"rms", fit.rms}, {"max", fit.max}}}};
  if (!fit.residuals.empty()) json["residuals"]["points"] = fit.residuals;
  return json;
}

nlohmann::ordered_json energy_json(const World& world) {
  const EnergyLedger& ledger = world.energy();
  double stored = 0;
  for (const BodyId id : world.ids()) stored += world.body(id).heat.stored(world.body(id).mesh);
  nlohmann::ordered_json json = {
      {"emitted", ledger.emitted}, {"absorbed", ledger.absorbed}, {"ejected", ejected_energy(world)},
      {"stored", stored},          {"lost", ledger.lost},         {"escaped", ledger.escaped}};
  if (ledger.burnt > 0) json["burnt"] = ledger.burnt;
  return json;
}

nlohmann::ordered_json removed_json(const CutJob& job, bool any_solid) {
  nlohmann::ordered_json json = {{"faces", job.removed_faces}, {"area", job.removed_area}};
  if (any_solid && !job.left_open) json["volume"] = job.solid.removed_volume;
  return json;
}

void add_solid(nlohmann::ordered_json& report, const CutJob& job, bool any_solid) {
  if (any_solid) report["walls"] = {{"faces", job.solid.wall_faces}, {"area", job.solid.wall_area}};
  report["notes"] = job.notes;
}

void add_energy(nlohmann::ordered_json& report, const CutJob& job, const World& world) {
  if (!job.thermal) return;
  report["energy_j"] = energy_json(world);
  report["depth_fraction"] = job.depth_fraction();
  if (!job.follows_segments) return;
  report["uncut"] = nlohmann::ordered_json::array();
  for (const UncutSegment& s : job.uncut) {
    nlohmann::ordered_json segment = to_json(s.at);
    segment["depth"] = s.depth;
    report["uncut"].push_back(std::move(segment));
  }
}

}  // namespace

void FreedParts::add(const PieceId& part, size_t stroke) {
  if (!find(part)) own_.emplace(part, stroke);
}

std::optional<size_t> FreedParts::find(const PieceId& part) const {
  if (const auto own = own_.find(part); own != own_.end()) return own->second;
  for (const auto& parts : shared_) {
    if (const auto found = parts->find(part); found != parts->end()) return found->second;
  }
  return std::nullopt;
}

void FreedParts::share() {
  if (own_.empty()) return;
  for (; !shared_.empty() && shared_.back()->size() <= own_.size(); shared_.pop_back())
    own_.insert(shared_.back()->begin(), shared_.back()->end());
  shared_.push_back(std::make_shared<const Parts>(std::move(own_)));
  own_.clear();
}

void CutJob::record_loaded(const MeshReport& mesh) {
  input_faces += mesh.faces;
  input_vertices += mesh.vertices;
  input_area += mesh.area;
  input_components += mesh.components;
}

void CutJob::record_step(const StepResult& step, const World& world, double seconds) {
  statistics.add(step.statistics);
  removed_faces += step.delta.removed_faces;
  removed_area += step.delta.removed_area;
  solid += step.delta.solid;
  for (const LeftOpen& open : step.delta.left_open) {
    left_open = true;
    const std::string note = left_open_text(open, world, FileUnit::kMetre);
    if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
  }
  if (step.delta.removed_faces > 0) step_s.push_back(seconds);
  for (const BodyDelta& body : step.delta.bodies) record_parts(body, world);
}

void CutJob::record_parts(const BodyDelta& body, const World& world) {
  for (const CutFace& cut : body.removed) {
    const std::optional<size_t> freed = freed_by.find({body.body, cut.piece});
    if (!freed || *freed == strokes) continue;
    const auto same = [&](const ScrapCut& s) { return s.body == body.body && s.piece == cut.piece; };
    const auto of_stroke =
        std::ranges::lower_bound(scrap, strokes, {}, [](const ScrapCut& s) { return s.at.stroke; });
    auto found = std::find_if(of_stroke, scrap.end(), same);
    if (found == scrap.end()) {
      found = scrap.insert(scrap.end(), {segment, *freed, body.body, cut.piece});
      found->at.stroke = strokes;
    }
    const Triangle& t = cut.corners;
    found->area += triangle_area(t);
    found->moment += triangle_area(t) * world.body(body.body).placement.to_world((t[0] + t[1] + t[2]) / 3.0);
  }
  for (const uint32_t label : body.new_pieces) freed_by.add({body.body, label}, strokes);
}

bool CutJob::record_segment(const StepStatistics& before) {
  const double met = statistics.met_s - before.met_s;
  if (met > 0) uncut.push_back({segment, (statistics.depth_s - before.depth_s) / met});
  return met > 0;
}

void CutJob::begin_stroke() {
  faces_before_stroke = removed_faces;
  met_before_stroke_s = statistics.met_s;
  segment = {strokes, 0, std::nullopt};
}

void CutJob::end_stroke() {
  if (removed_faces == faces_before_stroke && statistics.met_s == met_before_stroke_s)
    missed.push_back(strokes);
  ++strokes;
}

nlohmann::ordered_json settings_json(const CutSettings& s, const std::string& format, bool split_all) {
  const Resolution& resolution = s.resolution;
  nlohmann::ordered_json json = {
      {"radius", s.laser.radius},
      {"range", {s.laser.range.low, s.laser.range.high}},
      {"pattern", s.laser.pattern == Pattern::kRays4 ? "rays4" : "volume"},
      {"scheme", resolution.scheme == Scheme::kOneToFour ? "one-to-four" : "longest-edge"},
      {"rim", s.smooth() ? "smooth" : "faces"}};
  switch (resolution.rule) {
    case Resolution::Rule::kTargetEdge:
      json["target-edge"] = resolution.target_edge;
      break;
    case Resolution::Rule::kTolerance:
      json["tolerance"] = resolution.tolerance;
      break;
    case Resolution::Rule::kDepth:
      json["depth"] = resolution.depth;
      break;
  }
  json["model"] = s.model == Model::kThermal ? "thermal" : "geometric";
  if (s.model == Model::kThermal) {
    json["power"] = s.laser.power;
    if (s.laser.assist == Assist::kOxygen) json["assist"] = "oxygen";
    if (scales_removal(s)) json["energy_of_removal_scaled"] = true;
  }
  json["format"] = format;
  json["split-all"] = split_all;
  return json;
}

bool any_is_solid(const World& world) {
  return std::ranges::any_of(world.ids(), [&](BodyId id) { return world.body(id).solid; });
}

double smallest_angle(const World& world) { return degrees(extremes_of(world).largest_cosine); }

nlohmann::ordered_json cut_report(const CutJob& job, const World& world,
                                  const nlohmann::ordered_json& settings,
                                  const std::vector<WrittenPiece>& pieces) {
  const Extremes extremes = extremes_of(world);
  const bool any_solid = any_is_solid(world);
  size_t faces = 0, vertices = 0;
  double area = 0;
  auto list = nlohmann::ordered_json::array();
  for (const WrittenPiece& p : pieces) {
    faces += p.faces;
    vertices += p.vertices;
    area += p.area;
    list.push_back(to_json(p));
  }
  nlohmann::ordered_json report = {
      {"input",
       {{"faces", job.input_faces},
        {"vertices", job.input_vertices},
        {"area", job.input_area},
        {"components", job.input_components}}},
      {"settings", settings},
      {"removed", removed_json(job, any_solid)},
      {"output", {{"faces", faces}, {"vertices", vertices}, {"area", area}}},
      {"origin", vector_json(job.origin)},
      {"pieces", list},
      {"min_angle_deg",
       {{"input", job.input_min_angle}, {"output", faces > 0 ? degrees(extremes.largest_cosine) : 0.0}}},
      {"max_level", extremes.deepest_level},
      {"steps", job.steps},
      {"missed", job.missed}};
  for (const ScrapCut& s : job.scrap) report["scrap"].push_back(to_json(s, pieces, job.follows_segments));
  if (job.fit) report["fit"] = to_json(*job.fit);
  for (const NozzleSegment& s : job.nozzle) report["nozzle"].push_back(to_json(s));
  add_solid(report, job, any_solid);
  add_energy(report, job, world);
  if (job.program_s) report["program_ms"] = 1000 * *job.program_s;
  report["timing_ms"] = timing(job);
  report["state_hash"] = hash_text(state_hash(world));
  if (const auto looks = looks_hash(world)) report["looks_hash"] = hash_text(*looks);
  return report;
}

}  // namespace kerf
