"""Makes the pictures of the pages beside this script, but for those of figures: `make_pictures.py KERF`.

The picture of the editor needs a display. Needs nothing but Python's standard library.
"""

import json
import os
import shutil
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


# Runs a program in Python or the cells of a notebook, and saves its world, or the pieces in its answer, as a scene.
SAVE_SCENE = """
import base64, io, json, sys, contextlib
import kerf
scene, program, sys.argv = sys.argv[1], sys.argv[2], sys.argv[2:]
text, scope, said = open(program).read(), {}, io.StringIO()
if program.endswith('.ipynb'):
    text = '\\n'.join(''.join(cell['source']) for cell in json.loads(text)['cells'] if cell['cell_type'] == 'code')
with contextlib.redirect_stdout(said):
    exec(compile(text, program, 'exec'), scope)
world = scope.get('world')
if world is None:
    world = kerf.World()
    for piece in json.loads(said.getvalue())['pieces']:
        world.add(kerf.Mesh.decode(base64.b64decode(piece['mesh'])))
world.save_scene(scene)
"""


def make_examples(folder):
    """The result of each example, `examples/NAME.png`; its programs are built against an installation."""
    root, prefix = ASSETS.parent, folder / "prefix"
    examples, build, sphere = root / "app" / "examples", folder / "build", ASSETS / "meshes" / "sphere.obj"

    def run(*words, **options):
        subprocess.run([*map(str, words)], check=True, stdout=subprocess.DEVNULL, **options)
    run("cmake", "--install", Path(KERF).parent, "--prefix", prefix)
    run("cmake", "-S", examples, "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", build)
    site = dict(os.environ, PYTHONPATH=str(prefix / "lib/python3/dist-packages"))
    plate = {"vertices": [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]], "faces": [[0, 2, 1], [0, 3, 2]], "rim": "smooth",
             "strokes": [{"keys": [[t, [0.1 * t, 1, 0.2 + 0.6 * (t % 2)], [0, -1, 0]] for t in range(11)], "radius": 0.02}]}
    for name, words in (("cut_in_five_lines.py", [sphere]), ("drill_holes.py", []), ("tune_resolution.py", [sphere]),
                        ("rays_against_brute_force.py", [sphere]), ("tune_resolution.ipynb", []), ("cut_server.py", [])):
        run("/usr/bin/python3", "-c", SAVE_SCENE, folder / name, examples / name, *words, env=site, text=True,
            input=json.dumps(plate))
    for name, words in (("outside", [sphere]), ("outside_c", []), ("engine_extension", []), ("live_cut", [60])):
        run(build / name, *words, folder / (name + ".scene"))
    run("xvfb-run", "-a", build / "live_window", 110, folder / "live_window.scene")
    (folder / "meshes").mkdir()
    shutil.copy(ASSETS / "meshes" / "knot.obj", folder / "meshes")
    run("bash", examples / "cut_folder.sh", KERF, folder / "meshes", folder / "cut")
    (folder / "cut_folder.sh").mkdir()
    bodies = [{"mesh": str(piece)} for piece in sorted((folder / "cut" / "knot.obj").glob("*.obj"))]
    (folder / "cut_folder.sh" / "scene.json").write_text(json.dumps({"bodies": bodies}))
    (PICTURES / "examples").mkdir(exist_ok=True)
    for scene in folder.glob("*/scene.json"):
        name = scene.parent.name.removesuffix(".scene").replace(".ipynb", "_notebook").split(".")[0]
        kerf("render", scene, "--show", "pieces,wire", "--size", "480x300", "--out", PICTURES / "examples" / (name + ".png"))


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
        make_examples(Path(name))
