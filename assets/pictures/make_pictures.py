"""Makes the pictures of the pages beside this script, but for those of figures: `make_pictures.py KERF`.

The picture of the editor needs a display. Needs nothing but Python's standard library.
"""

import json
import os
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

PICTURES = Path(__file__).resolve().parent
ASSETS = PICTURES.parent
SIZES = {"car-apart": (1600, 900), "glow": (1280, 640), "yard": (1400, 700)}
TILE, GAP, DARK = (640, 400), 12, bytes((20, 23, 27))
BENT = {"strokes": [{"laser": {"radius": 0.03, "range": [0, 4]}, "keys": [
    {"t": 0, "origin": [-0.35, 0.45, 2], "direction": [0, 0, -1]},
    {"t": 1, "origin": [0.1, 0.53, 2], "direction": [0, 0, -1]},
    {"t": 2, "origin": [0.27, 0.37, 2], "direction": [0, 0, -1]}]}]}
# Cuts the car from roof to sill and shows the boxes of the tree that the beam has hit.
EDITOR = [{"draws": False}, {"frame": 0.25}, {"settle": 60}, {"key_down": "Esc"}, {"key_up": "Esc"}, {"settle": 60},
          {"move": [560, 290]}, {"press": "left"}, {"move": [600, 380]}, {"move": [640, 470]}, {"move": [690, 590]},
          {"release": "left"}, {"settle": 120}, {"move": [300, 700]}, {"key_down": "B"}, {"key_up": "B"},
          {"settle": 60}, {"draws": True}, {"settle": 10}]


def kerf(*words):
    subprocess.run([KERF, *map(str, words)], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def make_scene(name, scene):
    kerf("render", ASSETS / "scenes" / scene, "--size", "{}x{}".format(*SIZES[name]), "--out",
         PICTURES / (name + ".png"))


def make_rims(folder):
    """The same stroke four ways, with the edges of the faces."""
    (folder / "path.json").write_text(json.dumps(BENT))
    tiles = []
    for scheme in ("one-to-four", "longest-edge"):
        for rim in ("faces", "smooth"):
            kerf("cut", ASSETS / "meshes" / "sheet.obj", "--path", folder / "path.json", "--out", folder / "out",
                 "--scheme", scheme, "--rim", rim, "--target-edge", 0.015, "--journal", folder / "cut.kerf")
            kerf("render", folder / "cut.kerf", "--show", "wire", "--eye", "-0.04,0.45,0.85", "--target", "-0.04,0.45,0",
                 "--size", "{}x{}".format(*TILE), "--out", folder / "tile.png")
            tiles.append(read_png(folder / "tile.png"))
    side, width = DARK * GAP, TILE[0]
    middle = [side + left + side + right + side
              for pair in (tiles[:2], tiles[2:]) for left, right in zip(*pair)]
    bar = [DARK * (2 * width + 3 * GAP)] * GAP
    write_png(PICTURES / "four-rims.png", bar + middle[:TILE[1]] + bar + middle[TILE[1]:] + bar)


def make_editor(folder):
    steps = EDITOR + [{"picture": str(PICTURES / "editor.png")}, {"answer": "title"}]
    environment = dict(os.environ, XDG_CONFIG_HOME=str(folder), XDG_STATE_HOME=str(folder))
    subprocess.run([KERF, "--size", "1440x900", "--events", "-"], env=environment, text=True, check=True,
                   input="".join(json.dumps(step) + "\n" for step in steps), stdout=subprocess.DEVNULL)


def read_png(file):
    """The rows of a picture of red, green and blue, eight bits each."""
    content, at, data = file.read_bytes(), 8, b""
    while at < len(content):
        length, kind = struct.unpack(">I4s", content[at:at + 8])
        body = content[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height = struct.unpack(">II", body[:8])
        elif kind == b"IDAT":
            data += body
        at += length + 12
    data, stride, rows = zlib.decompress(data), 1 + 3 * width, [bytes(3 * width)]
    for y in range(height):
        rows.append(unfiltered(data[y * stride], bytearray(data[y * stride + 1:(y + 1) * stride]), rows[-1]))
    return rows[1:]


def unfiltered(kind, row, above):
    """The row as it was before it was filtered (PNG specification, third edition, 9.2)."""
    for i, up in enumerate(above):
        left, corner = (row[i - 3], above[i - 3]) if i >= 3 else (0, 0)
        near = min((left, up, corner), key=lambda x: abs(left + up - corner - x))
        row[i] = (row[i] + (0, left, up, (left + up) // 2, near)[kind]) & 255
    return bytes(row)


def write_png(file, rows):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    head = struct.pack(">IIBBBBB", len(rows[0]) // 3, len(rows), 8, 2, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + row for row in rows), 9)
    file.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", data) + chunk(b"IEND", b""))


if __name__ == "__main__":
    KERF = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as name:
        for picture, scene in (("car-apart", "car-apart.json"), ("glow", "glow.kerf"), ("yard", "yard.json")):
            make_scene(picture, scene)
        make_rims(Path(name))
        make_editor(Path(name))
