#pragma once

#include <nlohmann/json.hpp>

#include "core/base/parallel.h"
#include "core/document/journal.h"

namespace kerf {

// The stages of one move of the beam, as the editor shows them in single steps. Moves are counted from 1 over
// all strokes of the file, in the order of their execution, subdivided as they are cut:
// {"step": 3, "move": {"from": {"origin": [..], "direction": [..]}, "to": {..}, "seconds": 0.1},
//  "stages": [{"stage": "hit", "body": "car", "words": "..", "hit": [..], "born": [..], "gone": [..],
//              "relabelled": [..], "pieces": [..], "queries": [{..}]}], "state_hash": "0123456789abcdef"}
// The queries of the stages "hit" and "hit-again" list the boxes of the tree in the order in which they were
// tested, each with the index of its parent, its outcome ("entered", "culled", "missed" or "touched"), what a
// culled box lies outside of ("depth", "motion" or "lateral"), and the face of a leaf. Boxes are in the frame
// of the body. Bad input if there are fewer moves; fails with cancelled() when stopped.
Result<nlohmann::ordered_json> step_json(OpenedFile file, size_t number, const Progress* progress = nullptr);

}  // namespace kerf
