"""Bodies in time: play, pause and single ticks, pins, a spring that pulls a piece, and work that a crash leaves."""
import json
import os
import subprocess
import tempfile
import unittest

from editor_window import KERF, SPHERE, WindowTest, real_input

IN_TWO = [(0.2, 0.37), (0.8, 0.37)]


class Bodies(WindowTest):
    def cut_sphere(self):
        editor = self.open(SPHERE)
        editor.drag(IN_TWO)
        editor.point_at(0.9, 0.9)
        return editor

    def play(self, editor):
        """From here on the editor is never at rest."""
        editor.press("space")
        editor.wait_for(lambda: "play badge" in editor.landmarks()["parts"], "time does not pass")

    def stop(self, editor):
        editor.press("space")
        editor.settle()

    def test_the_ground_set_by_the_first_play_has_no_history_row(self):
        self.open(SPHERE).quit()
        self.only_panel("history")
        editor = self.open_again(SPHERE)
        self.play(editor)
        editor.pause(0.2)
        self.stop(editor)
        parts = editor.landmarks()["parts"]
        self.assertEqual([row for row in range(4) if f"history row {row}" in parts], [0, 2])
        editor.do("ctrl", "z")
        report = editor.quit()
        self.assertEqual(report["undo_depth"], 0)
        self.assertIsNone(report["time"]["ground"])

    @real_input
    def test_pieces_fall_during_play_and_stop_when_paused(self):
        editor = self.cut_sphere()
        self.play(editor)
        editor.pause(2)
        self.stop(editor)
        report = editor.quit()
        self.assertFalse(report["time"]["playing"])
        self.assertGreater(report["time"]["ticks"], 0)
        self.assertIsNotNone(report["time"]["ground"])
        self.assertEqual(report["bodies"], report["pieces"])
        self.assertGreater(report["bodies"], 1)
        self.assertLess(min(body["position"][1] for body in report["placements"]), 0)

    def test_one_undo_reverts_the_first_play_and_its_ground(self):
        editor = self.cut_sphere()
        self.play(editor)
        editor.pause(1)
        self.stop(editor)
        editor.do("ctrl", "z")
        report = editor.quit()
        self.assertEqual(report["undo_depth"], 1)
        self.assertIsNone(report["time"]["ground"])

    def test_each_tick_is_undone_individually_and_undo_pauses(self):
        editor = self.cut_sphere()
        for _ in range(3):
            editor.do("period")
        editor.do("ctrl", "z")
        editor.press("minus")
        self.play(editor)
        editor.pause(1)
        editor.do("ctrl", "z")
        report = editor.quit()
        self.assertEqual(report["time"], {**report["time"], "ticks": 2, "playing": False, "speed": 0.5})

    def test_esc_removes_a_copy_that_was_made_while_time_runs(self):
        editor = self.open(SPHERE)
        editor.press("k")
        editor.click(0.5, 0.53)
        self.play(editor)
        editor.press("shift", "d")
        editor.pause(1)
        editor.press("Escape")
        editor.settle()  # undo pauses
        self.assertEqual(editor.quit()["bodies"], 1)

    def test_a_pinned_piece_stays_while_others_fall(self):
        editor = self.cut_sphere()
        editor.press("k")
        editor.click(0.5, 0.6)
        editor.do("shift", "p")
        self.play(editor)
        editor.pause(1.5)
        self.stop(editor)
        placements = editor.quit()["placements"]
        self.assertEqual([body["position"] for body in placements if body["pinned"]], [[0, 0, 0]])
        self.assertTrue(any(body["position"] != [0, 0, 0] for body in placements))

    def test_the_panel_sets_gravity_and_the_ground_height(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.only_panel("bodies")
        editor = self.open_again(SPHERE)
        editor.click("gravity on", 0.5, 0.5)
        editor.click("gravity on", 0.5, 0.5)
        for name, value in (("Acceleration", "1.62"), ("Ground", "-20")):
            editor.click(name, 0.3, 0.5)
            editor.press("ctrl", "a")
            editor.type(value)
            editor.do("Return")
        report = editor.quit()
        self.assertEqual(report["time"]["gravity"], [0, -1.62, 0])
        self.assertAlmostEqual(report["time"]["ground"], -0.02)
        self.assertEqual(report["undo_depth"], 4)

    def test_gravity_keeps_its_value_when_the_ground_moves_in_another_unit(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.only_panel("bodies")
        editor = self.open_again(SPHERE)
        editor.click("gravity on", 0.5, 0.5)
        editor.click("gravity on", 0.5, 0.5)
        editor.press("ctrl", "p")
        editor.part("palette")
        editor.type("Unit mm")
        editor.press("Return")
        editor.settle()
        editor.click("Ground", 0.3, 0.5)
        editor.press("ctrl", "a")
        editor.type("-20")
        editor.do("Return")
        report = editor.quit()
        self.assertEqual(report["view"]["frame"]["unit"], "mm")
        self.assertAlmostEqual(report["time"]["gravity"][1], -9810)

    def test_a_drag_pulls_a_body_up_by_a_spring_during_play(self):
        editor = self.open(SPHERE)
        editor.press("k")
        editor.point_at(0.5, 0.5)
        self.play(editor)
        editor.hold(1)
        for i in range(10):
            editor.move_to(*editor.place((0.5, 0.5 - 0.03 * i)))
            editor.pause(0.1)
        editor.pause(3)
        editor.press("space")
        editor.release(1)
        editor.settle()
        report = editor.quit()
        self.assertGreater(report["placements"][0]["position"][1], 0.04)
        self.assertEqual(report["pieces_chosen"], 0)

    def test_a_crash_during_play_loses_at_most_the_last_second(self):
        editor = self.cut_sphere()
        self.play(editor)

        def kept():
            with open(self.unsaved()[0]) as file:
                return [json.loads(line) for line in file if line.endswith("\n")]

        def ticks():
            return sum(line.get("ticks", 0) for line in kept())

        editor.wait_for(lambda: ticks() >= 120, "no second of the run is kept")
        editor.die()
        replay = subprocess.run([KERF, "replay", self.unsaved()[0]], capture_output=True, text=True)
        editor = self.open_again()
        editor.press("Return")
        editor.wait_for(lambda: "play badge" in editor.landmarks()["parts"], "the work is not recovered")
        report = editor.quit()
        self.assertEqual(report["time"]["ticks"] % 120, 0)
        self.assertGreater(report["time"]["ticks"], 0)
        self.assertEqual(report["state_hash"], replay.stdout.split()[-1])

    def test_the_journal_stores_body_poses_when_play_stops(self):
        editor = self.cut_sphere()
        self.play(editor)
        editor.pause(1)
        self.stop(editor)

        def marks():
            with open(self.unsaved()[0]) as file:
                return [line for line in map(json.loads, file) if "bodies" in line and "hash" in line]

        editor.wait_for(marks, "the journal has no mark")
        self.assertGreater(marks()[-1]["clock"], 0)
        self.assertEqual(marks()[-1]["hash"], editor.quit()["state_hash"])

    def test_half_a_minute_of_a_journal_is_skipped_with_the_same_result(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path, journal = (os.path.join(folder.name, name) for name in ("path.json", "fall.kerf"))
        keys = [{"t": t, "origin": [x, 0.01, 1], "direction": [0, 0, -1]} for t, x in ((0, -0.2), (1, 0.2))]
        with open(path, "w") as file:
            json.dump({"strokes": [{"laser": {"radius": 0.002, "range": [0, 5]}, "keys": keys}]}, file)
        subprocess.run([KERF, "cut", SPHERE, "--path", path, "--out", os.path.join(folder.name, "out"), "--settle",
                        "30", "--journal", journal], check=True, capture_output=True)
        replay = subprocess.run([KERF, "replay", journal], capture_output=True, text=True, check=True)
        editor = self.open(journal)
        editor.point_at(0.9, 0.9)
        report = editor.quit()
        self.assertEqual(report["time"]["ticks"], 3600)
        self.assertEqual(report["state_hash"], replay.stdout.split()[-1])


if __name__ == "__main__":
    unittest.main()
