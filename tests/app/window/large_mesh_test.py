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
