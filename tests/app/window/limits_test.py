"""The editor where the machine has less than it wants: nothing that was made is lost."""
import os
import unittest

from editor_window import ACROSS, SPHERE, WindowTest, real_input


class Limits(WindowTest):
    @real_input
    def test_unsaved_work_survives_the_loss_of_the_display(self):
        editor = self.open(SPHERE)
        editor.drag(ACROSS)
        editor.settle()
        editor.screen.kill()
        editor.screen.wait()
        self.assertEqual(editor.kerf.wait(timeout=900), 1, "it ends by itself, not by a signal")
        editor.close()
        again = self.open_again(SPHERE)
        again.press("Return")
        again.wait_for_title("sphere.json* - Kerf")
        self.assertEqual(again.quit()["strokes"], 1)

    def test_cuts_without_an_autosave_folder_and_reports_it(self):
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
