# SPDX-License-Identifier: GPL-3.0-or-later
"""What a script, a command or a button can do; everything else in this package serves these functions."""

import math
import os
import shutil
import tempfile
import time

import FreeCAD
import ObjectsFem

from . import documents, edits, engine, export, overlays, reading, versions
from .errors import UserError
from .mesh_object import FeatureMesh, is_feature_mesh, options_of, plain

translate = FreeCAD.Qt.translate
DEFAULT_ELEMENTS = 30


def add_mesh(part, size=None, order=1, threads=0, name="FeatureMesh", automatic=True, elements=DEFAULT_ELEMENTS):
    """Adds a mesh object for `part` to its document; recompute it, or call update_mesh, to mesh.

    `size` in mm, by default the part's diagonal over `elements`. Throws UserError for sizes that make no sense.
    """
    size = default_size(part, elements) if size is None else float(size)
    check_size(size, part)
    mesh = part.Document.addObject(versions.mesh_object_type(), name)
    FeatureMesh(mesh)
    setattr(mesh, versions.part_property(mesh), part)
    mesh.Size, mesh.Order, mesh.Threads, mesh.Automatic = size, "2nd" if order == 2 else "1st", threads, automatic
    _join_analysis(mesh, part.Document)
    return mesh


def update_mesh(mesh, full=False, progress=None):
    """Brings the mesh up to date with its part, locally unless `full`. Returns the report (a dict)."""
    report = mesh.Proxy.update(mesh, full, progress)
    mesh.purgeTouched()
    return report


def recompute(document):
    """Recomputes, and returns the seconds FreeCAD took for it without the meshes.

    Throws UserError that names the feature and FreeCAD's message when a mesh's part has a feature in error that was not
    in error before, and the mesh's own error when that is what failed.
    """
    meshes = [obj for obj in document.Objects if is_feature_mesh(obj)]
    before = {obj for obj in document.Objects if reading.error_of(obj)}
    reports = {mesh: mesh.Report for mesh in meshes}
    start = time.perf_counter()
    document.recompute()
    seconds = time.perf_counter() - start
    for mesh in meshes:
        part = versions.part_of(mesh)
        for obj in (reading.dependencies(part) if part is not None else []):
            if reading.error_of(obj) and obj not in before:
                raise UserError(translate("FeatureMesh", "FreeCAD cannot recompute %s: %s") % (reading.describe(obj), reading.error_of(obj)))
        if mesh.Report != reports[mesh]:
            seconds -= mesh.Seconds
    return max(seconds, 0.0)


def set_parameters(document, assignments):
    """Applies edits such as "Pad.Length=12" or "Sketch.HoleX=30"; does not recompute. Throws UserError."""
    for assignment in assignments:
        edits.set_parameter(document, assignment)


def difference(old_part, new_part, resolution=0.0):
    """The feature difference of two objects, from one document or two (see featuremesh_engine.compare)."""
    return engine.load().compare(reading.read_document(old_part), reading.read_document(new_part), resolution)


def draw_difference(old_part, new_part, found, path):
    """Writes a picture of the difference `found` of two objects: kept, vanished and appeared faces in colours."""
    from . import difference_picture
    difference_picture.write(path, reading.outline_of(old_part), reading.outline_of(new_part), found["faces"])


def tree(part):
    """The feature tree of `part` as the engine understands it (see featuremesh_engine.read_tree)."""
    return engine.load().read_tree(reading.read_document(part))


def difference_to_file(part, path):
    """The feature difference between the part of the document in `path` (old) and `part` (new)."""
    active = FreeCAD.ActiveDocument
    with tempfile.TemporaryDirectory(prefix="featuremesh-") as folder:
        copy = os.path.join(folder, os.path.basename(path))  # FreeCAD opens no file twice, and `path` may be open
        try:
            shutil.copyfile(path, copy)
        except OSError as error:
            raise UserError(translate("FeatureMesh", "cannot read %s: %s") % (path, error)) from error
        document = documents.open_document(copy)
        try:
            old = reading.find_meshable(document, part.Name if document.getObject(part.Name) else None)
            return plain(difference(old, part))
        finally:
            FreeCAD.closeDocument(document.Name)
            if active is not None:
                FreeCAD.setActiveDocument(active.Name)


def estimate_tets(mesh):
    """About how many tets the mesh would have with its present settings."""
    return estimated_tets(*estimate_input(mesh))


