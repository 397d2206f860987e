# SPDX-License-Identifier: GPL-3.0-or-later
"""What all commands share: their looks, the selection, the transaction, and the message when something is wrong."""

import FreeCAD
import FreeCADGui as Gui

from .. import api, reading, versions
from ..mesh_object import is_feature_mesh
from ..view_provider import icon


class MeshCommand:
    """A command on the selected mesh object, or the only one."""

    name = text = tooltip = ""
    edits = True   # does it change the document, so that it can be undone?

    def GetResources(self):
        # FreeCAD itself translates these, with the command's name as context, and again when the language changes.
        return {"Pixmap": icon(self.name), "MenuText": self.text, "ToolTip": self.tooltip}

    @property
    def title(self):
        """The text in the user's language."""
        return FreeCAD.Qt.translate(self.name, self.text)

    def IsActive(self):
        document = FreeCAD.ActiveDocument
        return document is not None and not Gui.Control.activeDialog() and self.is_possible(document)

    def is_possible(self, document):
        """Is there something the command can work on?"""
        return bool(api.meshes_of(document))

    def Activated(self):
        document = FreeCAD.ActiveDocument
        if self.edits:
            document.openTransaction(self.title)
        try:
            self.run(document)
            if self.edits:
                document.commitTransaction()
        except Exception as error:
            if self.edits:
                document.abortTransaction()
            self.failed(document, error)

    def run(self, document):
        """The work; errors become a message and leave the document as it was."""
        raise NotImplementedError

    def failed(self, document, error):
        """Shows what went wrong, after the document was put back as it was."""
        from ..gui import errors
        meshes = api.meshes_of(document)
        errors.show(error, versions.part_of(selected_mesh(document)) if len(meshes) == 1 else None)


def selected_mesh(document):
    """The selected mesh object, or the only one of the document. Throws UserError."""
    meshes = [obj for obj in Gui.Selection.getSelection(document.Name) if is_feature_mesh(obj)]
    return meshes[0] if meshes else api.find_mesh(document)


def selected_part(document):
    """The selected object, or the only solid of the document. Throws UserError."""
    selection = Gui.Selection.getSelection(document.Name)
    if not selection:
        return reading.find_meshable(document)
    part = selection[0]
    body = part.getParentGeoFeatureGroup() if part.isDerivedFrom("PartDesign::Feature") else None
    return reading.find_meshable(document, (body or part).Name)
