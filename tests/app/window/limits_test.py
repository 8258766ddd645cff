"""The editor where the machine has less than it wants: nothing that was made is lost."""
import os
import unittest

from editor_window import ACROSS, SPHERE, WindowTest, real_input


class Limits(WindowTest):
    @real_input
    def test_work_is_kept_when_the_display_is_lost(self):
        editor = self.open(SPHERE)
        editor.drag(ACROSS)
        editor.settle()
        editor.screen.kill()
        editor.screen.wait()
        self.assertEqual(editor.kerf.wait(timeout=60), 1, "it ends by itself, not by a signal")
        editor.close()
        again = self.open_again(SPHERE)
        again.press("Return")
        again.wait_for_title("sphere.json* - Kerf")
        self.assertEqual(again.quit()["strokes"], 1)

    def test_without_a_folder_for_unsaved_work_it_says_so_and_cuts_all_the_same(self):
        editor = self.open(SPHERE)
        # A file in the place of the folder, which stops root as well.
        folder = os.path.join(self.folder, "kerf")
        os.rename(folder, folder + "-aside")
        with open(folder, "w"):
            pass
        editor.drag(ACROSS)
        report = editor.quit()
        self.assertEqual(report["strokes"], 1)
        self.assertIn("Autosave failed", report["message"])


if __name__ == "__main__":
    unittest.main()
