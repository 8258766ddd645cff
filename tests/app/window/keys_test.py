#!/usr/bin/env python3
"""The command palette by the keyboard alone, keys within one frame, and the settings of keys."""
import json
import os
import unittest

from editor_window import SPHERE, WindowTest, real_input


class PaletteTest(WindowTest):
    def find(self, editor, typed):
        editor.press("ctrl", "p")
        editor.part("palette")
        editor.type(typed)
        editor.pause(0.5)

    def wait_until_closed(self, editor):
        editor.wait_for(lambda: "palette" not in editor.landmarks()["parts"], "the palette stays open")

    def test_runs_the_typed_action_and_closes(self):
        editor = self.open(SPHERE)
        editor.point_at(0.5, 0.5)
        self.find(editor, "wire")
        editor.press("Return")
        self.wait_until_closed(editor)
        self.find(editor, "panels tree")
        editor.press("Return")
        self.wait_until_closed(editor)
        self.find(editor, "normals")
        editor.press("Escape")
        self.wait_until_closed(editor)
        view = editor.quit()["view"]
        self.assertEqual((view["wire"], view["normals"]), (True, False))
        self.assertTrue(self.settings()["panels"]["tree"])

    def test_a_disabled_action_does_not_run_and_arrows_select_another(self):
        editor = self.open(SPHERE)
        editor.point_at(0.5, 0.5)
        self.find(editor, "undo")
        editor.press("Return")
        editor.pause(0.5)
        self.assertIn("palette", editor.landmarks()["parts"])
        for _ in range(4):
            editor.press("BackSpace")
        editor.type("aabb")
        editor.pause(0.5)
        editor.press("Down")
        editor.press("Up")
        editor.press("Return")
        self.wait_until_closed(editor)
        self.assertTrue(editor.quit()["view"]["boxes"])

    def test_a_click_runs_a_row_and_a_click_outside_cuts_nothing(self):
        editor = self.open(SPHERE)
        self.find(editor, "wire")
        editor.click("palette row 0", 0.3, 0.5)
        self.wait_until_closed(editor)
        self.find(editor, "")
        editor.click(0.5, 0.9)
        self.wait_until_closed(editor)
        report = editor.quit()
        self.assertTrue(report["view"]["wire"])
        self.assertEqual(report["strokes"], 0)


class QuickKeysTest(WindowTest):
    """Keys that are pressed and released within one frame, and text that comes with the key that opens a field."""

    def test_a_path_typed_right_after_the_browser_key_opens_its_file(self):
        editor = self.open(SPHERE)
        editor.point_at(0.5, 0.5)
        copy = os.path.join(self.folder, "wire-bridge.json")
        with open(SPHERE) as source, open(copy, "w") as file:
            described = json.load(source)
            described["bodies"][0]["mesh"] = os.path.join(os.path.dirname(SPHERE), described["bodies"][0]["mesh"])
            json.dump(described, file)
        editor.press_at_once(("ctrl", "o"), copy, ("Return",))
        editor.wait_for_title("wire-bridge.json - Kerf")
        report = editor.quit()
        self.assertEqual((report["view"]["wire"], report["view"]["boxes"], report["undo_depth"]), (False, False, 0))

    def test_enter_on_an_empty_name_opens_nothing_and_arrows_select(self):
        self.open(SPHERE).quit()
        self.set(folder=self.folder)
        with open(os.path.join(self.folder, "a.json"), "w") as file:
            file.write("{}")
        editor = self.open_again(SPHERE)
        editor.press_at_once(("ctrl", "o"), ("Return",))
        editor.settle()
        self.assertIn("browser", editor.landmarks()["parts"])
        editor.press_at_once("no such name", ("Return",))
        editor.settle()
        self.assertIn("browser", editor.landmarks()["parts"])
        editor.press("Escape")
        editor.press_at_once(("ctrl", "o"), "a.js", ("Return",))
        editor.settle()
        self.assertNotIn("browser", editor.landmarks()["parts"])
        editor.press_at_once(("ctrl", "p"), ("Return",))
        editor.settle()
        self.assertIn("palette", editor.landmarks()["parts"])
        editor.press_at_once("wire", ("Return",))
        report = editor.quit()
        self.assertTrue(report["view"]["wire"])
        self.assertTrue(any("a.json" in message for message in report["messages"]), report["messages"])

    def test_the_unsaved_changes_dialog_accepts_a_letter_typed_with_its_key(self):
        editor = self.open(SPHERE)
        editor.drag([(0.32, 0.5), (0.68, 0.5)])
        editor.press_at_once(("ctrl", "q"), ("d",))
        self.assertTrue(editor.has_ended(20))
        self.assertEqual(editor.report()["undo_depth"], 1)


