#!/usr/bin/env python3
"""Moving, turning and duplicating the selected piece, by keys, by numbers and by handles."""
import unittest

from editor_window import SPHERE, WindowTest


class Moving(WindowTest):
    def pick_the_sphere(self):
        editor = self.open(SPHERE)
        editor.press("k")
        editor.click(0.5, 0.53)
        return editor

    def test_a_piece_is_moved_rotated_and_duplicated_by_numbers(self):
        editor = self.pick_the_sphere()
        editor.do("g")
        for key in ("y", "0", "period", "5"):
            editor.press(key)
        editor.do("Return")
        editor.do("r")
        for key in ("z", "9", "0"):
            editor.press(key)
        editor.do("Return")
        editor.do("shift", "d")
        for key in ("x", "minus", "2"):
            editor.press(key)
        editor.do("Return")
        report = editor.quit()
        self.assertEqual((report["strokes"], report["bodies"], report["pieces_chosen"]), (0, 2, 1))
        self.assertEqual(report["undo_depth"], 4)  # a move, a turn, a copy and its move
        sphere, copy = report["placements"]
        self.assertAlmostEqual(copy["position"][0] - sphere["position"][0], -2)
        self.assertEqual(copy["position"][1:], sphere["position"][1:])
        self.assertAlmostEqual(abs(sphere["orientation"][0]), 0.5 ** 0.5)
        self.assertAlmostEqual(abs(sphere["orientation"][3]), 0.5 ** 0.5)
        self.assertEqual(copy["orientation"], sphere["orientation"])
        self.assertFalse(report["view"]["ghost"])

    def test_a_cancelled_move_leaves_no_trace_and_keys_keep_their_usual_meaning(self):
        editor = self.pick_the_sphere()
        editor.do("g")
        editor.move_to(*editor.place((0.6, 0.4)))
        editor.settle()
        editor.press("Escape")
        editor.do("r")
        editor.click(0.3, 0.3, button=3)
        editor.do("shift", "d")
        editor.press("Escape")
        editor.do("l")
        editor.do("g")
        report = editor.quit()
        self.assertEqual((report["bodies"], report["undo_depth"]), (1, 0))
        self.assertEqual(report["placements"][0]["position"], [0, 0, 0])
        self.assertEqual(report["placements"][0]["orientation"], [1, 0, 0, 0])
        self.assertTrue(report["view"]["ghost"])

    def test_an_arrow_is_dragged_and_a_move_follows_the_pointer_until_a_click(self):
        editor = self.pick_the_sphere()
        x, y = editor.place(("move Y", 0.5, 0.5))
        editor.drag_pixels([(x, y), (x, y - 60)])
        editor.do("g")
        x, y = editor.pointer
        editor.move_to(x + 80, y)
        editor.settle()
        editor.click(0.8, 0.3)
        report = editor.quit()
        self.assertEqual((report["strokes"], report["undo_depth"], report["pieces_chosen"]), (0, 2, 1))
        position = report["placements"][0]["position"]
        self.assertGreater(position[1], 0.05)
        self.assertNotEqual(position[0], 0)

    def test_ctrl_snaps_the_drag_of_an_arrow_to_whole_centimetres(self):
        editor = self.pick_the_sphere()
        x, y = editor.place(("move Y", 0.5, 0.5))
        editor.key_down("ctrl")
        editor.drag_pixels([(x, y), (x, y - 37)])
        editor.key_up("ctrl")
        report = editor.quit()
        self.assertEqual((report["strokes"], report["undo_depth"]), (0, 1))
        centimetres = 100 * report["placements"][0]["position"][1]
        self.assertGreater(centimetres, 1)
        self.assertAlmostEqual(centimetres, round(centimetres), places=6)

    def test_half_a_cut_off_sphere_is_moved_and_undone(self):
        editor = self.open(SPHERE)
        editor.drag([(0.2, 0.5), (0.8, 0.5)])
        editor.press("k")
        editor.click(0.5, 0.35)
        editor.do("g")
        for key in ("y", "1"):
            editor.press(key)
        editor.do("Return")
        editor.pause(0.5)
        editor.do("ctrl", "z")
        editor.do("ctrl", "shift", "z")
        report = editor.quit()
        self.assertEqual((report["bodies"], report["undo_depth"]), (2, 2))
        self.assertIn([0, 1, 0], [p["position"] for p in report["placements"]])


class Inspecting(WindowTest):
    def test_a_face_is_described_and_two_clicks_measure(self):
        editor = self.open(SPHERE)
        editor.press("m")
        editor.point_at(0.5, 0.5)
        editor.part("face readout")
        editor.click(0.45, 0.5)
        editor.click(0.55, 0.5)
        report = editor.quit()
        self.assertEqual((report["strokes"], report["pieces_chosen"]), (0, 0))
        self.assertTrue(report["message"].startswith("Distance "), report["message"])

    def test_a_number_typed_in_the_panel_moves_the_selected_piece(self):
        self.open(SPHERE).quit()
        self.only_panel("pieces")
        editor = self.open_again(SPHERE)
        editor.press("k")
        editor.click(0.5, 0.53)
        editor.click("Centre 0", 0.5, 0.5)
        editor.press("ctrl", "a")
        editor.type("1.5")
        editor.do("Return")
        report = editor.quit()
        self.assertEqual(report["undo_depth"], 1)
        self.assertAlmostEqual(report["placements"][0]["position"][0], 1.5, places=3)


if __name__ == "__main__":
    unittest.main()
