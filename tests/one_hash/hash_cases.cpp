// Computes results from seeds and prints a line with a hash for each, for the comparison of two machines (see
// other_machine.py): `hash_cases CHECKOUT KIND COUNT`. A line begins with its kind and its case. Bodies move
// only in those of the kinds `fall`, `journal` and `match`.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "core/base/random.h"
#include "core/document/commands.h"
#include "core/document/document.h"
#include "core/document/journal.h"
#include "core/document/replay.h"
#include "core/document/scene.h"
#include "core/document/text/hash.h"
#include "core/game/match/match.h"
#include "core/game/match/recording.h"
#include "core/shadow/shadow_volume.h"
#include "core/world/world.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;

void print(const std::string& kind, const std::string& name, const World& world) {
  std::printf("%s %s: %zu faces, %zu pieces, %s\n", kind.c_str(), name.c_str(), world.live_faces(),
              world.live_pieces(), hash_text(state_hash(world)).c_str());
  std::fflush(stdout);
}

// A random result of one seed: a mesh of the assets and the commands that change it.
class Case {
 public:
  Case(std::string kind, uint64_t seed, const fs::path& meshes)
      : kind_(std::move(kind)), seed_(seed), random_(hash_combine(seed, 72)) {
    constexpr const char* kMeshes[] = {"plate", "bracket", "knot",  "sphere",
                                       "drum",  "sign",    "stack", "barrier"};
    mesh_ = kMeshes[random_.below(std::size(kMeshes))];
    auto scene = read_scene(meshes / (mesh_ + ".obj"));
    if (!scene) {
      std::fprintf(stderr, "%s\n", scene.error().message.c_str());
      std::exit(1);
    }
    document_ = Document(std::move(scene->world));
    const World::Bounds bounds = world().bounds();
    size_ = bounds.diagonal();
    middle_ = 0.5 * (bounds.min + bounds.max);
  }

  const World& world() const { return document_.world(); }
  Random& random() { return random_; }
  double size() const { return size_; }

  // A failed command is part of the result: its message is printed.
  void apply(const Command& command) {
    const Outcome outcome = document_.apply(command);
    if (!outcome.ok()) record(outcome.error().message);
  }
  void finish() {
    while (document_.waiting() > 0) {
      if (const auto step = document_.step(16); !step) record(step.error().message);
    }
  }
  void record(const std::string& text) { notes_ += ", " + text; }
  void print(const std::string& stage = "") {
    kerf::print(kind_, std::to_string(seed_) + ", " + mesh_ + notes_ + stage, world());
  }
  void print_value(uint64_t hash) const {
    std::printf("%s %llu, %s%s: %s\n", kind_.c_str(), static_cast<unsigned long long>(seed_), mesh_.c_str(),
                notes_.c_str(), hash_text(hash).c_str());
    std::fflush(stdout);
  }

  Vec3 direction() {
    for (;;) {
      // Braces evaluate from left to right; compilers differ in the order of other arguments.
      const Vec3 v{random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)};
      const double length2 = glm::dot(v, v);
      if (length2 > 0.01 && length2 < 1) return v / std::sqrt(length2);
    }
  }

  // Two bits of the seed select rim and scheme, so that four seeds in a row have all of them.
  CutSettings settings() {
    CutSettings settings;
    settings.laser.radius = size_ * random_.uniform(0.01, 0.04);
    settings.laser.range = {0, 10 * size_};
    settings.resolution.target_edge = settings.laser.radius * random_.uniform(0.6, 1.5);
    settings.resolution.scheme = seed_ & 1 ? Scheme::kOneToFour : Scheme::kLongestEdge;
    settings.resolution.rim = seed_ & 2 ? Rim::kSmooth : Rim::kFaces;
    return settings;
  }

  // A stroke of two to four poses past the middle; the beam turns a little on its way unless it is
  // `straight`.
  void stroke(const CutSettings& settings, bool straight = false) {
    const Vec3 axis = direction(), along = glm::normalize(glm::cross(axis, direction()));
    const Vec3 start = middle_ + 0.1 * size_ * direction() - size_ * axis - 0.6 * size_ * along;
    const uint64_t moves = 1 + random_.below(3);
    apply(BeginStroke{settings, {start, axis}});
    for (uint64_t i = 1; i <= moves; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(moves);
      const Vec3 to = start + 1.2 * size_ * share * along + 0.05 * size_ * direction();
      apply(MoveBeam{{to, straight ? axis : glm::normalize(axis + 0.15 * direction())}, share});
    }
    apply(EndStroke{});
  }

 private:
  std::string kind_;
  uint64_t seed_;
  Random random_;
  std::string mesh_, notes_;
  Document document_;
  double size_ = 0;
  Vec3 middle_{0};
};

