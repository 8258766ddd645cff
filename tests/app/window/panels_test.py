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

    def test_a_panel_shown_by_the_palette_scrolls_into_view(self):
        editor = self.open(SPHERE)
        editor.press("ctrl", "p")
        editor.type("panels light")
        editor.press("Return")
        editor.settle()
        x, y, width, height = editor.part("side")
        left, top = editor.part("panel light")[:2]
        self.assertTrue(y <= top < y + 0.5 * height, (top, y, height))
        editor.quit()

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
        editor.press("ctrl", "p")
        editor.type("welcome")
        editor.press("Return")
        editor.click("welcome car", 0.5, 0.5)
        editor.wait_for_title("car.json - Kerf")
        editor.quit()

    def select(self, editor, combo, index):
        """An entry of a list in the header."""
        editor.click(f"header {combo}", 0.5, 0.5)
        editor.click(f"header {combo} {index}", 0.5, 0.5)

    def test_the_header_has_the_options_of_the_active_tool(self):
        editor = self.open(SPHERE)
        editor.click("header radius", 0.1, 0.5)
        editor.do("k")
        self.assertNotIn("header radius", self.parts(editor))
        editor.click("header pieces.invert", 0.5, 0.5)
        self.select(editor, "selection shape", 1)
        editor.drag([(0.35, 0.2), (0.65, 0.2), (0.65, 0.8), (0.35, 0.8)])  # too close around the sphere
        editor.do("m")
        self.select(editor, "measured kind", 1)
        for across in (0.45, 0.5, 0.55):
            editor.click(across, 0.5)
        first = editor.quit()
        self.assertIn("second point", first["message"])
        self.assertEqual((first["strokes"], first["pieces_chosen"]), (0, 0))
        editor = self.open_again(SPHERE)
        editor.do("m")
        self.select(editor, "measured kind", 3)
        for across in (0.45, 0.5, 0.55):
            editor.click(across, 0.5)
        second = editor.quit()
        self.assertTrue(second["message"].startswith("Radius "), second["message"])
        self.assertLess(first["laser"]["radius"], second["laser"]["radius"])

    def test_the_header_is_hidden_with_the_toolbar(self):
        editor = self.open(SPHERE)
        self.assertIn("header bar", self.parts(editor))
        editor.press("ctrl", "p")
        editor.type("toolbar")
        editor.press("Return")
        editor.settle()
        self.assertNotIn("header bar", self.parts(editor))
        self.assertNotIn("tool.laser", self.parts(editor))
        editor.quit()
        self.assertFalse(self.settings()["toolbar_shown"])


if __name__ == "__main__":
    unittest.main()
