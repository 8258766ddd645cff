"""Writes the arenas `yard` and `depot`: a file for each beside this script, and the meshes to ../meshes.

    python3 assets/arenas/make_arenas.py

The yard is an industrial site of 80 by 80 metres at night: a bridge to drive over and under, ramps, two rows of
columns, containers, and a circuit around them. The depot is a narrow court of 36 by 84 metres between two galleries,
which four ramps reach and a bridge connects. Grey, matt concrete is fixed; painted sheet can be cut. Lamp posts, gantries
and stacks stand on plinths of concrete, which keep vehicles away from them until they are cut. The output is the same,
byte for byte, on each run. Needs only Python's standard library.
"""

import json
import math
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path += [str(HERE.parent / "meshes"), str(HERE.parent / "vehicles")]

import depot_structures as depot  # noqa: E402
import yard_structures as yard  # noqa: E402
from car_sheet import ObjFile  # noqa: E402
from joints import Joints  # noqa: E402
from yard_props import (barrier, container, drum, gantry, lamp_post, pylon, sign,  # noqa: E402
                        stack)

THICKNESS = {"drum": 0.001, "barrier": 0.001, "sign": 0.0015, "pylon": 0.002, "container": 0.0016,
             "lamp_post": 0.004, "gantry": 0.006, "stack": 0.004}
PROPS = {"drum": drum, "barrier": barrier, "sign": sign, "pylon": pylon, "container": container,
         "lamp_post": lamp_post, "gantry": gantry, "stack": stack}
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
    "post": {"colour": "#3f6b4f", "gloss": 0.6},
    "post_lamp": {"colour": "#fff0c8", "gloss": 0.6},
    "gantry_steel": {"colour": "#c99a1a", "gloss": 0.6},
    "gantry_black": {"colour": "#1d1f22", "gloss": 0.6},
    "stack": {"colour": "#8f9aa5", "gloss": 0.7},
    "stack_band": {"colour": "#b8302c", "gloss": 0.7},
}

def write_mesh(name, parts):
    mesh = ObjFile()
    for part, sheet in parts.items():
        mesh.add(part, sheet)
    target = HERE.parent / "meshes" / f"{name}.obj"
    target.write_text(mesh.text(f"Kerf {name}, made by make_arenas.py"), newline="\n")
    print(f"{target}: {mesh.triangle_count()} triangles")


def joints_of(parts):
    """Everything hangs on the first part, over others where these are nearer."""
    joints = Joints(parts)
    joints.hold_all(next(iter(parts)), 0.15)
    return joints.all


def turn(degrees):
    half = math.radians(degrees) / 2
    return [round(math.cos(half), 12), 0, round(math.sin(half), 12), 0]


def write_props():
    """The joints of each prop, by its name."""
    joints = {}
    for name, make in PROPS.items():
        parts = dict(make())
        write_mesh(name, parts)
        joints[name] = joints_of(parts)
    return joints


def bodies(arena, places, joints):
    found = [{"mesh": f"../meshes/{arena}.obj", "name": arena, "cuttable": False}]
    for name in PROPS:
        for i, (x, y, z, degrees) in enumerate(places.get(name, ())):
            found.append({"mesh": f"../meshes/{name}.obj", "name": f"{name}_{i + 1}",
                          "position": [x, y, z], "orientation": turn(degrees), "cuttable": True,
                          "thickness": THICKNESS[name], "density": 7850, "joints": joints[name]})
    return found


def starts(player, enemies):
    return {"player": {"position": [float(a) for a in player], "heading": 0},
            "enemies": [{"position": [float(x), 0.0, float(z)], "heading": h}
                        for x, z, h in enemies]}


def rows(entries):
    return "[\n" + ",\n".join("    " + json.dumps(entry) for entry in entries) + "\n  ]"


def write_arena(name, content, joints):
    write_mesh(name, dict(content.structures()))
    light = {"colour": "#ffe9c4", "intensity": content.INTENSITY}
    entries = {
        "name": json.dumps(name), "ground": "0", "size": json.dumps(content.SIZE),
        "bodies": rows(bodies(name, content.PLACES, joints)),
        "lamps": rows([{"position": list(p), **light} for p in content.lamps()]),
        "starts": json.dumps(starts(content.PLAYER, content.ENEMIES)),
        "paints": "{\n" + ",\n".join(f"    {json.dumps(name)}: {json.dumps(paint)}"
                                     for name, paint in PAINTS.items()) + "\n  }",
    }
    text = "{\n" + ",\n".join(f"  {json.dumps(k)}: {v}" for k, v in entries.items()) + "\n}\n"
    (HERE / f"{name}.json").write_text(text, newline="\n")


def main():
    joints = write_props()
    write_arena("yard", yard, joints)
    write_arena("depot", depot, joints)


if __name__ == "__main__":
    main()
