"""Writes the vehicles of the game: their files beside this script and their meshes to ../meshes.

    python3 assets/vehicles/make_vehicles.py [NAME...]

Metres, +Y up, +Z forward, the tyres on y = 0, counter-clockwise faces outwards. Every part is a
sheet without thickness; the joints are found from the meshes. The output is the same, byte for
byte, on each run. Needs nothing but Python's standard library.
"""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent.parent / "meshes"))

from buggy import buggy  # noqa: E402
from hatchback import hatchback  # noqa: E402
from pickup import pickup  # noqa: E402
from van import van  # noqa: E402

VEHICLES = {"hatchback": hatchback, "pickup": pickup, "van": van, "buggy": buggy}


def main():
    for name in sys.argv[1:] or VEHICLES:
        VEHICLES[name]().write()


if __name__ == "__main__":
    main()
