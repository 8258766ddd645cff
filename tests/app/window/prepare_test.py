"""The Prepare panel: numbers before, fewer or more faces afterwards, one undo, and Esc."""
import os
import unittest

from editor_window import ASSETS, SPHERE, WindowTest


class Prepare(WindowTest):
    def open_panel(self):
        """The editor with the sphere and nothing but the panel, and its faces."""
        faces = self.open(SPHERE).quit()["faces"]
        self.only_panel("prepare")
        editor = self.open_again(SPHERE)
        editor.part("prepare")
        return editor, faces

    def choose(self, editor, combo, item):
        editor.click(combo, 0.5, 0.5)
        editor.click(f"{combo} {item}", 0.5, 0.5)

    def type_number(self, editor, field, text):
        editor.click(field, 0.5, 0.5)
        editor.press("ctrl", "a")
        editor.type(text)
        editor.pause(0.5)
        editor.do("Return")

    def test_simplify_reaches_the_typed_face_count_and_is_undone(self):
        editor, faces = self.open_panel()
        self.type_number(editor, "Faces", str(faces // 4))
        editor.click("prepare", 0.5, 0.5)
        self.assertIn(editor.quit()["faces"], range(faces // 4 - 2, faces // 4 + 1))

    def test_subdivide_quadruples_faces_and_one_undo_reverts_both_passes(self):
        editor, faces = self.open_panel()
        self.choose(editor, "preparation", 2)
        self.type_number(editor, "Iterations", "2")
        editor.click("prepare", 0.5, 0.5)
        editor.point_at(0.9, 0.9)
        editor.do("ctrl", "z")
        report = editor.quit()
        self.assertEqual((report["faces"], report["undo_depth"]), (faces, 0))

    def test_the_preview_matches_the_result_and_changes_nothing(self):
        editor, faces = self.open_panel()
        self.type_number(editor, "Faces", str(faces // 4))
        report = editor.quit()
        preview = report["preview"]
        self.assertEqual((report["faces"], report["undo_depth"]), (faces, 0))
        self.assertIn(preview["faces"], range(faces // 4 - 2, faces // 4 + 1))
        self.assertEqual(preview["edges"], preview["faces"] * 3 // 2)
        self.assertGreater(preview["distance"], 0)

    def test_the_preview_is_drawn_over_the_surface_until_disabled(self):
        editor, _ = self.open_panel()
        editor.point_at(0.9, 0.9)
        places = [(x, y) for x in range(200, 400, 2) for y in range(200, 360, 2)]
        with_wire = self.picture(editor, places)
        editor.click("preview", 0.1, 0.5)
        editor.point_at(0.9, 0.9)
        without = self.picture(editor, places)
        self.assertGreater(sum(a != b for a, b in zip(with_wire, without)), 100)
        self.assertNotIn("preview", editor.quit())
        self.assertFalse(self.settings()["prepare_preview"])

    def picture(self, editor, places):
        pixel = editor.pixels()
        return [pixel(x, y) for x, y in places]

    def test_the_preview_follows_the_selected_piece(self):
        editor, faces = self.open_panel()
        self.choose(editor, "preparation", 2)
        editor.press("ctrl", "a")
        self.assertEqual(editor.quit()["preview"]["faces"], 4 * faces)

    def test_a_file_dropped_during_background_work_opens_afterwards(self):
        editor, _ = self.open_panel()
        self.choose(editor, "preparation", 2)
        self.type_number(editor, "Iterations", "3")
        editor.click("prepare", 0.5, 0.5)
        editor.drop(os.path.join(ASSETS, "meshes", "plate.obj"))
        editor.part("question")
        editor.press("d")
        editor.wait_for_title("plate.obj - Kerf")
        editor.quit()

    def test_down_and_enter_select_in_a_list(self):
        editor, faces = self.open_panel()
        editor.click("preparation", 0.5, 0.5)
        for key in ("Down", "Down", "Return"):
            editor.press(key)
        editor.click("prepare", 0.5, 0.5)
        self.assertEqual(editor.quit()["faces"], 4 * faces)

    def test_smoothing_keeps_the_face_count(self):
        editor, faces = self.open_panel()
        self.choose(editor, "preparation", 3)
        editor.click("prepare", 0.5, 0.5)
        report = editor.quit()
        self.assertEqual((report["faces"], report["undo_depth"]), (faces, 1))


if __name__ == "__main__":
    unittest.main()
