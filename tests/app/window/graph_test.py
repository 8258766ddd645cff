"""The Graph panel: what it says of a cut, its traversal, and the pointer that lights nodes and faces."""
import tempfile
import unittest

from editor_window import SPHERE, WindowTest


class Graph(WindowTest):
    def open_graph(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.only_panel("graph")
        editor = self.open_again(SPHERE)
        editor.resize(900, 720)  # the panel is high
        return editor

    def test_the_slider_plays_the_traversal_of_a_separating_cut(self):
        editor = self.open_graph()
        editor.drag([(0.2, 0.5), (0.8, 0.5)])
        editor.click("graph slider", 0.5, 0.5)
        graph = editor.quit()["graph"]
        self.assertGreater(graph["removed"], 0)
        self.assertLess(graph["reached"], graph["total"])
        self.assertAlmostEqual(graph["marked"] / graph["reached"], 0.5, delta=0.1)
        self.assertLessEqual(graph["nodes"], 2000)

    def test_the_face_under_the_pointer_is_highlighted_and_a_click_expands_a_cluster(self):
        editor = self.open_graph()
        editor.click("graph start", 0.5, 0.5)
        editor.point_at(0.5, 0.4)
        graph = editor.quit()["graph"]
        self.assertTrue(graph["any_open"])
        self.assertTrue(graph["face_lit"])
        self.assertEqual((graph["removed"], graph["reached"]), (0, graph["total"]))

    def test_a_face_that_no_node_shows_is_reported_until_the_graph_changes(self):
        editor = self.open_graph()
        editor.click("graph find", 0.5, 0.5)
        editor.type("9999999")
        editor.do("Return")
        editor.part("graph face missing")
        editor.drag([(0.2, 0.5), (0.8, 0.5)])
        editor.settle()
        self.assertNotIn("graph face missing", editor.landmarks()["parts"])
        self.assertGreater(editor.quit()["graph"]["removed"], 0)

    def middle_of(self, editor, part):
        x, y, width, height = editor.part(part)
        return x + 0.5 * width, y + 0.5 * height

    def test_the_wheel_zooms_to_the_pointer_and_a_drag_pans_the_graph(self):
        editor = self.open_graph()
        editor.point_at("graph canvas", 0.5, 0.5)
        pointer, before = editor.pointer, self.middle_of(editor, "graph start")
        editor.wheel(3)
        editor.do("Shift_L")
        zoomed = self.middle_of(editor, "graph start")
        for i in (0, 1):
            self.assertAlmostEqual(zoomed[i] - pointer[i], 1.2 ** 3 * (before[i] - pointer[i]), delta=3)
        x, y = pointer
        editor.drag_pixels([(x, y), (x + 40, y - 30)])
        moved = self.middle_of(editor, "graph start")
        self.assertAlmostEqual(moved[0] - zoomed[0], 40, delta=9)  # a drag begins after some pixels
        self.assertAlmostEqual(moved[1] - zoomed[1], -30, delta=9)
        self.assertFalse(editor.quit()["graph"]["any_open"])

    def test_the_second_view_lists_pieces_and_draws_the_graph_of_the_selected_one(self):
        editor = self.open_graph()
        editor.drag([(0.2, 0.5), (0.8, 0.5)])
        editor.click("graph removals", 0.02, 0.3)
        editor.click("graph nodes", 0.5, 0.5)
        editor.click("graph nodes 3", 0.3, 0.5)
        editor.click("piece node 1", 0.3, 0.5)
        editor.click("graph nodes", 0.5, 0.5)
        editor.click("graph nodes 2", 0.3, 0.5)
        report = editor.quit()
        graph = report["graph"]
        self.assertEqual(report["pieces_chosen"], 1)
        self.assertTrue(graph["of_piece"])
        self.assertEqual((graph["removed"], graph["reached"]), (0, graph["total"]))
        self.assertLess(graph["total"], report["faces"])
        self.assertEqual(report["strokes"], 1)


if __name__ == "__main__":
    unittest.main()
