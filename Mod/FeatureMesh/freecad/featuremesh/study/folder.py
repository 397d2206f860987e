# SPDX-License-Identifier: GPL-3.0-or-later
"""The folder of a study: `study.sqlite` with every case, `base.FCStd` that all cases start from, `cases/0001` ... with their files."""

import contextlib
import errno
import filecmp
import hashlib
import json
import os
import shutil
from pathlib import Path

from ..errors import UserError
from ..messages import said
from .database import Database
from .design import from_plain

_DATABASE = "study.sqlite"
_CHUNK = 1 << 20


class StudyFolder:
    """An existing study, or one that is being made."""

    def __init__(self, path, new=False):
        """Throws UserError: no study there, or (for a new one) one there already."""
        self.path = os.path.abspath(path)
        self.database_path = os.path.join(self.path, _DATABASE)
        self.base_path = os.path.join(self.path, "base.FCStd")
        self._lock_path = os.path.join(self.path, "running.lock")
        there = has_study(self.path)
        if new and there:
            raise UserError(said("{path:text} holds a study already: go on with `study resume`, extend it with `study add`, or name another --folder",
                                 path=path))
        if not new and not there:
            raise UserError(said("{path:text} holds no study; begin one there with `study run ... --folder {folder:text}`", path=path, folder=path))
        if new:
            self._make()
        self._lock = None
        self.database = None if new else Database(self.database_path)

    def _make(self):
        cases = Path(self.path) / "cases"
        self._made = [folder for folder in (cases, *cases.parents) if not folder.is_dir()]   # the innermost first
        try:
            cases.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            if error.errno in (errno.ENOSPC, errno.EDQUOT):
                raise
            raise UserError(said("{path:text} cannot be made a study's folder ({why:text}); name another --folder",
                                 path=self.path, why=error.strerror)) from error

    def create(self, study, facts, plan):
        """Makes the database, once the base document is there. `facts` are what base.make gave; `plan(folder)` adds the cases. The study is there with all
        its cases, or it is not there."""
        temporary = self.database_path + ".new"
        for ending in ("", "-wal", "-shm"):
            if os.path.exists(temporary + ending):
                os.unlink(temporary + ending)
        self.database = Database(temporary, new=True)
        for key, value in (("study", study.to_plain()), ("facts", facts), ("document_hash", hash_of_file(study.document)),
                           ("base_hash", hash_of_file(self.base_path))):
            self.database.set_value(key, value)
        plan(self)
        self.database.close()
        os.replace(temporary, self.database_path)
        self.database = Database(self.database_path)

    def give_up(self):
        """Leaves the folder as it was where no study came to be in it."""
        if has_study(self.path):
            return
        for path in [self._lock_path, self.base_path, *Path(self.path).glob(_DATABASE + ".new*")]:
            with contextlib.suppress(FileNotFoundError):
                os.unlink(path)
        for folder in self._made:
            with contextlib.suppress(OSError):   # somebody else has put something there
                folder.rmdir()

    def study(self):
        """The design.Study; its document, where that is kept in the folder, in the folder as it was moved or copied."""
        found = from_plain(self.database.value("study"))
        beside = os.path.join(self.path, os.path.basename(found.document))
        if beside != self.base_path and os.path.isfile(beside):
            found.document = beside
        return found

    def facts(self):
        return self.database.value("facts")

    def case_folder(self, case_id):
        """The folder of one case, made if need be."""
        folder = os.path.join(self.path, "cases", "%04d" % case_id)
        os.makedirs(folder, exist_ok=True)
        return folder

    def clear_case(self, case_id):
        """Removes what an earlier attempt left."""
        shutil.rmtree(os.path.join(self.path, "cases", "%04d" % case_id), ignore_errors=True)
        return self.case_folder(case_id)

    def lock(self):
        """Throws UserError while another process runs the study, or where it cannot be written; the lock ends with this process, however it ends."""
        import fcntl   # which Windows has not, where studies are looked at only
        try:
            stream = open(self._lock_path, "a+", encoding="utf-8")
        except OSError as error:
            raise UserError(said("cannot write {path:text}: {why:messages}", path=self._lock_path, why=error.strerror)) from error
        try:
            fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            stream.seek(0)
            owner = stream.read().strip() or "unknown"
            stream.close()
            raise UserError(said("the study in {folder:text} is being run already, by process {process:text}", folder=self.path, process=owner)) from None
        stream.truncate(0)
        stream.write("%d\n" % os.getpid())
        stream.flush()
        self._lock = stream

    def refuse_damaged_base(self):
        """Throws UserError when the base document is not the one that the cases before were made from."""
        if not os.path.isfile(self.base_path) or hash_of_file(self.base_path) != self.database.value("base_hash"):
            raise UserError(said("{path:text} is not as the study made it; start the study anew in another folder", path=self.base_path))


def has_study(path):
    """Is there a study in that folder? "" is none."""
    return bool(path) and os.path.isfile(os.path.join(path, _DATABASE))


def is_same_study(folder, other):
    """Are two folders of one study, one of them a copy? Their cases may differ since."""
    try:
        return os.path.samefile(folder, other) or filecmp.cmp(*(os.path.join(path, "base.FCStd") for path in (folder, other)))   # it remembers what it compared
    except OSError:
        return False


class DocumentWatch:
    """Tells when a study's document is no longer what it was when the study began."""

    def __init__(self, path, known_hash):
        self._path, self._known_hash = path, known_hash
        self._seen = None   # the stamp of the file that was found unchanged last

    def has_changed(self):
        """Is the file another one, or gone? It is read only when its size or time changed."""
        try:
            status = os.stat(self._path)
            stamp = (status.st_size, status.st_mtime_ns, status.st_ino)
            if stamp != self._seen:
                if hash_of_file(self._path) != self._known_hash:
                    return True
                self._seen = stamp
        except FileNotFoundError:
            return True
        return False


def hash_of_file(path):
    """SHA-256, as a hex string."""
    digest = hashlib.sha256()
    with open(path, "rb") as stream:
        while chunk := stream.read(_CHUNK):
            digest.update(chunk)
    return digest.hexdigest()


def made_of(study, facts, document_hash, parameters):
    """The hash of all that decides what a case gives: the document, the parameters, the settings, the programs."""
    plain = study.to_plain()
    settings = {key: plain[key] for key in ("object", "analysis", "mesh_size", "mesh_order", "threads", "responses")}
    said = [document_hash, parameters, settings, facts["solver"], facts["engine"], facts["freecad"]]
    return hashlib.sha256(json.dumps(said, sort_keys=True).encode()).hexdigest()
