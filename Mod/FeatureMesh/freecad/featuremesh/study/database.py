# SPDX-License-Identifier: GPL-3.0-or-later
"""Every case of a study in one SQLite file, which other programs may read while the study runs."""

import json
import os
import shutil
import sqlite3
import tempfile
import urllib.parse
from contextlib import contextmanager
from dataclasses import dataclass, field

from ..errors import UserError
from ..messages import is_message, of_error, said

SCHEMA = 1
WAITING, RUNNING, DONE, INFEASIBLE, FAILED = "waiting", "running", "done", "infeasible", "failed"
STATES = (WAITING, RUNNING, DONE, INFEASIBLE, FAILED)
_TABLES = """
create table study (key text primary key, value text not null);
create table cases (
  id integer primary key, state text not null, parameters text not null, responses text not null default '{}', message text not null default '',
  seconds text not null default '{}', mesh text not null default '{}', hashes text not null default '{}', attempts integer not null default 0,
  maker text not null default '');
create unique index cases_by_parameters on cases (parameters);
"""
_COPY = "study.sqlite"   # its name in a temporary folder
_JSON = ("parameters", "responses", "seconds", "mesh", "hashes")


@dataclass
class Case:
    """One row: what was asked, and what came out."""
    id: int
    state: str
    parameters: dict
    responses: dict = field(default_factory=dict)
    message: object = ""                          # of messages.py, or a text as older programs kept it
    seconds: dict = field(default_factory=dict)   # of each step (see steps.py)
    mesh: dict = field(default_factory=dict)      # nodes, tets, kept share
    hashes: dict = field(default_factory=dict)    # made_of: document, parameters, settings; result: mesh and responses
    attempts: int = 0
    maker: str = ""                               # what asked for it: the sampling, a file, an optimiser


class DiskFull(UserError):
    """Nothing more can be written; what was finished is safe."""


class Database:
    """The file of one study. Each method is one transaction, on the disk when it returns."""

    def __init__(self, path, new=False):
        """Opens it, or makes it; in a folder that cannot be written only to be read. Throws UserError for what is no study's file or a newer program's."""
        self._path = path
        is_writable = os.access(os.path.dirname(os.path.abspath(path)), os.W_OK)
        self._copy = None if is_writable else _copy_with_log(path)
        self._link = _link_to_copy(self._copy.name) if self._copy else _link_to(path, "" if is_writable else "?immutable=1")
        try:
            with _disk_errors(path):
                if is_writable:
                    self._link.execute("pragma journal_mode=wal")
                    self._link.execute("pragma synchronous=full")
                if new:
                    with self._transaction():
                        for statement in _TABLES.split(";"):
                            self._link.execute(statement)
                        self._link.execute("insert into study values ('schema', ?)", (json.dumps(SCHEMA),))
            schema = self.value("schema")
        except sqlite3.DatabaseError as error:
            raise UserError(said("{path:text} is no study's database: {why:messages}", path=path, why=of_error(error))) from error
        if schema != SCHEMA:
            raise UserError(said("{path:text} is of a newer FeatureMesh (schema {schema:text}, this one reads {newest:count})",
                                 path=path, schema=schema, newest=SCHEMA))

    def close(self):
        self._link.close()
        if self._copy:
            self._copy.cleanup()

    def value(self, key, default=None):
        """Something kept about the whole study."""
        row = self._link.execute("select value from study where key = ?", (key,)).fetchone()
        return json.loads(row[0]) if row else default

    def set_value(self, key, value):
        with self._transaction():
            self._link.execute("insert or replace into study values (?, ?)", (key, json.dumps(value)))

    def add_cases(self, cases, maker, values=None):
        """Adds (parameters, message) pairs; those with a message are infeasible at once. Cases that are there already are not added.

        `values` are set in the same transaction. Returns the ids, also of those that were there.
        """
        with self._transaction():
            for parameters, message in cases:
                self._link.execute("insert or ignore into cases (state, parameters, message, maker) values (?, ?, ?, ?)",
                                   (INFEASIBLE if message else WAITING, _key(parameters), _message(message), maker))
            for key, value in (values or {}).items():
                self._link.execute("insert or replace into study values (?, ?)", (key, json.dumps(value)))
        return [self._link.execute("select id from cases where parameters = ?", (_key(parameters),)).fetchone()[0] for parameters, _ in cases]

    def start(self, case_id):
        """The case is running from now on."""
        with self._transaction():
            self._link.execute("update cases set state = ?, attempts = attempts + 1 where id = ?", (RUNNING, case_id))

    def wait_again(self, case_id, counts=True):
        """The case was not finished; an attempt that does not count is taken back."""
        with self._transaction():
            self._link.execute("update cases set state = ?, attempts = attempts - ? where id = ?", (WAITING, 0 if counts else 1, case_id))

    def finish(self, case_id, result):
        """Keeps what a case gave."""
        with self._transaction():
            self._link.execute("update cases set state = ?, responses = ?, message = ?, seconds = ?, mesh = ?, hashes = ? where id = ?",
                               (result["state"], _plain(result.get("responses")), _message(result.get("message")), _plain(result.get("seconds")),
                                _plain(result.get("mesh")), _plain(result.get("hashes")), case_id))

    def forget_running(self):
        """Cases that a runner began and did not finish wait again. Returns how many these were."""
        with self._transaction():
            return self._link.execute("update cases set state = ?, attempts = attempts - 1 where state = ?", (WAITING, RUNNING)).rowcount

    def retry_failed(self):
        """Failed cases wait again, with all their attempts. Returns how many these were."""
        with self._transaction():
            return self._link.execute("update cases set state = ?, attempts = 0, message = '' where state = ?", (WAITING, FAILED)).rowcount

    def cases(self, state=None):
        """All cases, or those in a state, by their ids."""
        where = (" where state = ?", (state,)) if state else ("", ())
        cursor = self._link.execute("select * from cases" + where[0] + " order by id", where[1])
        names = [column[0] for column in cursor.description]
        return [_case(dict(zip(names, row))) for row in cursor]

    def case(self, case_id):
        cursor = self._link.execute("select * from cases where id = ?", (case_id,))
        row = cursor.fetchone()
        return _case(dict(zip([column[0] for column in cursor.description], row))) if row else None

    def counts(self):
        """{state: number of cases}, every state named."""
        found = dict(self._link.execute("select state, count(*) from cases group by state").fetchall())
        return {state: found.get(state, 0) for state in STATES}

    def mean_seconds(self):
        """What a case that is done took, in the mean; None before the first. It reads no case, and so is quick for thousands."""
        return self._link.execute("select avg(json_extract(seconds, '$.total')) from cases where state = ?", (DONE,)).fetchone()[0]

    def first_lost(self):
        """The first case that could not be made or solved, None where there is none."""
        found = self._link.execute("select min(id) from cases where state in (?, ?)", (FAILED, INFEASIBLE)).fetchone()[0]
        return None if found is None else self.case(found)

    @contextmanager
    def _transaction(self):
        with _disk_errors(self._path):
            try:
                self._link.execute("begin immediate")
                yield
                self._link.execute("commit")
            except BaseException:
                if self._link.in_transaction:
                    self._link.execute("rollback")
                raise


