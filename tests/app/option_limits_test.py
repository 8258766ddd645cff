"""Limits are one: `option_limits_test.py KERF`. The help states the limits of each number; here each is tried at, below and
above them, on the command line, in files, and in the journal that is written."""
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest

KERF = os.path.abspath(sys.argv.pop(1))
PLATE = "v -0.5 0 -0.5\nv 0.5 0 -0.5\nv 0.5 0 0.5\nv -0.5 0 0.5\nf 1 4 3\nf 1 3 2\n"
FAR = {"keys": [{"t": 0, "origin": [0, -9, 0], "direction": [0, -1, 0]}]}  # its beam meets nothing
LEAST, MOST = math.ulp(0.0), sys.float_info.max
# How each command begins whose options are tried; a file that is missing is read after the options.
BEGINNINGS = {"prepare": ["none.obj", "--out", "a.obj", "--subdivide", "loop"], "render": ["none.obj", "--out", "a.png"],
              "replay": ["none.kerf", "--frames", "f"], "inspect": ["none.obj"], "play": ["none.json", "--headless"],
              "figures": ["--out", "f", "--list", "none.json"], "cut": ["none.obj", "--out", "o"]}

# What some options of a cut require.
REQUIRED = {"ground": ["--settle", "1"], "turn": ["--drawing", "none.svg"], "scale": ["--drawing", "none.svg"], "wrap": ["--drawing", "none.svg"],
            "power-at-s1000": ["--gcode", "none.nc"]}


def run(*args, folder=None):
    return subprocess.run([KERF, *map(str, args)], cwd=folder, capture_output=True, text=True, timeout=900)


def options_of(command):
    """The options of a command, as its help has them: their type and the rest of their text."""
    text = run(command, "--help").stdout
    found = re.findall(r"^  (?:-\w,)?--([\w-]+)((?: (?:TEXT|FLOAT|INT|UINT)\S*)?)(.*?)(?=^  \S|^\S|\Z)", text, re.M | re.S)
    return {name: (kind.strip(), " ".join(rest.split())) for name, kind, rest in found}


def limits_of(text):
    """The least and the most number that a help text states."""
    if stated := re.search(r"; from (\S+) to (\S+?)(?: [^;]*)?$", text):
        return float(stated[1]), float(stated[2])
    if text.endswith("; greater than zero"):
        return LEAST, MOST
    if text.endswith("; any number"):
        return -MOST, MOST
    raise AssertionError("no limits: " + text)


def numbers(least, most, whole):
    """Numbers at the limits, and outside of them."""
    if whole:
        return [int(least), int(most)], [int(least) - 1, int(most) + 1, int(least) + 0.5]
    outside = [math.nextafter(least, -math.inf)] if least > -MOST else []
    outside += [math.nextafter(most, math.inf)] if most < MOST else []
    return [least, most], [*outside, "nan", "inf", "-inf", "1e999"]


