// Cuts each mesh in several ways and prints a line with the state hash for each: `made_cuts MESH...`.
#include <cstdio>

#include "core/document/commands.h"
#include "core/document/document.h"
#include "core/document/scene.h"
#include "core/document/text/hash.h"
#include "core/world/world.h"

namespace kerf {
namespace {

const char* name_of(const Command& command) {
  return std::visit([]<typename C>(const C&) { return C::kName; }, command);
}

// Settings that the kinds of cut differ in.
struct Kind {
  const char* name;
  Scheme scheme;
  Pattern pattern;
  Rim rim;
  Resolution::Rule rule;
  bool hot = false;  // heat is left, and flows for 16 ticks
  Model model = Model::kGeometric;
};
constexpr Kind kKinds[] = {
    {"longest-edge", Scheme::kLongestEdge, Pattern::kVolume, Rim::kFaces, Resolution::Rule::kTargetEdge},
    {"one-to-four", Scheme::kOneToFour, Pattern::kVolume, Rim::kFaces, Resolution::Rule::kTolerance},
    {"smooth", Scheme::kLongestEdge, Pattern::kVolume, Rim::kSmooth, Resolution::Rule::kTargetEdge},
    {"smooth one-to-four", Scheme::kOneToFour, Pattern::kVolume, Rim::kSmooth, Resolution::Rule::kTargetEdge},
    {"rays4", Scheme::kLongestEdge, Pattern::kRays4, Rim::kFaces, Resolution::Rule::kDepth},
    {"hot", Scheme::kLongestEdge, Pattern::kVolume, Rim::kSmooth, Resolution::Rule::kTargetEdge, true},
    {"thermal", Scheme::kLongestEdge, Pattern::kVolume, Rim::kFaces, Resolution::Rule::kTargetEdge, true,
     Model::kThermal},
};

// Of the sheet that all bodies are made of, for a kerf of two radii and all of the way in a second, twice
// what is needed.
double power_for(double radius, double way) {
  const Sheet sheet;
  return 4 * radius * way * sheet.thickness * sheet.substance.density * enthalpy_of_removal(sheet.substance) /
         sheet.substance.absorptivity_fibre;
}

CutSettings settings_of(const Kind& kind, double diagonal) {
  CutSettings settings;
  settings.laser.radius = diagonal / 25;
  settings.laser.range = {0, 10 * diagonal};
  settings.laser.pattern = kind.pattern;
  settings.resolution.scheme = kind.scheme;
  settings.resolution.rule = kind.rule;
  settings.resolution.rim = kind.rim;
  settings.resolution.target_edge = settings.laser.radius / 2;
  settings.resolution.tolerance = settings.laser.radius / 4;
  settings.resolution.depth = 3;
  settings.model = kind.model;
  if (kind.model == Model::kThermal) settings.resolution.target_edge = 2 * settings.laser.radius;
  if (kind.hot && kind.model == Model::kGeometric) settings.heat_width = settings.laser.radius;
  settings.laser.power = power_for(settings.laser.radius, 1.2 * diagonal);
  return settings;
}

// A stroke that tilts on its way, and one back across it.
void draw(Document& document, const Kind& kind) {
  const World::Bounds bounds = document.world().bounds();
  const double d = bounds.diagonal();
  const Vec3 above = 0.5 * (bounds.min + bounds.max) + Vec3(0, d, 0);
  const CutSettings settings = settings_of(kind, d);
  document.apply(BeginStroke{settings, {above + Vec3(-0.6, 0, 0.05) * d, {0, -1, 0}}});
  document.apply(MoveBeam{{above + Vec3(0.6, 0, -0.04) * d, glm::normalize(Vec3(0.1, -1, 0.2))}, 1});
  document.apply(EndStroke{});
  document.apply(BeginStroke{settings, {above + Vec3(0.07, 0, -0.6) * d, glm::normalize(Vec3(0, -1, 0.3))}});
  document.apply(MoveBeam{{above + Vec3(-0.02, 0, 0.3) * d, {0, -1, 0}}, 1});
  document.apply(MoveBeam{{above + Vec3(0.3, 0, 0.3) * d, glm::normalize(Vec3(0.3, -1, 0))}, 1.5});
  document.apply(EndStroke{});
  if (kind.hot) document.apply(AdvanceTime{16, false});
}

void print(const char* mesh, const char* kind, const World& world) {
  std::printf("%s, %s: %zu faces, %zu pieces, %s\n", mesh, kind, world.live_faces(), world.live_pieces(),
              hash_text(state_hash(world)).c_str());
}

// Prepares every body with each tool, one after the other.
Status print_preparation(const char* mesh) {
  auto scene = read_scene(mesh);
  if (!scene) return scene.error();
  Document document(std::move(scene->world));
  const World::Bounds bounds = document.world().bounds();
  for (const BodyId first : document.world().ids()) {
    PieceId piece{first, 0};
    const size_t faces = document.world().body(first).mesh.live_faces();
    for (const Command& command :
         {Command(SubdividePiece{piece, Subdivision::kLoop}), Command(SmoothPiece{piece, 2}),
          Command(SimplifyPiece{piece, {.faces = 2 * faces}}),
          Command(SimplifyPiece{piece, {.faces = faces}}),
          Command(SubdividePiece{piece, Subdivision::kSqrt3}),
          Command(SimplifyPiece{piece, {.error = bounds.diagonal() / 1000}}),
          Command(SimplifyPiece{piece, {.error = bounds.diagonal() / 500}})}) {
      Command own = command;
      std::visit(
          [&](auto& c) {
            if constexpr (requires { c.piece; }) c.piece = piece;
          },
          own);
      const Outcome outcome = document.apply(own);
      if (!outcome.ok()) return outcome.error();
      if (!outcome.delta.created.empty()) piece.body = outcome.delta.created.front();
      print(mesh, name_of(own), document.world());
    }
  }
  return Done{};
}

Status print_cuts(const char* mesh) {
  for (const Kind& kind : kKinds) {
    auto scene = read_scene(mesh);
    if (!scene) return scene.error();
    Document document(std::move(scene->world));
    draw(document, kind);
    while (document.waiting() > 0) {
      if (const auto step = document.step(16); !step) return step.error();
    }
    print(mesh, kind.name, document.world());
  }
  return print_preparation(mesh);
}

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (const kerf::Status printed = kerf::print_cuts(argv[i]); !printed) {
      std::fprintf(stderr, "%s\n", printed.error().message.c_str());
      return 1;
    }
  }
  return 0;
}
