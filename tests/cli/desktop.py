"""A desktop of its own for a test: Xvfb, a person's mouse and keys (xdotool), files dropped on windows
(the XDND protocol, version 5). Tests nothing itself."""

import os
import pathlib
import subprocess
import time
import urllib.parse

import Xlib.display
import Xlib.X
from Xlib.protocol import event

LIMIT_SECONDS = 60


def wait_until(what, condition, seconds=LIMIT_SECONDS):
    """What `condition` comes to once it is true."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        result = condition()
        if result:
            return result
        time.sleep(0.02)
    raise AssertionError(f"waited {seconds} s in vain for {what}")


class Desktop:
    """An X server without a window manager."""

    def __init__(self, width=1000, height=700):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{width}x{height}x24",
             "-nolisten", "tcp", "-noreset"],  # which would turn away whoever comes meanwhile
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as stream:
            self.display = ":" + stream.readline().strip()

    def close(self):
        self.server.terminate()
        self.server.wait()

    def do(self, *arguments):
        """One xdotool command; what it printed."""
        return subprocess.run(["xdotool", *map(str, arguments)],
                              env={**os.environ, "DISPLAY": self.display}, check=True, text=True,
                              capture_output=True, timeout=LIMIT_SECONDS).stdout

    def find_window(self, process):
        """The window of a process, once it is there."""
        def search():
            assert process.poll() is None, "the program has ended"
            found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "ribalta"],
                                   env={**os.environ, "DISPLAY": self.display}, text=True,
                                   capture_output=True, timeout=LIMIT_SECONDS, check=False)
            return found.stdout.split()
        return int(wait_until("a window", search)[-1])

    def drop(self, window, files, at=(100, 100)):
        """Drops files on a window, as a file manager does."""
        connection = Xlib.display.Display(self.display)
        try:
            _drop(connection, window, files, at)
        finally:
            connection.close()


def _drop(connection, window, files, at):
    atom = connection.intern_atom
    target = connection.create_resource_object("window", window)
    source = connection.screen().root.create_window(0, 0, 1, 1, 0, Xlib.X.CopyFromParent)
    selection = atom("XdndSelection")
    uri_list = atom("text/uri-list")
    source.set_selection_owner(selection, Xlib.X.CurrentTime)

    def send(name, *data):
        data = (source.id, *data, *[0] * (4 - len(data)))
        target.send_event(event.ClientMessage(window=target, client_type=atom(name),
                                              data=(32, data)))
        connection.flush()

    send("XdndEnter", 5 << 24, uri_list)
    send("XdndPosition", 0, at[0] << 16 | at[1], Xlib.X.CurrentTime, atom("XdndActionCopy"))
    send("XdndDrop", 0, Xlib.X.CurrentTime)
    text = "".join(pathlib.Path(file).resolve().as_uri() + "\r\n" for file in files)
    finished = atom("XdndFinished")
    end = time.monotonic() + LIMIT_SECONDS
    while time.monotonic() < end:
        if not connection.pending_events():
            time.sleep(0.01)
            continue
        got = connection.next_event()
        if got.type == Xlib.X.SelectionRequest:
            got.requestor.change_property(got.property, uri_list, 8, text.encode())
            got.requestor.send_event(event.SelectionNotify(
                time=got.time, requestor=got.requestor, selection=got.selection,
                target=got.target, property=got.property))
            connection.flush()
        elif got.type == Xlib.X.ClientMessage and got.client_type == finished:
            return
    raise AssertionError(f"{urllib.parse.unquote(text)} was not taken")
