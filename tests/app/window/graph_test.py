"""The Graph panel: what it says of a cut, its traversal, and the pointer that lights nodes and faces."""
import tempfile
import unittest

from editor_window import SPHERE, WindowTest


class Graph(WindowTest):
    def open_graph(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.only_panel("Graph")
        return self.open_again(SPHERE)

    def test_the_slider_plays_the_traversal_of_a_cut_that_separated_something(self):
        editor = self.open_graph()
        editor.drag([(0.2, 0.5), (0.8, 0.5)])
        editor.click("graph slider", 0.5, 0.5)
        graph = editor.quit()["graph"]
        self.assertGreater(graph["removed"], 0)
        self.assertLess(graph["reached"], graph["total"])
        self.assertAlmostEqual(graph["marked"] / graph["reached"], 0.5, delta=0.1)
        self.assertLessEqual(graph["nodes"], 2000)

    def test_the_face_under_the_pointer_is_lit_and_a_click_divides_a_cluster(self):
        editor = self.open_graph()
        editor.click("graph canvas", 0.5, 0.5)
        editor.point_at(0.5, 0.4)
        graph = editor.quit()["graph"]
        self.assertTrue(graph["any_open"])
        self.assertTrue(graph["face_lit"])
        self.assertEqual((graph["removed"], graph["reached"]), (0, graph["total"]))


if __name__ == "__main__":
    unittest.main()
