# SPDX-License-Identifier: GPL-3.0-or-later
"""What every runner of a study does with cases: hands them out, keeps what they gave, sees that they stay cases of the same document."""

import time

from ..errors import UserError
from ..messages import said
from .database import WAITING, DiskFull
from .folder import DocumentWatch, made_of
from .room import DISK_FULL
from .steps import PROCESSORS

MOST_ATTEMPTS = 2


class Stopped(UserError):
    """The study ended before all cases were run; what was finished is kept."""


class CaseBook:
    """The cases of one folder during one run; `seconds` are those of each case that was finished."""

    def __init__(self, folder, show=None, keep_base=False):
        """`show(counts, running_for, seconds, jobs)` is called now and then. With `keep_base` the document may be another one by now."""
        self.folder, self.study, self.facts, self.database = folder, folder.study(), folder.facts(), folder.database
        self._show, self.seconds = show or (lambda *_: None), []
        self._document_hash = self.database.value("document_hash")
        self._watch = None if keep_base else DocumentWatch(self.study.document, self._document_hash)

    def waiting(self, case_ids=None):
        """The cases to run, or those of `case_ids`; what a killed runner left is among them."""
        self.folder.refuse_damaged_base()
        self.database.forget_running()
        return [case for case in self.database.cases(WAITING) if case_ids is None or case.id in case_ids]

    def refuse_changed_document(self):
        if self._watch and self._watch.has_changed():
            raise Stopped(said("{document:text} was changed since the study began; its cases are of the document as it was then (base.FCStd in its "
                               "folder). `study resume {folder:text} --keep-base` goes on with that",
                               document=self.study.document, folder=self.folder.path))

    def start(self, case):
        """What a worker needs to know of the case, which runs from now on."""
        folder = self.folder.clear_case(case.id)
        self.database.start(case.id)
        case.attempts += 1
        return {"id": case.id, "parameters": case.parameters, "folder": folder,
                "set": [parameter.assignment(case.parameters[parameter.name]) for parameter in self.study.parameters]}

    def keep(self, case, result, seconds):
        """Keeps what a case gave. Returns whether it is to be run again. Throws DiskFull."""
        if result["state"] == DISK_FULL:
            raise DiskFull(said("the disk of {folder:text} is full ({why:messages}); every finished case is safe. Make room, then go on with `study resume`",
                                folder=self.folder.path, why=result["message"]))
        if result["state"] == "killed" and case.attempts < MOST_ATTEMPTS:
            self.database.wait_again(case.id)
            return True
        self.database.finish(case.id, self._final(case, result))
        self.seconds.append(seconds)
        return False

    def _final(self, case, result):
        """The case's row: a case that was killed too often has failed."""
        if result["state"] == "killed":
            result = {**result, "state": "failed", "message": said("it was ended {times:count} {times:time|times}: {why:messages}",
                                                                   times=case.attempts, why=result["message"])}
        seconds = dict(result.get("seconds", {}))
        if "elapsed" in result:
            seconds["total"] = result["elapsed"]
            seconds[PROCESSORS] = {**seconds.get(PROCESSORS, {}), "total": result[PROCESSORS]}
        made = made_of(self.study, self.facts, self._document_hash, case.parameters)
        return {**result, "seconds": seconds, "hashes": {**result.get("hashes", {}), "made_of": made}}

    def give_back(self, case):
        """The case was not begun and waits again."""
        self.database.wait_again(case.id, counts=False)
        case.attempts -= 1

    def give_back_all(self):
        """What was not finished waits again, as if it had not been started. The database says what that is: an interrupt can come anywhere."""
        try:
            self.database.forget_running()
        except DiskFull:
            pass   # the next run does it

    def show_progress(self, started, jobs):
        """`started` are the times at which the running cases began, by time.monotonic."""
        now = time.monotonic()
        self._show(self.database.counts(), [now - start for start in started], self.seconds, jobs)

    def worker_settings(self):
        """What a worker has to know of the study."""
        limit = self.study.memory_limit_gb
        return {"base": self.folder.base_path, "study": self.study.to_plain(), "solver": self.facts["solver"],
                "seconds_limit": self.study.seconds_limit, "memory_limit": limit * 1e9 if limit else None}
