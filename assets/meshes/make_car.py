"""Writes car.obj beside this script, a small hatchback of thin sheets, and rally_car.obj, the same in a
paint with a number, stripes and rust (car_paint.py).

    python3 assets/meshes/make_car.py

Metres, +Y up, +Z forward, the tyres on y = 0, counter-clockwise faces outwards. About five
thousand triangles; every part is a sheet without thickness and the windows are open. The output
is the same, byte for byte, on each run. Needs nothing but Python's standard library.
"""

from pathlib import Path

from car_body import body
from car_cabin import fittings, seats
from car_paint import image, png, uv
from car_sheet import ObjFile
from car_wheels import axles, wheels


MATERIALS = """# Kerf rally car, made by make_car.py
newmtl paint
Kd 1 1 1
Ns 640
map_Kd rally_car.png
newmtl trim
Kd 0.11 0.12 0.14
newmtl light_front
Kd 0.89 0.91 0.93
newmtl light_rear
Kd 0.49 0.11 0.14
newmtl tyre
Kd 0.09 0.09 0.11
newmtl rim
Kd 0.66 0.69 0.72
newmtl chrome
Kd 0.77 0.79 0.82
newmtl axle
Kd 0.29 0.31 0.34
newmtl seat
Kd 0.23 0.25 0.29
newmtl interior
Kd 0.16 0.17 0.20
"""


def main():
    car = ObjFile()
    car.add("body", body())
    for parts in (wheels(), axles(), seats(), fittings()):
        for name, sheet in parts:
            car.add(name, sheet)
    folder = Path(__file__).resolve().parent
    (folder / "car.obj").write_text(car.text("Kerf car, made by make_car.py"), newline="\n")
    painted = car.text("Kerf rally car, made by make_car.py", "rally_car.mtl", uv)
    (folder / "rally_car.obj").write_text(painted, newline="\n")
    (folder / "rally_car.mtl").write_text(MATERIALS, newline="\n")
    (folder / "rally_car.png").write_bytes(png(image()))
    print(f"{folder}: {car.triangle_count()} triangles")


if __name__ == "__main__":
    main()
