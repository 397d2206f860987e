# SPDX-License-Identifier: GPL-3.0-or-later
"""What all commands share: their looks, the selection, the transaction, and the message when something is wrong."""

import contextlib

import FreeCAD
import FreeCADGui as Gui

from .. import analyses, api, assembled, reading, resolving, versions
from ..errors import UserError
from ..gui.undo import undo_step
from ..messages import said
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
        try:
            with undo_step(document, self.title) if self.edits else contextlib.nullcontext():
                self.run(document)
        except Exception as error:
            self.failed(document, error)

    def run(self, document):
        """The work; errors become a message and leave the document as it was."""
        raise NotImplementedError

    def failed(self, document, error):
        """Shows what went wrong, after the document was put back as it was."""
        from ..gui import errors
        meshes = selected_meshes(document) or api.meshes_of(document)
        errors.show(error, versions.part_of(meshes[0]) if len(meshes) == 1 else None)


def selected_mesh(document):
    """The selected mesh object, else that of a selected part, or the only one of the document. Throws UserError."""
    meshes = selected_meshes(document)
    return meshes[0] if meshes else api.find_mesh(document)


def selected_meshes(document):
    """The selected mesh objects; where there are none the mesh of what else is selected, such as a face, if that has just one."""
    selected = _selected(document)
    chosen = [obj for obj in selected if is_feature_mesh(obj)]
    parts = list(map(_part_of, selected))
    of_parts = [mesh for mesh in api.meshes_of(document) if any(api.is_mesh_of(mesh, part) for part in parts)]
    return chosen or (of_parts if len(of_parts) == 1 else [])


def chosen(document, mesh):
    """What is selected of solids, faces, edges and vertices, as (object, name) pairs that lead through links and containers; None when it is the mesh
    itself or nothing, so that they are to be chosen in the panel that opens: the part may be hidden."""
    entries = [entry for entry in _as_clicked(document) if entry.Object is not mesh]
    return None if not entries else [(entry.Object, name) for entry in entries for name in entry.SubElementNames or ("",)]


def add_and_open(document, title, add):
    """Adds an object, and opens its panel, in which more of the part can be clicked. Both are one step of undo, with what the panel changes; it ends it."""
    document.openTransaction(title)
    try:
        obj = add()
        if not Gui.getDocument(document).setEdit(obj.Name):
            document.commitTransaction()
    except Exception:
        FreeCAD.closeActiveTransaction(True)
        raise


def selected_part(document):
    """What is to be meshed of the selection: a solid, the link by which it was clicked, the body of a selected feature or sketch, the part of a mesh;
    without a selection that has to do with a solid, the only one of the document. Throws UserError."""
    through = [step for entry in _as_clicked(document) for sub in entry.SubElementNames or ("",) for step in resolving.path_of(entry.Object, sub)[0]
               if step.isDerivedFrom("App::Link")]
    if through:
        return through[0]
    selected = list(map(_part_of, _selected(document)))
    if len(set(selected)) > 1:
        raise UserError(said("several parts are selected, select one, or the container of those to mesh: {parts:text}",
                             parts=", ".join(map(reading.describe, dict.fromkeys(selected)))))
    return reading.find_meshable(document, selected[0].Name if selected else None)


def only_shown_part(document):
    """Where nothing that has to do with a part is selected, the one of the parts that is shown; else None."""
    if _selected(document):
        return None
    shown = [part for part in reading.final_parts(document) if part.ViewObject.Visibility]
    return shown[0] if len(shown) == 1 else None


def selected_container(document):
    """The selected App::Part, group or assembly, None where another thing is selected."""
    selected = _selected(document)
    return selected[0] if selected and assembled.is_container(selected[0]) else None


def _as_clicked(document):
    """The selection with the paths that lead to it, such as Link.Body.Fillet.Face19."""
    return Gui.Selection.getSelectionEx(document.Name, 0)


def _selected(document):
    """What is selected and has to do with a part, unlike a load, a group of a mesh, a result, a study or a spreadsheet."""
    return [obj for obj in Gui.Selection.getSelection(document.Name)
            if hasattr(obj, "Shape") or obj.isDerivedFrom("Mesh::Feature") or is_feature_mesh(obj) or assembled.is_to_be_shown(obj) and not analyses.is_analysis(obj)]


def _part_of(obj):
    if is_feature_mesh(obj):
        return versions.part_of(obj) or obj
    group = obj.getParentGeoFeatureGroup()
    if group is not None and group.TypeId == "PartDesign::Body":
        return group
    if reading.has_shape(obj) and not reading.is_drawn(obj):
        return obj
    made_of_it = [part for part in reading.final_parts(obj.Document) if obj in reading.dependencies(part)]
    return made_of_it[0] if len(made_of_it) == 1 else obj
