"""What is hot cools down, is undone with its stroke, and can be held."""
import unittest

from editor_window import ACROSS, SPHERE, WindowTest


class Heat(WindowTest):
    heat_held = False

    def cut(self, seconds=1):
        """Cuts the sphere and waits a while, but not until all is cold."""
        editor = self.open(SPHERE)
        begin, end = editor.place(ACROSS[0]), editor.place(ACROSS[1])
        editor.move_to(*begin)
        editor.settle()
        editor.hold(1)
        for share in (0.25, 0.5, 0.75, 1):
            editor.move_to(*(round(a + share * (b - a)) for a, b in zip(begin, end)))
            editor.pause(0.1)
        editor.release(1)
        editor.pause(seconds)
        return editor

    def choose_thermal_model(self, editor):
        editor.click("laser model", 0.5, 0.5)
        editor.click("laser model 1", 0.5, 0.5)

    def test_a_rim_cools_within_the_undo_entry_of_its_stroke(self):
        report = self.cut(seconds=3).quit()
        self.assertGreater(report["time"]["ticks"], 30)
        self.assertLess(report["heat"]["hottest"], 1700)
        self.assertGreater(report["heat"]["emitted"], 0)
        self.assertEqual((report["undo_depth"], report["time"]["playing"]), (1, False))

    def test_one_undo_reverts_a_stroke_and_its_cooling_time(self):
        editor = self.cut()
        editor.press("ctrl", "z")
        editor.pause(1)
        report = editor.quit()
        self.assertEqual((report["undo_depth"], report["time"]["ticks"], report["faces_removed"]), (0, 0, 0))
        self.assertLess(report["heat"]["hottest"], 294)

    def test_one_undo_reverts_a_command_and_its_cooling_time(self):
        editor = self.cut()
        editor.press("ctrl", "a")
        editor.press("shift", "p")
        editor.pause(2)
        editor.press("ctrl", "z")
        editor.pause(1)
        report = editor.quit()
        self.assertEqual(report["undo_depth"], 1)
        self.assertTrue(report["messages"][-1].startswith("Undo: Pin"), report["messages"])

    def test_escape_ends_a_slow_stroke_at_the_beam_and_undo_reverts_it(self):
        """A stroke of 20 s in one frame, of which some milliseconds are cut before Esc and the keys after it come."""
        self.heat_held = True
        editor = self.open(SPHERE)
        self.choose_thermal_model(editor)
        begin, end = editor.place(ACROSS[0]), editor.place(ACROSS[1])
        editor.move_to(*begin)
        editor.settle()
        way = [[round(a + share * (b - a)) for a, b in zip(begin, end)] for share in (0, 0.25, 0.5, 0.75, 1)]
        editor.send({"frame": 20})
        editor.draw_at_once(way)
        editor.send({"frame": 0.001})
        self.assertTrue(editor.landmarks()["busy"])
        editor.press_at_once(("Escape",), ("ctrl", "z"), ("ctrl", "shift", "z"))
        editor.settle()
        report = editor.quit()
        said = [text.split(":")[0] for text in report["messages"][-3:]]
        self.assertEqual(said, ["Stopped", "Undo", "Redo"])
        self.assertEqual((report["undo_depth"], report["strokes"]), (1, 1))
        power = 2000  # W, of the laser
        self.assertLess(report["heat"]["emitted"], 0.5 * 20 * power)

    def test_frozen_temperature_does_not_change(self):
        self.heat_held = True
        editor = self.cut()
        report = editor.quit()
        self.assertGreater(report["heat"]["hottest"], 1000)
        self.assertEqual(report["time"]["ticks"], 0)

    def test_a_stationary_thermal_beam_keeps_heating(self):
        editor = self.open(SPHERE)
        self.choose_thermal_model(editor)
        editor.move_to(*editor.place((0.5, 0.5)))
        editor.settle()
        editor.hold(1)
        editor.pause(1)
        editor.release(1)
        report = editor.quit()
        self.assertEqual(report["strokes"], 1)
        self.assertGreater(report["heat"]["emitted"], 40)  # far more than in the tick of the click
        self.assertGreater(report["heat"]["absorbed"], 0)


if __name__ == "__main__":
    unittest.main()
