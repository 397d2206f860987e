# SPDX-License-Identifier: GPL-3.0-or-later
"""The program of the worker process: runs the engine's functions for a FreeCAD that shall survive a crash in them.

    python worker_main.py LAST_WORDS [FOLDER OF THE ENGINE]

Speaks with worker.py through standard input and output; LAST_WORDS is a file which gets what a crash interrupted. Uses neither
FreeCAD nor anything else of this package, so it starts at once. Messages are tuples, pickled on both sides by these two programs only:

    to the worker:    ("call", function, args, kwargs), ("forget", keys of meshes), and the bare word cancel
    from the worker:  ("ready", what the engine says about itself) or ("unusable", reason), then per call any number of ("progress", step, share) and one
                      ("done", value) or ("error", class name, text, the engine's message or None)

Meshes stay in the worker under a key; FreeCAD's side gets the key with their arrays.
"""

import io
import operator
import os
import pickle
import queue
import signal
import struct
import sys
import threading

_LENGTH = struct.Struct("!Q")
_LONGEST = 2000   # characters of a message; a call with wrong arguments would print the whole part


def write_message(stream, data):
    """Writes bytes with their length to an unbuffered stream."""
    for part in (_LENGTH.pack(len(data)), data):
        rest = memoryview(part)
        while rest:
            rest = rest[stream.write(rest):]


def read_message(stream):
    """The bytes of the next message of an unbuffered stream. Throws EOFError at its end."""
    return _read(stream, _LENGTH.unpack(_read(stream, _LENGTH.size))[0])


def _read(stream, count):
    data = bytearray(count)
    rest = memoryview(data)
    while rest:
        got = stream.readinto(rest)
        if not got:
            raise EOFError
        rest = rest[got:]
    return data


class Worker:
    """Answers calls, one at a time; a thread of its own listens, so that a cancel arrives in the middle of one."""

    def __init__(self, incoming, outgoing, engine):
        self._incoming, self._outgoing, self._engine = incoming, outgoing, engine
        self._meshes = {}
        self._last_key = 0
        self._calls = queue.Queue()
        self._cancelled = threading.Event()
        threading.Thread(target=self._listen, daemon=True).start()

    def serve(self):
        """Runs until FreeCAD's side closes the line, which ends the process."""
        while True:
            kind, *words = self._load(self._calls.get())
            if kind == "forget":
                for key in words[0]:
                    self._meshes.pop(key, None)
            else:
                self._send(self._answer(*words))

    def _answer(self, name, args, kwargs):
        if "progress" in kwargs:
            kwargs["progress"] = self._progress
        try:
            return "done", operator.attrgetter(name)(self._engine)(*args, **kwargs)
        except BaseException as error:
            return "error", type(error).__name__, str(error)[:_LONGEST], getattr(error, "message", None)

    def _progress(self, step, share):
        self._send(("progress", step, share))
        return not self._cancelled.is_set()

    def _listen(self):
        while True:
            try:
                data = read_message(self._incoming)
            except (EOFError, OSError):
                os._exit(0)
            if data == b"cancel":
                self._cancelled.set()
                continue
            self._cancelled.clear()
            self._calls.put(data)

    def _send(self, message):
        stream = io.BytesIO()
        pickler = pickle.Pickler(stream, pickle.HIGHEST_PROTOCOL)
        pickler.persistent_id = self._keep
        pickler.dump(message)
        try:
            write_message(self._outgoing, stream.getbuffer())
        except OSError:
            os._exit(0)

    def _load(self, data):
        unpickler = pickle.Unpickler(io.BytesIO(data))
        unpickler.persistent_load = self._meshes.__getitem__
        return unpickler.load()

    def _keep(self, value):
        """A mesh is not copied: it stays here, and its key goes with all that can be asked of it."""
        if not isinstance(value, self._engine.PartMesh):
            return None
        self._last_key += 1
        self._meshes[self._last_key] = value
        return self._last_key, {"order": value.order, "corner_count": value.corner_count, "arrays": value.arrays(),
                                "node_origin": value.node_origin(), "tet_origin": value.tet_origin(),
                                "active_points": value.active_points()}


def main(last_words, folder=None):
    signal.signal(signal.SIGINT, signal.SIG_IGN)   # Ctrl-C in the console that FreeCAD was started from is for FreeCAD
    incoming = sys.stdin.buffer.raw
    outgoing = os.fdopen(os.dup(1), "wb", buffering=0)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)   # libraries that print must not disturb the messages
    if folder:
        sys.path.insert(0, folder)
    try:
        import numpy  # noqa: F401  the engine needs it later, without a word of its own
        import featuremesh_engine as engine
    except ImportError as error:
        write_message(outgoing, pickle.dumps(("unusable", str(error))))
        return
    if hasattr(engine, "write_activity_of_crash_to"):
        engine.write_activity_of_crash_to(os.open(last_words, os.O_WRONLY))
    write_message(outgoing, pickle.dumps(("ready", engine.about() if hasattr(engine, "about") else {})))
    Worker(incoming, outgoing, engine).serve()


if __name__ == "__main__":
    main(*sys.argv[1:])
