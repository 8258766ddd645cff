#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "core/document/journal.h"
#include "core/mesh/measures.h"
#include "core/world/body_mass.h"
#include "core/world/world.h"
#include "tests/fuzz/strokes/scenario.h"
#include "tests/fuzz/strokes/world_check.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"

namespace kerf::fuzz {

namespace {

void run_queue_of(Document& document) {
  while (document.waiting() > 0) (void)document.step(8).ok();
}

// The journal leads to the same world; undone to its beginning it is the loaded world again, to the bit, and
// done again the same.
void check_history(Document& document, const World& start) {
  const uint64_t hash = state_hash(document.world());
  Document again{World(start)};
  for (const Command& command : document.journal()) {
    (void)again.apply(command).ok();
    run_queue_of(again);
  }
  require(state_hash(again.world()) == hash, "a replay of the journal leads to another state");
  const size_t end = document.history().position();
  while (document.history().position() > 0) {
    const size_t before = document.history().position();
    document.apply(Undo{});
    require(document.history().position() < before, "a step cannot be undone");
  }
  test::expect_same_world(document.world(), start);
  while (document.history().position() < end) {
    const size_t before = document.history().position();
    document.apply(Redo{});
    run_queue_of(document);
    require(document.history().position() > before, "a step cannot be done again");
  }
  require(state_hash(document.world()) == hash, "done again it is another state");
}

// Prints what would be done, for whoever looks into a finding.
void report(const Document& document) {
  if (std::getenv("KERF_FUZZ_TELL") == nullptr) return;
  const auto lines = journal_lines(document.journal(), {}, {});
  if (lines) std::fprintf(stderr, "%s", lines->c_str());
}

void check(const uint8_t* data, size_t size) {
  ByteSource bytes(data, size);
  const FuzzedMesh mesh = mesh_from(bytes);
  const auto built = build_mesh(mesh.soup);
  if (!built) return;
  auto body = make_body("mesh", BuiltMesh(*built));
  const EnclosedVolume enclosed = enclosed_volume(built->mesh, body.middle());
  body.solid = mesh.solid;
  if (body.solid) update_mass_properties(body);
  World start;
  start.add(std::move(body));
  if (!(start.bounds().diagonal() > 0)) return;
  Document document{World(start)};
  Scenario scenario(document, bytes, mesh.solid);
  const double loaded = test::live_area(built->mesh);
  while (!bytes.empty()) {
    scenario.act();
    report(document);
  }
  scenario.finish();
  check_world(document.world());
  if (mesh.solid && enclosed.closed && enclosed.volume > 0 && !scenario.may_be_open())
    check_closed(document.world());
  // The walls of a solid add to the area.
  if (!scenario.remade() && !mesh.solid) {
    double left = document.history().totals().removed_area;
    for (const BodyId id : document.world().ids()) left += test::live_area(document.world().body(id).mesh);
    require(
        std::abs(left - loaded) <= 1e-6 * loaded,
        "areas do not balance: " + std::to_string(left / loaded) + " of what was loaded is left and removed");
  }
  check_history(document, start);
}

// A broken expectation ends the program, as a broken requirement does.
bool break_on_failure() {
  int count = 1;
  char name[] = "fuzz", *arguments[] = {name, nullptr};
  testing::InitGoogleTest(&count, arguments);
  GTEST_FLAG_SET(break_on_failure, true);
  return true;
}

}  // namespace

}  // namespace kerf::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {  // NOLINT: libFuzzer's name
  [[maybe_unused]] static const bool breaks = kerf::fuzz::break_on_failure();
  kerf::fuzz::check(data, size);
  return 0;
}
