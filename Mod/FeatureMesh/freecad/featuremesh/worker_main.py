# SPDX-License-Identifier: GPL-3.0-or-later
"""The program of the worker process: runs the engine's functions for a FreeCAD that shall survive a crash in them.

    python worker_main.py CONNECTION LAST_WORDS [FOLDER OF THE ENGINE]

CONNECTION is the descriptor of a socket to worker.py, LAST_WORDS that of a pipe which gets what a crash interrupted. Uses neither
FreeCAD nor anything else of this package, so it starts at once. Messages are tuples, pickled on both sides by these two programs only:

    to the worker:    ("call", function, args, kwargs), ("cancel",), ("forget", keys of meshes)
    from the worker:  ("ready",) or ("unusable", reason), then per call any number of ("progress", step, share) and one
                      ("done", value) or ("error", class name, text)

Meshes stay in the worker under a key; FreeCAD's side gets the key with their arrays.
"""

import io
import os
import pickle
import queue
import sys
import threading
from multiprocessing.connection import Connection

_LONGEST = 2000   # characters of a message; a call with wrong arguments would print the whole part


class Worker:
    """Answers calls, one at a time; a thread of its own listens, so that a cancel arrives in the middle of one."""

    def __init__(self, connection, engine):
        self._connection, self._engine = connection, engine
        self._meshes = {}
        self._last_key = 0
        self._calls = queue.Queue()
        self._cancelled = threading.Event()
        threading.Thread(target=self._listen, daemon=True).start()

    def serve(self):
        """Runs until FreeCAD's side closes the connection, which ends the process."""
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
            return "done", getattr(self._engine, name)(*args, **kwargs)
        except BaseException as error:
            return "error", type(error).__name__, str(error)[:_LONGEST]

    def _progress(self, step, share):
        self._send(("progress", step, share))
        return not self._cancelled.is_set()

    def _listen(self):
        while True:
            try:
                data = self._connection.recv_bytes()
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
            self._connection.send_bytes(stream.getbuffer())
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
                                "active_points": value.active_points(), "owners_of_faces": value.owners_of_faces(),
                                "owners_of_tets": value.owners_of_tets()}


def main(connection, last_words, folder=None):
    connection = Connection(int(connection))
    if folder:
        sys.path.insert(0, folder)
    try:
        import featuremesh_engine
    except ImportError as error:
        connection.send_bytes(pickle.dumps(("unusable", str(error))))
        return
    featuremesh_engine.write_activity_of_crash_to(int(last_words))
    connection.send_bytes(pickle.dumps(("ready",)))
    Worker(connection, featuremesh_engine).serve()


if __name__ == "__main__":
    main(*sys.argv[1:])
