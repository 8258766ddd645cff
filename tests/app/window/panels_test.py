"""The tabs of panels, the places where a panel is shown, the welcome and the tour."""
import unittest

from editor_window import SPHERE, WindowTest


class Panels(WindowTest):
    def parts(self, editor):
        return editor.landmarks()["parts"]

    def test_a_tab_is_selected_by_key_or_click_and_remembered(self):
        editor = self.open(SPHERE)
        self.assertIn("panel laser", self.parts(editor))
        editor.do("alt", "2")
        self.assertIn("panel view", self.parts(editor))
        self.assertNotIn("panel laser", self.parts(editor))
        editor.click("tab mesh", 0.5, 0.5)
        self.assertIn("panel prepare", self.parts(editor))
        editor.quit()
        editor = self.open_again(SPHERE)
        self.assertIn("panel prepare", self.parts(editor))
        self.assertNotIn("panel laser", self.parts(editor))
        editor.quit()

    def test_a_panel_moves_to_each_dock_and_back_to_its_tab(self):
        editor = self.open(SPHERE)
        whole = editor.part("viewport")
        for place, area in (("Below the Viewport", "strip"), ("In a Second Column", "second_side")):
            editor.click("dock laser", 0.5, 0.5)
            editor.click(place, 0.3, 0.5)
            x, y, width, height = editor.part(area)
            self.assertGreater(width * height, 0)
            left, top = editor.part("panel laser")[:2]  # the header in the column is drawn first
            self.assertTrue(x <= left < x + width and y <= top < y + height, (place, left, top))
        editor.click("dock laser", 0.5, 0.5)
        editor.click("In Its Tab", 0.3, 0.5)
        self.assertEqual(editor.part("viewport"), whole)
        editor.quit()
        self.assertEqual(self.settings()["docks"]["laser"], "column")

    def test_the_tour_advances_when_a_step_is_done_and_ends_with_esc(self):
        editor = self.open(SPHERE)
        editor.press("ctrl", "p")
        editor.type("guided tour")
        editor.press("Return")
        editor.part("tour")
        editor.drag([(0.3, 0.5), (0.7, 0.5)])
        editor.do("ctrl", "z")
        editor.do("ctrl", "shift", "z")
        editor.click("tour next", 0.5, 0.5)
        self.assertEqual(editor.ask("report")["tour"], 4)
        editor.do("Escape")
        self.assertIsNone(editor.quit()["tour"])

    def test_the_welcome_screen_opens_a_scene_and_closes_on_any_key(self):
        editor = self.open(SPHERE)
        editor.press("ctrl", "p")
        editor.type("welcome")
        editor.press("Return")
        editor.part("welcome")
        editor.do("w")
        self.assertNotIn("welcome", self.parts(editor))
        editor.press("ctrl", "p")
        editor.type("welcome")
        editor.press("Return")
        editor.click("welcome Bracket", 0.3, 0.5)
        editor.wait_for_title("bracket.json - Kerf")
        editor.quit()


if __name__ == "__main__":
    unittest.main()
