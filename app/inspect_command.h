#pragma once

#include "core/base/json.h"
#include "core/base/parallel.h"
#include "core/document/journal.h"

namespace kerf {

// Returns the stages of one move of the beam, like the single steps of the editor. Moves are counted from 1
// over all strokes of the file, in the order of execution and with their subdivision:
// {"step": 3, "move": {"from": {"origin": [..], "direction": [..]}, "to": {..}, "seconds": 0.1},
//  "stages": [{"stage": "hit", "body": "car", "words": "..", "hit": [..], "born": [..], "gone": [..],
//              "relabelled": [..], "pieces": [..], "queries": [{..}]}], "state_hash": "0123456789abcdef"}
// The queries of "hit" and "hit-again" list the boxes of the tree in the order of the tests: the index of the
// parent, the outcome ("entered", "culled", "missed" or "touched"), the side that culled it ("depth",
// "motion" or "lateral"), and the face of a leaf. Boxes are in the frame of the body. Fails with bad input if
// there are fewer moves, and with cancelled() when stopped.
Result<nlohmann::ordered_json> step_json(OpenedFile file, size_t number, const Progress* progress = nullptr);

}  // namespace kerf