class SettingsTest(WindowTest):
    @real_input
    def test_a_key_is_rebound_after_its_conflict_is_named_and_persists(self):
        editor = self.open(SPHERE)
        editor.point_at(0.05, 0.95)
        editor.do("ctrl", "comma")
        editor.click("settings page Keymap", 0.5, 0.5)
        editor.click("key of edit.undo", 0.1, 0.5)
        editor.do("w")
        editor.part("take the key")  # W is the key of Wireframe
        editor.do("Return")
        editor.do("Escape")
        editor.do("w")  # nothing was done yet, so undo says so
        report = editor.quit()
        self.assertFalse(report["view"]["wire"])
        self.assertIn("Nothing to undo.", report["messages"])
        self.assertEqual(self.settings()["bindings"], {"edit.undo": "W", "view.wire": ""})
        self.set(bindings={"view.wire": "F7", "no.such_action": "F7", "view.normals": 7})
        editor = self.open_again(SPHERE)
        editor.point_at(0.05, 0.95)
        editor.do("F7")
        self.assertTrue(editor.quit()["view"]["wire"])

    def test_settings_of_all_pages_are_searched_and_changed_by_keys(self):
        editor = self.open(SPHERE)
        editor.point_at(0.05, 0.95)
        editor.press("ctrl", "comma")
        editor.type("palette")
        editor.press("Down")
        editor.press("Right")
        editor.press("Escape")
        editor.press("PgDn")
        editor.press("PgDn")
        editor.press("Down")
        editor.press("Right")
        editor.press("Escape")
        editor.settle()
        self.assertNotIn("settings", editor.landmarks()["parts"])
        editor.quit()
        self.assertEqual(self.settings()["palette"], "orange-blue")
        self.assertEqual(self.settings()["autosave_seconds"], 5)

    def test_a_format_with_a_unit_is_asked_about_again(self):
        self.open(SPHERE).quit()
        self.set(frames={"stl": {"unit": "cm", "up": "z"}})
        editor = self.open_again(SPHERE)
        editor.point_at(0.05, 0.95)
        editor.do("ctrl", "comma")
        editor.click("settings page Units", 0.5, 0.5)
        editor.click("unit of stl", 0.5, 0.5)
        editor.click("stl as Ask", 0.5, 0.5)
        editor.do("Escape")
        editor.quit()
        self.assertEqual(self.settings()["frames"], {})

    def test_a_preset_changes_keys(self):
        editor = self.open(SPHERE)
        editor.point_at(0.05, 0.95)
        editor.do("ctrl", "comma")
        editor.click("settings page Keymap", 0.5, 0.5)
        editor.click("Blender", 0.5, 0.5)
        editor.do("Escape")
        editor.do("shift", "z")
        editor.press("F3")
        editor.part("palette")
        editor.press("Escape")
        self.assertTrue(editor.quit()["view"]["wire"])
        self.assertEqual(self.settings()["bindings"]["view.wire"], "Shift+Z")


    def test_an_exported_keymap_is_imported_after_a_reset(self):
        editor = self.open(SPHERE)
        editor.point_at(0.05, 0.95)
        editor.do("ctrl", "comma")
        editor.click("settings page Keymap", 0.5, 0.5)
        editor.click("Blender", 0.5, 0.5)
        editor.click("export keymap", 0.5, 0.5)
        self.type_name(editor, "keys.json")
        editor.settle()
        editor.click("reset keymap", 0.5, 0.5)
        editor.quit()
        self.assertEqual(self.settings()["bindings"], {})
        editor = self.open_again(SPHERE)
        editor.point_at(0.05, 0.95)
        editor.do("ctrl", "comma")
        editor.click("settings page Keymap", 0.5, 0.5)
        editor.click("import keymap", 0.5, 0.5)
        self.type_name(editor, "keys.json")
        editor.settle()
        editor.do("Escape")
        editor.do("shift", "z")
        self.assertTrue(editor.quit()["view"]["wire"])
        self.assertEqual(self.settings()["bindings"]["view.wire"], "Shift+Z")


class PointerTest(WindowTest):
    def test_pieces_are_copied_pasted_undone_and_redone_by_the_usual_keys(self):
        editor = self.open(SPHERE)
        editor.point_at(0.5, 0.5)
        editor.press("a")
        for key in "cvzy":
            editor.press("ctrl", key)
        report = editor.quit()
        self.assertEqual((report["bodies"], report["undo_depth"]), (2, 1))

    def test_a_right_click_selects_and_opens_a_menu_and_a_right_drag_only_pans(self):
        editor = self.open(SPHERE)
        editor.point_at(0.5, 0.5)
        editor.hold(3)
        editor.point_at(0.6, 0.5)
        editor.release(3)
        editor.pause(0.5)
        self.assertNotIn("popup", editor.landmarks()["parts"])
        editor.hold(3)
        editor.release(3)
        editor.pause(0.5)
        self.assertIn("popup", editor.landmarks()["parts"])
        self.assertEqual(editor.quit()["pieces_chosen"], 1)

    def test_the_toolbar_runs_actions_and_a_double_click_edits_a_slider(self):
        editor = self.open(SPHERE)
        editor.click("view.section", 0.5, 0.5)
        editor.point_at("radius", 0.3, 0.5)
        editor.double_click()
        editor.type("5 mm")
        editor.press("Return")
        report = editor.quit()
        self.assertTrue(report["view"]["section"])
        self.assertAlmostEqual(report["laser"]["radius"], 0.005)


if __name__ == "__main__":
    unittest.main()
