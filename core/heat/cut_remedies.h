#pragma once

#include "core/heat/lumped_cut.h"

namespace kerf {

// What would have got a beam through a sheet that it did not get through: each of the three on its own, by
// the lumped heat balance.
struct CutRemedies {
  double speed = 0;  // m/s, slower; 0: no speed at which the balance holds is slow enough
  double power = 0;  // W, more
  double kerf = 0;   // m, narrower; 0: narrower alone would not do
};

// The remedies for a cut at a speed (m/s, > 0) through a sheet of this thickness (m, > 0, along the beam);
// nothing changes where the balance says that it gets through: all three are those of the cut. Constant time.
CutRemedies remedies(const LumpedCut& cut, double thickness, double speed);

}  // namespace kerf
