"""The Scalar map panel: faces coloured by a quantity, its range, and that it follows cuts."""
import tempfile
import unittest

from editor_window import SPHERE, WindowTest


class ScalarMap(WindowTest):
    def open_map(self, quantity):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.only_panel("scalar_map")
        editor = self.open_again(SPHERE)
        self.ask_palette(editor, f"Colour by {quantity}")
        return editor

    def ask_palette(self, editor, name):
        editor.press("ctrl", "p")
        editor.type(name)
        editor.press("Return")
        editor.settle()

    def map_of(self, editor):
        return editor.ask("report")["scalar_map"]

    def test_a_quantity_colours_the_faces_and_paint_restores_them(self):
        editor = self.open_map("Min. Angle")
        place = editor.place((0.5, 0.5))
        mapped = editor.pixels()(*place)
        self.assertGreater(self.map_of(editor)["faces"], 0)
        self.ask_palette(editor, "Colour by Paint")
        painted = editor.pixels()(*place)
        self.assertGreater(sum(abs(a - b) for a, b in zip(mapped, painted)), 40)
        self.assertIsNone(editor.quit()["scalar_map"]["quantity"])

    def test_dragging_a_handle_sets_an_end_until_the_range_is_fitted(self):
        editor = self.open_map("longest edge")
        before = self.map_of(editor)
        self.assertTrue(before["fits"])
        x, y, width, height = editor.part("scalar low")
        middle = x + width // 2, y + height // 2
        editor.drag_pixels([middle, (middle[0] + 40, middle[1])])
        dragged = self.map_of(editor)
        self.assertFalse(dragged["fits"])
        self.assertGreater(dragged["low"], before["low"])
        self.assertEqual(dragged["high"], before["high"])
        editor.click("scalar Fit", 0.5, 0.5)
        self.assertEqual(self.map_of(editor), before)
        editor.quit()

    def test_an_end_typed_beyond_the_other_is_refused_with_a_reason(self):
        editor = self.open_map("longest edge")
        before = self.map_of(editor)
        for end, number, reason in (("From", "1 km", "it must be less than To"),
                                    ("To", "-1 km", "it must be more than From")):
            editor.click(end, 0.5, 0.5)
            editor.press("ctrl", "a")
            editor.type(number)
            editor.do("Return")
            message = editor.ask("report")["messages"][-1]
            self.assertIn(f"{end} stays ", message)
            self.assertIn(reason, message)
        self.assertEqual(self.map_of(editor), before)
        editor.quit()

    def test_fields_of_a_range_that_ends_at_zero_keep_their_unit(self):
        editor = self.open_map("longest edge")
        for end, text in (("From", "-10 mm"), ("To", "0 mm"), ("From", "nothing")):
            editor.click(end, 0.5, 0.5)
            editor.press("ctrl", "a")
            editor.type(text)
            editor.do("Return")
        self.assertIn("From stays -10 mm: ", editor.ask("report")["messages"][-1])
        editor.quit()

    def test_follows_a_cut_and_its_undo(self):
        editor = self.open_map("level")
        before = self.map_of(editor)
        self.assertEqual(before["low"], 0)
        editor.drag([(0.2, 0.5), (0.8, 0.5)])
        cut = self.map_of(editor)
        self.assertNotEqual(cut["faces"], before["faces"])
        editor.do("ctrl", "z")
        self.assertEqual(self.map_of(editor), before)
        editor.quit()

    def test_another_face_colouring_ends_it(self):
        editor = self.open_map("level")
        editor.point_at(0.5, 0.5)
        editor.do("p")
        self.assertIsNone(editor.quit()["scalar_map"]["quantity"])


if __name__ == "__main__":
    unittest.main()
