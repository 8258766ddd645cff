#pragma once

#include <functional>

#include "tests/bench/subject.h"
#include "tests/bench/table.h"

namespace kerf::bench {

// How much work a run does: the usual one, which takes at most ten minutes on two cores.
struct Effort {
  int steps = 10000;      // of four rays, a pass
  int times = 9;          // passes, of which the median counts
  int build_times = 5;    // builds and cuts
  int edit_steps = 5000;  // of a cut
  int slot_steps = 400;   // of a slot through the whole mesh
  uint64_t sheets = 200;  // that rain
  int cuts = 5;           // along each axis, through the car that collapses
  size_t match_ticks = 2400;
  int heat_ticks = 31;
  size_t published_cuts = 6;        // 34 in a long run
  size_t scale_faces = 10'000'000;  // 30 million in a long run with 16 GB of memory
  size_t league_faces = 276'000, league_cuts = 100;
};

// Each section measures one thing on one mesh and hands over its rows. Rows that want a peer which this
// program was built without are left out.
using Report = std::function<void(const Row&)>;
void bench_build(const Subject& subject, const Effort& effort, const Report& report);
void bench_queries(const Subject& subject, const Effort& effort, const Report& report);
void bench_edits(const Subject& subject, const Effort& effort, const Report& report);
// The half-edges alone, beside OpenMesh's.
void bench_kernel(const Subject& subject, const Effort& effort, const Report& report);
void bench_cut(const Subject& subject, const Effort& effort, const Report& report);
void bench_shadows(const Subject& subject, const Effort& effort, const Report& report);
void bench_heat(const Subject& subject, const Effort& effort, const Report& report);

// Loading, building the tree and saving, in elapsed time with all threads.
void bench_files(const Subject& subject, const Effort& effort, const Report& report);

// On a rain of sheets that is made here and on the car cut to pieces, whatever the subject.
void bench_fall(const Subject& subject, const Effort& effort, const Report& report);

// On the standard match, whatever the subject: all five enemies of its last wave are alive.
void bench_game(const Subject& subject, const Effort& effort, const Report& report);

// A slot through a mesh made here, whatever the subject, compared with one of a tenth of its faces.
void bench_scale(const Subject& subject, const Effort& effort, const Report& report);

// Random slots through a solid knot made here, one after the other, whatever the subject.
void bench_league(const Subject& subject, const Effort& effort, const Report& report);

// Published speeds of laser cuts beside those of the thermal model, whatever the subject: no times.
void bench_laser(const Subject& subject, const Effort& effort, const Report& report);

}  // namespace kerf::bench
