"""Numbers that are typed: units, arithmetic, what is refused and what is limited."""
import unittest

from editor_window import SPHERE, WindowTest


class Numbers(WindowTest):
    def open_panel(self, panel):
        self.open(SPHERE).quit()
        self.only_panel(panel)
        return self.open_again(SPHERE)

    def type_into_slider(self, editor, slider, text):
        editor.point_at(slider, 0.2, 0.5)
        editor.key_down("ctrl")
        editor.click(slider, 0.2, 0.5)
        editor.key_up("ctrl")
        editor.press("ctrl", "a")
        editor.type(text)
        editor.do("Return")
        return editor.ask("report")

    def test_a_slider_accepts_units_rejects_other_text_and_reports_clamping(self):
        editor = self.open_panel("laser")
        before = editor.ask("report")["laser"]["radius"]
        report = self.type_into_slider(editor, "radius", "1/4 in")
        self.assertAlmostEqual(report["laser"]["radius"], 0.00635, delta=1e-9)
        for text, reason in (("abc-5", '"abc" is not a number'), ("1e999", '"1e999" is too large'),
                             ("1,5", "commas are not supported"), ("4 00", "is not one number"),
                             ("3 W", "the units are mm, cm, m, in and ft")):
            report = self.type_into_slider(editor, "radius", text)
            self.assertAlmostEqual(report["laser"]["radius"], 0.00635, delta=1e-9)
            self.assertIn("Radius stays 6.35 mm: ", report["messages"][-1])
            self.assertIn(reason, report["messages"][-1])
        report = self.type_into_slider(editor, "radius", "1 km")
        self.assertAlmostEqual(report["laser"]["radius"], 20 * before, delta=1e-9)
        self.assertIn("Radius is limited to ", report["messages"][-1])
        report = self.type_into_slider(editor, "radius", "2*(1+1) mm")
        self.assertAlmostEqual(report["laser"]["radius"], 0.004, delta=1e-9)
        editor.quit()

    def test_a_slider_cancelled_by_esc_is_unchanged(self):
        editor = self.open_panel("laser")
        before = editor.ask("report")
        editor.key_down("ctrl")
        editor.click("radius", 0.2, 0.5)
        editor.key_up("ctrl")
        editor.type("9 mm")
        editor.press("Escape")
        editor.settle()
        report = editor.ask("report")
        self.assertEqual(report["laser"]["radius"], before["laser"]["radius"])
        self.assertEqual(report["messages"], before["messages"])
        editor.quit()

    def test_a_field_reads_the_text_it_shows(self):
        editor = self.open_panel("prepare")
        faces = editor.ask("report")["faces"]
        editor.click("Faces", 0.5, 0.5)
        editor.press("ctrl", "a")
        editor.type("1 000*2/2")
        editor.do("Return")
        editor.click("prepare", 0.5, 0.5)
        self.assertGreater(faces, 1000)
        self.assertIn(editor.quit()["faces"], range(990, 1001))


if __name__ == "__main__":
    unittest.main()