def _link_to(path, words):
    return sqlite3.connect("file:%s%s" % (urllib.parse.quote(path), words), isolation_level=None, timeout=30.0, uri=True)


def _copy_with_log(path):
    """A temporary folder with a copy of a database and its log, whose cases SQLite reads only where it may write; None where the log holds none. Throws
    UserError."""
    log = path + "-wal"
    try:
        if not os.path.exists(log) or not os.path.getsize(log):
            return None
        folder = tempfile.TemporaryDirectory(prefix="featuremesh-")
        for file, name in ((path, _COPY), (log, _COPY + "-wal")):
            shutil.copyfile(file, os.path.join(folder.name, name))
    except OSError as error:
        raise UserError(said("cannot read {path:text}: {why:messages}", path=path, why=error.strerror)) from error
    return folder


def _link_to_copy(folder):
    """For reading."""
    link = _link_to(os.path.join(folder, _COPY), "")
    link.execute("pragma query_only=true")
    return link


@contextmanager
def _disk_errors(path):
    """SQLite's word for a full disk as ours."""
    try:
        yield
    except sqlite3.OperationalError as error:
        if any(words in str(error) for words in ("disk is full", "disk I/O error", "readonly database", "unable to open")):
            raise DiskFull(said("{path:text} cannot be written: {why:messages}; every finished case is safe. Make room, then go on with `study resume`",
                                path=path, why=of_error(error))) from error
        raise


def _key(parameters):
    return json.dumps(parameters, sort_keys=True)


def _plain(value):
    return json.dumps(value or {}, sort_keys=True)


def _message(value):
    return json.dumps(value, sort_keys=True) if is_message(value) else value or ""


def _case(row):
    known = {name: json.loads(value) if name in _JSON else value for name, value in row.items()}
    return Case(**{**known, "message": json.loads(row["message"]) if row["message"].startswith('{"') else row["message"]})
