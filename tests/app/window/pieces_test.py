"""Choosing, hiding, renaming and exporting pieces, and what the window shows of them."""
import json
import os
import subprocess
import unittest

from editor_window import ACROSS, ASSETS, KERF, SPHERE, WindowTest, real_input


class Pieces(WindowTest):
    def test_keys_toggle_overlays_and_the_theme_which_is_remembered(self):
        editor = self.open()
        for key in ("b", "w", "g"):
            editor.press(key)
        editor.press("F9")
        editor.pause(1)
        view = editor.quit()["view"]
        self.assertEqual([view[name] for name in ("boxes", "wire", "ghost", "normals")], [True, True, True, False])
        self.assertEqual(self.settings()["theme"], "light")

    def test_keys_toggle_shadow_views_and_a_light_can_be_dragged(self):
        editor = self.open(SPHERE)
        for key in ("d", "e", "v", "c", "t", "x"):
            editor.press(key)
        editor.pause(1)
        view = editor.quit()["view"]
        names = ("silhouette", "shadow_counts", "shadow_facing", "shadow_compare")
        self.assertEqual(view["shadows"], "none")  # after all
        self.assertTrue(all(view[name] for name in names))
        self.assertFalse(view["shadow_volumes"])  # the counts exclude them

        settings = self.settings()
        settings["panels"]["light"], settings["tab"] = True, "view"
        with open(self.settings_file(), "w") as file:
            json.dump(settings, file)
        editor = self.open_again(SPHERE)
        light = editor.quit()["lights"][0]
        editor = self.open_again(SPHERE)
        x, y = editor.place(("light 0", 0.5, 0.5))
        editor.drag_pixels([(x, y), (x + 50, y + 30)])
        report = editor.quit()
        moved = report["lights"][0]
        self.assertEqual(report["strokes"], 0)
        self.assertNotEqual(moved["at"], light["at"])
        self.assertLess(abs(moved["handle"][0] - x - 50) + abs(moved["handle"][1] - y - 30), 6)

    def test_a_piece_is_picked_and_hidden(self):
        editor = self.open(SPHERE)
        editor.press("k")
        editor.click(0.5, 0.53)
        editor.press("h")
        report = editor.quit()
        self.assertEqual((report["pieces_hidden"], report["pieces_chosen"], report["strokes"]), (1, 0, 0))

    def test_pieces_are_selected_by_a_box_and_isolated(self):
        editor = self.open(SPHERE)
        editor.drag([(0.2, 0.5), (0.8, 0.5)])
        editor.key_down("ctrl")
        editor.drag([(0.9, 0.2), (0.1, 0.3)])  # from right to left, over the upper half alone
        editor.key_up("ctrl")
        editor.do("slash")
        editor.do("slash")
        report = editor.quit()
        self.assertEqual((report["pieces"], report["pieces_chosen"], report["pieces_hidden"]), (2, 1, 0))
        self.assertEqual(report["undo_depth"], 3)  # the stroke, one half hidden, and shown again

    def test_one_undo_reverts_isolating_many_pieces(self):
        editor = self.open(SPHERE)
        for down in (0.35, 0.5, 0.65):
            editor.drag([(0.2, down), (0.8, down)])
        editor.press("k")
        editor.click(0.5, 0.42)
        editor.do("slash")
        editor.do("ctrl", "z")
        editor.do("ctrl", "shift", "z")
        editor.do("ctrl", "z")
        report = editor.quit()
        self.assertEqual((report["pieces"], report["pieces_hidden"], report["undo_depth"]), (4, 0, 3))

    def test_a_piece_hidden_after_show_all_stays_hidden_when_another_is_isolated(self):
        editor = self.open(SPHERE)
        for down in (0.35, 0.5, 0.65):
            editor.drag([(0.2, down), (0.8, down)])
        editor.press("k")
        editor.click(0.5, 0.42)
        editor.do("slash")
        editor.do("shift", "h")
        editor.do("Escape")
        editor.click(0.5, 0.58)
        editor.do("h")
        editor.click(0.5, 0.42)
        editor.do("slash")
        report = editor.quit()
        self.assertEqual((report["pieces"], report["pieces_chosen"], report["pieces_hidden"]), (4, 1, 3))

    def picture(self, editor):
        """The colours of the picture at points of a grid, once it is smooth, while the pointer is in a corner."""
        editor.point_at(0.02, 0.04)
        x, y, width, height = editor.part("viewport")
        points = [(round(x + width * i / 100), round(y + height * j / 100)) for i in range(8, 92) for j in range(8, 92)]
        last = None
        for _ in range(20):
            pixel = editor.pixels()
            now = [pixel(*point) for point in points]
            if now == last:
                break
            last = now
            editor.pause(1.5)
        return now

    def changed(self, before, after):
        """The share of the points whose colour is another."""
        return sum(max(abs(a - b) for a, b in zip(p, q)) > 24 for p, q in zip(before, after)) / len(before)

    def test_a_piece_looks_unchanged_after_it_is_hidden_and_shown(self):
        self.open(SPHERE).quit()
        self.set(antialias=False)  # how edges are smoothed depends on how long pictures take
        editor = self.open_again()
        editor.drag([(0.53, 0.14), (0.53, 0.93)])
        editor.press("k")
        before = self.picture(editor)
        editor.click(0.42, 0.6)
        editor.do("h")
        self.assertGreater(self.changed(before, self.picture(editor)), 0.02)
        editor.do("shift", "h")
        self.assertLess(self.changed(before, self.picture(editor)), 0.002)
        self.assertEqual(editor.quit()["pieces_hidden"], 0)

    def test_an_export_offers_its_formats_and_names_files_after_pieces(self):
        self.open(SPHERE).quit()
        self.set(folder=self.folder)
        editor = self.open_again(SPHERE)
        editor.point_at(0.5, 0.5)
        editor.do("ctrl", "a")
        editor.do("ctrl", "e")
        editor.click("format PLY", 0.3, 0.5)
        editor.press("Return")
        editor.wait_for(lambda: os.path.exists(os.path.join(self.folder, "sphere.ply")), "no file was written")
        editor.quit()

    def comb_without_teeth(self):
        """The journal of a bar from which a stroke has cut the tips of twelve teeth."""
        mesh, path, journal = (os.path.join(self.folder, name) for name in ("comb.obj", "path.json", "comb.kerf"))
        corners = [(0.1 * x, y, 0) for y in (0, 1, 1.1, 1.102) for x in range(24)]
        quads = [(0, x) for x in range(23)] + [(y, x) for y in (1, 2) for x in range(0, 24, 2)]
        with open(mesh, "w") as file:
            file.writelines(f"v {x} {y} {z}\n" for x, y, z in corners)
            for y, x in quads:
                a = 24 * y + x + 1
                file.write(f"f {a} {a + 1} {a + 25} {a + 24}\n")
        keys = [{"t": t, "origin": [x, 1.05, 1], "direction": [0, 0, -1]} for t, x in ((0, -0.1), (1, 2.5))]
        with open(path, "w") as file:
            json.dump({"strokes": [{"laser": {"radius": 0.03}, "keys": keys}]}, file)
        subprocess.run([KERF, "cut", mesh, "--path", path, "--out", os.path.join(self.folder, "pieces"),
                        "--depth", "0", "--journal", journal], check=True, capture_output=True)
        return journal

    def test_clicking_the_pin_or_eye_of_a_row_pins_or_hides_the_piece(self):
        self.open(SPHERE).quit()
        self.only_panel("pieces")
        editor = self.open_again(SPHERE)
        editor.click("pin sphere", 0.5, 0.5)
        editor.click("eye sphere", 0.5, 0.5)
        report = editor.quit()
        self.assertEqual((report["undo_depth"], report["pieces_hidden"]), (2, 1))
        self.assertTrue(report["placements"][0]["pinned"])
        self.assertEqual(report["pieces_chosen"], 0)

    def test_the_solid_checkbox_toggles_a_closed_piece_and_each_change_is_undoable(self):
        self.open(SPHERE).quit()
        self.only_panel("material")
        editor = self.open_again(SPHERE)
        editor.click("solid", 0.5, 0.5)
        report = editor.quit()
        self.assertEqual((report["undo_depth"], report["placements"][0]["solid"]), (1, True))
        editor = self.open_again(SPHERE)
        editor.click("solid", 0.5, 0.5)
        editor.click("solid", 0.5, 0.5)
        editor.press("ctrl", "z")
        report = editor.quit()
        self.assertEqual((report["undo_depth"], report["placements"][0]["solid"]), (1, True))
        self.assertEqual(report["messages"][-1], "Undo: Make sphere a sheet")

    def test_a_stroke_through_an_open_solid_reports_why_it_stays_a_sheet(self):
        with open(os.path.join(ASSETS, "meshes", "sphere.obj")) as file:
            lines = file.readlines()
        lines.remove(next(line for line in lines if line.startswith("f ")))
        self.open(SPHERE).quit()
        scene = os.path.join(self.folder, "open.json")
        with open(os.path.join(self.folder, "open.obj"), "w") as file:
            file.writelines(lines)
        with open(SPHERE) as file:
            described = json.load(file)
        described["bodies"] = [{"mesh": "open.obj", "name": "eggshell", "solid": True}]
        with open(scene, "w") as file:
            json.dump(described, file)
        editor = self.open_again(scene)
        editor.drag(ACROSS)
        report = editor.quit()
        self.assertEqual(report["undo_depth"], 1)
        self.assertGreater(report["faces_removed"], 0)
        self.assertTrue(report["message"].startswith("eggshell: "), report["message"])

    def test_specks_are_counted_separately_in_a_row_that_a_click_unfolds(self):
        self.open(SPHERE).quit()
        self.only_panel("pieces")
        editor = self.open_again(self.comb_without_teeth())
        editor.wait_for_title("comb.kerf - Kerf")
        editor.part("specks")
        teeth = lambda: [name for name in editor.landmarks()["parts"] if name.startswith("piece comb ")]
        self.assertEqual(teeth(), [])
        editor.click("specks", 0.5, 0.5)
        editor.wait_for(teeth, "no speck is listed")
        report = editor.quit()
        self.assertEqual((report["pieces"], report["specks"]), (13, 12))

    def test_the_eye_of_the_specks_hides_and_shows_them_and_keeps_the_selection(self):
        self.open(SPHERE).quit()
        self.only_panel("pieces")
        editor = self.open_again(self.comb_without_teeth())
        editor.wait_for_title("comb.kerf - Kerf")
        editor.click("piece comb", 0.5, 0.5)
        for hidden in (12, 0):
            editor.click("eye specks", 0.5, 0.5)
            editor.settle()
            report = editor.ask("report")
            self.assertEqual((report["pieces_hidden"], report["pieces_chosen"]), (hidden, 1))
        editor.do("ctrl", "z")
        self.assertEqual(editor.quit()["messages"][-1], "Undo: Show specks")

    def double_click_for(self, editor, part, *point):
        """Double clicks until the part is there. On a busy machine two clicks may come too far apart to be one."""
        editor.point_at(*point)
        for _ in range(6):
            editor.double_click()
            if part in editor.landmarks()["parts"]:
                return
        editor.part(part)

    def test_a_double_click_renames_a_piece_and_undo_restores_the_name(self):
        self.open(SPHERE).quit()
        self.only_panel("pieces")
        editor = self.open_again(SPHERE)
        for name, end in (("half of a ball", "Return"), ("nothing", "Escape")):
            where = "piece sphere" if end == "Return" else "piece half of a ball"
            self.double_click_for(editor, "new name", where, 0.2, 0.5)
            editor.type(name)
            editor.pause(0.5)
            editor.do(end)
            editor.part("piece half of a ball")
        editor.do("ctrl", "z")
        editor.part("piece sphere")
        editor.do("ctrl", "shift", "z")
        self.save_as(editor, "named")
        editor.wait_for_title("named.kerf - Kerf")
        editor.quit()
        with open(os.path.join(self.folder, "named.kerf")) as file:
            self.assertIn('"half of a ball"', file.read())

    def test_f2_renames_the_selected_piece_and_requires_a_selection(self):
        self.open(SPHERE).quit()
        self.only_panel("light")
        editor = self.open_again(SPHERE)
        editor.point_at(0.9, 0.9)
        editor.do("F2")
        self.assertNotIn("new name", editor.landmarks()["parts"])
        editor.press("k")
        editor.click(0.5, 0.53)
        editor.press("F2")  # unfolds the list
        editor.part("new name")
        editor.type("ball")
        editor.pause(0.5)
        editor.do("Return")
        editor.part("piece ball")
        report = editor.quit()
        self.assertEqual((report["undo_depth"], report["strokes"]), (1, 0))

    def rename_by_f2(self, hide):
        """Where `hide` has put the list out of sight, F2, a name and Enter, all within a frame."""
        self.open(SPHERE).quit()
        self.write_settings({"panels": {panel: panel != "graph" for panel in self.settings()["panels"]}})
        editor = self.open_again(SPHERE)
        editor.press("k")
        editor.click(0.5, 0.53)
        hide(editor)
        self.assertNotIn("piece sphere", editor.landmarks()["parts"])
        editor.press_at_once(("F2",), "wing d p c", ("Return",))
        editor.settle()
        editor.part("piece wing d p c")
        report = editor.quit()
        self.assertEqual((report["undo_depth"], report["strokes"], report["time"]["playing"]), (1, 0, False))
        self.assertFalse(report["view"]["shadow_counts"])

    def test_f2_reveals_the_list_from_another_tab(self):
        self.rename_by_f2(lambda editor: editor.do("alt", "2"))

    def test_f2_reveals_the_list_in_a_hidden_sidebar(self):
        self.rename_by_f2(lambda editor: editor.do("F4"))

    def test_f2_reveals_the_list_in_a_folded_panel(self):
        self.rename_by_f2(lambda editor: editor.click("panel pieces", 0.5, 0.5))

    def test_f2_reveals_the_list_after_scrolling_away(self):
        self.rename_by_f2(lambda editor: None)  # the panels above it fill the column

    def test_hiding_the_list_accepts_the_typed_name_and_reopens_no_field(self):
        self.open(SPHERE).quit()
        self.only_panel("pieces")
        editor = self.open_again(SPHERE)
        self.double_click_for(editor, "new name", "piece sphere", 0.2, 0.5)
        editor.type("ball")
        editor.click("tab view", 0.5, 0.5)
        editor.click("tab cut", 0.5, 0.5)
        editor.part("piece ball")
        self.assertNotIn("new name", editor.landmarks()["parts"])
        self.assertEqual(editor.quit()["undo_depth"], 1)

    def test_a_smaller_window_keeps_panels_and_viewport_apart(self):
        editor = self.open()
        editor.resize(800, 600)
        layout = editor.quit()["layout"]
        self.assertEqual(layout["viewport"][2] + layout["side"][2], 800)
        self.assertGreaterEqual(layout["viewport"][2], 320)
        self.assertEqual(layout["status"][1] + layout["status"][3], 600)


if __name__ == "__main__":
    unittest.main()