PieceId whole(const Case& c) { return {c.world().ids().front(), 0}; }

void cut(Case& c) {
  c.stroke(c.settings());
  c.stroke(c.settings());
  c.finish();
  c.print();
}

// Solids, cut by strokes and by the knife.
void cut_solid(Case& c) {
  c.apply(SetSolid{whole(c), true});
  CutSettings settings = c.settings();
  settings.resolution.rim = Rim::kSmooth;
  c.stroke(settings, true);
  c.finish();
  c.print(", stroke");
  const Vec3 normal = c.direction();
  const World::Bounds bounds = c.world().bounds();
  c.apply(CutPlane{{normal, glm::dot(normal, 0.5 * (bounds.min + bounds.max))}});
  c.print(", knife");
}

// Both models, with heat that flows for a third of a second.
void heat(Case& c) {
  CutSettings settings = c.settings();
  if (c.random().below(2) == 0) {
    settings.heat_width = settings.laser.radius;
  } else {
    const Sheet sheet;
    settings.model = Model::kThermal;
    settings.laser.power = c.random().uniform(2, 6) * 2 * settings.laser.radius * c.size() * sheet.thickness *
                           sheet.substance.density * enthalpy_of_removal(sheet.substance) /
                           sheet.substance.absorptivity_fibre;
  }
  c.stroke(settings);
  c.apply(AdvanceTime{40, false});
  c.finish();
  c.print();
}

// One tool after another on the same piece.
void prepare(Case& c) {
  PieceId piece = whole(c);
  const size_t faces = c.world().live_faces();
  for (int i = 0; i < 3; ++i) {
    Command command;
    switch (c.random().below(4)) {
      case 0:
        command = SubdividePiece{piece, c.random().below(2) == 0 ? Subdivision::kLoop : Subdivision::kSqrt3};
        break;
      case 1:
        command = SmoothPiece{piece, 1 + c.random().below(4)};
        break;
      case 2:
        command = SimplifyPiece{piece, {.faces = faces / (1 + c.random().below(4))}};
        break;
      default:
        command = SimplifyPiece{piece, {.error = c.size() * c.random().uniform(0.0005, 0.005)}};
        break;
    }
    c.apply(command);
    piece = whole(c);
  }
  c.print();
}

