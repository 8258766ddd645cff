"""Writes car.obj beside this script: a small hatchback of thin sheets.

    python3 assets/meshes/make_car.py

Metres, +Y up, +Z forward, the tyres on y = 0, counter-clockwise faces outwards. About five
thousand triangles; every part is a sheet without thickness and the windows are open. The output
is the same, byte for byte, on each run. Needs nothing but Python's standard library.
"""

from pathlib import Path

from car_body import body
from car_cabin import fittings, seats
from car_sheet import ObjFile
from car_wheels import axles, wheels


def main():
    car = ObjFile()
    car.add("body", body())
    for parts in (wheels(), axles(), seats(), fittings()):
        for name, sheet in parts:
            car.add(name, sheet)
    target = Path(__file__).resolve().parent / "car.obj"
    target.write_text(car.text("Kerf car, made by make_car.py"), newline="\n")
    print(f"{target}: {car.triangle_count()} triangles")


if __name__ == "__main__":
    main()
