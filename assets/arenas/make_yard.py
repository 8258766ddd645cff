"""Writes the arena `yard`: yard.json beside this script and its meshes to ../meshes.

    python3 assets/arenas/make_yard.py

An industrial yard of 80 by 80 metres at night: a bridge to drive over and under, ramps, two rows
of columns, containers, pylons with boards, and a circuit around them. What is concrete, grey and matt stands fast;
what is painted sheet can be cut. The output is the same, byte for byte, on each run. Needs nothing
but Python's standard library.
"""

import json
import math
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path += [str(HERE.parent / "meshes"), str(HERE.parent / "vehicles")]

from car_sheet import ObjFile  # noqa: E402
from joints import Joints  # noqa: E402
from yard_props import barrier, container, drum, pylon, sign  # noqa: E402
from yard_structures import lamps, structures  # noqa: E402

THICKNESS = {"drum": 0.001, "barrier": 0.001, "sign": 0.0015, "pylon": 0.002, "container": 0.0016}
PROPS = {"drum": drum, "barrier": barrier, "sign": sign, "pylon": pylon, "container": container}
# (x, y, z, degrees from +z towards +x)
PLACES = {
    "container": [(-21, 0, 24, 25), (-14.5, 0, 27.5, -60), (20, 0, 26, 85), (23, 0, -24, -20),
                  (-24, 0, -22, 50), (-20.4, 2.59, 24.4, 32)],
    "drum": [(-30.4, 0, 2, 15), (-17.5, 0, 22, 0), (-16.7, 0, 21.8, 40), (18, 0, 22.5, 0),
             (18.8, 0, 22.2, 30), (24, 0, -18.5, 0), (24.8, 0, -18.9, 60), (23.5, 0, -19.3, 20),
             (-21, 0, -17.8, 0), (-20.2, 0, -18.3, 50), (0.4, 0, 12, 0), (-0.4, 0, 11.6, 25),
             (0.3, 0, -12, 0), (-0.5, 0, -11.7, 70)],
    "barrier": [(-6, 0, 26, 90), (-6, 0, 28.3, 90), (6, 0, 31, 80), (6.2, 0, 33.3, 95),
                (12, 0, -26, 90), (12, 0, -31, 90), (-12, 0, -25, 100), (-12, 0, -30, 85),
                (33, 0, 14, 0), (30.6, 0, 14.4, 10), (-30, 0, -14, 0), (-32.4, 0, -14.3, -8)],
    "pylon": [(-35.6, 0, -8, 0), (35.6, 0, 8, 180)],
    "sign": [(36.8, 0, 36.8, 225), (-36.8, 0, 36.8, 135), (36.8, 0, -36.8, 315),
             (-36.8, 0, -36.8, 45), (28.2, 0, 0, 270), (-28.2, 0, 0, 90)],
}
PAINTS = {
    "concrete": {"colour": "#6d7073", "gloss": 0.05},
    "concrete_dark": {"colour": "#505356", "gloss": 0.05},
    "asphalt": {"colour": "#3a3c3f", "gloss": 0.1},
    "band": {"colour": "#8a8371", "gloss": 0.05},
    "band_edge": {"colour": "#8f9091", "gloss": 0.05},
    "band_red": {"colour": "#5e4341", "gloss": 0.05},
    "gate": {"colour": "#45494e", "gloss": 0.1},
    "marking": {"colour": "#8c8d88", "gloss": 0.05},
    "mast": {"colour": "#4c5055", "gloss": 0.1},
    "floodlight": {"colour": "#fff6e0", "gloss": 0.0},
    "hall": {"colour": "#34373b", "gloss": 0.05},
    "hall_light": {"colour": "#474b50", "gloss": 0.05},
    "window_dark": {"colour": "#20252b", "gloss": 0.3},
    "window_lit": {"colour": "#c9a869", "gloss": 0.0},
    "drum": {"colour": "#1f6fb0", "gloss": 0.75},
    "drum_stripe": {"colour": "#e4e7ea", "gloss": 0.75},
    "sheet_red": {"colour": "#c0282b", "gloss": 0.75},
    "sheet_white": {"colour": "#e6e8ea", "gloss": 0.75},
    "sheet_yellow": {"colour": "#e0b21c", "gloss": 0.75},
    "sheet_steel": {"colour": "#9aa3ad", "gloss": 0.8},
    "sign_dark": {"colour": "#16181b", "gloss": 0.6},
    "container": {"colour": "#b4552a", "gloss": 0.6},
    "container_frame": {"colour": "#8e401f", "gloss": 0.6},
}
ENEMIES = [(33, 22, 180), (22, 34, 270), (34, -24, 0), (-20, 34, 90), (18, -35, 270), (-33, 25, 180),
           (-18, 6, 180), (-10.5, -19.5, 270), (10, 22, 180), (22, -8, 270), (0.5, 35.5, 270), (34, 0, 180),
           (-5, -8.5, 270), (6, -8.5, 90)]
STARTS = {"player": {"position": [-33.0, 0.0, -22.0], "heading": 0},
          "enemies": [{"position": [float(x), 0.0, float(z)], "heading": h} for x, z, h in ENEMIES]}


def write_mesh(name, parts):
    mesh = ObjFile()
    for part, sheet in parts.items():
        mesh.add(part, sheet)
    target = HERE.parent / "meshes" / f"{name}.obj"
    target.write_text(mesh.text(f"Kerf {name}, made by make_yard.py"), newline="\n")
    print(f"{target}: {mesh.triangle_count()} triangles")


def joints_of(parts):
    """Everything hangs on the first part, over others where these are nearer."""
    joints = Joints(parts)
    joints.hold_all(next(iter(parts)), 0.15)
    return joints.all


def turn(degrees):
    half = math.radians(degrees) / 2
    return [round(math.cos(half), 12), 0, round(math.sin(half), 12), 0]


def bodies():
    write_mesh("yard", dict(structures()))
    found = [{"mesh": "../meshes/yard.obj", "name": "yard", "cuttable": False}]
    for name, make in PROPS.items():
        parts = dict(make())
        write_mesh(name, parts)
        joints = joints_of(parts)
        for i, (x, y, z, degrees) in enumerate(PLACES[name]):
            found.append({"mesh": f"../meshes/{name}.obj", "name": f"{name}_{i + 1}",
                          "position": [x, y, z], "orientation": turn(degrees), "cuttable": True,
                          "thickness": THICKNESS[name], "density": 7850, "joints": joints})
    return found


def rows(entries):
    return "[\n" + ",\n".join("    " + json.dumps(entry) for entry in entries) + "\n  ]"


def main():
    light = {"colour": "#ffe9c4", "intensity": 0.03}
    entries = {
        "name": json.dumps("yard"), "ground": "0", "size": "[80, 80]", "bodies": rows(bodies()),
        "lamps": rows([{"position": list(p), **light} for p in lamps()]),
        "starts": json.dumps(STARTS),
        "paints": "{\n" + ",\n".join(f"    {json.dumps(name)}: {json.dumps(paint)}"
                                     for name, paint in PAINTS.items()) + "\n  }",
    }
    text = "{\n" + ",\n".join(f"  {json.dumps(k)}: {v}" for k, v in entries.items()) + "\n}\n"
    (HERE / "yard.json").write_text(text, newline="\n")


if __name__ == "__main__":
    main()