def estimate_input(mesh, raw=None, **settings):
    """What estimated_tets needs of a mesh object, with other engine options than the object's where given.

    `raw` is the part as it was read before, when it is known to be the same still.
    """
    part = versions.part_of(mesh)
    options = options_of(mesh, part)
    options.update((name, value) for name, value in settings.items() if value is not None)
    return raw or reading.read_document(part), options


def estimated_tets(raw, options):
    """The estimate itself; touches no FreeCAD object, so any thread may ask for it."""
    return engine.load().estimate_tets(raw, options)


def add_local_size(mesh, references, size=None):
    """Adds an FEM mesh refinement: `size` (mm, by default half the mesh size) on faces, edges or vertices of the part.

    `references` are (object, "Face3") pairs. Throws UserError when there are none, or when they are not on the part.
    """
    part = versions.part_of(mesh)
    foreign = [obj for obj, _ in references if obj is not part]
    if not references or foreign:
        raise UserError(translate("FeatureMesh", "select faces, edges or vertices of %s%s")
                        % (reading.describe(part), translate("FeatureMesh", ", not of %s") % foreign[0].Name if foreign else ""))
    region = ObjectsFem.makeMeshRegion(mesh.Document, mesh, mesh.Size.Value / 2 if size is None else size)
    region.References = references
    return region


def show_kept(mesh):
    """Colours the elements in the window, if there is one: those the last update kept, and new ones. Returns {tet number: colour}.

    Throws UserError when there was no update since the document was opened.
    """
    return _coloured(mesh, overlays.kept_colours(mesh))


def show_quality(mesh):
    """Colours the elements in the window, if there is one, by their smallest angle. Returns {tet number: colour}."""
    return _coloured(mesh, overlays.quality_colours(mesh))


def show_plain(mesh):
    """Takes colours away again."""
    _coloured(mesh, {})


def export_mesh(mesh, path, file_format=None):
    """Writes the mesh with its groups as vtu, inp, unv or med (by default what the file's name says)."""
    export.write(mesh, path, file_format or os.path.splitext(path)[1].lstrip("."))


def meshes_of(document):
    """All FeatureMesh objects of the document."""
    return [obj for obj in document.Objects if is_feature_mesh(obj)]


def find_mesh(document, part_name=None):
    """The document's mesh object, of that part when named. Throws UserError: none, or several."""
    meshes = meshes_of(document)
    if part_name:
        part = reading.find_object(document, part_name)
        meshes = [mesh for mesh in meshes if part in (mesh, versions.part_of(mesh))]
    if not meshes:
        raise UserError(translate("FeatureMesh", "the document %s has no mesh%s; make one with `featuremesh mesh`")
                        % (document.Label, translate("FeatureMesh", " of %s") % part_name if part_name else ""))
    if len(meshes) > 1:
        raise UserError(translate("FeatureMesh", "the document has several meshes, select one or name it with --object: %s")
                        % ", ".join(reading.describe(mesh) for mesh in meshes))
    return meshes[0]


def default_size(part, elements=DEFAULT_ELEMENTS):
    """A sensible edge length for a part: its diagonal over `elements`, rounded to two digits, mm."""
    size = part.Shape.BoundBox.DiagonalLength / elements
    digits = 1 - int(math.floor(math.log10(size))) if size > 0 else 0
    return round(size, digits)


def _coloured(mesh, colours):
    if mesh.ViewObject is not None:
        mesh.ViewObject.Proxy.colour(mesh, colours)
        mesh.ViewObject.Visibility = True
    return colours


def _join_analysis(mesh, document):
    """A lone analysis without a mesh gets this one; an analysis works with exactly one."""
    analyses = [obj for obj in document.Objects if obj.isDerivedFrom("Fem::FemAnalysis")]
    if len(analyses) == 1 and not any(member.isDerivedFrom("Fem::FemMeshObject") for member in analyses[0].Group):
        analyses[0].addObject(mesh)


def check_size(size, part):
    """Throws UserError for a size that is not positive or larger than the part."""
    diagonal = part.Shape.BoundBox.DiagonalLength
    if not size > 0 or math.isinf(size):
        raise UserError(translate("FeatureMesh", "the size has to be greater than 0 mm, not %g") % size)
    if size > diagonal:
        raise UserError(translate("FeatureMesh", "the size %g mm is larger than the part (%g mm across); try %g")
                        % (size, diagonal, default_size(part)))

