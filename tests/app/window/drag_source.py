"""The other side of a drag: drops files on a window of the X server in $DISPLAY, by the XDND protocol, version 5.

Run as `drag_source.py WINDOW X Y FILE...`: the window's number, a place on the screen within it, the files. It exits
with 0 when the window has said that it took them.
"""
import ctypes
import pathlib
import sys
import time

X = ctypes.CDLL("libX11.so.6")
Window = Atom = Time = ctypes.c_ulong
CLIENT_MESSAGE, SELECTION_REQUEST, SELECTION_NOTIFY = 33, 30, 31
PROP_REPLACE = 0
HANG = 900  # seconds


class ClientMessage(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("window", Window), ("message_type", Atom), ("format", ctypes.c_int),
                ("data", ctypes.c_long * 5)]


class SelectionRequest(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("owner", Window), ("requestor", Window), ("selection", Atom),
                ("target", Atom), ("property", Atom), ("time", Time)]


class SelectionNotify(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("requestor", Window), ("selection", Atom), ("target", Atom),
                ("property", Atom), ("time", Time)]


class Event(ctypes.Union):
    _fields_ = [("type", ctypes.c_int), ("client", ClientMessage), ("request", SelectionRequest),
                ("notify", SelectionNotify), ("pad", ctypes.c_long * 24)]


def declare(name, result, *arguments):
    function = getattr(X, name)
    function.restype, function.argtypes = result, arguments


POINTER, INT, LONG = ctypes.c_void_p, ctypes.c_int, ctypes.c_long
declare("XOpenDisplay", POINTER, ctypes.c_char_p)
declare("XDefaultRootWindow", Window, POINTER)
declare("XCreateSimpleWindow", Window, POINTER, Window, INT, INT, ctypes.c_uint, ctypes.c_uint, ctypes.c_uint,
        ctypes.c_ulong, ctypes.c_ulong)
declare("XInternAtom", Atom, POINTER, ctypes.c_char_p, INT)
declare("XSetSelectionOwner", INT, POINTER, Atom, Window, Time)
declare("XSendEvent", INT, POINTER, Window, INT, LONG, ctypes.POINTER(Event))
declare("XChangeProperty", INT, POINTER, Window, Atom, Atom, INT, INT, ctypes.c_char_p, INT)
declare("XPending", INT, POINTER)
declare("XNextEvent", INT, POINTER, ctypes.POINTER(Event))
declare("XFlush", INT, POINTER)


class Source:
    def __init__(self, target, files):
        self.display = X.XOpenDisplay(None)
        if not self.display:
            sys.exit("drag_source: no display")
        root = X.XDefaultRootWindow(self.display)
        self.window = X.XCreateSimpleWindow(self.display, root, 0, 0, 1, 1, 0, 0, 0)
        self.target = target
        self.uris = "".join(pathlib.Path(file).absolute().as_uri() + "\r\n" for file in files).encode()
        X.XSetSelectionOwner(self.display, self.atom("XdndSelection"), self.window, 0)

    def atom(self, name):
        return X.XInternAtom(self.display, name.encode(), False)

    def tell(self, message, *data):
        event = Event()
        event.client = ClientMessage(CLIENT_MESSAGE, 0, 1, self.display, self.target, self.atom(message), 32,
                                     (LONG * 5)(self.window, *data))
        X.XSendEvent(self.display, self.target, False, 0, ctypes.byref(event))
        X.XFlush(self.display)

    def hear(self, message):
        """Waits for the target to say so, handing out the files' addresses meanwhile; the message's data."""
        wanted, until = self.atom(message), time.monotonic() + HANG
        while time.monotonic() < until:
            if not X.XPending(self.display):
                time.sleep(0.01)
                continue
            event = Event()
            X.XNextEvent(self.display, ctypes.byref(event))
            if event.type == SELECTION_REQUEST:
                self.hand_out(event.request)
            elif event.type == CLIENT_MESSAGE and event.client.message_type == wanted:
                return list(event.client.data)
        sys.exit("drag_source: the window never said " + message)

    def hand_out(self, request):
        X.XChangeProperty(self.display, request.requestor, request.property, request.target, 8, PROP_REPLACE,
                          self.uris, len(self.uris))
        event = Event()
        event.notify = SelectionNotify(SELECTION_NOTIFY, 0, 1, self.display, request.requestor, request.selection,
                                       request.target, request.property, request.time)
        X.XSendEvent(self.display, request.requestor, False, 0, ctypes.byref(event))
        X.XFlush(self.display)

    def drop(self, x, y):
        copy = self.atom("XdndActionCopy")
        self.tell("XdndEnter", 5 << 24, self.atom("text/uri-list"), 0, 0)
        self.tell("XdndPosition", 0, x << 16 | y, 0, copy)
        accepted = self.hear("XdndStatus")[1] & 1
        if not accepted:
            sys.exit("drag_source: the window does not want them")
        self.tell("XdndDrop", 0, 0, 0, 0)
        self.hear("XdndFinished")


if __name__ == "__main__":
    Source(int(sys.argv[1]), sys.argv[4:]).drop(int(sys.argv[2]), int(sys.argv[3]))
