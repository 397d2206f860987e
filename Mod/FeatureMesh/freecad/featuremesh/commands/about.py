# SPDX-License-Identifier: GPL-3.0-or-later
from .base import MeshCommand


class Command(MeshCommand):
    name = "FeatureMesh_About"
    text = "About FeatureMesh"
    tooltip = "Shows versions, where things are installed and where the log is, to be copied into a bug report"
    edits = False

    def IsActive(self):
        return True

    def Activated(self):
        from ..gui import about
        about.show()
