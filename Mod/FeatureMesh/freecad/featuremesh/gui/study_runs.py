# SPDX-License-Identifier: GPL-3.0-or-later
"""The studies that run beside the window, by their objects; they end with their object, document or FreeCAD."""

import FreeCAD

from ..study import study_object

_runs = {}   # (document's name, object's name) -> window_run.WindowRun


def install():
    """To be called once."""
    FreeCAD.addDocumentObserver(_Observer())
    study_object.on_run.append(_keep)


def run_of(study):
    """The study's WindowRun, the last one where it has ended; None before the first."""
    return _runs.get(_key(study))


def _keep(study, run):
    _runs[_key(study)] = run


def _key(study):
    return study.Document.Name, study.Name


def _end(study):
    run = _runs.pop(_key(study), None)
    if run is not None and run.is_running():
        run.kill()


class _Observer:

    def slotDeletedObject(self, obj):
        if study_object.is_study(obj):
            _end(obj)

    def slotDeletedDocument(self, document):
        for key in [key for key in _runs if key[0] == document.Name]:
            run = _runs.pop(key)
            if run.is_running():
                run.kill()
