#!/usr/bin/env python3
"""The section plane: its key, its handles, its numbers, its text in the clipboard, and what the pointer meets."""
import math
import os
import subprocess
import unittest

from editor_window import KERF, SPHERE, WindowTest, real_input


def numbers(report):
    """The point and the normal of the plane."""
    point, normal = report["view"]["section_plane"].split(" ")
    return [float(x) for x in point.split(",")], [float(x) for x in normal.split(",")]


class Section(WindowTest):
    def open_with_panel(self):
        self.open(SPHERE).quit()
        self.only_panel("view")
        return self.open_again(SPHERE)

    def type_into(self, editor, field, text):
        editor.click(field, 0.5, 0.5)
        editor.press("ctrl", "a")
        editor.type(text)
        editor.do("Return")

    def test_handles_move_and_rotate_the_plane_without_cutting(self):
        editor = self.open(SPHERE)
        editor.point_at(0.1, 0.9)
        editor.do("z")
        x, y = editor.place(("section move", 0.5, 0.5))
        editor.drag_pixels([(x, y), (x - 40, y + 40)])
        x, y = editor.place(("section tilt", 0.5, 0.5))
        editor.drag_pixels([(x, y), (x, y - 50)])
        report = editor.quit()
        self.assertEqual((report["strokes"], report["pieces_chosen"], report["undo_depth"]), (0, 0, 0))
        point, normal = numbers(report)
        self.assertGreater(point[2], 0.02)  # towards the eye, which is in front
        self.assertNotEqual(normal[1], 0)
        self.assertEqual(normal[0], 0)

    @real_input
    def test_numbers_are_typed_copied_and_pasted_and_render_accepts_the_text(self):
        editor = self.open_with_panel()
        editor.point_at(0.1, 0.9)
        editor.do("z")
        self.type_into(editor, "Section 1", "0.25")
        self.type_into(editor, "Normal 1", "1")
        editor.click("section copy", 0.5, 0.5)
        editor.click("section X", 0.5, 0.5)
        editor.click("section flip", 0.5, 0.5)
        editor.click("section paste", 0.5, 0.5)
        report = editor.quit()
        point, normal = numbers(report)
        self.assertEqual(point[1], 0.25)
        self.assertEqual(normal[0], 0)
        self.assertAlmostEqual(normal[1], 0.5 ** 0.5)
        self.assertAlmostEqual(normal[2], 0.5 ** 0.5)
        picture = os.path.join(self.folder, "section.png")
        subprocess.run([KERF, "render", SPHERE, "--out", picture, "--size", "64x48", "--section",
                        report["view"]["section_plane"]], check=True)
        self.assertTrue(os.path.exists(picture))

    def test_the_pointer_picks_visible_faces_and_the_beam_cuts_clipped_ones(self):
        editor = self.open_with_panel()
        editor.point_at(0.1, 0.9)
        editor.do("z")
        self.type_into(editor, "Section 2", "-7")  # behind the sphere: all of it is taken away
        editor.press("k")
        editor.click(0.35, 0.5)
        editor.press("l")
        editor.drag([(0.3, 0.4), (0.36, 0.45)])
        report = editor.quit()
        self.assertEqual(report["pieces_chosen"], 0)
        self.assertEqual(report["strokes"], 1)
        self.assertGreater(report["faces_removed"], 0)
        self.assertTrue(report["view"]["section"])

    def test_the_knife_cuts_along_a_line_as_one_undo_step_and_shift_snaps_its_angle(self):
        editor = self.open(SPHERE)
        whole = editor.ask("report")
        editor.click("tool.knife", 0.5, 0.5)
        start, level, aslant = editor.place((0.2, 0.5)), editor.place((0.5, 0.5)), editor.place((0.5, 0.53))
        editor.drag_pixels([start, level])
        editor.settle()
        straight = editor.ask("report")
        self.assertEqual((straight["pieces"], straight["undo_depth"], straight["faces_removed"]), (2, 1, 0))
        editor.do("ctrl", "z")
        self.assertEqual(editor.ask("report")["state_hash"], whole["state_hash"])
        editor.key_down("Shift_L")
        editor.drag_pixels([start, aslant])
        editor.key_up("Shift_L")
        editor.settle()
        self.assertEqual(editor.ask("report")["state_hash"], straight["state_hash"])
        editor.do("ctrl", "z")
        editor.drag_pixels([start, aslant])
        editor.settle()
        self.assertNotEqual(editor.quit()["state_hash"], straight["state_hash"])

    def test_esc_cancels_the_line_and_a_line_beside_the_mesh_cuts_nothing(self):
        editor = self.open(SPHERE)
        editor.press("q")
        (x, y), (x1, y1) = editor.place((0.2, 0.5)), editor.place((0.5, 0.5))
        editor.move_to(x, y)
        editor.settle()
        editor.press_button(1, x, y)
        editor.move_to(x1, y1)
        editor.press("Escape")
        editor.release(1)
        editor.settle()
        self.assertEqual(editor.ask("report")["undo_depth"], 0)
        editor.drag([(0.02, 0.1), (0.5, 0.11)])
        report = editor.quit()
        self.assertEqual((report["undo_depth"], report["pieces"]), (0, 1))
        self.assertIn("The plane crosses no visible piece.", report["messages"])

    def select_shape(self, editor, number):
        """Line, Lasso or Polyline."""
        editor.press("q")
        editor.click("header knife shape", 0.5, 0.5)
        editor.click(f"header knife shape {number}", 0.5, 0.5)

    def test_a_lasso_cuts_out_what_it_encloses_on_both_sides_and_the_journal_repeats_it(self):
        editor = self.open(SPHERE)
        whole = editor.ask("report")
        self.select_shape(editor, 1)
        x, y = editor.place((0.5, 0.5))
        ring = [(x + 60 * math.cos(a / 4), y + 50 * math.sin(a / 4)) for a in range(26)]  # past its start
        editor.drag_pixels(ring)
        editor.settle()
        cut = editor.ask("report")
        self.assertEqual((cut["pieces"], cut["undo_depth"], cut["faces_removed"]), (3, 1, 0))
        editor.do("ctrl", "z")
        self.assertEqual(editor.ask("report")["state_hash"], whole["state_hash"])
        editor.do("ctrl", "shift", "z")
        self.assertEqual(editor.ask("report")["state_hash"], cut["state_hash"])
        self.save_as(editor, "lasso")
        editor.wait_for_title("lasso.kerf - Kerf")
        editor.quit()
        subprocess.run([KERF, "replay", os.path.join(self.folder, "lasso.kerf"), "--expect", cut["state_hash"]],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def test_a_lasso_beside_the_mesh_or_a_cancelled_one_cuts_nothing(self):
        editor = self.open(SPHERE)
        self.select_shape(editor, 1)
        (x, y), (x1, y1) = editor.place((0.4, 0.4)), editor.place((0.6, 0.6))
        editor.move_to(x, y)
        editor.settle()
        editor.press_button(1, x, y)
        editor.move_to(x1, y)
        editor.move_to(x1, y1)
        editor.press("Escape")
        editor.release(1)
        editor.settle()
        self.assertEqual(editor.ask("report")["undo_depth"], 0)
        editor.drag([(0.1, 0.8), (0.2, 0.8), (0.2, 0.9), (0.1, 0.9)])
        editor.settle()
        report = editor.quit()
        self.assertEqual((report["undo_depth"], report["pieces"]), (0, 1))
        self.assertIn("The line crosses no visible piece.", report["messages"])

    def test_a_polyline_is_closed_at_its_first_point_or_ended_by_enter(self):
        editor = self.open(SPHERE)
        self.select_shape(editor, 2)
        square = [(0.45, 0.42), (0.55, 0.42), (0.55, 0.58), (0.45, 0.58)]
        for at in square + square[:1]:
            editor.click(*at)
        editor.settle()
        closed = editor.ask("report")
        self.assertEqual((closed["pieces"], closed["undo_depth"]), (3, 1))
        editor.do("ctrl", "z")
        editor.click(0.15, 0.5)
        editor.click(0.5, 0.45)
        editor.click(0.5, 0.9)
        editor.do("BackSpace")
        editor.click(0.85, 0.5)
        editor.do("Return")
        editor.settle()
        opened = editor.ask("report")
        self.assertEqual((opened["pieces"], opened["undo_depth"], opened["faces_removed"]), (2, 1, 0))
        editor.click(0.4, 0.5)
        editor.click(0.6, 0.5)
        editor.do("Escape")
        editor.do("Return")
        self.assertEqual(editor.quit()["state_hash"], opened["state_hash"])

    def test_a_normal_of_zeros_is_refused_with_a_reason(self):
        editor = self.open_with_panel()
        editor.point_at(0.1, 0.9)
        editor.do("z")
        editor.click("section X", 0.5, 0.5)
        before = numbers(editor.ask("report"))
        self.type_into(editor, "Normal 0", "0")
        report = editor.quit()
        self.assertEqual(numbers(report), before)
        self.assertIn("Normal stays the same: one of its numbers must not be 0", report["messages"][-1])

    def test_esc_stops_the_emitter_before_it_discards_a_polyline(self):
        editor = self.open(SPHERE)
        editor.point_at(0.1, 0.1)
        editor.do("shift", "u")
        editor.part("emitter target")
        self.select_shape(editor, 2)
        for at in ((0.15, 0.5), (0.5, 0.7), (0.85, 0.5)):
            editor.click(*at)
        editor.do("u")
        self.assertTrue(editor.ask("report")["emitter"]["firing"])
        editor.do("Escape")
        before = editor.ask("report")
        self.assertFalse(before["emitter"]["firing"])
        editor.do("Return")
        editor.settle()
        self.assertEqual(editor.quit()["undo_depth"], before["undo_depth"] + 1)

    def test_the_button_cuts_at_the_section_plane(self):
        editor = self.open_with_panel()
        editor.point_at(0.1, 0.9)
        editor.do("z")
        editor.click("section cut", 0.5, 0.5)
        editor.settle()
        report = editor.quit()
        self.assertEqual((report["pieces"], report["undo_depth"], report["faces_removed"]), (2, 1, 0))


if __name__ == "__main__":
    unittest.main()
