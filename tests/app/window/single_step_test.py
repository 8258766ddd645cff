"""Single steps: the last stroke is cut stage by stage, forth and back, by keys and by the buttons of the panel."""
import os
import subprocess
import tempfile
import unittest

from editor_window import ACROSS, ACROSS_ABOVE, KERF, SPHERE, WindowTest


class SingleStep(WindowTest):
    def open_panel(self, panel):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.only_panel(panel)
        return self.open_again(SPHERE)

    def hash_of(self, journal):
        """That of the state to which the commands of a journal lead."""
        replay = subprocess.run([KERF, "replay", os.path.join(self.folder, journal)], capture_output=True, text=True)
        self.assertEqual(replay.returncode, 0, replay.stderr)
        return replay.stdout.split()[-1]

    def test_stepping_a_stroke_back_and_forth_gives_the_drawn_result(self):
        editor = self.open_panel("single_step")
        editor.drag(ACROSS)
        self.save_as(editor, "drawn.kerf")
        editor.wait_for_title("drawn.kerf - Kerf")
        editor.point_at(0.9, 0.9)
        editor.do("shift", "F8")
        for key in ("period", "period", "period", "comma", "period"):
            editor.do(key)
        editor.click("stage next", 0.5, 0.5)
        editor.click("stage end of move", 0.5, 0.5)
        editor.click("stage back", 0.5, 0.5)
        editor.do("shift", "period")
        editor.click("stage row 2", 0.5, 0.5)
        editor.do("End")
        editor.do("comma")
        editor.click("stage end of stroke", 0.5, 0.5)
        report = editor.quit()
        stages = report["stages"]
        self.assertEqual(report["waiting"], 0)
        self.assertEqual(stages["done"], len(stages["told"]))
        self.assertGreater(stages["done"], 20)
        self.assertEqual([text.split(":")[0] for text in stages["told"][:3]], ["Sweep", "Hit", "Refine"])
        self.assertEqual(report["state_hash"], self.hash_of("drawn.kerf"))

    def test_a_stroke_waits_for_its_stages_and_plays_in_slow_motion(self):
        editor = self.open_panel("single_step")
        editor.click("stages on", 0.05, 0.5)
        editor.drag(ACROSS)
        editor.do("period")
        editor.click("stage speed", 0.9, 0.5)
        editor.press("space")
        editor.press("space")
        editor.point_at(0.9, 0.9)
        stages = editor.quit()
        self.assertGreater(stages["waiting"], 0)
        self.assertGreater(stages["stages"]["done"], 2)
        self.assertEqual(stages["stages"]["done"], len(stages["stages"]["told"]))
        self.assertFalse(stages["stages"]["playing"])

    def test_another_stroke_finishes_the_previous_one_and_waits(self):
        editor = self.open_panel("single_step")
        editor.press("F8")
        editor.drag(ACROSS)
        editor.do("period")
        editor.drag(ACROSS_ABOVE)
        report = editor.quit()
        self.assertEqual(report["strokes"], 2)
        self.assertGreater(report["faces_removed"], 100)
        self.assertGreater(report["waiting"], 0)
        self.assertEqual(report["stages"]["done"], 0)

    def test_a_stage_requested_during_an_earlier_stroke_follows_it(self):
        editor = self.open_panel("single_step")
        start, end = editor.place((0.3, 0.4)), editor.place((0.7, 0.6))
        across = [editor.place((0.3 + 0.01 * i, 0.4 + 0.02 * (i % 10))) for i in range(40)]
        editor.draw_at_once([start, *across, end])  # many moves, which are not cut within a frame
        steps = [{"press": "left"}, {"move": list(editor.place((0.6, 0.5)))}, {"release": "left"},
                 {"key_down": "."}, {"key_up": "."}]
        editor.send({"together": [{"key_down": "F8"}, {"key_up": "F8"}]})
        editor.move_to(*editor.place((0.4, 0.5)))
        editor.send({"together": steps})
        state = editor.ask("report")
        self.assertGreater(state["waiting"], 0)
        editor.settle()
        report = editor.ask("report")
        self.assertEqual(report["strokes"], 2)
        self.assertEqual(report["stages"]["done"], 1, report["stages"])
        self.assertGreater(report["waiting"], 0)

    def test_a_badge_names_the_next_single_step(self):
        editor = self.open_panel("single_step")
        self.assertFalse(editor.shows("single step badge"))
        editor.press("F8")
        self.assertTrue(editor.shows("single step badge"))
        self.assertEqual(editor.ask("report")["stages"]["state"], "draw a stroke")
        editor.drag(ACROSS)
        self.assertEqual(editor.ask("report")["stages"]["state"], "next stage (.)")
        self.assertTrue(editor.shows("waiting stroke 0"))
        editor.do("period")
        self.assertFalse(editor.shows("waiting stroke 0"))
        editor.do("End")
        self.assertEqual(editor.ask("report")["stages"]["state"], "the stroke is cut")
        editor.press("F8")
        editor.settle()
        self.assertFalse(editor.shows("single step badge"))

    def test_the_tree_panel_slider_steps_through_the_query_box_by_box(self):
        editor = self.open_panel("tree")
        editor.drag(ACROSS)
        editor.do("shift", "F8")
        editor.do("period")
        editor.do("period")
        editor.click("query slider", 0.5, 0.5)
        editor.do("bracketright")
        query = editor.quit()["stages"]["query"]
        self.assertTrue(query["drawn"])
        self.assertGreater(query["boxes"], 10)
        self.assertAlmostEqual(query["visited"] / query["boxes"], 0.5, delta=0.15)


if __name__ == "__main__":
    unittest.main()
