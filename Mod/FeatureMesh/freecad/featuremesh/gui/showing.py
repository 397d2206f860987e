# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows a part in place of its meshes: in one place they would flicker, and hide the faces that are selected."""

import FreeCAD

from .. import api, versions


def show_part(part):
    """Shows the part and hides its meshes. Returns what `restore` needs to take that back."""
    shown = {part: True}
    shown.update((mesh, False) for mesh in api.meshes_of(part.Document) if versions.part_of(mesh) is part)
    before = [(obj.Document.Name, obj.Name, obj.ViewObject.Visibility) for obj in shown]
    for obj, visible in shown.items():
        obj.ViewObject.Visibility = visible
    return before


def restore(before):
    """Makes visible and hides what was so before show_part, as far as it is still there."""
    for document_name, name, visible in before:
        document = FreeCAD.listDocuments().get(document_name)
        obj = document.getObject(name) if document is not None else None
        if obj is not None:
            obj.ViewObject.Visibility = visible
