"""The game: a match that is played with keys and mouse, the pause menu, and the way there from the editor."""
import json
import os
import subprocess
import tempfile
import unittest

from editor_window import ASSETS, KERF, SPHERE, WindowTest, real_input

RULES = {"name": "duel", "player": os.path.join(ASSETS, "vehicles", "hatchback.json"),
         "waves": [[os.path.join(ASSETS, "vehicles", "van.json")]], "laser": {"range": 60}}
ARENA = {"name": "duel", "ground": 0, "size": [60, 60],
         "starts": {"player": {"position": [0, 0, -5], "heading": 0},
                    "enemies": [{"position": [0, 0, 4], "heading": 90}]}}


class Game(WindowTest):
    def write_rules(self, **changes):
        """A match in which the enemy stands across, before the player."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        arena, rules = (os.path.join(folder.name, name) for name in ("arena.json", "rules.json"))
        with open(arena, "w") as file:
            json.dump(ARENA, file)
        with open(rules, "w") as file:
            json.dump({**RULES, "arena": arena, **changes}, file)
        return rules

    def playing(self, editor):
        return editor.landmarks()["busy"]

    def open_menu(self, editor):
        """The menu is not in the middle before its size is known, a frame later."""
        editor.press("Escape")
        editor.wait_for(lambda: not self.playing(editor) and "leave" in editor.landmarks()["parts"],
                        "Esc never paused the match")
        editor.pause(1.5)

    def begin_from_editor(self, editor):
        editor.press("F5")
        editor.wait_for(lambda: "start" in editor.landmarks()["parts"], "the menu before the match never came")
        editor.press("Enter")
        editor.wait_for(lambda: self.playing(editor) and "viewport" not in editor.landmarks()["parts"],
                        "the game never began")

    @real_input
    def test_keys_and_mouse_drive_and_cut_and_the_match_replays(self):
        rules = self.write_rules()
        record = os.path.join(os.path.dirname(rules), "match.kerf")
        game = self.open("play", rules, "--difficulty", "easy", "--record", record)
        game.wait_for(lambda: self.playing(game), "the match never began")
        game.hold(1)
        for way in (60, -120, 60) * 3:
            for _ in range(12):
                game.xdotool("mousemove_relative", "--", round(way / 12), 0)
                game.pause(0.08)
        game.release(1)
        game.key_down("s")
        game.pause(2)
        game.key_up("s")
        self.open_menu(game)
        game.point_at("leave", 0.5, 0.5)
        game.hold(1)
        game.pause(0.5)
        game.release(1)
        report = game.report()
        self.assertGreater(report["faces_removed"], 100)
        self.assertGreaterEqual(report["strokes"], 1)
        self.assertGreater(report["frames"], 10)
        subprocess.run([KERF, "replay", record, "--expect", report["state_hash"]], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def kept(self, name):
        with open(os.path.join(self.folder, "kerf", name)) as file:
            return json.load(file)

    def test_command_line_choices_are_not_stored_as_settings(self):
        game = self.open("play", self.write_rules(), "--difficulty", "hard")
        game.wait_for(lambda: self.playing(game), "the match never began")
        self.open_menu(game)
        game.click("guide", 0.5, 0.5)
        game.press("Escape")
        game.wait_for(lambda: self.playing(game), "Esc never resumed the match")
        game.pause(1)
        game.die()
        kept = self.kept("game.json")
        self.assertFalse(kept["guide"], "what the player set is kept")
        self.assertEqual(kept["difficulty"], "normal")
        self.write_settings({"width": 900, "height": 700})
        self.open_again(SPHERE).quit()
        self.assertEqual([self.settings()[key] for key in ("width", "height")], [900, 700])

    def test_settings_are_kept_when_the_window_is_closed_in_the_pause_menu(self):
        game = self.open("play", self.write_rules())
        game.wait_for(lambda: self.playing(game), "the match never began")
        self.open_menu(game)
        game.click("guide", 0.5, 0.5)
        game.send({"close": True})
        game.report()
        self.assertFalse(self.kept("game.json")["guide"])

    def test_colours_selected_in_an_editor_during_a_match_are_kept(self):
        game = self.open("play", self.write_rules())
        game.wait_for(lambda: self.playing(game), "the match never began")
        self.write_settings({"palette": "orange-blue"})
        game.send({"close": True})
        game.report()
        self.assertEqual(self.settings()["palette"], "orange-blue")

    def test_the_lesson_appears_once_and_can_be_skipped(self):
        game = self.open("play")
        game.wait_for(lambda: "start" in game.landmarks()["parts"], "the menu before the match never came")
        game.press("Enter")
        game.wait_for(lambda: self.playing(game), "the lesson never began")
        game.press("Enter")
        game.pause(1)
        game.wait_for(lambda: self.playing(game), "the match never began")
        self.open_menu(game)
        game.click("title", 0.5, 0.5)
        game.wait_for(lambda: "start" in game.landmarks()["parts"], "the menu before the match never came back")
        game.die()
        self.assertTrue(self.kept("game.json")["taught"])
        self.assertEqual(self.kept("game.json")["vehicle"], "hatchback")

    def test_a_finished_match_is_stored_and_a_kill_keeps_settings_and_scores_intact(self):
        game = self.open("play", self.write_rules(times={"match": 2}), "--difficulty", "hard")
        game.wait_for(lambda: "replay" in game.landmarks()["parts"], "the match was never over")
        game.pause(1.5)
        game.die()
        with open(os.path.join(self.folder, "kerf", "game.json"), "w") as file:
            json.dump({"difficulty": "easy", "guide": False}, file)
        kept = {name: self.kept(name) for name in ("game.json", "scores.json")}
        self.assertEqual([s["difficulty"] for s in kept["scores.json"]["scores"]], ["hard"])
        self.assertEqual([s["rules"] for s in kept["scores.json"]["scores"]], ["duel"])
        game = self.open_again("play", self.write_rules())
        game.wait_for(lambda: self.playing(game), "the match never began")
        game.hold(1)
        game.pause(1)
        game.die()
        self.assertEqual({name: self.kept(name) for name in kept}, kept)

    def test_a_match_without_points_offers_no_highlight(self):
        game = self.open("play", self.write_rules(targets=True, times={"match": 2}))
        game.wait_for(lambda: "restart" in game.landmarks()["parts"], "the match was never over")
        self.assertIn("no replay", game.landmarks()["parts"])
        self.assertNotIn("replay", game.landmarks()["parts"])

    def test_the_score_of_a_bot_is_no_high_score(self):
        game = self.open("play", self.write_rules(times={"match": 2}), "--driver", "bot")
        game.wait_for(lambda: "replay" in game.landmarks()["parts"], "the match was never over")
        game.report()
        self.assertFalse(os.path.exists(os.path.join(self.folder, "kerf", "scores.json")))

    def test_a_finished_match_comes_back_from_the_editor_as_its_result(self):
        game = self.open("play", self.write_rules(times={"match": 2}))
        game.wait_for(lambda: "replay" in game.landmarks()["parts"], "the match was never over")
        game.pause(1.5)
        game.click("inspect", 0.5, 0.5)
        game.wait_for_title("scene.json - Kerf")
        game.press("F5")
        game.wait_for(lambda: "replay" in game.landmarks()["parts"], "the result is not kept")
        game.press("Escape")
        game.pause(5)
        self.assertIn("replay", game.landmarks()["parts"])
        self.assertEqual(len(self.kept("scores.json")["scores"]), 1)

    def test_help_can_be_shown_again_after_it_has_disappeared(self):
        game = self.open("play", self.write_rules(waves=[]))
        game.wait_for(lambda: self.playing(game), "the match never began")
        self.assertIn("help", game.landmarks()["parts"])
        game.pause(15)
        self.assertNotIn("help", game.landmarks()["parts"])
        game.press("h")
        self.assertIn("help", game.landmarks()["parts"])

    def test_a_key_pressed_right_after_resuming_ends_with_its_release(self):
        rules = self.write_rules(waves=[])
        record = os.path.join(os.path.dirname(rules), "match.kerf")
        game = self.open("play", rules, "--record", record)
        game.wait_for(lambda: self.playing(game), "the match never began")
        self.open_menu(game)
        game.send({"together": [{"key_down": "Esc"}, {"key_down": "W"}]})
        game.pause(0.5)
        game.key_up("w")
        game.pause(0.5)
        game.report()
        with open(record) as file:
            lines = [json.loads(line) for line in file]
        throttles = [run[1] for line in lines for run in line.get("inputs", [])]
        self.assertIn(100, throttles)
        self.assertEqual(throttles[-1], 0)

    def test_a_mouse_button_held_through_a_pause_fires_when_the_match_resumes(self):
        rules = self.write_rules(waves=[])
        record = os.path.join(os.path.dirname(rules), "match.kerf")
        game = self.open("play", rules, "--record", record)
        game.wait_for(lambda: self.playing(game), "the match never began")
        game.hold(1)
        self.open_menu(game)
        game.press("Escape")
        game.wait_for(lambda: self.playing(game), "Esc never resumed the match")
        game.pause(0.5)
        game.report()
        with open(record) as file:
            lines = [json.loads(line) for line in file]
        self.assertEqual([run[4] for line in lines for run in line.get("inputs", [])][-1], 1)

    def test_menus_work_with_keys_alone_in_a_small_window(self):
        game = self.open("play")
        game.resize(640, 400)
        game.wait_for(lambda: "start" in game.landmarks()["parts"], "the menu before the match never came")
        game.pause(0.5)
        _, y, _, height = game.landmarks()["parts"]["start"]
        self.assertLessEqual(y + height, 400)
        game.press("Enter")
        game.wait_for(lambda: self.playing(game), "the lesson never began")
        game.press("Enter")
        game.pause(1)
        for keys in (("Tab", "Up", "Space"), ("Down", "Up", "Enter")):
            self.open_menu(game)
            for key in keys:
                game.press(key)
                game.pause(0.2)
            game.wait_for(lambda: self.playing(game), f"{keys} never resumed the match")

    def test_closing_the_window_during_a_game_of_the_editor_ends_the_editor(self):
        editor = self.open(SPHERE)
        self.begin_from_editor(editor)
        editor.send({"close": True})
        editor.pause(1)
        self.assertTrue(editor.has_ended(1.5))

    def test_the_editor_is_unchanged_after_the_game_and_opens_its_world(self):
        editor = self.open(SPHERE)
        self.begin_from_editor(editor)
        self.open_menu(editor)
        editor.click("leave", 0.5, 0.5)
        editor.wait_for(lambda: "viewport" in editor.landmarks()["parts"], "the editor never came back")
        editor.wait_for_title("sphere.json - Kerf")
        self.begin_from_editor(editor)
        self.open_menu(editor)
        editor.click("inspect", 0.5, 0.5)
        editor.wait_for_title("scene.json - Kerf")
        editor.press("ctrl", "comma")
        editor.type("palette")
        for key in ("Down", "Right", "Escape", "Escape"):
            editor.press(key)
        editor.press("F5")
        editor.wait_for(lambda: "resume" in editor.landmarks()["parts"], "the match is not gone on with")
        editor.pause(1.5)
        editor.click("leave", 0.5, 0.5)
        editor.wait_for_title("scene.json - Kerf")
        self.assertGreater(editor.quit()["bodies"], 5)
        self.assertEqual(self.settings()["palette"], "orange-blue")


if __name__ == "__main__":
    unittest.main()
