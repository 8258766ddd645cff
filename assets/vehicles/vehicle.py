"""A vehicle as its program lays it out, and the two files it is written to."""

import json
from pathlib import Path

from car_sheet import ObjFile
from joints import Joints

PAINTS = {
    "trim": {"colour": "#1c1f24", "gloss": 0.25},
    "underbody": {"colour": "#3a3f46", "gloss": 0.2},
    "tyre": {"colour": "#17181b", "gloss": 0.1},
    "rim": {"colour": "#a9b0b8", "gloss": 0.8},
    "light_front": {"colour": "#e2e8ee", "gloss": 0.9},
    "light_rear": {"colour": "#9c1f26", "gloss": 0.7},
    "indicator": {"colour": "#b8641c", "gloss": 0.7},
    "seat": {"colour": "#3a4049", "gloss": 0.1},
    "interior": {"colour": "#282c32", "gloss": 0.15},
    "chrome": {"colour": "#c4cad1", "gloss": 1.0},
    "axle": {"colour": "#4a4f57", "gloss": 0.4},
    "steel": {"colour": "#767d86", "gloss": 0.7},
    "engine": {"colour": "#5b6168", "gloss": 0.5},
    "engine_cover": {"colour": "#7a2a22", "gloss": 0.6},
    "tank": {"colour": "#8c2a25", "gloss": 0.6},
    "grille": {"colour": "#22262b", "gloss": 0.4},
    "laser": {"colour": "#8b939c", "gloss": 0.7},
    "laser_dark": {"colour": "#2b3037", "gloss": 0.5},
    "lens": {"colour": "#5c0f14", "gloss": 1.0},
}


class Vehicle:
    """Parts in the order they were added, joints between them, and what the game has to know."""

    def __init__(self, name, mass, paints):
        """paints: of this vehicle alone. Its name is put before theirs, as worlds hold several."""
        self.name, self.mass = name, mass
        self._own = {paint: f"{name}_{paint}" for paint in paints}
        self.paints = {**{self._own[paint]: look for paint, look in paints.items()}, **PAINTS}
        self.parts = {}
        self.wheels, self.vital = [], []
        self.tank = {"part": "tank", "mount": "body"}
        self.turret, self.driver_eye = None, None
        self.engine = {}      # force in N, power in W, top_speed in m/s
        self._joints = None

    def add(self, *parts):
        """Adds (name, sheet) pairs. Precondition: no joint was asked for yet."""
        assert self._joints is None
        for name, sheet in parts:
            assert name not in self.parts, name
            self.parts[name] = [(self._own.get(paint, paint), polygon) for paint, polygon in sheet]

    @property
    def joints(self):
        if self._joints is None:
            self._joints = Joints(self.parts)
        return self._joints

    def wheel(self, part, mount, hub, radius, steers, driven, travel):
        self.wheels.append({"part": part, "mount": mount, "hub": list(hub), "radius": radius,
                            "steers": steers, "driven": driven, "suspension": {"travel": travel}})

    def write(self):
        folder = Path(__file__).resolve().parent
        target = folder.parent / "meshes" / f"{self.name}.obj"
        mesh = ObjFile()
        for name, sheet in self.parts.items():
            mesh.add(name, sheet)
        target.write_text(mesh.text(f"Kerf {self.name}, made by make_vehicles.py"), newline="\n")
        (folder / f"{self.name}.json").write_text(self._json(), newline="\n")
        print(f"{target}: {mesh.triangle_count()} triangles, {len(self.joints.all)} joints")

    def _json(self):
        used = {material for sheet in self.parts.values() for material, _ in sheet}
        entries = {
            "name": self.name, "mesh": f"../meshes/{self.name}.obj", "thickness": 0.0008,
            "density": 7850, "mass": self.mass, "wheels": self.wheels, "turret": self.turret,
            "vital": self.vital, "tank": self.tank, "driver_eye": self.driver_eye, "engine": self.engine,
            "joints": self.joints.all,
            "paints": {name: paint for name, paint in self.paints.items() if name in used},
        }
        return "{\n" + ",\n".join(f"  {json.dumps(key)}: {_lines(value)}"
                                  for key, value in entries.items()) + "\n}\n"


def _lines(value):
    """JSON with one line for each entry of a list of objects or of an object of objects."""
    if isinstance(value, list) and value and isinstance(value[0], dict):
        return "[\n" + ",\n".join("    " + json.dumps(entry) for entry in value) + "\n  ]"
    if isinstance(value, dict) and all(isinstance(entry, dict) for entry in value.values()):
        return "{\n" + ",\n".join(f"    {json.dumps(key)}: {json.dumps(entry)}"
                                  for key, entry in value.items()) + "\n  }"
    return json.dumps(value)
