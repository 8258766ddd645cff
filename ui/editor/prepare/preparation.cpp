#include "ui/editor/prepare/preparation.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/mesh/measures.h"

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
    return "The mesh already has fewer faces.";
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
  const size_t from = document.history().position();
  Outcome all;
  ProgressShares progress_shares(progress);
  for (size_t i = 0; i < commands.size() && all.ok(); ++i) {
    const Progress own = progress_shares.next(shares[i]);
    Outcome one = document.apply(commands[i], progress ? &own : nullptr);
    for (Command& command : commands) rename(command, one.delta);
    all.append(std::move(one));
  }
  if (all.ok()) return all;
  Outcome undone(std::move(all.delta));
  undone.append(document.travel(from));
  const bool stopped = all.error().message == cancelled().message;
  undone.fail(stopped ? failed("Stopped; nothing was changed.") : all.error());
  return undone;
}

namespace {

constexpr double kMaxDepth =
    0.008;  // of the world size, max. depth behind a surface at which a wire is visible

std::vector<FaceId> faces_of(const Body& body, uint32_t label) {
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (body.mesh.is_live(FaceId(f)) && body.mesh.data(FaceId(f)).piece == label) faces.emplace_back(f);
  }
  return faces;
}

std::vector<Triangle> surface_of(const World& world, const PieceId& piece) {
  const Body& body = world.body(piece.body);
  std::vector<Triangle> surface;
  for (const FaceId f : faces_of(body, piece.label)) {
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
  for (const FaceId f : faces_of(body, label)) {
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

}  // namespace

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
  if (wanted_ && wanted_->pieces != now.pieces) shown_.reset();
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

}  // namespace kerf
