#include "tests/support/random_commands.h"

#include <bit>
#include <cmath>

#include "tests/support/strokes.h"

namespace kerf::test {

namespace {

// Of any size and sign, now and then a number that is hard to write.
double random_number(Random& random) {
  switch (random.below(8)) {
    case 0:
      return -0.0;
    case 1:
      return static_cast<double>(random.below(1u << 20));
    case 2:
      return 5e-324;
    case 3:
      return 1.7976931348623157e308;
    default:
      return std::ldexp(random.uniform(-1, 1), static_cast<int>(random.below(200)) - 100);
  }
}
double random_positive(Random& random) { return std::abs(random_number(random)) + 1e-300; }
Vec3 random_point(Random& random) {
  return {random_number(random), random_number(random), random_number(random)};
}
PieceId random_piece(Random& random) {
  const auto slot = static_cast<uint32_t>(random.below(BodyId::kNone));
  const auto generation = static_cast<uint32_t>(random.below(BodyId::kNone));
  return {{slot, generation}, static_cast<uint32_t>(random.below(9))};
}
Sheet random_sheet(Random& random) {
  Sheet sheet{random.uniform(1e-4, 0.1), random.uniform(1, 1e4), {}};
  Substance& s = sheet.substance;
  for (double* x : {&s.density, &s.heat_solid, &s.heat_liquid, &s.conductivity, &s.transition, &s.latent})
    *x = random.uniform(300, 1e4);
  for (double* x : {&s.emissivity, &s.absorptivity_fibre, &s.absorptivity_co2, &s.wavelength})
    *x = random.unit() + 1e-9;
  for (double* x : {&s.emissivity, &s.absorptivity_fibre, &s.absorptivity_co2}) *x = std::min(1.0, *x);
  s.burnt_share = random.below(2) == 0 ? random.unit() : 0;
  return sheet;
}

std::string random_name(Random& random) {
  constexpr std::array kNames{"plain", "", "with \"quotes\" and \\", "\xc3\xa4\xe2\x82\xac",
                              "line\nend\ttab"};
  return kNames[random.below(kNames.size())];
}
Placement random_placement(Random& random) {
  const Vec3 axis = random_direction(random);
  const double c = random.uniform(-1, 1), s = std::sqrt(1 - c * c);
  return {random_point(random), glm::dquat(c, axis.x * s, axis.y * s, axis.z * s)};
}

void put(std::vector<uint64_t>& bits, double x) { bits.push_back(std::bit_cast<uint64_t>(x)); }
void put(std::vector<uint64_t>& bits, const Vec3& v) {
  for (int k = 0; k < 3; ++k) put(bits, v[k]);
}
void put(std::vector<uint64_t>& bits, const Pose& pose) {
  put(bits, pose.origin);
  put(bits, pose.direction);
}
void put(std::vector<uint64_t>& bits, const PieceId& piece) {
  bits.push_back(piece.body.slot);
  bits.push_back(piece.body.generation);
  bits.push_back(piece.label);
}
void put(std::vector<uint64_t>& bits, const std::string& text) {
  bits.push_back(text.size());
  for (const char c : text) bits.push_back(static_cast<unsigned char>(c));
}
void put(std::vector<uint64_t>& bits, const CutSettings& s) {
  const Resolution& r = s.resolution;
  for (const double x : {s.laser.radius, s.laser.range.low, s.laser.range.high, s.laser.power, r.target_edge,
                         r.tolerance, s.heat_width, s.laser.wavelength, s.laser.focus.value_or(-1),
                         s.laser.pulse_rate, s.laser.duty, s.model == Model::kThermal ? 1.0 : 0.0}) {
    put(bits, x);
  }
  for (const auto n :
       {static_cast<int>(s.laser.assist), static_cast<int>(s.laser.pattern), static_cast<int>(r.scheme),
        static_cast<int>(r.rule), static_cast<int>(r.rim), r.depth}) {
    bits.push_back(static_cast<uint64_t>(n));
  }
  bits.push_back(s.max_faces);
  for (const BodyId& id : s.bodies) bits.insert(bits.end(), {id.slot, id.generation});
}

struct Bits {
  std::vector<uint64_t> bits;
  void operator()(const BeginStroke& c) {
    put(bits, c.settings);
    put(bits, c.pose);
  }
  void operator()(const MoveBeam& c) {
    put(bits, c.pose);
    put(bits, c.time);
  }
  void operator()(const AdvanceTime& c) {
    bits.push_back(c.ticks);
    bits.push_back(c.bodies);
    bits.push_back(c.joins);
  }
  void operator()(const DragBody& c) {
    put(bits, c.piece);
    put(bits, c.at);
    put(bits, c.to);
  }
  void operator()(const PinPiece& c) {
    put(bits, c.piece);
    bits.push_back(c.pinned);
  }
  void operator()(const SetSheetProperties& c) {
    put(bits, c.piece);
    const Substance& s = c.sheet.substance;
    for (const double x : {c.sheet.thickness, c.sheet.density, s.density, s.heat_solid, s.heat_liquid,
                           s.conductivity, s.transition, s.latent, s.emissivity, s.absorptivity_fibre,
                           s.absorptivity_co2, s.burnt_share, s.wavelength})
      put(bits, x);
  }
  void operator()(const SetSolid& c) {
    put(bits, c.piece);
    bits.push_back(c.solid);
  }
  void operator()(const SimplifyPiece& c) {
    put(bits, c.piece);
    bits.push_back(c.target.faces);
    put(bits, c.target.error);
  }
  void operator()(const SubdividePiece& c) {
    put(bits, c.piece);
    bits.push_back(static_cast<uint64_t>(c.scheme));
  }
  void operator()(const SmoothPiece& c) {
    put(bits, c.piece);
    bits.push_back(c.times);
  }
  void operator()(const TurnShells& c) { put(bits, c.piece); }
  void operator()(const CutPlane& c) {
    put(bits, c.plane.normal);
    put(bits, c.plane.distance);
    bits.push_back(static_cast<uint64_t>(c.pegs.count));
    for (const double x : {c.pegs.diameter, c.pegs.depth, c.pegs.tolerance}) put(bits, x);
    bits.push_back(c.max_faces);
    for (const BodyId id : c.bodies) bits.insert(bits.end(), {id.slot, id.generation});
  }
  void operator()(const CutPath& c) {
    for (const Pose& pose : c.path.poses) put(bits, pose);
    put(bits, c.path.range.low);
    put(bits, c.path.range.high);
    bits.push_back(c.max_faces);
    for (const BodyId id : c.bodies) bits.insert(bits.end(), {id.slot, id.generation});
  }
  void operator()(const JoinParts& c) {
    put(bits, c.piece);
    const JointDescription& joint = c.joint;
    bits.push_back(static_cast<uint64_t>(joint.kind));
    for (const std::string& part : joint.parts) put(bits, part);
    put(bits, joint.anchor);
    put(bits, joint.axis);
    const Interval limits = joint.limits.value_or(Interval{-1, -1});
    for (const double x : {limits.low, limits.high, joint.radius.value_or(0)}) put(bits, x);
    for (const Vec3& point : joint.near.value_or(std::array<Vec3, 2>{})) put(bits, point);
  }
  void operator()(const SetEnvironment& c) {
    put(bits, c.around.gravity);
    bits.push_back(c.around.ground.has_value());
    put(bits, c.around.ground.value_or(0));
  }
  void operator()(const StopStroke& c) {
    put(bits, c.moves);
    bits.push_back(c.ticks);
  }
  void operator()(const ReleaseBody&) {}
  void operator()(const Play&) {}
  void operator()(const Recut& c) { put(bits, c.settings); }
  void operator()(const AddMesh& c) {
    put(bits, c.file.string());
    put(bits, c.name);
  }
  void operator()(const MovePiece& c) {
    put(bits, c.piece);
    put(bits, c.to.position);
    for (int k = 0; k < 4; ++k) put(bits, c.to.orientation[k]);
  }
  void operator()(const DuplicatePiece& c) {
    put(bits, c.piece);
    put(bits, c.to.position);
    for (int k = 0; k < 4; ++k) put(bits, c.to.orientation[k]);
  }
  void operator()(const HidePiece& c) {
    put(bits, c.piece);
    bits.push_back(c.hidden);
  }
  void operator()(const DeletePiece& c) { put(bits, c.piece); }
  void operator()(const RenamePiece& c) {
    put(bits, c.piece);
    put(bits, c.name);
  }
  void operator()(const EndStroke&) {}
  void operator()(const Undo&) {}
  void operator()(const Redo&) {}
};

}  // namespace

CutSettings random_settings(Random& random) {
  CutSettings s;
  s.laser.radius = random_positive(random);
  const double low = random_positive(random), high = random_positive(random);
  s.laser.range = {std::min(low, high), std::max(low, high)};
  s.laser.pattern = random.below(2) > 0 ? Pattern::kRays4 : Pattern::kVolume;
  s.laser.power = random_positive(random);
  s.resolution.scheme = random.below(2) > 0 ? Scheme::kOneToFour : Scheme::kLongestEdge;
  s.resolution.rule = static_cast<Resolution::Rule>(random.below(3));
  s.resolution.target_edge = random_positive(random);
  s.resolution.tolerance = random_positive(random);
  s.resolution.depth = static_cast<int>(random.below(Resolution::kMaxDepth + 1));
  s.resolution.rim = random.below(2) > 0 ? Rim::kSmooth : Rim::kFaces;
  if (random.below(2) == 0) {
    s.model = Model::kThermal;
    s.heat_width = random_positive(random);
    s.laser.wavelength = random_positive(random);
    s.laser.focus = random_positive(random);
    s.laser.pulse_rate = random_positive(random);
    s.laser.duty = random.uniform(0.01, 1);
    s.laser.assist = random.below(2) == 0 ? Assist::kOxygen : Assist::kNone;
  }
  if (random.below(3) == 0) s.max_faces = 1 + random.below(1u << 30);
  for (uint64_t i = random.below(3); i > 0; --i)
    s.bodies.push_back({static_cast<uint32_t>(random.below(9)), static_cast<uint32_t>(random.below(9))});
  return s;
}

// A weld has no axis, and only a hinge has limits.
JoinParts random_joint(Random& random) {
  JoinParts join{random_piece(random), {}};
  join.joint.kind = static_cast<Joint::Kind>(random.below(3));
  join.joint.anchor = random_point(random);
  if (join.joint.kind != Joint::Kind::kWeld) join.joint.axis = random_direction(random);
  if (join.joint.kind == Joint::Kind::kHinge) join.joint.limits = Interval{-random.uniform(0, 180), 9};
  if (random.below(2) > 0) join.joint.radius = random_positive(random);
  if (random.below(2) > 0) {
    join.joint.parts = {"door", random_name(random)};
  } else {
    join.joint.near.emplace();
    for (Vec3& point : *join.joint.near) point = random_point(random);
  }
  return join;
}

Command random_command(Random& random, const BeamAt& beam) {
  Vec3 direction = random_direction(random);
  if (glm::length(direction + beam.pose.direction) < 1e-3) direction = beam.pose.direction;
  const Pose pose{random_point(random), direction};
  switch (random.below(28)) {
    case 0:
      return BeginStroke{random_settings(random), pose};
    case 1:
      return EndStroke{};
    case 2:
      return Recut{random_settings(random)};
    case 3:
      return AddMesh{"/some/folder/" + std::to_string(random.below(9)) + ".obj", random_name(random)};
    case 4:
      return MovePiece{random_piece(random), random_placement(random)};
    case 5:
      return HidePiece{random_piece(random), random.below(2) > 0};
    case 6:
      return DeletePiece{random_piece(random)};
    case 7:
      return RenamePiece{random_piece(random), random_name(random)};
    case 8:
      return Undo{};
    case 9:
      return Redo{};
    case 10:
      return AdvanceTime{1 + random.below(AdvanceTime::kMaxInALine), random.below(2) > 0,
                         random.below(2) > 0};
    case 11:
      return DuplicatePiece{random_piece(random), random_placement(random)};
    case 12:
      return DragBody{random_piece(random), random_point(random), random_point(random)};
    case 13:
      return ReleaseBody{};
    case 14:
      return Play{};
    case 15:
      return PinPiece{random_piece(random), random.below(2) > 0};
    case 16: {
      SetEnvironment set{{random_point(random), std::nullopt}};
      if (random.below(2) > 0) set.around.ground = random_number(random);
      return set;
    }
    case 17:
      return SetSheetProperties{random_piece(random), random_sheet(random)};
    case 18:
      return SimplifyPiece{random_piece(random), random.below(2) > 0
                                                     ? SimplifyTarget{.faces = 1 + random.below(1u << 30)}
                                                     : SimplifyTarget{.error = random_positive(random)}};
    case 19:
      return SubdividePiece{random_piece(random), static_cast<Subdivision>(random.below(3))};
    case 20:
      return SmoothPiece{random_piece(random), 1 + random.below(kMaxSmoothing)};
    case 21:
      return SetSolid{random_piece(random), random.below(2) > 0, random.below(3) > 0 ? "" : "\"foam\""};
    case 22:
      return StopStroke{random.uniform(0, 1000), random.below(100)};
    case 23:
      return TurnShells{random_piece(random)};
    case 24: {
      const CutSettings settings = random_settings(random);
      CutPlane cut{{random_direction(random), random_number(random)}, settings.bodies, settings.max_faces};
      if (random.below(2) > 0)
        cut.pegs = {1 + static_cast<int>(random.below(9)), random.uniform(1e-9, 1), random.uniform(1e-9, 1),
                    random.uniform(0, 1)};
      return cut;
    }
    case 25: {
      const CutSettings settings = random_settings(random);
      return CutPath{{{beam.pose, pose}, settings.laser.range}, settings.bodies, settings.max_faces};
    }
    case 26:
      return random_joint(random);
    default:
      return MoveBeam{pose, random.below(3) == 0 ? beam.time : beam.time + random.unit()};
  }
}

std::vector<Command> random_commands(Random& random, size_t count) {
  std::vector<Command> commands;
  BeamAt beam{{{}, {0, 1, 0}}, 0};
  while (commands.size() < count) {
    commands.push_back(random_command(random, beam));
    if (const auto* begin = std::get_if<BeginStroke>(&commands.back())) beam = {begin->pose, 0};
    if (const auto* move = std::get_if<MoveBeam>(&commands.back())) beam = {move->pose, move->time};
  }
  return commands;
}

bool same_bits(const Command& a, const Command& b) {
  if (a.index() != b.index()) return false;
  Bits of_a, of_b;
  std::visit(of_a, a);
  std::visit(of_b, b);
  return of_a.bits == of_b.bits;
}

}  // namespace kerf::test
