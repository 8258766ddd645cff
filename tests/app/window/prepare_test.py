"""The Prepare panel: numbers before, fewer or more faces afterwards, one undo, and Esc."""
import unittest

from editor_window import SPHERE, WindowTest


class Prepare(WindowTest):
    def open_panel(self):
        """The editor with the sphere and nothing but the panel, and its faces."""
        faces = self.open(SPHERE).quit()["faces"]
        self.only_panel("Prepare")
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

    def test_simplifying_leaves_the_number_of_faces_that_was_typed_and_is_undone(self):
        editor, faces = self.open_panel()
        self.type_number(editor, "Faces", str(faces // 4))
        editor.click("prepare", 0.5, 0.5)
        self.assertIn(editor.quit()["faces"], range(faces // 4 - 2, faces // 4 + 1))

    def test_subdividing_makes_four_faces_of_each_and_one_undo_takes_both_times_back(self):
        editor, faces = self.open_panel()
        self.choose(editor, "preparation", 2)
        self.type_number(editor, "Times", "2")
        editor.click("prepare", 0.5, 0.5)
        editor.point_at(0.9, 0.9)
        editor.do("ctrl", "z")
        report = editor.quit()
        self.assertEqual((report["faces"], report["undo_depth"]), (faces, 0))

    def test_smoothing_leaves_the_number_of_faces(self):
        editor, faces = self.open_panel()
        self.choose(editor, "preparation", 3)
        editor.click("prepare", 0.5, 0.5)
        report = editor.quit()
        self.assertEqual((report["faces"], report["undo_depth"]), (faces, 1))


if __name__ == "__main__":
    unittest.main()
