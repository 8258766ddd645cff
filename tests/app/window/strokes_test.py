"""Strokes of the mouse, and cutting them again."""
import math
import unittest

from editor_window import ACROSS, ACROSS_ABOVE, SPHERE, WindowTest, real_input


class Strokes(WindowTest):
    def test_a_drag_across_the_car_cuts_it_in_two(self):
        editor = self.open()
        editor.drag([(0.53, 0.14), (0.53, 0.93)])
        report = editor.quit()
        self.assertEqual(report["strokes"], 1)
        self.assertGreater(report["faces_removed"], 100)
        self.assertGreater(report["pieces"], 1)
        self.assertGreater(report["frames"], 5)
        self.assertEqual(sorted(report["frame_ms"]), ["max", "p50", "p99"])

    def test_orbiting_the_view_and_stray_keys_cut_nothing(self):
        editor = self.open()
        editor.drag([(0.53, 0.5), (0.66, 0.43)], button=2)
        editor.drag([(0.53, 0.5), (0.6, 0.57)], button=3)
        editor.press("Escape")
        for key in ("f", "Home", "x", "comma", "Delete"):
            editor.press(key)
        editor.wheel(3)
        report = editor.quit()
        self.assertEqual((report["strokes"], report["faces_removed"], report["pieces"]), (0, 0, 1))

    def test_a_stroke_that_misses_is_reported_and_adds_no_undo_entry(self):
        editor = self.open(SPHERE)
        editor.drag(ACROSS)
        editor.do("ctrl", "z")
        editor.drag([(0.05, 0.1), (0.2, 0.08)])
        report = editor.ask("report")
        self.assertEqual((report["undo_depth"], report["strokes"]), (0, 0))
        self.assertTrue(report["messages"][-1].startswith("Missed"), report["messages"])
        editor.do("ctrl", "shift", "z")  # what can be done again still can
        self.assertEqual(editor.quit()["undo_depth"], 1)

    @real_input
    def test_a_slit_follows_the_pointer_within_a_slow_frame(self):
        self.assert_slit_follows_pointer(self.open())

    def test_a_press_applies_at_its_position_despite_later_motion_in_the_frame(self):
        editor = self.open()
        on_car, over_panel = editor.place((0.3, 0.51)), editor.place(("side", 0.5, 0.7))
        editor.draw_at_once([on_car, editor.place((0.5, 0.5)), over_panel])
        editor.settle()
        editor.draw_at_once([over_panel, on_car, editor.place((0.5, 0.6))])
        editor.settle()
        self.assertEqual(editor.quit()["strokes"], 1)

    def test_standard_views_work_by_key_and_axis_and_a_slit_follows_the_pointer(self):
        editor = self.open()
        editor.point_at(0.05, 0.05)
        editor.do("ctrl", "3")
        editor.do("KP_5")
        editor.click("axis X", 0.5, 0.5)
        editor.do("Home")
        self.assert_slit_follows_pointer(editor)
        editor.click("axis Z", 0.5, 0.5)
        report = editor.quit()
        self.assertEqual((report["strokes"], report["view"]["orthographic"]), (1, True))
        x, y, z = report["view"]["eye"]
        self.assertLess(max(abs(x), abs(y)), 1.5)
        self.assertGreater(z, 3)

    def assert_slit_follows_pointer(self, editor):
        """Draws a curve over the car from the bonnet to a door, all within a frame or two."""
        x, y = editor.place((0.3, 0.51))
        x1, y1 = editor.place((0.68, 0.46))
        path = [(round(x + (x1 - x) * i / 120), round(y - (y - y1) * math.sin(i / 13))) for i in range(121)]
        editor.move_to(*path[0])
        editor.settle()
        before = editor.pixels()
        editor.draw_at_once(path)
        editor.move_to(*editor.place((0.05, 0.05)))
        editor.settle()
        after = editor.pixels()
        missed = [p for p in path if max(abs(a - b) for a, b in zip(before(*p), after(*p))) < 12]
        self.assertLess(len(missed), 8, f"the slit is not at {missed}")

    def test_a_stroke_over_the_sky_removes_nothing(self):
        editor = self.open()
        editor.drag([(0.06, 0.07), (0.21, 0.09)])
        report = editor.quit()
        self.assertEqual(report["faces_removed"], 0)

    def test_a_click_on_empty_space_adds_no_undo_entry(self):
        editor = self.open(SPHERE)
        editor.click(0.06, 0.1)
        editor.wait_for_title("sphere.json - Kerf")
        report = editor.quit()
        self.assertEqual((report["undo_depth"], report["strokes"]), (0, 0))

    def test_the_last_stroke_is_recut(self):
        editor = self.open(SPHERE)
        editor.drag(ACROSS)
        editor.do("r")
        report = editor.quit()
        self.assertEqual((report["recuts"], report["strokes"]), (1, 1))
        self.assertGreater(report["faces_removed"], 100)

    def test_a_stroke_in_a_dense_mesh_is_recut_repeatedly_and_all_pieces_are_shown(self):
        editor = self.open()
        editor.drag([(0.53, 0.14), (0.53, 0.93)])
        for keys in (("r",), ("r",), ("ctrl", "a"), ("h",), ("shift", "h")):
            editor.do(*keys)
        report = editor.quit()
        self.assertGreater(report["faces"], 40000)
        self.assertEqual((report["recuts"], report["strokes"], report["pieces_hidden"]), (2, 1, 0))
        self.assertEqual(report["undo_depth"], 2 + 2 * report["pieces"])

    def test_the_last_stroke_follows_the_radius_slider_and_totals_follow_undo(self):
        editor = self.open(SPHERE)
        editor.drag(ACROSS)
        editor.drag([("radius", 0.5, 0.5), ("radius", 0.7, 0.5)])
        report = editor.quit()
        self.assertEqual(report["strokes"], 1)
        self.assertGreater(report["recuts"], 0)
        wide = report["last_stroke"]
        again = self.open_again(SPHERE)
        again.drag(ACROSS)
        again.drag(ACROSS_ABOVE)
        again.do("ctrl", "z")
        report = again.quit()
        self.assertGreater(wide["radius"], 1.5 * report["last_stroke"]["radius"])
        self.assertGreater(wide["removed_area"], 1.5 * report["last_stroke"]["removed_area"])
        self.assertEqual(report["last_stroke"]["faces_removed"], report["faces_removed"])
        self.assertGreater(report["last_stroke"]["faces_made"], 100)

    def test_a_live_recut_dropped_with_its_document_does_not_widen_the_next_one(self):
        self.open(SPHERE).quit()
        self.set(bindings={"laser.wider": "F7", "resolution.live": "F6"})
        editor = self.open_again(SPHERE)
        editor.drag(ACROSS)
        self.save_as(editor, "cut")
        editor.wait_for_title("cut.kerf - Kerf")
        editor.press_at_once(("ctrl", "n"), ("F7",))
        editor.wait_for_title("car.json - Kerf")
        editor.drag([(0.53, 0.14), (0.53, 0.93)])
        editor.do("F6")
        editor.do("F7")
        before = editor.ask("report")["last_stroke"]["radius"]
        editor.do("r")
        report = editor.quit()
        self.assertEqual((report["recuts"], report["last_stroke"]["radius"]), (1, before))

    def test_a_slider_stays_active_during_a_background_recut(self):
        editor = self.open()
        editor.drag([(0.27, 0.36), (0.8, 0.42)])
        x, y = editor.place(("radius", 0.5, 0.5))
        editor.move_to(x, y)
        editor.settle()
        editor.press_button(1, x, y)
        for along in (0.46, 0.4, 0.36):
            editor.move_to(*editor.place(("radius", along, 0.5)))
            editor.pause(0.05)
        editor.wait_until_heard("the last move")
        editor.release(1)
        editor.settle()
        report = editor.quit()
        self.assertGreater(report["faces"], 40000)
        self.assertLess(report["last_stroke"]["radius"], 0.0075)  # from 0.0122

    def test_a_split_view_cuts_the_stroke_at_two_resolutions(self):
        self.assert_split_view_works()

    def test_a_split_view_works_without_an_installed_font(self):
        self.assert_split_view_works("--own-font")

    def assert_split_view_works(self, *options):
        editor = self.open(SPHERE, *options)
        editor.press("s")
        editor.part("second")
        editor.drag([("first", 0.32, 0.5), ("first", 0.7, 0.5)])
        editor.drag([("second", 0, 0.77), (0.32, 0.77)])
        report = editor.quit()
        self.assertEqual(report["strokes"], 1)
        self.assertTrue(report["split"]["shown"])
        self.assertGreater(report["split"]["faces"], 5000)
        self.assertLess(report["split"]["faces"], report["faces"])
        first, second = report["layout"]["first"], report["layout"]["second"]
        self.assertAlmostEqual(first[2], 0.32 * report["layout"]["viewport"][2], delta=8)
        self.assertEqual(first[2] + second[2], report["layout"]["viewport"][2])

    def test_escape_and_a_stroke_close_overlays(self):
        editor = self.open(SPHERE)
        for opener, button in ((("radius",), 3), (("pattern",), 1)):
            editor.click(*opener, 0.3, 0.5, button=button)
            editor.wait_for_popup(True)
            editor.do("Escape")
            editor.wait_for_popup(False)
        editor.click("radius", 0.3, 0.5, button=3)
        editor.wait_for_popup(True)
        editor.click(0.5, 0.5)
        editor.wait_for_popup(False)
        editor.click("pattern", 0.3, 0.5)
        editor.wait_for_popup(True)
        editor.drag(ACROSS)
        report = editor.quit()
        self.assertEqual(report["strokes"], 1)
        self.assertGreater(report["faces_removed"], 100)


if __name__ == "__main__":
    unittest.main()