class OptionLimits(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.write("plate.obj", PLATE)
        self.write("far.json", json.dumps({"strokes": [FAR]}))

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w") as file:
            file.write(text)

    def run_here(self, *args):
        return run(*args, folder=self.folder)

    def test_every_number_is_accepted_at_its_limits_and_rejected_beyond(self):
        tried = set()
        for command, beginning in BEGINNINGS.items():
            for name, (kind, text) in options_of(command).items():
                if not kind.startswith(("FLOAT", "INT", "UINT")):
                    continue
                fitting, outside = numbers(*limits_of(text), kind.startswith(("INT", "UINT")))
                more = REQUIRED.get(name, [])
                for number in fitting:
                    done = self.run_here(command, *beginning, f"--{name}={number!r}", *more)
                    self.assertNotIn("--" + name, done.stderr)
                    self.assertIn("none.", done.stderr)
                for number in outside:
                    done = self.run_here(command, *beginning, f"--{name}={number}", *more)
                    self.assertEqual(done.returncode, 2, (command, name, number, done.stderr))
                    self.assertIn("--" + name, done.stderr)
                tried.add((command, name))
        for one in (("cut", "thickness"), ("cut", "depth"), ("cut", "ground"), ("prepare", "simplify"), ("prepare", "smooth"),
                    ("replay", "fps"), ("render", "spread"), ("inspect", "step"), ("play", "seed"), ("play", "seconds")):
            self.assertIn(one, tried)

    def test_sizes_are_accepted_at_their_limits_and_rejected_beyond(self):
        for command in ("render", "replay", "play", "figures"):
            beginning = BEGINNINGS[command]
            for size in ("0x100", "100x0", "16385x100", "100x16385", "100.5x100", "100", "x"):
                done = self.run_here(command, *beginning, "--size", size)
                if command == "play" or (command == "replay" and "none.kerf" in done.stderr):
                    continue  # read with the window, or with the film
                self.assertEqual((done.returncode, "--size" in done.stderr), (2, True), (command, size, done.stderr))
            done = self.run_here(command, *beginning, "--size", "16384x64")
            self.assertNotIn("--size", done.stderr)

    def test_drivers_are_accepted_with_and_without_a_window(self):
        for driver in ("bot", "still"):
            for more in ([], ["--headless"]):
                done = self.run_here("play", "none.json", "--driver", driver, *more)
                self.assertNotIn("--driver", done.stderr)
                self.assertIn("none.json", done.stderr)

    def test_settings_files_and_journals_accept_what_the_command_line_does(self):
        """And what it refuses is refused by settings files."""
        for name, (kind, text) in options_of("cut").items():
            if not kind.startswith(("FLOAT", "INT")) or name in ("settle", *REQUIRED):
                continue
            fitting, outside = numbers(*limits_of(text), kind.startswith("INT"))
            if name == "steps":
                fitting = fitting[:1]  # a million steps take long
            for number in fitting:
                cut = ["cut", "plate.obj", "--path", "far.json", "--out", "o", "--journal", "j.kerf"]
                done = self.run_here(*cut, f"--{name}={number!r}")
                self.assertEqual(done.returncode, 0, (name, number, done.stderr))
                with open(os.path.join(self.folder, "o", "report.json")) as file:
                    state = json.load(file)["state_hash"]
                done = self.run_here("replay", "j.kerf", "--expect", state)
                self.assertEqual((done.returncode, done.stderr), (0, ""), (name, number))
                self.write("s.json", json.dumps({name: number}))
                done = self.run_here(*cut, "--settings", "s.json")
                self.assertEqual(done.returncode, 0, (name, number, done.stderr))
            for number in outside:
                if isinstance(number, str):
                    continue  # is no JSON
                self.write("s.json", json.dumps({name: number}))
                done = self.run_here("cut", "plate.obj", "--out", "o", "--settings", "s.json")
                self.assertEqual(done.returncode, 2, (name, number, done.stderr))

    def test_a_settings_file_may_have_the_options_that_its_help_names(self):
        options = options_of("cut")
        first, last = re.search(r"options from --([\w-]+) to --([\w-]+);", options["settings"][1]).groups()
        names = list(options)
        keys = names[names.index(first):names.index(last) + 1]
        self.assertGreater(len(keys), 20)
        for name in names:
            self.write("s.json", json.dumps({name: None}))
            done = self.run_here("cut", "plate.obj", "--out", "o", "--settings", "s.json")
            self.assertEqual((done.returncode, "is not a setting" in done.stderr), (2, name not in keys), (name, done.stderr))

    def test_leading_zeros_make_no_number_octal(self):
        done = self.run_here("cut", "plate.obj", "--path", "far.json", "--out", "o", "--depth", "010")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(os.path.join(self.folder, "o", "report.json")) as file:
            self.assertEqual(json.load(file)["settings"]["depth"], 10)
        for command, option in (("cut", "--steps"), ("prepare", "--simplify"), ("inspect", "--step"), ("play", "--seed")):
            done = self.run_here(command, *BEGINNINGS[command], option, "08")
            self.assertNotIn(option, done.stderr)
            self.assertIn("none.", done.stderr)
            done = self.run_here(command, *BEGINNINGS[command], option, "0x8")
            self.assertEqual((done.returncode, option in done.stderr), (2, True), (command, done.stderr))

    def test_whole_numbers_of_settings_files_do_not_overflow(self):
        for number in (-2**63, 2**63, 2**64 - 1, 1e300):
            self.write("s.json", json.dumps({"depth": number}))
            done = self.run_here("cut", "plate.obj", "--out", "o", "--settings", "s.json")
            self.assertEqual((done.returncode, "depth" in done.stderr), (2, True), (number, done.stderr))

    def test_a_range_is_accepted_at_its_limits_and_rejected_beyond(self):
        for text, status in (("0,0", 0), (f"0,{MOST!r}", 0), (f"{MOST!r},{MOST!r}", 0), (f"{-LEAST!r},1", 2), ("1,0.5", 2),
                             ("0,inf", 2), ("nan,1", 2), ("0,1e999", 2)):
            cut = ["cut", "plate.obj", "--path", "far.json", "--out", "o", "--journal", "j.kerf", f"--range={text}"]
            self.assertEqual(self.run_here(*cut).returncode, status, text)
            if status == 0:
                self.assertEqual(self.run_here("replay", "j.kerf").returncode, 0, text)

    def test_scenes_and_paths_have_the_limits_of_the_command_line(self):
        options = options_of("cut")
        for name in ("thickness", "density", "radius", "power"):
            fitting, outside = numbers(*limits_of(options[name][1]), False)
            for number in fitting + outside:
                if isinstance(number, str):
                    continue
                of_stroke = name in ("radius", "power")
                stroke = {**FAR, "laser": {name: number}} if of_stroke else FAR
                body = {"mesh": "plate.obj"} if of_stroke else {"mesh": "plate.obj", name: number}
                self.write("scene.json", json.dumps({"bodies": [body], "strokes": [stroke]}))
                done = self.run_here("cut", "scene.json", "--out", "o")
                self.assertEqual(done.returncode, 0 if number in fitting else 2, (name, number, done.stderr))


if __name__ == "__main__":
    unittest.main()
