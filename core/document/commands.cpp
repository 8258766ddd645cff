#include "core/document/commands.h"

#include <array>
#include <cmath>
#include <utility>

#include "core/document/scene.h"
#include "core/document/text/fields.h"
#include "core/edit/detach.h"
#include "core/world/body_creation.h"
#include "core/world/body_mass.h"

namespace kerf {

namespace {

constexpr std::array kPatterns{"volume", "rays4"};
constexpr std::array kSchemes{"one-to-four", "longest-edge"};
constexpr std::array kRules{"target-edge", "tolerance", "depth"};
constexpr std::array kRims{"faces", "smooth"};
constexpr std::array kAssists{"none", "oxygen"};
constexpr std::array kModels{"geometric", "thermal"};

constexpr double kMaxMoves = 1e9;
constexpr Ticks kMaxTicks = Ticks{1} << 40;

}  // namespace

// The settings of a stroke: everything on which the result of its cut depends.
static void describe(Fields& f, CutSettings& s) {
  f.number("radius", s.laser.radius, kPositive);
  f.interval("range", s.laser.range);
  f.choice("pattern", s.laser.pattern, kPatterns);
  f.number("power", s.laser.power, kPositive);
  f.choice("scheme", s.resolution.scheme, kSchemes);
  f.choice("rule", s.resolution.rule, kRules);
  f.number("target-edge", s.resolution.target_edge, kPositive);
  f.number("tolerance", s.resolution.tolerance, kPositive);
  f.whole("depth", s.resolution.depth, 0, Resolution::kMaxDepth);
  f.choice("rim", s.resolution.rim, kRims);
  f.choice("model", s.model, kModels, Model::kGeometric);
  f.number("heat-width", s.heat_width, kPositive, 0);
  f.number("wavelength", s.laser.wavelength, kPositive, 0);
  f.number("focus", s.laser.focus, kPositive);
  f.number("pulse-rate", s.laser.pulse_rate, kPositive, 0);
  f.number("duty", s.laser.duty, kPositiveShare, 1);
  f.choice("assist", s.laser.assist, kAssists, Assist::kNone);
  f.whole("most-faces", s.max_faces, 1, uint64_t{1} << 32, CutSettings::kMaxFaces);
  bodies_field(f, "bodies", s.bodies);
}

void describe(Fields& f, BeginStroke& c) {
  f.object("settings", c.settings);
  describe(f, c.pose);
}

void describe(Fields& f, MoveBeam& c) {
  describe(f, c.pose);
  f.number("t", c.time, kFinite, 0);
}

void describe(Fields& f, StopStroke& c) {
  f.number("moves", c.moves, {0, kMaxMoves});
  f.whole("ticks", c.ticks, 0, kMaxTicks, 0);
}

void describe(Fields& f, Recut& c) { f.object("settings", c.settings); }

void describe(Fields& f, AdvanceTime& c) {
  f.whole("ticks", c.ticks, 1, AdvanceTime::kMaxInALine);
  f.flag("bodies", c.bodies, false);
  f.flag("joins", c.joins, false);
}

void describe(Fields& f, DragBody& c) {
  piece_field(f, c.piece);
  f.vector("at", c.at);
  f.vector("to", c.to);
}

void describe(Fields& f, MovePiece& c) {
  piece_field(f, c.piece);
  describe(f, c.to);
}

Result<Delta> MovePiece::run(World& world, uint32_t generation, const Progress*) const {
  return edit_piece(
      world, piece, generation, &Delta::moved,
      [&](const Body& body) { return body.placement != to || !body.motion.at_rest(); },
      [&](Body& own) {
        own.placement = to;
        own.motion = {};
      });
}

void describe(Fields& f, DuplicatePiece& c) {
  piece_field(f, c.piece);
  describe(f, c.to);
}

Result<Delta> DuplicatePiece::run(World& world, uint32_t generation, const Progress*) const {
  if (!has_faces(world, piece)) return no_such_piece(piece);
  Delta delta;
  const BodyId copy = duplicate(world, piece, generation, delta);
  world.body(copy).placement = to;
  const double stored = world.body(copy).heat.stored(world.body(copy).mesh);
  EnergyLedger& ledger = world.edit_energy();
  ledger.emitted += stored;
  ledger.absorbed += stored;
  return delta;
}

void describe(Fields& f, HidePiece& c) {
  piece_field(f, c.piece);
  f.flag("hidden", c.hidden);
}

Result<Delta> HidePiece::run(World& world, uint32_t generation, const Progress*) const {
  return edit_piece(
      world, piece, generation, &Delta::visibility_changed,
      [&](const Body& body) { return body.hidden != hidden; }, [&](Body& own) { own.hidden = hidden; });
}

void describe(Fields& f, DeletePiece& c) { piece_field(f, c.piece); }

Result<Delta> DeletePiece::run(World& world, uint32_t generation, const Progress*) const {
  if (!has_faces(world, piece)) return no_such_piece(piece);
  Delta delta, change;
  const BodyId own = detach(world, piece, generation, delta);
  const Body& body = world.body(own);
  world.edit_energy().deleted += body.ejected + body.heat.stored(body.mesh);
  world.remove(own);
  change.destroyed = {own};
  delta.append(std::move(change));
  return delta;
}

void describe(Fields& f, RenamePiece& c) {
  piece_field(f, c.piece);
  f.text("name", c.name);
}

Result<Delta> RenamePiece::run(World& world, uint32_t, const Progress*) const {
  if (!has_faces(world, piece)) return no_such_piece(piece);
  Delta delta;
  Body& body = world.body(piece.body);
  if (body.name_of(piece.label) == name) return delta;
  if (is_only_piece(world, piece)) {
    body.name = name;
    body.named = piece.label;
    body.piece_names.clear();
  } else {
    body.piece_names[piece.label] = name;
  }
  delta.renamed = {piece.body};
  return delta;
}

void describe(Fields& f, PinPiece& c) {
  piece_field(f, c.piece);
  f.flag("pinned", c.pinned);
}

Result<Delta> PinPiece::run(World& world, uint32_t generation, const Progress*) const {
  return edit_piece(
      world, piece, generation, &Delta::pinned, [&](const Body& body) { return body.pinned != pinned; },
      [&](Body& own) {
        own.pinned = pinned;
        own.motion = {};
      });
}

void describe(Fields& f, SetSheetProperties& c) {
  piece_field(f, c.piece);
  describe(f, c.sheet);
}

Result<Delta> SetSheetProperties::run(World& world, uint32_t generation, const Progress*) const {
  return edit_piece(
      world, piece, generation, &Delta::mass_changed, [&](const Body& body) { return body.sheet != sheet; },
      [&](Body& own) { own.sheet = sheet; });
}

void describe(Fields& f, SetSolid& c) {
  piece_field(f, c.piece);
  f.flag("solid", c.solid);
  if (f.present("cut_material", !c.cut_material.empty())) f.filled_text("cut_material", c.cut_material);
}

Result<Delta> SetSolid::run(World& world, uint32_t generation, const Progress*) const {
  const auto material = [&](const Body& body) {
    return cut_material.empty() ? body.cut_material : cut_material;
  };
  return edit_piece(
      world, piece, generation, &Delta::mass_changed,
      [&](const Body& body) { return body.solid != solid || body.cut_material != material(body); },
      [&](Body& own) {
        own.cut_material = material(own);
        make_solid(own, solid);
      });
}

void describe(Fields& f, SimplifyPiece& c) {
  piece_field(f, c.piece);
  if (f.present("error", std::isfinite(c.target.error))) {
    f.number("error", c.target.error, kPositive);
    f.present("faces", false);
  } else {
    f.whole("faces", c.target.faces, 1, FaceId::kNone);
  }
}

Result<Delta> SimplifyPiece::run(World& world, uint32_t generation, const Progress* progress) const {
  return remesh_piece(
      world, piece, generation,
      [&](const Mesh& mesh, const TrackedFaces& tracked, const Progress* working) {
        return simplify(mesh, target, {tracked.kept, tracked.is_seam, tracked.uv_sets}, working,
                        tracked.warm);
      },
      progress);
}

void describe(Fields& f, SubdividePiece& c) {
  piece_field(f, c.piece);
  f.choice("scheme", c.scheme, kSubdivisionNames);
}

Result<Delta> SubdividePiece::run(World& world, uint32_t generation, const Progress* progress) const {
  if (has_faces(world, piece) && world.body(piece.body).pieces[piece.label].faces > kMaxToSubdivide)
    return bad_input(piece_words(piece) + " has too many faces to be subdivided");
  return remesh_piece(
      world, piece, generation,
      [&](const Mesh& mesh, const TrackedFaces& tracked, const Progress* working) {
        return subdivide(mesh, scheme, {tracked.kept, tracked.is_seam}, working);
      },
      progress);
}

void describe(Fields& f, SmoothPiece& c) {
  piece_field(f, c.piece);
  f.whole("times", c.times, 1, kMaxSmoothing);
}

Result<Delta> SmoothPiece::run(World& world, uint32_t generation, const Progress* progress) const {
  return remesh_piece(
      world, piece, generation,
      [&](const Mesh& mesh, const TrackedFaces& tracked, const Progress* working) {
        return smooth(mesh, times, {tracked.kept, tracked.is_seam}, working);
      },
      progress);
}

void describe(Fields& f, TurnShells& c) { piece_field(f, c.piece); }

Result<Delta> TurnShells::run(World& world, uint32_t generation, const Progress* progress) const {
  return remesh_piece(
      world, piece, generation,
      [](const Mesh& mesh, const TrackedFaces&, const Progress* working) {
        return turn_shells(mesh, working);
      },
      progress);
}

// The fields that all commands of the knife share.
template <typename C>
static void describe_knife(Fields& f, C& c) {
  bodies_field(f, "bodies", c.bodies);
  f.whole("most-faces", c.max_faces, 1, uint64_t{1} << 32, CutSettings::kMaxFaces);
}

static std::vector<BodyId> bodies_to_cut(const World& world, const std::vector<BodyId>& bodies) {
  CutSettings settings;
  settings.bodies = bodies;
  return cuttable(world, settings);
}

static Result<Delta> delta_of(Result<StepResult> result) {
  if (!result) return result.error();
  return std::move(result->delta);
}

static void describe(Fields& f, Pegs& pegs) {
  f.whole("count", pegs.count, 1, Pegs::kMaxCount);
  f.number("diameter", pegs.diameter, kPositive);
  f.number("depth", pegs.depth, kPositive);
  f.number("tolerance", pegs.tolerance, NumberRange{0, std::numeric_limits<double>::max(), "m"});
}

void describe(Fields& f, CutPlane& c) {
  f.vector("normal", c.plane.normal, VectorRule::kNotZero);
  f.number("distance", c.plane.distance, kFinite);
  describe_knife(f, c);
  if (f.present("pegs", c.pegs.count > 0)) f.object("pegs", c.pegs);
}

Result<Delta> CutPlane::run(World& world, uint32_t, const Progress* progress) const {
  return delta_of(cut_with_plane(world, plane, bodies_to_cut(world, bodies), max_faces, progress, pegs));
}

void describe(Fields& f, CutPath& c) {
  f.list("poses", "poses", c.path.poses);
  f.check(c.path.poses.size() >= 2, "poses", "must hold at least two");
  f.interval("range", c.path.range);
  describe_knife(f, c);
}

Result<Delta> CutPath::run(World& world, uint32_t, const Progress* progress) const {
  return delta_of(cut_with_path(world, path, bodies_to_cut(world, bodies), max_faces, progress));
}

void describe(Fields& f, AddMesh& c) {
  f.path("mesh", c.file);
  f.text("name", c.name);
}

Result<Delta> AddMesh::run(World& world, uint32_t generation, const Progress* progress) const {
  Result<Body> body = create ? create(progress) : load_body(name, file, progress);
  if (!body) return body.error();
  Delta delta;
  delta.created = {world.add(std::move(*body), generation)};
  return delta;
}

void describe(Fields& f, JoinParts& c) {
  piece_field(f, c.piece);
  f.object("joint", c.joint);
}

Result<Delta> JoinParts::run(World& world, uint32_t, const Progress*) const {
  const BodyId id = piece.body;
  if (!has_faces(world, piece)) return no_such_piece(piece);
  const Body& body = world.body(id);
  if (body.loaded_as != id || body.mesh.face_slots() != body.loaded.faces ||
      body.mesh.live_faces() != body.loaded.faces)
    return bad_input(body.name + ": parts can only be joined before the body is cut or falls apart");
  auto made = make_joint(joint, id, body);
  if (!made) return made.error();
  Joints joints = world.joints();
  joints.all.push_back(std::move(*made));
  world.set_joints(std::move(joints));
  Delta delta;
  delta.joined = {id};
  return delta;
}

void describe(Fields& f, SetEnvironment& c) {
  f.vector("gravity", c.around.gravity);
  f.number("ground", c.around.ground, kFinite);
  f.number("metre", c.around.metre, kPositive, 1);
}

Result<Delta> SetEnvironment::run(World& world, uint32_t, const Progress*) const {
  Delta delta;
  if (world.environment() == around) return delta;
  world.set_environment(around);
  delta.environment = true;
  return delta;
}

}  // namespace kerf
