"""The path of the laser: its points, its file, its run against `kerf cut --path`, holes; and the emitter."""
import json
import os
import subprocess
import tempfile
import time
import unittest

from editor_window import ACROSS, ASSETS, KERF, SPHERE, WindowTest, real_input

PLATE = os.path.join(ASSETS, "scenes", "thin-plate.json")


def mesh(name):
    return os.path.join(ASSETS, "meshes", name)


def commands_of(journal):
    with open(journal) as file:
        lines = [json.loads(line) for line in file]
    return [line for line in lines if "do" in line]


class Path(WindowTest):
    def open_path(self, *arguments):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.only_panel("path")
        return self.open_again(*arguments)

    def write_path(self, strokes, radius):
        """A path file of strokes from above, across the sphere."""
        file = os.path.join(self.folder, "path.json")
        keys = lambda z: [{"t": t, "origin": [x, 1, z], "direction": [0.1, -2, 0]} for t, x in ((0, -0.3), (2, 0.3))]
        with open(file, "w") as text:
            json.dump({"strokes": [{"laser": {"radius": radius}, "keys": keys(z)} for z in strokes]}, text)
        return file

    def expect_same_cut(self, path, journal, mesh_file):
        """The journal of the editor holds what `kerf cut --path` does with the path, and its end is the same."""
        out, cut = os.path.join(self.folder, "out"), os.path.join(self.folder, "cut.kerf")
        subprocess.run([KERF, "cut", mesh_file, "--path", path, "--out", out, "--journal", cut], check=True,
                       stderr=subprocess.DEVNULL)
        self.assertEqual(commands_of(journal), commands_of(cut))
        with open(os.path.join(out, "report.json")) as file:
            state = json.load(file)["state_hash"]
        subprocess.run([KERF, "replay", journal, "--expect", state], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)

    def test_clicked_points_are_moved_deleted_and_restored(self):
        editor = self.open_path(SPHERE)
        editor.press("o")
        editor.click(0.44, 0.5)
        editor.click(0.56, 0.5)
        editor.key_down("shift")
        editor.click(0.5, 0.62)
        editor.key_up("shift")
        before = editor.landmarks()["parts"]
        x, y = editor.place(("path point 0", 0.5, 0.5))
        editor.drag_pixels([(x, y), (x, y - 50)])
        x, y = editor.place(("path knob", 0.5, 0.5))
        editor.drag_pixels([(x, y), (x + 40, y)])
        after = editor.landmarks()["parts"]
        self.assertAlmostEqual(after["path point 0"][1], before["path point 0"][1] - 50, delta=3)
        self.assertEqual(after["path point 1"], before["path point 1"])
        editor.click("path point 2", 0.5, 0.5)
        editor.do("BackSpace")
        editor.do("Delete")
        self.assertEqual(sorted(n for n in editor.landmarks()["parts"] if n.startswith("path point")), ["path point 0"])
        editor.do("ctrl", "z")
        editor.do("ctrl", "z")
        report = editor.quit()
        self.assertEqual((report["path"]["strokes"], len(report["path"]["targets"])), (2, 3))
        self.assertEqual((report["undo_depth"], report["strokes"]), (0, 0))

    def open_drawing(self, text, name="drawing.svg", *options):
        """Drops a drawing on the sphere."""
        editor = self.open_path(SPHERE)
        drawing = os.path.join(self.folder, name)
        with open(drawing, "w") as file:
            file.write(text)
        editor.settle()
        editor.drop(drawing)
        editor.settle()
        return editor

    SQUARE = ('<svg width="500mm" height="250mm" viewBox="0 0 500 250"><rect width="400" height="200" x="10" y="10" '
              'stroke="red"/><text>A</text></svg>')

    def test_a_dropped_drawing_is_moved_scaled_turned_and_removed(self):
        editor = self.open_drawing(self.SQUARE)
        first = editor.ask("report")
        self.assertAlmostEqual(first["drawing"]["width"], 0.4)
        self.assertEqual(first["drawing"]["points"], first["drawing"]["points_on_surface"])
        self.assertIn("left out: 1 text", first["messages"][-1])
        x, y = editor.place(("drawing", 0.5, 0.5))
        corner = editor.place(("drawing corner 2", 0.5, 0.5))
        editor.drag_pixels([corner, (2 * corner[0] - x, 2 * corner[1] - y)])
        scaled = editor.ask("report")["drawing"]
        self.assertAlmostEqual(scaled["width"], 0.8, delta=0.02)
        knob = editor.place(("drawing turn", 0.5, 0.5))
        editor.key_down("shift")
        editor.drag_pixels([knob, (x - 100, y + 3)])
        editor.key_up("shift")
        self.assertAlmostEqual(editor.ask("report")["drawing"]["turn"], 90)
        editor.drag_pixels([(x, y), (x + 40, y - 40)])
        moved = editor.ask("report")
        self.assertGreater(moved["drawing"]["at"][0], first["drawing"]["at"][0])
        self.assertGreater(moved["drawing"]["at"][1], first["drawing"]["at"][1])
        self.assertEqual((moved["undo_depth"], moved["state_hash"]), (0, first["state_hash"]))
        editor.do("Escape")
        report = editor.quit()
        self.assertNotIn("drawing", report)
        self.assertEqual((report["undo_depth"], report["state_hash"]), (0, first["state_hash"]))

    def test_a_drawing_named_with_a_broken_mesh_is_not_placed_on_the_default_scene(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.write_settings({})
        broken, drawing = (os.path.join(self.folder, name) for name in ("broken.stl", "drawing.svg"))
        for file, text in ((broken, "solid nothing\nfacet normal none\n"), (drawing, self.SQUARE)):
            with open(file, "w") as output:
                output.write(text)
        self.assertIn("drawing", self.open_again(drawing).quit())
        report = self.open_again(broken, drawing).quit()
        self.assertEqual(report["files"], ["car.json"])
        self.assertIn("broken.stl", report["message"])
        self.assertNotIn("drawing", report)

    def test_esc_stops_the_emitter_before_it_removes_a_drawing(self):
        editor = self.open_drawing(self.SQUARE)
        editor.point_at(0.1, 0.1)
        editor.do("shift", "u")
        editor.part("emitter target")
        editor.do("u")
        self.assertTrue(editor.ask("report")["emitter"]["firing"])
        editor.do("Escape")
        report = editor.ask("report")
        self.assertFalse(report["emitter"]["firing"])
        self.assertIn("drawing", report)
        editor.do("Escape")
        self.assertNotIn("drawing", editor.quit())

    def test_a_drawing_along_the_view_is_cut_by_the_knife_and_its_journal_repeats_it(self):
        editor = self.open_drawing(self.SQUARE.replace("400", "200").replace('"200" x', '"100" x'))
        whole = editor.ask("report")["state_hash"]
        for row, number in (("drawing mode", 2), ("drawing with", 1)):
            editor.click(row, 0.5, 0.5)
            editor.click(f"{row} {number}", 0.5, 0.5)
        editor.click("header drawing.cut", 0.5, 0.5)
        editor.settle()
        report = editor.ask("report")
        self.assertEqual((report["pieces"], report["faces_removed"]), (3, 0))
        self.save_as(editor, "drawing")
        editor.wait_for_title("drawing.kerf - Kerf")
        subprocess.run([KERF, "replay", os.path.join(self.folder, "drawing.kerf"), "--expect", report["state_hash"]],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        editor.do("ctrl", "z")
        self.assertEqual(editor.quit()["state_hash"], whole)

    def test_a_drawing_is_cut_by_the_laser_as_one_step(self):
        editor = self.open_drawing('<svg width="90mm" height="90mm" viewBox="0 0 90 90"><path d="M30 30h50v50z"/></svg>')
        whole = editor.ask("report")["state_hash"]
        editor.do("Return")
        editor.settle()
        report = editor.ask("report")
        self.assertGreater(report["faces_removed"], 0)
        self.assertGreater(report["pieces"], 1)
        editor.do("ctrl", "z")
        self.assertEqual(editor.quit()["state_hash"], whole)

    def test_a_drawing_is_recut_and_undone_as_a_whole(self):
        lines = "".join(f'<path d="M20 {y}h50"/>' for y in (20, 40, 60))
        editor = self.open_drawing(f'<svg width="90mm" height="90mm" viewBox="0 0 90 90">{lines}</svg>')
        whole = editor.ask("report")["state_hash"]
        editor.do("Return")
        editor.settle()
        narrow = editor.ask("report")
        editor.drag([("header radius", 0.5, 0.5), ("header radius", 0.7, 0.5)])
        editor.settle()
        wide = editor.ask("report")
        self.assertEqual([r["strokes"] for r in (narrow, wide)], [3, 3])
        self.assertEqual((wide["recuts"], wide["undo_depth"]), (1, 3))
        times = wide["last_stroke"]["radius"] / narrow["last_stroke"]["radius"]
        self.assertGreater(times, 1.2)
        self.assertGreater(wide["removed_area"], 0.5 * (1 + times) * narrow["removed_area"])
        self.save_as(editor, "drawing")
        editor.wait_for_title("drawing.kerf - Kerf")
        editor.quit()
        again = self.open_again(os.path.join(self.folder, "drawing.kerf"))
        again.wait_for_title("drawing.kerf - Kerf")
        again.do("ctrl", "z")
        report = again.quit()
        self.assertEqual((report["state_hash"], report["messages"][-1]), (whole, "Undo: Cut drawing"))

    def test_lines_that_the_thermal_beam_does_not_cut_through_are_marked_until_undo(self):
        editor = self.open(PLATE)
        drawing = os.path.join(self.folder, "a.svg")
        with open(drawing, "w") as file:
            file.write('<svg width="90mm" height="90mm" viewBox="0 0 90 90"><path d="M20 20h50v30"/></svg>')
        editor.click("laser model", 0.5, 0.5)
        editor.do("Down")
        editor.do("Return")
        for panel in ("panel laser", "panel resolution", "panel pieces", "panel history"):
            editor.click(panel, 0.3, 0.5)
        editor.drop(drawing)
        editor.click("Speed", 0.5, 0.5)
        editor.press("ctrl", "a")
        editor.type("2 m/s")
        editor.do("Return")
        editor.click("header drawing.cut", 0.5, 0.5)
        editor.settle()
        report = editor.ask("report")
        self.assertEqual((report["uncut_lines"], report["faces_removed"]), (1, 0))
        self.assertTrue(editor.shows("uncut lines"))
        editor.do("ctrl", "z")
        self.assertNotIn("uncut_lines", editor.quit())

    def test_a_program_is_a_path_whose_uncut_strokes_are_marked_until_undo(self):
        editor = self.open(SPHERE)
        program = os.path.join(self.folder, "a.nc")
        with open(program, "w") as file:
            file.write("G21 G90\nG0 X-100 Y0 Z2000\nM3 S1\nG1 X200 F120000\nG1 Y100\nM5\n")
        editor.click("laser model", 0.5, 0.5)
        editor.do("Down")
        editor.do("Return")
        editor.drop(program)
        editor.settle()
        self.assertEqual(editor.ask("report")["path"]["strokes"], 1)
        editor.do("ctrl", "Return")
        editor.settle()
        report = editor.ask("report")
        self.assertEqual((report["uncut_lines"], report["faces_removed"]), (1, 0))
        self.assertTrue(editor.shows("uncut lines"))
        editor.do("ctrl", "z")
        self.assertNotIn("uncut_lines", editor.quit())

    def test_a_path_that_meets_no_surface_does_not_count_as_run(self):
        editor = self.open(SPHERE)
        program = os.path.join(self.folder, "aside.nc")
        with open(program, "w") as file:
            file.write("G21 G90\nG0 X90000 Y0 Z2000\nM3 S1\nG1 X90200 F120000\nM5\n")
        editor.drop(program)
        editor.settle()
        editor.do("ctrl", "Return")
        editor.settle()
        self.assertIn("Path meets no surface.", editor.ask("report")["messages"])
        editor.press("l")
        editor.drag(ACROSS)
        editor.press("o")
        editor.do("ctrl", "z")  # of the path, which is still to be run
        report = editor.quit()
        self.assertEqual((report["path"]["strokes"], report["undo_depth"]), (0, 1))

    def test_a_faulty_drawing_leaves_a_message_and_nothing_else(self):
        editor = self.open_drawing("<svg><path d='M0 0 L'/></svg>")
        report = editor.quit()
        self.assertNotIn("drawing", report)
        self.assertIn("drawing.svg", report["messages"][-1])

    def test_a_saved_path_runs_like_kerf_cut(self):
        editor = self.open_path(SPHERE)
        editor.press("o")
        for at in ((0.4, 0.45), (0.5, 0.55), (0.6, 0.45)):
            editor.click(*at)
        editor.click("Save", 0.5, 0.5)
        self.type_name(editor, "clicked")
        path, journal = (os.path.join(self.folder, name) for name in ("clicked.json", "run.kerf"))
        editor.wait_for(lambda: os.path.exists(path), "the path was not saved")
        editor.do("ctrl", "Return")
        self.save_as(editor, "run")
        editor.wait_for_title("run.kerf - Kerf")
        report = editor.quit()
        self.assertEqual(report["strokes"], 1)
        self.assertGreater(report["faces_removed"], 0)
        self.expect_same_cut(path, journal, mesh("sphere.obj"))

    def test_a_dropped_path_runs_like_kerf_cut_and_its_speed_can_be_typed(self):
        editor = self.open_path(SPHERE)
        path = self.write_path([0.05, -0.05], 0.006)
        editor.drop(path)
        editor.part("path point 3")
        editor.click("Run", 0.5, 0.5)
        self.save_as(editor, "run")
        editor.wait_for_title("run.kerf - Kerf")
        editor.click("Speed", 0.5, 0.5)
        editor.press("ctrl", "a")
        editor.type("600")  # the field is in mm/s
        editor.do("Return")
        report = editor.quit()
        self.assertEqual((report["strokes"], report["undo_depth"]), (2, 2))
        self.assertAlmostEqual(report["path"]["speed"], 0.6)
        self.expect_same_cut(path, os.path.join(self.folder, "run.kerf"), mesh("sphere.obj"))

    def test_a_path_dropped_with_a_mesh_belongs_to_it_and_is_dropped_on_cancel(self):
        editor = self.open(SPHERE)
        path = self.write_path([0.05, -0.05], 0.006)
        editor.drag(ACROSS)
        for key, title, strokes in (("Escape", "sphere.json* - Kerf", 0), ("d", "plate.obj* - Kerf", 2)):
            editor.drop(mesh("plate.obj"), path)
            editor.part("question")
            editor.do(key)
            editor.wait_for_title(title)
            self.assertEqual(editor.ask("report")["path"]["strokes"], strokes)
        editor.quit()

    @real_input
    def test_a_cancelled_run_leaves_no_trace(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        path = self.write_path([-0.2 + 0.002 * i for i in range(200)], 0.0006)
        self.only_panel("path")
        editor = self.open_again(SPHERE, path)
        editor.point_at(0.1, 0.1)
        editor.press("ctrl", "Return")
        editor.pause(2)
        editor.press("Escape")
        editor.settle()
        report = editor.quit()
        self.assertEqual((report["undo_depth"], report["strokes"], report["faces_removed"]), (0, 0, 0))
        self.assertIn("Path stopped; nothing was cut.", report["messages"])
        self.assertEqual(report["path"]["strokes"], 200)

    def test_a_grid_of_holes_around_a_clicked_point_drills_the_plate(self):
        editor = self.open_path(PLATE)
        editor.press("o")
        editor.click(0.5, 0.5)
        self.assertNotIn("hole preview", editor.landmarks()["parts"])
        editor.click("Holes header", 0.3, 0.5)
        _, _, width, height = editor.part("hole preview")
        self.assertGreater(width, height)  # of three rows of four
        editor.click("add holes", 0.5, 0.5)
        editor.do("ctrl", "Return")
        editor.do("ctrl", "z")
        editor.do("ctrl", "shift", "z")
        report = editor.quit()
        self.assertEqual(report["messages"][-2:], ["Undo: Run path", "Redo: Run path"])
        self.assertEqual((report["path"]["strokes"], report["strokes"]), (12, 12))
        self.assertEqual(report["pieces"], 1 + 2 * 12)  # of each hole a disc of the front and one of the back

    def test_a_path_is_recovered_with_its_own_document_after_a_crash(self):
        editor = self.open_path(SPHERE)
        editor.press("o")
        editor.click(0.45, 0.5)
        editor.click(0.55, 0.5)
        editor.pause(1.5)
        targets = [editor.landmarks()["parts"][f"path point {i}"] for i in range(2)]
        editor.die()
        other = self.open_again(PLATE)
        other.press("Escape")  # the lost work waits
        self.assertEqual(other.quit()["path"]["targets"], [])
        editor = self.open_again()
        editor.press("Return")
        editor.part("path point 1")
        parts = editor.landmarks()["parts"]
        self.assertEqual([parts[f"path point {i}"] for i in range(2)], targets)

    def test_path_and_emitter_are_saved_with_their_document_and_absent_from_a_new_one(self):
        editor = self.open_path(SPHERE)
        editor.press("o")
        editor.click(0.45, 0.5)
        editor.do("shift", "u")
        self.save_as(editor, "planned")
        editor.wait_for_title("planned.kerf - Kerf")
        editor.do("ctrl", "n")
        editor.wait_for(lambda: "path point 0" not in editor.landmarks()["parts"], "the path is still there")
        editor.quit()
        journal = os.path.join(self.folder, "planned.kerf")
        editor = self.open_again(journal)
        editor.part("path point 0")
        editor.part("emitter target")
        self.assertEqual(editor.title(), "planned.kerf - Kerf")
        report = editor.quit()
        self.assertEqual((len(report["path"]["targets"]), report["emitter"]["placed"]), (1, True))

    def test_the_emitter_cuts_while_moved_and_one_undo_reverts_the_stroke(self):
        editor = self.open(SPHERE)
        editor.point_at(0.1, 0.1)
        editor.do("shift", "u")
        editor.part("emitter target")
        editor.do("u")
        x, y = editor.place(("emitter target", 0.5, 0.5))
        editor.drag_pixels([(x, y), (x + 60, y)])
        x, y = editor.place(("emitter body", 0.5, 0.5))
        editor.drag_pixels([(x, y), (x - 60, y)])
        editor.do("u")
        self.save_as(editor, "fired")
        editor.wait_for_title("fired.kerf - Kerf")
        moves = [c for c in commands_of(os.path.join(self.folder, "fired.kerf")) if c["do"] == "move-beam"]
        editor.do("ctrl", "z")
        report = editor.quit()
        self.assertGreater(len(moves), 10)
        self.assertEqual(sorted(m["t"] for m in moves), [m["t"] for m in moves])
        self.assertEqual((report["strokes"], report["undo_depth"], report["emitter"]["firing"]), (0, 0, False))

    @real_input
    def test_the_emitter_fires_at_the_typed_rate(self):
        self.open(SPHERE).quit()
        self.only_panel("laser")
        editor = self.open_again(SPHERE)
        editor.point_at(0.1, 0.1)
        editor.do("shift", "u")
        editor.click("emitter fires", 0.5, 0.5)
        editor.click("emitter fires 1", 0.5, 0.5)
        editor.click("Shot Rate", 0.5, 0.5)
        editor.press("ctrl", "a")
        editor.type("2")
        editor.do("Return")
        editor.point_at(0.9, 0.9)
        editor.press("u")
        began = time.monotonic()
        x, y = editor.place(("emitter target", 0.5, 0.5))
        editor.move_to(x, y)
        editor.pause(0.3)
        editor.hold(1)
        for i in range(1, 31):
            editor.move_to(x + 3 * i, y)
            editor.pause(0.1)
            editor.wait_until_heard("a move")
        editor.release(1)
        editor.do("u")
        took = time.monotonic() - began
        report = editor.quit()
        self.assertEqual((report["emitter"]["in_shots"], report["emitter"]["pace"]), (True, 2))
        self.assertFalse(report["emitter"]["firing"])
        self.assertGreater(report["strokes"], 2)
        self.assertLessEqual(report["strokes"], 2 * took + 1)

    def test_an_emitter_at_its_target_is_refused_with_a_reason(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.only_panel("laser")
        editor = self.open_again(SPHERE)
        editor.point_at(0.1, 0.1)
        editor.do("shift", "u")
        for field in ("Target", "Position"):
            for axis in range(3):
                editor.click(f"{field} {axis}", 0.5, 0.5)
                editor.press("ctrl", "a")
                editor.type("3")
                editor.do("Return")
        report = editor.quit()
        self.assertIn("Position stays the same: it must differ from the target", report["messages"][-1])
        self.assertEqual(report["emitter"]["at"][:2], report["emitter"]["target"][:2])
        self.assertNotEqual(report["emitter"]["at"], report["emitter"]["target"])


if __name__ == "__main__":
    unittest.main()
