#pragma once

#include "core/game/arena/sight.h"
#include "core/game/vehicle/vehicle.h"

namespace kerf {

// Lets the wheels of a vehicle act on its chassis for a tick: suspension, steering, drive, brakes, rolling
// resistance and the grip of the tyres, as its controls say. A vehicle that is dead rolls on with light
// brakes until it falls asleep. Changes the motion of the chassis and of what it stands on, and the state of
// the wheels; `sight` shows the world as it is.
//
// Where a wheel is gone, what is left of its suspension drags over the ground, lower and without drive.
//
// Each wheel is one ray against the ground and the bodies that can carry it: neither the vehicle itself, nor
// what came off it, nor loose bodies that are light (see kLightBody). A spring with a damper acts along the
// normal of what it meets; the tyre takes away the velocity across the wheel and, as far as the brakes do,
// along it, by impulses within a friction circle that follow each other over all wheels (projected
// Gauss-Seidel, as for contacts). A loose body under a wheel gets the opposite impulses. Impulses across the
// wheel act nearer to the height of the centre of mass than the ground, so that a vehicle leans less than it
// would.
void drive(World& world, Vehicle& vehicle, const Sight& sight);

// Steering angle of the front wheels at full lock at a speed in m/s; rad.
double full_lock(double speed);

}  // namespace kerf
