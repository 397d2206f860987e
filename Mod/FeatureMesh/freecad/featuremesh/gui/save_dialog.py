# SPDX-License-Identifier: GPL-3.0-or-later
"""Asks for the file to write."""

import os
import re

import FreeCAD
from PySide import QtGui

from . import message_box

translate = FreeCAD.Qt.translate


def ask_for_file(parent, title, proposed, filters, endings):
    """The path of the file to write, None where there is to be none; `endings` are those that the program knows, such as "csv".

    A name without one of these gets that of the chosen kind of file, and so does the proposed ending where another kind was chosen. Qt asks before a
    file is replaced that was named as a whole only, so that of another name is asked for here.
    """
    typed, kind = QtGui.QFileDialog.getSaveFileName(parent, title, proposed, filters)
    if not typed:
        return None
    wanted = re.search(r"\*(\.\w+)", kind).group(1)
    stem, ending = os.path.splitext(typed)
    if ending.lstrip(".").lower() not in endings:   # a dot in a name, as in "plate 1.5 mm", is no ending
        path = typed + wanted
    else:
        path = stem + wanted if ending == os.path.splitext(proposed)[1] else typed
    if path != typed and os.path.exists(path):
        if not message_box.is_agreed(title, translate("FeatureMesh", "%s is there already. Replace it?") % path, parent):
            return None
    return os.path.abspath(path)
