#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/document/files/path_file.h"

namespace kerf {

// Edits of the strokes of a path by hand. A stroke has one time for each key.

// The length of the way of the beam's origin (m), and the time that it takes (s).
double way_of(const StrokePath& stroke);
double duration_of(const StrokePath& stroke);

// Sets the times so that the origin moves at a constant speed (m/s, > 0) from time 0 on. Where it stays in
// its place and the beam only turns, the next key comes a tick later.
void retime(StrokePath& stroke, double speed);

// Inserts a key before number `at`, or at the end. It comes halfway between its neighbours in time; at an end
// of the stroke it keeps up the mean speed of the stroke. Precondition: at <= keys, the direction is a unit
// vector.
void insert_key(StrokePath& stroke, size_t at, const Pose& pose);
// Removes a key with its time. Precondition: at < keys.
void erase_key(StrokePath& stroke, size_t at);

// The sentence why a path file with these strokes would be refused, or nothing.
std::optional<std::string> why_no_cut(std::span<const StrokePath> strokes);

}  // namespace kerf
