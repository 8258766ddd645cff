"""What a test does with the editor, whatever hands its input to it."""
import os
import sys
import time

KERF = os.path.abspath(sys.argv.pop(1))
# Seconds after which an editor is taken to hang. No test depends on how fast the machine is.
HANG = 900


class EditorDriver:
    """An editor that runs, and its input and landmarks.

    A point of the window is (along, down), shares of the width and the height of the picture, or (part, along, down),
    those of a part of the window that the editor reports under this name (ui/window/layout.h). Keys have the names
    of X.

    A driver has these, too: kerf, the process; pause(seconds); landmarks(); settle(); title(); move_to(x, y), in pixels;
    hold(button) and release(button), 1 the left, 2 the middle, 3 the right one; wheel(notches); key_down(key) and
    key_up(key); type(text); drop(file, ...); resize(width, height); draw_at_once(path); pixels().
    """

    def wait_for(self, met, what):
        """Until met() is true. `what` is said otherwise: a text, or a function that gives one."""
        until = time.monotonic() + HANG
        while not met():
            if time.monotonic() > until:
                raise AssertionError(what() if callable(what) else what)
            self.pass_time()

    def pass_time(self):
        self.pause(0.1)

    def expect_running(self):
        if self.kerf.poll() is not None:
            raise AssertionError(f"the editor ended with {self.kerf.returncode}: {self.kerf.stderr.read()}")

    def shows(self, name):
        return any(self.landmarks()["parts"].get(name, []))

    def part(self, name):
        """The rectangle of a part of the window, x, y, width and height, once there is one that is not empty."""
        self.wait_for(lambda: self.shows(name), f"the editor shows no {name!r}")
        return self.landmarks()["parts"][name]

    def place(self, point):
        """The point in pixels."""
        *part, along, down = point
        x, y, width, height = self.part(part[0] if part else "viewport")
        return round(x + along * width), round(y + down * height)

    def point_at(self, *point):
        self.move_to(*self.place(point))
        self.settle()

    def wait_for_popup(self, there):
        self.wait_for(lambda: ("popup" in self.landmarks()["parts"]) == there, f"a popup is open: {not there}")

    def wait_for_title(self, title):
        self.wait_for(lambda: self.title() == title, lambda: f"the title is {self.title()!r} and not {title!r}")

    def click(self, *point, button=1):
        """A press and a release that different frames hear of."""
        x, y = self.place(point)
        self.move_to(x, y)
        self.settle()
        self.press_button(button, x, y)
        self.release(button)
        self.move_to(x, y)
        self.settle()

    def press_button(self, button, x, y):
        """A press that the editor has heard of, where it was, when this returns."""
        self.hold(button)
        self.move_to(x + 1, y)
        self.wait_until_heard("the press")

    def drag(self, points, button=1):
        """Moves through the points with the button down, slowly enough that a software renderer sees them."""
        self.drag_pixels([self.place(point) for point in points], button)

    def drag_pixels(self, points, button=1):
        x, y = points[0]
        self.move_to(x, y)
        self.settle()
        self.press_button(button, x, y)
        for (x0, y0), (x1, y1) in zip(points, points[1:]):
            for i in range(1, 13):
                self.move_to(round(x0 + (x1 - x0) * i / 12), round(y0 + (y1 - y0) * i / 12))
                self.pause(0.05)
        self.pause(0.3)
        self.wait_until_heard("the last move")
        self.release(button)
        self.pause(0.2)
        self.settle()

    def press(self, *keys):
        for key in keys:
            self.key_down(key)
            self.pause(0.15)
        for key in reversed(keys):
            self.key_up(key)
            self.pause(0.15)

    def do(self, *keys):
        """Presses the keys and waits until the editor has done what they ask for; the pointer was moved before."""
        self.press(*keys)
        x, y = self.pointer
        self.move_to(x + 1, y)  # seen after the keys were heard
        self.settle()

    def quit(self):
        """Ends the editor by its own shortcut, gives up what is not saved, and returns its report."""
        self.press("ctrl", "q")
        for _ in range(10):
            if self.has_ended(1.5):
                break
            self.press("d")  # again where a slow picture kept the question from being there
        return self.report()

    def draw_without_end(self):
        """A stroke that is running still."""
        self.point_at(0.3, 0.63)
        self.hold(1)
        for i in range(10):
            self.move_to(*self.place((0.3 + 0.02 * i, 0.63)))
            self.pause(0.1)
