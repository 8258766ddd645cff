#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/game/vehicle/vehicle_description.h"

namespace kerf {

// Reads a vehicle file:
//
//   {"name": "hatchback", "mesh": "../meshes/hatchback.obj", "thickness": 0.0008, "density": 7850,
//    "mass": 1000,
//    "wheels": [{"part": "wheel_front_left", "mount": "axle_front", "hub": [..], "radius": 0.31,
//                "steers": true, "driven": false, "suspension": {"travel": 0.25}}],
//    "turret": {"part": "turret", "mount": "body", "pivot": [..], "yaw": [-180, 180],
//               "barrel": {"part": "barrel", "pivot": [..], "muzzle": [..], "pitch": [-15, 35]}},
//    "vital": [{"kind": "engine", "part": "engine", "mount": "body"}],
//    "driver_eye": [..], "engine": {"force": 7000, "power": 120000, "top_speed": 24},
//    "joints": as in scenes, "paints": as in scenes}
//
// Required are "mesh", "wheels" and "turret", and of these the parts, mounts, hubs, radii, pivots and the
// muzzle. Bad input otherwise: the message names the file and the JSON pointer of the first wrong value. The
// mesh is not read.
Result<VehicleDescription> read_vehicle(const std::filesystem::path& file);

}  // namespace kerf
