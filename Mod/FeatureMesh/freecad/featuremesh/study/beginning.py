# SPDX-License-Identifier: GPL-3.0-or-later
"""Begins a study: its folder with the base document and the planned cases."""

from ..errors import UserError
from ..messages import said
from . import planning
from .folder import StudyFolder, hash_of_file


def begin(study, path, make_base):
    """The folder, locked. `make_base(plain_study, out)` writes the base document and returns what is known then, as base.make does. Throws UserError, and
    leaves nothing behind where no study begins."""
    folder = StudyFolder(path, new=True)
    folder.lock()
    try:
        _fill(folder, study, make_base)
    except BaseException:
        folder.give_up()
        raise
    return folder


def _fill(folder, study, make_base):
    before = hash_of_file(study.document)
    facts = make_base(study.to_plain(), folder.base_path)
    if hash_of_file(study.document) != before:
        raise UserError(said("{document:text} was changed while its base mesh was made; start the study again", document=study.document))
    folder.create(study, facts, planning.plan)
