"""What kerf shows on a terminal: run as `terminal_test.py KERF`. Exits with 77 where there is no pseudo-terminal."""
import json
import os
import pty
import signal
import subprocess
import sys
import tempfile
import unittest

from command_line_test import ACROSS, KERF, PLATE


class Terminal:
    """kerf with standard error on a pseudo-terminal."""
    def __init__(self, *args, cwd):
        self.master, slave = pty.openpty()
        self.process = subprocess.Popen([KERF, *map(str, args)], cwd=cwd, stdout=subprocess.DEVNULL, stderr=slave)
        os.close(slave)
        self.shown = b""

    def read(self):
        try:
            part = os.read(self.master, 4096)
        except OSError:  # EIO: the other end is closed
            part = b""
        self.shown += part
        return bool(part)

    def read_until(self, text):
        while text not in self.shown and self.read():
            pass
        return text in self.shown

    def finish(self):
        while self.read():
            pass
        os.close(self.master)
        return self.process.wait(timeout=900)


class TerminalOutput(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.write("plate.obj", PLATE)
        self.write("across.json", json.dumps(ACROSS))

    def write(self, name, text):
        with open(os.path.join(self.folder.name, name), "w") as file:
            file.write(text)

    def test_progress_is_a_single_line_that_is_erased_at_the_end(self):
        run = Terminal("cut", "plate.obj", "--path", "across.json", "--out", "out", "--target-edge", "0.0002",
                       cwd=self.folder.name)
        self.assertEqual(run.finish(), 0, run.shown)
        self.assertRegex(run.shown, rb"kerf: (cutting|writing) \d+ %")
        progress, end = run.shown.rsplit(b"\r\x1b[K", 1)
        self.assertNotIn(b"\n", progress)
        self.assertRegex(end, rb"^kerf: 1 stroke removed [^\n]*\r\n$")

    def test_ctrl_c_cancels_loading_a_long_file(self):
        long = "very\nlong.obj"
        self.write(long, PLATE + "vt 0 0\n" * 20_000_000)
        for command in (["info", long], ["cut", long, "--out", "out"], ["render", long, "--out", "l.png"]):
            run = Terminal(*command, cwd=self.folder.name)
            self.assertTrue(run.read_until(b"kerf: loading very?long.obj"), run.shown)
            run.process.send_signal(signal.SIGINT)
            self.assertEqual(run.finish(), 130, run.shown)
            self.assertTrue(run.shown.endswith(b"\r\x1b[Kkerf: interrupted\r\n"), run.shown[-60:])
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["across.json", "plate.obj", long])


def has_pseudo_terminals():
    try:
        for end in pty.openpty():
            os.close(end)
    except OSError as error:
        print(f"skipped: there is no pseudo-terminal here ({error}); is /dev/pts mounted?")
        return False
    return True


if __name__ == "__main__":
    if not has_pseudo_terminals():
        sys.exit(77)
    unittest.main()
