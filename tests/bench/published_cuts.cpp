#include "tests/bench/published_cuts.h"

namespace kerf::bench {

namespace {

constexpr const char* kOxygen = "empirical: one share that burns and one fastest front for all rows";
constexpr const char* kMachine = "the machine's acceleration and the flow of gas limit it, not energy";
constexpr const char* kFitted = "the absorptivity of the class was fitted to these two rows";

// First those that the model can be expected to meet.
constexpr PublishedCut kCuts[] = {
    {14, "stainless-304", 1, 1000, 12, 12, .16, "stainless, nitrogen", ""},
    {15, "stainless-304", 2, 2000, 11, 11, .19, "stainless, nitrogen", ""},
    {16, "stainless-304", 3, 3000, 8, 8, .22, "stainless, nitrogen", ""},
    {17, "stainless-304", 5, 4000, 5.5, 5.5, .26, "stainless, nitrogen", ""},
    {18, "stainless-304", 10, 6000, 2.8, 2.8, .33, "stainless, nitrogen", ""},
    {9, "mild-steel", 1, 2000, 24, 30, .15, "mild steel, nitrogen or air", ""},
    {10, "mild-steel", 1, 4000, 33, 42, .18, "mild steel, nitrogen or air", ""},
    {23, "pmma", 3, 42, .6, .9, .25, "acrylic", ""},
    {24, "pmma", 6, 54, .3, .48, .30, "acrylic", ""},
    {25, "pmma", 3, 100, 1.5, 1.5, .25, "acrylic", ""},
    {26, "pmma", 10, 150, .6, .6, .40, "acrylic", ""},
    {27, "plywood", 3, 45, .72, 1.08, .30, "birch plywood", ""},
    {29, "plywood", 5.3, 42, .6, .6, .35, "oak plywood", ""},
    {30, "plywood", 7.7, 42, .36, .36, .35, "plywood", ""},
    {32, "plywood", 19, 45, .12, .12, .45, "pine", ""},
    {33, "pmma", 8, 80, .3, .3, .35, "acrylic", ""},
    {1, "mild-steel", 1, 500, 7, 9, .15, "mild steel, oxygen", kOxygen, Assist::kOxygen},
    {2, "mild-steel", 1, 1000, 8, 10, .15, "mild steel, oxygen", kOxygen, Assist::kOxygen},
    {3, "mild-steel", 3, 1000, 2.4, 3, .20, "mild steel, oxygen", kOxygen, Assist::kOxygen},
    {4, "mild-steel", 3, 2000, 3, 4.8, .25, "mild steel, oxygen", kOxygen, Assist::kOxygen},
    {5, "mild-steel", 6, 1000, 1.4, 1.6, .25, "mild steel, oxygen", kOxygen, Assist::kOxygen},
    {6, "mild-steel", 6, 2000, 1.8, 2.6, .30, "mild steel, oxygen", kOxygen, Assist::kOxygen},
    {7, "mild-steel", 10, 1000, .6, 1, .35, "mild steel, oxygen", kOxygen, Assist::kOxygen},
    {8, "mild-steel", 10, 3000, 1.2, 2, .40, "mild steel, oxygen", kOxygen, Assist::kOxygen},
    {11, "mild-steel", 1, 12000, 30, 50, .20, "mild steel", kMachine},
    {12, "mild-steel", 3, 12000, 10, 20, .25, "mild steel", kMachine},
    {13, "stainless-304", 1, 500, 8, 13, .15, "stainless 201", "more than the balance of energies allows"},
    {19, "aluminium-6061", 2, 2000, 9, 9, .19, "aluminium, nitrogen", kFitted},
    {20, "aluminium-6061", 5, 4000, 5, 5, .26, "aluminium, nitrogen", kFitted},
    {21, "copper", 1, 2000, 8, 8, .19, "copper, nitrogen", kFitted},
    {22, "copper", 3, 4000, 4, 4, .24, "copper, nitrogen", kFitted},
    {28, "plywood", 6, 58.5, .3, .48, .35, "birch plywood", "glue and moisture differ from board to board"},
    {31, "plywood", 3, 36, 1.2, 1.2, .30, "MDF", "more than the balance of energies allows"},
    {34, "titanium-64", .15, 33, .12, .12, .023, "titanium foil, pulsed", "pulses drill it hole by hole"},
};

}  // namespace

std::span<const PublishedCut> published_cuts() { return kCuts; }

}  // namespace kerf::bench
