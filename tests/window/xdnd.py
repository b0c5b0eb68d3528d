"""Drops a file on a window the way a file manager does (the XDND protocol), with nothing but libX11."""

import ctypes
import ctypes.util
import time
import urllib.parse

CLIENT_MESSAGE, SELECTION_REQUEST, SELECTION_NOTIFY = 33, 30, 31


class ClientMessage(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("window", ctypes.c_ulong), ("message_type", ctypes.c_ulong),
                ("format", ctypes.c_int), ("data", ctypes.c_long * 5)]


class SelectionRequest(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("owner", ctypes.c_ulong), ("requestor", ctypes.c_ulong),
                ("selection", ctypes.c_ulong), ("target", ctypes.c_ulong), ("property", ctypes.c_ulong),
                ("time", ctypes.c_ulong)]


class SelectionNotify(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("requestor", ctypes.c_ulong), ("selection", ctypes.c_ulong),
                ("target", ctypes.c_ulong), ("property", ctypes.c_ulong), ("time", ctypes.c_ulong)]


class Event(ctypes.Union):
    _fields_ = [("type", ctypes.c_int), ("client", ClientMessage), ("request", SelectionRequest),
                ("notify", SelectionNotify), ("pad", ctypes.c_long * 24)]


def load():
    x = ctypes.CDLL(ctypes.util.find_library("X11") or "libX11.so.6")
    x.XOpenDisplay.restype = ctypes.c_void_p
    x.XOpenDisplay.argtypes = [ctypes.c_char_p]
    x.XInternAtom.restype = ctypes.c_ulong
    x.XInternAtom.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int]
    x.XDefaultRootWindow.restype = ctypes.c_ulong
    x.XDefaultRootWindow.argtypes = [ctypes.c_void_p]
    x.XCreateSimpleWindow.restype = ctypes.c_ulong
    x.XCreateSimpleWindow.argtypes = [ctypes.c_void_p, ctypes.c_ulong] + [ctypes.c_int] * 2 + [ctypes.c_uint] * 3 + [
        ctypes.c_ulong] * 2
    x.XSetSelectionOwner.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_ulong, ctypes.c_ulong]
    x.XSendEvent.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int, ctypes.c_long, ctypes.POINTER(Event)]
    x.XChangeProperty.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_ulong, ctypes.c_ulong, ctypes.c_int,
                                  ctypes.c_int, ctypes.c_char_p, ctypes.c_int]
    for name in ("XFlush", "XPending", "XCloseDisplay"):
        getattr(x, name).argtypes = [ctypes.c_void_p]
    x.XNextEvent.argtypes = [ctypes.c_void_p, ctypes.POINTER(Event)]
    return x


def drop(display_name, window, path, x, y, timeout=10.0):
    """Drops the file on a point of the screen; comes back when the window has asked for its name and got it."""
    lib = load()
    display = lib.XOpenDisplay(display_name.encode())
    assert display, f"cannot open {display_name}"
    atom = lambda name: lib.XInternAtom(display, name.encode(), 0)
    source = lib.XCreateSimpleWindow(display, lib.XDefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0)
    uri_list, selection = atom("text/uri-list"), atom("XdndSelection")
    lib.XSetSelectionOwner(display, selection, source, 0)

    def send(kind, *data):
        event = Event()
        event.client.type, event.client.window, event.client.message_type = CLIENT_MESSAGE, window, atom(kind)
        event.client.format = 32
        event.client.data[0] = source
        for i, value in enumerate(data):
            event.client.data[i + 1] = value
        lib.XSendEvent(display, window, 0, 0, ctypes.byref(event))
        lib.XFlush(display)

    def next_event(wanted):
        end = time.monotonic() + timeout
        event = Event()
        while time.monotonic() < end:
            while lib.XPending(display):
                lib.XNextEvent(display, ctypes.byref(event))
                if wanted(event):
                    return event
            time.sleep(0.01)
        raise AssertionError("the window does not answer to the drop")

    send("XdndEnter", 5 << 24, uri_list, 0, 0)
    send("XdndPosition", 0, (int(x) << 16) | int(y), 0, atom("XdndActionCopy"))
    next_event(lambda e: e.type == CLIENT_MESSAGE and e.client.message_type == atom("XdndStatus"))
    send("XdndDrop", 0, 0)
    request = next_event(lambda e: e.type == SELECTION_REQUEST).request
    text = ("file://" + urllib.parse.quote(path) + "\r\n").encode()
    lib.XChangeProperty(display, request.requestor, request.property, request.target, 8, 0, text, len(text))
    answer = Event()
    answer.notify.type, answer.notify.requestor = SELECTION_NOTIFY, request.requestor
    answer.notify.selection, answer.notify.target = request.selection, request.target
    answer.notify.property, answer.notify.time = request.property, request.time
    lib.XSendEvent(display, request.requestor, 0, 0, ctypes.byref(answer))
    lib.XFlush(display)
    next_event(lambda e: e.type == CLIENT_MESSAGE and e.client.message_type == atom("XdndFinished"))
    lib.XCloseDisplay(display)
