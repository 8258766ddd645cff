#include "tests/fuzz/strokes/scenario.h"

#include <algorithm>

#include "core/document/stroke_path.h"
#include "core/world/world.h"
#include "tests/fuzz/strokes/world_check.h"
#include "tests/support/made_meshes.h"

namespace kerf::fuzz {

namespace {

constexpr size_t kMaxFaces = 800;  // of a world, so that a run stays short
constexpr size_t kMaxFacesOfSolids = 2500;
constexpr size_t kMaxBodies = 24;

Soup shape_from(ByteSource& bytes) {
  const auto from = [&](int low, int high) {
    return low + static_cast<int>(bytes.below(static_cast<size_t>(high - low + 1)));
  };
  switch (bytes.below(9)) {
    case 0:
      return test::grid(from(1, 9), 1);
    case 1:
      return test::sphere(from(3, 8), from(3, 10), 0.5);
    case 2:
      return test::torus(from(3, 8), from(3, 10), 0.5, bytes.between(0.05, 0.3));
    case 3:
      return test::tube(from(2, 8), from(3, 10), 0.3, 1);
    case 4:
      return test::moebius(from(5, 20));
    case 5:
      return test::book(from(2, 5));
    case 6:
      return test::pillow();
    case 7:
      return test::both(test::grid(from(1, 4), 1), test::moved(test::sphere(4, 6, 0.4), {0.1, 0.05, 0}, 1));
    default: {
      Random random(bytes.byte());
      return test::random_soup(from(2, 40), random);
    }
  }
}

}  // namespace

FuzzedMesh mesh_from(ByteSource& bytes) {
  constexpr double kScales[] = {1, 1, 1e-6, 1e-3, 1e3, 1e6};
  const Soup shape = shape_from(bytes);
  const double scale = kScales[bytes.below(std::size(kScales))];
  const uint8_t place = bytes.byte();  // by its upper two bits; the lower three are left for another use
  return {test::moved(shape, scale * (place >> 6) * Vec3(0, 1e3, -1e5), scale), (place & 7) == 5};
}

Scenario::Scenario(Document& document, ByteSource& bytes, bool solid)
    : document_(document), bytes_(bytes), solid_(solid) {
  const World::Bounds bounds = document.world().bounds();
  middle_ = 0.5 * bounds.min + 0.5 * bounds.max;
  size_ = 0.5 * bounds.diagonal();
}

void Scenario::act() {
  switch (bytes_.below(10)) {
    case 0:
    case 1:
    case 2:
      return draw();
    case 3:
      return apply(Undo{});
    case 4:
      return apply(Redo{});
    case 5:
      if (can_recut(document_)) apply(Recut{settings()});
      return;
    case 6:
      return apply(Play{});
    case 7:
      return apply(AdvanceTime{1 + bytes_.below(12), bytes_.below(2) == 0});
    case 8:
      return apply(StopStroke{bytes_.between(0, 4), bytes_.below(3)});
    default:
      return edit();
  }
}

CutSettings Scenario::settings() {
  CutSettings s;
  s.laser.radius = size_ * bytes_.between(0.01, 0.2);
  s.laser.range = {0, 10 * size_};
  // The ends of the range seldom lie in the mesh: distances from them take long where they move.
  if (bytes_.below(8) == 1)
    s.laser.range = {bytes_.factor_below(3) * 0.3 * size_, size_ * bytes_.between(1, 8)};
  s.laser.power = 500 * (1 + bytes_.factor_below(8));
  s.resolution.target_edge = s.laser.radius * bytes_.between(0.4, 2);
  s.resolution.depth = static_cast<int>(bytes_.below(6));
  s.resolution.tolerance = s.laser.radius * bytes_.between(0.1, 1);
  constexpr Resolution::Rule kRules[] = {Resolution::Rule::kTargetEdge, Resolution::Rule::kTolerance,
                                         Resolution::Rule::kDepth};
  s.resolution.rule = kRules[bytes_.below(3)];
  s.resolution.scheme = bytes_.below(2) == 0 ? Scheme::kOneToFour : Scheme::kLongestEdge;
  s.resolution.rim = bytes_.below(2) == 0 ? Rim::kSmooth : Rim::kFaces;
  // Heat is rare, because it takes a hundred times as long.
  const size_t kind = 127 - bytes_.below(128);
  if (kind == 0 && !heated_) {
    heated_ = true;
    s.model = Model::kThermal;
    // Or its steps and faces are too many.
    s.laser.radius = std::max(s.laser.radius, 0.1 * size_);
    s.resolution.rule = Resolution::Rule::kTargetEdge;
    s.resolution.target_edge = s.laser.radius;
  }
  if (kind < 16) s.laser.pattern = Pattern::kRays4;
  if (kind == 16) s.heat_width = default_heat_width(s.laser.radius);
  s.max_faces = kMaxFaces;
  if (solid_) {
    s.resolution.rim = Rim::kSmooth;
    s.model = Model::kGeometric;
    s.laser.pattern = Pattern::kVolume;
    s.max_faces = kMaxFacesOfSolids;
    // Or hardly any stroke stays below that.
    s.laser.radius = std::max(s.laser.radius, 0.06 * size_);
    s.resolution.rule = Resolution::Rule::kTargetEdge;
    s.resolution.target_edge = 2 * s.laser.radius;
  }
  s.faces_per_step = 1 + bytes_.below(50);
  s.search_a_move = 1 + 8 * bytes_.below(50);
  return s;
}

// From outside towards the middle, more or less.
Pose Scenario::pose() {
  const auto component = [&] { return bytes_.between(-1, 1); };
  Vec3 from(component(), component(), component());
  if (glm::length(from) < 0.1) from = Vec3(0, 1, 0);
  from = glm::normalize(from);
  const Vec3 towards = 0.7 * Vec3(component(), component(), component());
  return {middle_ + 3 * size_ * from, glm::normalize(towards - 3.0 * from)};
}

void Scenario::draw() {
  const CutSettings how = settings();
  Pose at = pose();
  apply(BeginStroke{how, at});
  const size_t moves = bytes_.below(6);
  double time = 0;
  for (size_t i = 0; i < moves; ++i) {
    // A beam that keeps its direction, or one that turns; directions that are nearly opposite are no move.
    const Pose next = pose();
    const bool turns = bytes_.below(solid_ ? 8 : 2) == 0 && glm::dot(next.direction, at.direction) > -0.9;
    at = {next.origin, turns ? next.direction : at.direction};
    time += 0.01 * bytes_.factor_below(8);
    apply(MoveBeam{at, time});
    if (bytes_.below(8) == 0) apply(AdvanceTime{1 + bytes_.below(3), bytes_.below(2) == 0});
  }
  if (bytes_.below(8) != 0) apply(EndStroke{});
}

PieceId Scenario::piece() {
  std::vector<PieceId> pieces;
  for (const BodyId id : document_.world().ids()) {
    const Body& body = document_.world().body(id);
    for (uint32_t label = 0; label < body.pieces.size(); ++label) {
      if (body.pieces[label].faces > 0) pieces.push_back({id, label});
    }
  }
  return pieces.empty() ? PieceId{} : pieces[bytes_.byte() % pieces.size()];
}

void Scenario::edit() {
  const PieceId of = piece();
  const World& world = document_.world();
  switch (bytes_.below(8)) {
    case 0:
      remade_ = true;
      return apply(DeletePiece{of});
    case 1:
      return apply(HidePiece{of, bytes_.below(2) == 0});
    case 2:
      return apply(PinPiece{of, bytes_.below(2) == 0});
    case 3:
      remade_ = true;
      if (world.ids().size() < kMaxBodies) apply(DuplicatePiece{of, {}});
      return;
    case 4:
    case 5: {
      Placement to;
      if (world.contains(of.body)) to = world.body(of.body).placement;
      to.position += size_ * Vec3(bytes_.between(-1, 1), bytes_.between(-1, 1), bytes_.between(-1, 1));
      return apply(MovePiece{of, to});
    }
    default:
      return prepare(of);
  }
}

void Scenario::prepare(const PieceId& of) {
  remade_ = may_be_open_ = true;
  const size_t faces = document_.world().live_faces();
  switch (bytes_.below(4)) {
    case 0:
      return apply(SimplifyPiece{of, {.faces = faces / 2}});
    case 1:
      if (faces < kMaxFaces / 4) apply(SubdividePiece{of, static_cast<Subdivision>(bytes_.below(3))});
      return;
    default:
      return apply(SmoothPiece{of, 1 + bytes_.below(3)});
  }
}

void Scenario::apply(const Command& command) {
  const Outcome outcome = document_.apply(command);
  may_be_open_ = may_be_open_ || !outcome.delta.left_open.empty();
  execute();
}

void Scenario::step(size_t moves) {
  const Result<StepResult> stepped = document_.step(moves);
  may_be_open_ = may_be_open_ || !stepped.ok() || !stepped->delta.left_open.empty();
}

void Scenario::finish() {
  document_.apply(EndStroke{});
  while (document_.waiting() > 0) step(8);
}

void Scenario::execute() {
  switch (bytes_.below(4)) {
    case 0:
      return;
    case 1:
      return step(1 + bytes_.below(16));
    default:
      while (document_.waiting() > 0) step(1 + bytes_.below(64));
      check_world(document_.world());
  }
}

}  // namespace kerf::fuzz