uint64_t hash_of(const ShadowCaster& caster, const ShadowVolume& volume) {
  uint64_t hash = 0;
  for (const int8_t sign : volume.signs()) hash = hash_combine(hash, static_cast<uint64_t>(sign + 1));
  for (const SilhouetteEdge& edge : volume.silhouette()) {
    const ShadowCaster::Ends ends = caster.ends(edge.edge);
    for (const glm::vec3& end : {ends.low, ends.high}) {
      for (int i = 0; i < 3; ++i) hash = hash_combine(hash, number_bits(end[i]));
    }
    hash = hash_combine(hash, static_cast<uint64_t>(edge.multiplicity + 1'000));
  }
  return hash;
}

// Shadow volumes of each method, for a point light or a direction, of a cut mesh.
void cast_shadows(Case& c) {
  c.stroke(c.settings());
  c.finish();
  const LightPoint light{3 * c.size() * c.direction(), c.random().below(2) == 0 ? 1.0 : 0.0};
  uint64_t hash = 0;
  for (const BodyId id : c.world().ids()) {
    const Body& body = c.world().body(id);
    const Bounds bounds = body.bounds();
    const ShadowCaster caster(body.mesh, FloatFrame::around(bounds.min, bounds.max));
    for (const ShadowMethod method :
         {ShadowMethod::kPaperOneVolume, ShadowMethod::kPaperTwoVolumes, ShadowMethod::kRobust}) {
      ShadowVolume volume(method);
      volume.rebuild(caster, {light, {}});
      hash = hash_combine(hash, hash_of(caster, volume));
    }
  }
  c.print_value(hash);
}

// Pieces of two strokes fall onto the ground and each other.
void fall(Case& c) {
  const double lowest = c.world().bounds().min.y;
  c.apply(SetEnvironment{{.gravity = {0, -9.81, 0}, .ground = lowest - 0.2 * c.size()}});
  c.stroke(c.settings());
  c.stroke(c.settings());
  c.apply(Play{});
  for (const Ticks ticks : {Ticks{1}, Ticks{29}, Ticks{90}, Ticks{120}}) {
    for (Ticks i = 0; i < ticks; ++i) c.apply(AdvanceTime{1, true});
    c.finish();
    c.print(", " + std::to_string(c.world().clock()) + " ticks");
  }
}

Status replay(const fs::path& file) {
  auto opened = open_journal(file);
  if (!opened) return opened.error();
  Journal& journal = opened->journal;
  bool motion = false;
  // Without the states of bodies, motion is computed on every machine.
  for (StateMark& mark : journal.marks) {
    motion = motion || !mark.bodies.empty();
    mark.bodies.clear();
  }
  Document document(std::move(opened->scene.world));
  Replay replay(journal, document);
  QueueRun how;
  how.told = [](const Result<StepResult>&) -> Status { return Done{}; };
  for (const StateMark& mark : journal.marks) {
    while (!replay.done() && replay.applied() < mark.commands) {
      if (const Status next = replay.next(how); !next) return next;
    }
    print(motion ? "journal" : "kept",
          file.filename().string() + ", mark of line " + std::to_string(mark.line), document.world());
  }
  return Done{};
}

Status replay_match(const fs::path& file) {
  const auto recording = read_recording(file);
  if (!recording) return recording.error();
  auto rules = load_rules(recording->rules, nullptr, recording->player, recording->arena);
  if (!rules) return rules.error();
  Match match({*rules, recording->seed, recording->difficulty});
  for (size_t t = 0; t < recording->controls.size(); ++t) {
    match.tick(recording->controls[t]);
    if (t == 0 || (t + 1) % kTicksPerSecond == 0)
      print("match", file.filename().string() + ", tick " + std::to_string(t + 1), match.world());
  }
  return Done{};
}

Status replay_kept(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".kerf") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  for (const fs::path& file : files) {
    const Status replayed = is_recording(file) ? replay_match(file) : replay(file);
    if (!replayed) return replayed;
  }
  return Done{};
}

struct Kind {
  const char* name;
  void (*run)(Case&);
};
constexpr Kind kKinds[] = {{"stroke", cut},      {"solid", cut_solid},     {"heat", heat},
                           {"prepare", prepare}, {"shadow", cast_shadows}, {"fall", fall}};

Status run(const fs::path& checkout, const std::string& kind, uint64_t count) {
  if (kind == "kept") return replay_kept(checkout / "tests/kept");
  for (const Kind& known : kKinds) {
    if (kind != known.name) continue;
    for (uint64_t seed = 1; seed <= count; ++seed) {
      Case c(kind, seed, checkout / "assets/meshes");
      known.run(c);
    }
    return Done{};
  }
  return bad_input(kind + ": unknown kind of case");
}

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "hash_cases CHECKOUT KIND COUNT\n");
    return 2;
  }
  const kerf::Status ran = kerf::run(argv[1], argv[2], std::strtoull(argv[3], nullptr, 10));
  if (!ran) std::fprintf(stderr, "%s\n", ran.error().message.c_str());
  return ran ? 0 : 1;
}
