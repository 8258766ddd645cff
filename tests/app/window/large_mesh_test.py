"""A mesh of 1.1 million faces, which lies outside the project."""
import json
import os
import subprocess
import unittest

from editor_window import KERF, SPHERE, WindowTest, real_input


class LargeMesh(WindowTest):
    def large_mesh(self):
        mesh = os.path.join(os.environ.get("KERF_TEST_MESHES", ""), "real", "derived", "big_bunny_x16.ply")
        if not os.path.exists(mesh):
            self.skipTest("KERF_TEST_MESHES names no folder with the large mesh")
        return mesh

    def test_a_million_faces_open_without_blocking_frames(self):
        editor = self.open(self.large_mesh())
        editor.wait_for_title("big_bunny_x16.ply - Kerf")
        report = editor.quit()
        self.assertEqual(report["faces"], 1114656)
        self.assertEqual(report["files"], ["big_bunny_x16.ply"])
        longest = report["between_pictures_ms"]["max"]
        print(f"1.1 M faces: the longest frame took {longest:.0f} ms beside drawing, "
              f"{report['process_bytes'] / report['faces']:.0f} bytes a face in the process")

    def test_a_million_faces_are_cut_live(self):
        editor = self.open(self.large_mesh())
        editor.wait_for_title("big_bunny_x16.ply - Kerf")
        editor.drag([(0.48, 0.17), (0.51, 0.9)])
        report = editor.quit()
        self.assertEqual(report["strokes"], 1)
        self.assertGreater(report["faces_removed"], 1000)
        cutting = report["while_cutting"]
        self.assertGreater(cutting["frames"], 1)
        self.assertEqual(len(cutting["each_frame_ms"]), cutting["frames"])
        for name in "frame_ms", "between_pictures_ms":
            times = ", ".join(f"{key} {value:.0f}" for key, value in cutting[name].items())
            print(f"1.1 M faces, {cutting['frames']} frames that cut: {name} {times}")

    def test_cancelling_an_upload_returns_to_the_unsaved_work(self):
        editor = self.open(SPHERE)
        editor.drag([(0.3, 0.5), (0.7, 0.5)])
        editor.wait_for_title("sphere.json* - Kerf")
        before = editor.ask("report")
        editor.press("ctrl", "o")
        editor.part("browser")
        editor.pause(1)
        editor.type(self.large_mesh())
        editor.pause(0.5)
        editor.press("Return")
        editor.part("question")
        editor.press("d")  # discards the stroke
        self.assertEqual(editor.title(), "big_bunny_x16.ply - Kerf")
        self.assertEqual(editor.ask("report")["faces"], 1114656)
        editor.do("Escape")
        editor.wait_for_title("sphere.json* - Kerf")
        report = editor.ask("report")
        self.assertEqual(report["message"], "Cancelled opening big_bunny_x16.ply; sphere.json is open again.")
        for key in "faces", "strokes", "state_hash", "files", "laser":
            self.assertEqual(report[key], before[key], key)
        editor.do("ctrl", "z")
        self.assertEqual(editor.quit()["strokes"], 0)

    def slot_journal(self, mesh):
        """The mesh cut in two large pieces, and a small one, by a stroke of more than 16 MB of before-images."""
        journal = os.path.join(self.folder, "slot.kerf")
        path = os.path.join(self.folder, "path.json")
        keys = [{"t": t, "origin": [-0.0168, y, -0.157], "direction": [0, 0, 1]} for t, y in ((0, 0.001), (1, 0.22))]
        with open(path, "w") as file:
            json.dump({"strokes": [{"laser": {"radius": 0.0003}, "keys": keys}]}, file)
        subprocess.run([KERF, "cut", mesh, "--path", path, "--out", os.path.join(self.folder, "pieces"),
                        "--target-edge", "0.00015", "--steps", "400", "--journal", journal], check=True)
        return journal

    @unittest.skipUnless("KERF_LONG" in os.environ, "one of the tests of ./tests/run --long")
    def test_a_large_detach_and_an_undo_by_replay_do_not_block_frames(self):
        mesh = self.large_mesh()
        self.open(SPHERE).quit()
        with open(self.settings_file(), "w") as file:
            json.dump({"history_mb": 16}, file)
        editor = self.open_again(self.slot_journal(mesh))
        editor.wait_for_title("slot.kerf - Kerf")
        editor.key_down("ctrl")
        editor.click(0.64, 0.63)
        editor.key_up("ctrl")
        editor.do("h")
        editor.wait_for_title("slot.kerf* - Kerf")
        editor.do("ctrl", "z")
        editor.do("ctrl", "z")
        report = editor.quit()
        self.assertEqual((report["undo_depth"], report["strokes"], report["bodies"], report["pieces"]), (0, 0, 1, 1))
        self.assertEqual(report["faces"], 1114656)
        print(f"1.1 M faces: the longest frame took {report['between_pictures_ms']['max']:.0f} ms beside drawing")

    @real_input
    def test_cancelling_an_open_changes_nothing(self):
        editor = self.open()
        before = editor.quit()["faces"]
        editor = self.open()
        editor.drop(self.large_mesh(), seconds=0)  # opening takes less than a second
        editor.press("Escape")
        editor.pause(6)
        report = editor.quit()
        self.assertEqual(report["faces"], before)
        self.assertIn("Cancelled", report["message"])


if __name__ == "__main__":
    unittest.main()
