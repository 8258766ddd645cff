#include "ui/render/view/stage_colours.h"

namespace kerf {

namespace {

constexpr StageColours kDusk = {.sky_high = {0.0048, 0.0064, 0.0100, 0},
                                .sky_low = {0.030, 0.038, 0.050, 0},
                                .sky_band = {0.034, 0.030, 0.025, 0},
                                .sky_light = {0.30, 0.37, 0.47, 0},
                                .ground_light = {0.115, 0.105, 0.095, 0},
                                .ground_matt = {0.060, 0.061, 0.063, 0},
                                .ground_line = {0.014, 0.0155, 0.018, 0}};

constexpr StageColours kDay = {.sky_high = {0.33, 0.40, 0.49, 0},
                               .sky_low = {0.58, 0.62, 0.66, 0},
                               .sky_band = {0.10, 0.09, 0.08, 0},
                               .sky_light = {0.52, 0.57, 0.64, 0},
                               .ground_light = {0.30, 0.29, 0.28, 0},
                               .ground_matt = {0.40, 0.41, 0.42, 0},
                               .ground_line = {-0.063, -0.06975, -0.081, 0}};

}  // namespace

const StageColours& stage_colours(bool by_day) { return by_day ? kDay : kDusk; }

}  // namespace kerf
