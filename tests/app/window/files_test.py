"""Opening files, and work that is not lost."""
import json
import os
import shutil
import signal
import struct
import subprocess
import tempfile
import unittest

from editor_window import ACROSS, ACROSS_ABOVE, ASSETS, KERF, SPHERE, WindowTest, real_input


def png_size_and_bytes(file):
    with open(file, "rb") as png:
        content = png.read()
    return struct.unpack(">II", content[16:24]), content


class Files(WindowTest):
    def test_a_broken_file_leaves_the_default_scene_and_a_running_editor(self):
        with tempfile.NamedTemporaryFile("w", suffix=".obj") as file:
            file.write("f one two three\n")
            file.flush()
            report = self.open(file.name).quit()
        self.assertGreater(report["faces"], 3000)

    def test_a_mesh_file_opens_as_guessed_and_its_question_does_not_block(self):
        cut = [KERF, "cut", os.path.join(ASSETS, "meshes", "plate.obj"), "--format", "stl", "--out"]
        pieces = tempfile.TemporaryDirectory()
        self.addCleanup(pieces.cleanup)
        subprocess.run([*cut, pieces.name], check=True, capture_output=True)
        plate, = (os.path.join(pieces.name, name) for name in os.listdir(pieces.name) if name.endswith(".stl"))
        editor = self.open(plate)
        editor.part("up axis")
        editor.drag(ACROSS)
        report = editor.quit()
        self.assertEqual(report["strokes"], 1)
        self.assertEqual(report["view"]["frame"]["unit"], "m")
        self.assertEqual(self.settings()["frames"], {})
        editor = self.open_again(plate)
        editor.click("frame for all", 0.5, 0.5)
        frame = editor.quit()["view"]["frame"]
        self.assertEqual(self.settings()["frames"], {"stl": frame})

    def test_a_path_with_a_slash_begins_in_the_folder_of_the_dialog(self):
        editor = self.open(SPHERE)
        os.makedirs(os.path.join(self.folder, "below"))
        shutil.copy(os.path.join(ASSETS, "meshes", "plate.obj"), os.path.join(self.folder, "below", "one.obj"))
        editor.do("ctrl", "o")
        editor.part("browser")
        for text in (self.folder, "below/../below/", "../below/one.obj"):
            editor.type(text)
            editor.do("Return")
        editor.wait_for_title("one.obj - Kerf")

    def test_the_dialog_lists_the_folder_of_an_absolute_path_while_it_is_typed(self):
        editor = self.open(SPHERE)
        below = os.path.join(self.folder, "below")
        os.makedirs(below)
        shutil.copy(os.path.join(ASSETS, "meshes", "plate.obj"), os.path.join(below, "one.obj"))
        editor.do("ctrl", "o")
        editor.part("browser")
        self.assertNotIn("entry one.obj", editor.landmarks()["parts"])
        editor.type(below)
        editor.part("entry one.obj")
        editor.type("/on")
        editor.part("entry one.obj")
        editor.do("Return")
        editor.wait_for_title("one.obj - Kerf")
        editor.quit()

    def test_a_failed_save_as_keeps_the_dialog_with_the_error(self):
        editor = self.open(SPHERE)
        editor.drag(ACROSS)
        self.save_as(editor, os.path.join("missing", "ball.kerf"))
        editor.settle()
        editor.part("browser")
        self.assertIn("missing", editor.ask("report")["message"])
        editor.wait_for_title("sphere.json* - Kerf")
        editor.type(os.path.join(self.folder, "ball.kerf"))
        editor.do("Return")
        editor.wait_for_title("ball.kerf - Kerf")
        self.assertNotIn("browser", editor.landmarks()["parts"])
        os.makedirs(os.path.join(self.folder, "below"))
        self.save_as(editor, os.path.join("below", 300 * "x" + ".kerf"))  # too long for a file system
        editor.settle()
        editor.part("browser")
        editor.do("Escape")
        editor.quit()
        self.assertNotEqual(os.path.basename(self.settings()["folder"]), "below")

    def test_a_valid_file_opens_and_a_broken_one_changes_nothing(self):
        editor = self.open()
        self.open_by_browser(editor, SPHERE)
        broken = os.path.join(self.folder, "broken.obj")
        with open(broken, "w") as file:
            file.write("f one two three\n")
        self.open_by_browser(editor, broken)
        report = editor.quit()
        self.assertEqual(report["files"], [os.path.basename(SPHERE)])
        self.assertIn("broken.obj", report["message"])
        self.assertEqual(self.settings()["recent"], [os.path.realpath(SPHERE)])

    def test_a_missing_mesh_is_named_and_found_elsewhere(self):
        editor = self.open(SPHERE)
        scene, mesh = os.path.join(self.folder, "part.json"), os.path.join(self.folder, "moved.obj")
        with open(scene, "w") as file:
            file.write('{"bodies": [{"mesh": "gone.obj"}]}')
        with open(mesh, "w") as file:
            file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.open_by_browser(editor, scene)
        editor.part("question")
        editor.do("Escape")
        report = editor.ask("report")
        self.assertEqual(report["files"], [os.path.basename(SPHERE)])
        self.assertIn("gone.obj", report["message"])
        self.open_by_browser(editor, scene)
        editor.part("question")
        editor.press("Return")
        editor.part("browser")
        editor.type(mesh)
        editor.press("Return")
        editor.wait_for_title("part.json* - Kerf")
        report = editor.quit()
        self.assertEqual((report["files"], report["faces"]), (["part.json"], 1))

    def test_a_wrong_mesh_for_a_journal_is_refused_until_the_right_one_is_found(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        ball, found = os.path.join(folder.name, "ball.obj"), os.path.join(folder.name, "found.obj")
        shutil.copy(os.path.join(ASSETS, "meshes", "knot.obj"), ball)
        editor = self.open(ball)
        editor.drag(ACROSS)
        self.save_as(editor, os.path.join(folder.name, "job.kerf"))
        editor.wait_for_title("job.kerf - Kerf")
        editor.quit()
        os.rename(ball, found)
        shutil.copy(os.path.join(ASSETS, "meshes", "plate.obj"), os.path.join(folder.name, "other.obj"))
        editor = self.open(os.path.join(folder.name, "job.kerf"))
        for name in ("other.obj", "other.obj", "found.obj"):
            editor.part("question")
            editor.do("Return")
            editor.part(f"entry {name}")  # the dialog begins in the folder of the journal
            editor.type(name)
            editor.do("Return")
        editor.wait_for_title("job.kerf* - Kerf")
        report = editor.quit()
        self.assertEqual((report["files"], report["strokes"]), (["job.kerf"], 1))

    def test_a_suggested_name_is_replaced_by_typing_every_time(self):
        editor = self.open(SPHERE)
        editor.press("ctrl", "shift", "s")
        editor.part("browser")
        editor.pause(1)
        editor.press("BackSpace")
        editor.press("Escape")
        self.save_as(editor, "kept.kerf")
        editor.wait_for_title("kept.kerf - Kerf")
        editor.quit()

    def test_recent_files_have_thumbnails_until_cleared(self):
        editor = self.open(SPHERE)
        pictures = os.path.join(self.folder, "kerf", "thumbnails")
        editor.pixels()  # frames are drawn
        thumbnail, = os.listdir(pictures)
        uncut = png_size_and_bytes(os.path.join(pictures, thumbnail))
        self.assertEqual(uncut[0], (240, 150))
        editor.drag(ACROSS)
        self.save_as(editor, "ball")
        editor.pixels()
        self.assertEqual(len(os.listdir(pictures)), 2)
        saved, = set(os.listdir(pictures)) - {thumbnail}
        self.assertNotEqual(png_size_and_bytes(os.path.join(pictures, saved)), uncut)
        self.assertEqual(png_size_and_bytes(os.path.join(pictures, thumbnail)), uncut)
        editor.press("ctrl", "p")
        editor.part("palette")
        editor.type("Clear Recent Files")
        editor.press("Return")
        editor.settle()
        editor.quit()
        self.assertEqual(os.listdir(pictures), [])

    def test_a_file_changed_by_another_program_is_offered_for_reloading(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        part, scene = (os.path.join(folder.name, name) for name in ("part.obj", "scene.json"))

        def write_part(name):
            with open(os.path.join(ASSETS, "meshes", name)) as mesh, open(part, "w") as file:
                file.write(mesh.read())

        with open(scene, "w") as file:
            json.dump({"bodies": [{"mesh": "part.obj"}]}, file)
        faces = {}
        for choice in ("keep files", "reload files"):
            write_part("plate.obj")
            editor = self.open(scene)
            editor.pause(3)
            self.assertNotIn(choice, editor.landmarks()["parts"])
            write_part("bracket.obj")
            editor.pause(3)
            editor.click(choice, 0.5, 0.5)
            self.assertNotIn(choice, editor.landmarks()["parts"])
            report = editor.quit()
            self.assertEqual(report["files"], ["scene.json"])
            faces[choice] = report["faces"]
        self.assertGreater(faces["keep files"], 4000)
        self.assertLess(faces["reload files"], 1000)

    def scene_of_plate(self):
        """The paths of a mesh and of a scene with it, in a new folder."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        part, scene = (os.path.join(folder.name, name) for name in ("part.obj", "scene.json"))
        shutil.copy(os.path.join(ASSETS, "meshes", "plate.obj"), part)
        with open(scene, "w") as file:
            json.dump({"bodies": [{"mesh": "part.obj"}]}, file)
        return part, scene

    def test_a_reloaded_file_is_seen_from_the_same_place(self):
        part, scene = self.scene_of_plate()
        editor = self.open(scene)
        editor.point_at(0.05, 0.05)
        home = editor.ask("report")["view"]["eye"]
        editor.do("ctrl", "3")
        editor.pause(3)
        before = editor.ask("report")["view"]["eye"]
        self.assertNotEqual(before, home)
        with open(part, "a") as file:
            file.write("# the same mesh\n")
        editor.pause(3)
        editor.click("reload files", 0.5, 0.5)
        editor.pause(3)
        for new, old in zip(editor.quit()["view"]["eye"], before):
            self.assertAlmostEqual(new, old, places=3)

    def test_a_reloaded_file_has_a_new_thumbnail(self):
        part, scene = self.scene_of_plate()
        editor = self.open(scene)
        pictures = os.path.join(self.folder, "kerf", "thumbnails")
        editor.pixels()
        thumbnail, = os.listdir(pictures)
        plate = png_size_and_bytes(os.path.join(pictures, thumbnail))
        editor.pause(3)
        shutil.copy(os.path.join(ASSETS, "meshes", "bracket.obj"), part)
        editor.pause(3)
        editor.click("reload files", 0.5, 0.5)
        editor.pause(3)
        editor.pixels()
        self.assertNotEqual(png_size_and_bytes(os.path.join(pictures, thumbnail)), plate)
        editor.quit()

    def test_saving_reports_a_mesh_that_another_program_has_changed(self):
        part, scene = self.scene_of_plate()
        editor = self.open(scene)
        editor.pause(3)
        self.assertNotIn("keep files", editor.landmarks()["parts"])
        shutil.copy(os.path.join(ASSETS, "meshes", "bracket.obj"), part)
        editor.pause(3)
        editor.click("keep files", 0.5, 0.5)
        self.save_as(editor, "job")
        editor.wait_for_title("job.kerf - Kerf")
        self.assertIn("part.obj was changed by another program", editor.ask("report")["message"])
        self.assertNotIn("browser", editor.landmarks()["parts"])
        editor.quit()

    def test_saving_over_a_journal_that_another_program_has_changed_names_the_kept_version(self):
        editor = self.open(SPHERE)
        self.save_as(editor, "ball")
        editor.wait_for_title("ball.kerf - Kerf")
        editor.pause(3)
        journal = os.path.join(self.folder, "ball.kerf")
        messages = []
        for path in ACROSS, ACROSS_ABOVE:
            editor.drag(path)
            editor.wait_for_title("ball.kerf* - Kerf")
            if not messages:
                with open(journal, "a") as file:
                    file.write("\n")
            editor.press("ctrl", "s")
            editor.wait_for_title("ball.kerf - Kerf")
            messages.append(editor.ask("report")["message"])
            if len(messages) == 1:
                with open(journal + "~") as kept:
                    self.assertTrue(kept.read().endswith("\n\n"))
        self.assertIn("the version of another program is now ball.kerf~", messages[0])
        self.assertNotIn("another program", messages[1])
        editor.quit()

    def test_a_changed_material_library_is_offered_for_reloading(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        part, library, scene = (os.path.join(folder.name, name) for name in ("part.obj", "part.mtl", "scene.json"))
        with open(os.path.join(ASSETS, "meshes", "plate.obj")) as mesh, open(part, "w") as file:
            file.write("mtllib part.mtl\n" + mesh.read())
        with open(library, "w") as file:
            file.write("newmtl paint\n")
        with open(scene, "w") as file:
            json.dump({"bodies": [{"mesh": "part.obj"}]}, file)
        editor = self.open(scene)
        editor.pause(3)
        self.assertNotIn("reload files", editor.landmarks()["parts"])
        with open(library, "a") as file:
            file.write("Kd 1 0 0\n")
        editor.pause(3)
        self.assertIn("reload files", editor.landmarks()["parts"])
        editor.quit()

    def test_the_open_dialog_previews_the_selected_file(self):
        editor = self.open(SPHERE)
        for name, has_image in (("good.obj", True), ("bad.obj", False)):
            with open(os.path.join(self.folder, name), "w") as file:
                file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 " + ("3\n" if has_image else "x\n"))
            editor.press("ctrl", "o")
            editor.part("browser")
            self.assertNotIn("preview image", editor.landmarks()["parts"])
            editor.pause(1)
            editor.type(os.path.join(self.folder, name))
            editor.pause(1)
            self.assertEqual("preview image" in editor.landmarks()["parts"], has_image)
            editor.press("Escape")
            editor.settle()
        self.assertEqual(editor.quit()["files"], [os.path.basename(SPHERE)])

    @real_input
    def test_dropped_files_open_together_despite_a_broken_one(self):
        editor = self.open()
        bracket, plate = (os.path.join(ASSETS, "meshes", name) for name in ("bracket.obj", "plate.obj"))
        broken = os.path.join(self.folder, "not a mesh.stl")
        with open(broken, "w") as file:
            file.write("solid nothing\nfacet normal none\n")
        editor.drop(bracket, broken, plate)
        editor.wait_for_title("bracket.obj and 1 more - Kerf")
        editor.point_at("message", 0.3, 0.5)
        editor.part("whole message")
        editor.drop(broken)
        editor.click("message", 0.3, 0.5)
        editor.part("messages")
        editor.do("Escape")
        self.assertNotIn("messages", editor.landmarks()["parts"])
        report = editor.quit()
        self.assertEqual(report["files"], ["bracket.obj", "plate.obj"])
        self.assertEqual(report["bodies"], 2)
        self.assertIn("not a mesh.stl", report["message"])
        self.assertEqual(sum("not a mesh.stl" in text for text in report["messages"]), 2)

    def test_files_open_together_and_broken_settings_are_set_aside(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        os.mkdir(os.path.join(folder.name, "kerf"))
        with open(os.path.join(folder.name, "kerf", "settings.json"), "w") as file:
            file.write("{broken")
        meshes = os.path.join(ASSETS, "meshes")
        self.folder = folder.name
        editor = self.open_again(os.path.join(meshes, "knot.obj"), os.path.join(meshes, "bracket.obj"))
        report = editor.quit()
        self.assertEqual(report["bodies"], 2)
        self.assertTrue(os.path.exists(os.path.join(folder.name, "kerf", "settings.json.bad")))
        self.assertIn("set aside", report["message"])

    def test_a_saved_cut_reopens_unchanged(self):
        editor = self.open(SPHERE)
        editor.wait_for_title("sphere.json - Kerf")
        editor.drag(ACROSS)
        editor.wait_for_title("sphere.json* - Kerf")
        self.save_as(editor, "ball")
        editor.wait_for_title("ball.kerf - Kerf")
        editor.drag(ACROSS_ABOVE)
        editor.wait_for_title("ball.kerf* - Kerf")
        editor.press("ctrl", "s")
        editor.wait_for_title("ball.kerf - Kerf")
        saved = editor.quit()
        self.assertEqual(self.unsaved(), [])
        journal = os.path.join(self.folder, "ball.kerf")
        self.assertTrue(os.path.exists(journal + "~"))
        replayed = subprocess.run([KERF, "replay", journal], capture_output=True, text=True)
        self.assertEqual((replayed.returncode, replayed.stderr), (0, ""))
        self.set(folder=self.folder)
        again = self.open_again(SPHERE)
        self.open_by_browser(again, "all.kerf")  # a part of its name
        again.wait_for_title("ball.kerf - Kerf")
        report = again.quit()
        for key in ("strokes", "faces", "pieces", "faces_removed"):
            self.assertEqual(report[key], saved[key], key)
        self.assertEqual(self.settings()["recent"][0], os.path.realpath(journal))

    def test_save_asks_for_the_name_of_an_opened_previous_version(self):
        editor = self.open(SPHERE)
        self.save_as(editor, "ball")
        editor.wait_for_title("ball.kerf - Kerf")
        editor.drag(ACROSS)
        editor.press("ctrl", "s")
        editor.wait_for_title("ball.kerf - Kerf")
        editor.quit()
        editor = self.open_again(os.path.join(self.folder, "ball.kerf~"))
        editor.wait_for_title("ball.kerf~ - Kerf")
        editor.drag(ACROSS)
        editor.press("ctrl", "s")
        self.type_name(editor, "older")
        editor.wait_for_title("older.kerf - Kerf")
        editor.quit()

    def test_strokes_are_undone_and_redone(self):
        editor = self.open(SPHERE)
        editor.drag(ACROSS)
        editor.drag(ACROSS_ABOVE)
        for keys in (("ctrl", "z"), ("ctrl", "z"), ("ctrl", "shift", "z")):
            editor.do(*keys)
        back = editor.quit()
        self.assertEqual((back["undo_depth"], back["strokes"]), (1, 1))
        self.assertGreater(back["faces_removed"], 0)

    def test_clicking_the_first_row_of_the_history_returns_to_the_opened_state(self):
        self.assert_history_is_travelled()

    def test_the_history_works_without_an_installed_font(self):
        self.assert_history_is_travelled("--own-font")

    def assert_history_is_travelled(self, *options):
        self.open(SPHERE).quit()
        self.only_panel("history")
        editor = self.open_again(SPHERE, *options)
        editor.drag(ACROSS)
        editor.drag(ACROSS_ABOVE)
        editor.part("history row 2")
        editor.click("history row 0", 0.2, 0.5)
        there = editor.quit()
        self.assertEqual((there["undo_depth"], there["strokes"], there["faces_removed"]), (0, 0, 0))
        self.assertEqual(there["pieces"], 1)

    def test_unsaved_changes_are_confirmed_before_closing(self):
        editor = self.open(SPHERE)
        editor.drag(ACROSS)
        for leave in (("ctrl", "q"), ("ctrl", "n")):
            editor.press(*leave)
            editor.part("question")
            editor.press("Escape")
            editor.pause(0.5)
            editor.wait_for_title("sphere.json* - Kerf")
        editor.press("ctrl", "n")
        editor.part("question")
        editor.drop(os.path.join(ASSETS, "meshes", "plate.obj"))
        self.assertIn("Answer the question first", editor.ask("report")["message"])
        editor.press("d")
        editor.wait_for_title("car.json - Kerf")
        editor.pause(1)
        editor.drag([(0.53, 0.14), (0.53, 0.5)])
        editor.wait_for_title("car.json* - Kerf")
        editor.press("ctrl", "q")
        editor.part("question")
        editor.press("5")
        editor.press("s")
        self.type_name(editor, "car")
        self.assertEqual(editor.report()["strokes"], 1)
        self.assertTrue(os.path.exists(os.path.join(self.folder, "car.kerf")))
        self.assertEqual(self.unsaved(), [])

    def test_a_file_dropped_over_a_dialog_closes_it_before_the_question(self):
        editor = self.open(SPHERE)
        editor.drag(ACROSS)
        editor.do("ctrl", "o")
        editor.part("browser")
        editor.drop(os.path.join(ASSETS, "meshes", "plate.obj"))
        editor.part("question")
        self.assertNotIn("browser", editor.landmarks()["parts"])
        editor.press("d")
        editor.wait_for_title("plate.obj - Kerf")
        editor.quit()

    def test_a_killed_editor_loses_nothing_and_the_next_one_resumes(self):
        editor = self.open(SPHERE)
        editor.drag(ACROSS)
        editor.draw_without_end()
        editor.die()
        left, = self.unsaved()
        with open(left) as file:
            lines = file.read().splitlines()
        self.assertEqual(sum('"do":"begin-stroke"' in line for line in lines), 2)
        self.assertIn('"do":"move-beam"', lines[-1])

        later = self.open_again(SPHERE)
        later.press("Escape")
        self.assertEqual(later.quit()["strokes"], 0)
        self.assertEqual(self.unsaved(), [left])

        editor = self.open_again(SPHERE)
        editor.title()  # it has found the lost work
        other = self.open_again(SPHERE)  # is not offered what another looks at
        self.assertEqual(other.quit()["strokes"], 0)
        editor.press("Return")
        editor.wait_for_title("sphere.json* - Kerf")
        self.assertNotIn(left, self.unsaved())
        self.assertEqual(len(self.unsaved()), 1)
        self.save_as(editor, "saved")
        editor.wait_for_title("saved.kerf - Kerf")
        report = editor.quit()
        self.assertEqual(report["strokes"], 2)
        self.assertGreater(report["faces_removed"], 500)
        self.assertGreater(report["last_stroke"]["faces_made"], 100)  # as figures of what was replayed
        self.assertEqual(self.unsaved(), [])
        replayed = subprocess.run([KERF, "replay", os.path.join(self.folder, "saved.kerf")], stdout=subprocess.DEVNULL)
        self.assertEqual(replayed.returncode, 0)

    def test_autosaves_keep_the_interval_of_the_settings(self):
        editor = self.open(SPHERE)
        editor.quit()
        self.set(autosave_seconds=60)
        editor = self.open_again(SPHERE)
        strokes = []
        for seconds in (1, 1, 62):
            editor.drag(ACROSS)
            editor.pause(seconds)
            editor.title()
            left, = self.unsaved()
            with open(left) as file:
                strokes.append(file.read().count('"do":"begin-stroke"'))
        self.assertEqual(strokes, [1, 1, 3])
        editor.quit()

    def test_two_concurrent_editors_keep_their_work_separate(self):
        one = self.open(SPHERE)
        one.drag(ACROSS)
        two = self.open_again(SPHERE)
        two.drag(ACROSS_ABOVE)
        two.wait_for_title(one.title())
        self.assertEqual(len(self.unsaved()), 2)
        two.die()
        self.assertEqual(one.quit()["strokes"], 1)
        self.assertEqual(len(self.unsaved()), 1)

    @real_input
    def test_sigterm_leaves_unsaved_work_for_the_next_launch(self):
        editor = self.open(SPHERE)
        editor.drag(ACROSS)
        editor.kerf.send_signal(signal.SIGTERM)
        self.assertEqual(editor.report(143)["strokes"], 1)
        self.assertEqual(len(self.unsaved()), 1)

    @real_input
    def test_sigterm_exits_with_a_report(self):
        editor = self.open()
        editor.kerf.send_signal(signal.SIGTERM)
        self.assertEqual(editor.report(143)["strokes"], 0)


if __name__ == "__main__":
    unittest.main()
