# SPDX-License-Identifier: GPL-3.0-or-later
"""What a script, a command or a button can do; everything else in this package serves these functions."""

import contextlib
import math
import os
import shutil
import tempfile
import time

import FreeCAD
import ObjectsFem

from . import requirements
requirements.check()   # before what cannot be imported otherwise
from . import (adopt, analyses, assembled, difference_drawing, documents, edits, engine, export, history, load_cases, mesh_drawing, overlays, reading,
               recompute_errors, resolving, section, size_zone, solve_guard, solving, statics, statics_result, transfer, versions)
from . import live_result as live_results
from .about import facts
from .errors import NotSelected, StateError, UserError
from .messages import of_error, said
from .mesh_object import FeatureMesh, is_feature_mesh, options_of, refuse_other
from .mesh_properties import DIMENSIONS, FROM_SHAPE, what_it_is_of
from .refining import refine_by_error, solve_to  # noqa: F401
from .refusals import all_or_nothing, finite_length, length_of, measure_of, pairs_given, part_to_mesh, refuse_no_document, refuse_no_size
from .reports import plain

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
DEFAULT_ELEMENTS = 30


def add_mesh(part, size=None, order=None, threads=0, name="FeatureMesh", automatic=True, elements=DEFAULT_ELEMENTS,
             join_analysis=True, active_analysis=None, dimension=FROM_SHAPE, ignore_below=0.0, in_place_of=None):
    """Adds a mesh object for `part` to its document; recompute it, or call update_mesh, to mesh.

    Of a container (App::Part, group, assembly) all parts are meshed, each by itself, by way of an object that shows them (see assembled.py); so is a link.

    `size` in mm, by default the part's diagonal over `elements`; `order` 2 for 10-node tetrahedra (the default), 1 for 4-node ones, which are far too stiff
    in bending; `dimension` "Solids", "Faces" (triangles for shells), "Edges" (segments for beams), or by default what the shape has. Details smaller
    than `ignore_below` (mm) get no elements of their own; 0: those below a two-hundredth of the size, or fewer where the part cannot be meshed without
    them, negative: none. It joins the active analysis, where one is given, or the one that it is for, see analyses.for_new_mesh; or those of `in_place_of`, a mesh object
    of another maker that leaves them and stays in the document, whose refinements and groups are the new mesh's, too, and whose size and order are the defaults.
    Throws UserError for sizes that make no sense.
    """
    reading.refuse_gone(part)
    order = adopt.asked_order(in_place_of) if order is None else order
    if order not in (1, 2):
        raise UserError(said("the order is 1 (4-node) or 2 (10-node), not {order:text}", order=str(order)))
    if not isinstance(threads, int) or threads < 0:
        raise UserError(said("the number of threads is a whole number, 0 for all that the machine has, not {threads:text}", threads=str(threads)))
    if dimension not in DIMENSIONS:
        raise UserError(said("the dimension is one of {dimensions:text}, not {dimension:text}", dimensions=", ".join(DIMENSIONS), dimension=str(dimension)))
    with all_or_nothing(part.Document):
        part = _shown_by_one(part)
        size = adopt.asked_size(in_place_of) or default_size(part, elements) if size is None else length_of(size)
        check_size(size, part)
        ignore_below = finite_length(ignore_below)
        mesh = part.Document.addObject(versions.mesh_object_type(), name)
        FeatureMesh(mesh)
        setattr(mesh, versions.part_property(mesh), part)
        mesh.Size, mesh.Order, mesh.Threads, mesh.Automatic = size, "2nd" if order == 2 else "1st", threads, automatic
        mesh.Dimension, mesh.IgnoreBelow = dimension, ignore_below
        if in_place_of is not None:
            _take_what_belongs_to(in_place_of, mesh)
            _take_place_of([in_place_of], mesh)
        elif join_analysis:
            _join_analysis(mesh, part, active_analysis)
        return mesh


def _shown_by_one(part):
    """The part, or the object that shows all parts of a container, or what a link shows. Throws UserError for what cannot be meshed."""
    if assembled.is_to_be_shown(part):
        if not assembled.is_container(part):
            reading.refuse_unmeshable(part)
        part = assembled.of(part)
    reading.refuse_unmeshable(part)
    assembled.refuse_endless(part)
    return part


def _join_analysis(mesh, part, active):
    analysis, remark = analyses.for_new_mesh(part, active)
    if analysis is not None:
        analyses.take_in(analysis, mesh)
    if remark:
        FreeCAD.Console.PrintWarning("%s: %s\n" % (mesh.Label, remark))


def _take_what_belongs_to(foreign, mesh):
    """Its refinements and groups."""
    for name in ("MeshRegionList", "MeshGroupList"):
        setattr(mesh, name, [obj for obj in getattr(foreign, name, []) if not getattr(obj, "Suppressed", False)])


def _take_place_of(replaced, mesh):
    """Of these meshes, in the analysis of the first of them that is in one."""
    for analysis in next(filter(None, map(analyses.directly_holding, replaced)), []):
        analyses.take_in(analysis, mesh, set(analysis.Group).intersection(replaced))


def update_mesh(mesh, full=False, progress=None):
    """Brings the mesh up to date with its part, locally unless `full`. Returns the report (a dict)."""
    refuse_other(mesh)
    report = mesh.Proxy.update(mesh, full, progress)
    mesh.purgeTouched()
    return report


def adopt_mesh(foreign, part=None, size=None, progress=None, in_place_of=None, threads=0, automatic=True):
    """Makes the mesh of another FEM mesh object (Gmsh, Netgen, imported) a mesh object of ours that updates locally.

    `part` is by default the one the mesh was made of, `size` (mm) the edge length most of the mesh has. What fits the part keeps its
    bits and numbers. Analyses get the new object in place of the old one, which stays in the document; so does `in_place_of`, a mesh of ours that the part
    has already. Returns the mesh object and the report. Throws UserError.
    """
    reading.refuse_gone(foreign, said("the FEM mesh of another maker"))
    if is_feature_mesh(foreign):
        raise UserError(said("{foreign:text} is FeatureMesh's own already", foreign=reading.describe(foreign)))
    if not foreign.isDerivedFrom("Fem::FemMeshObject"):
        raise UserError(said("{foreign:text} is no FEM mesh", foreign=reading.describe(foreign)))
    part = part or adopt.part_of(foreign) or reading.find_meshable(foreign.Document)
    others = [mesh for mesh in meshes_of(foreign.Document) if is_mesh_of(mesh, part)]
    if others and in_place_of is None:
        raise UserError(said("{part:text} has a mesh already: {mesh:text}; delete one of the two",
                             part=reading.describe(part), mesh=reading.describe(others[0])))
    arrays = adopt.arrays_of(foreign)
    order = 2 if len(arrays["tet_mids"]) else 1
    with all_or_nothing(foreign.Document):
        mesh = add_mesh(part, adopt.typical_size(arrays) if size is None else size, order, threads, automatic=automatic, join_analysis=False)
        _take_what_belongs_to(foreign, mesh)
        report = mesh.Proxy.adopt(mesh, arrays, progress)
    _take_place_of([foreign] if in_place_of is None else [foreign, in_place_of], mesh)
    mesh.Proxy.renew_groups(mesh)
    mesh.purgeTouched()
    return mesh, report


def renumber_mesh(mesh):
    """Numbers nodes and elements anew, from 1 without gaps; updates never do. Groups follow, results solved before do not.

    Returns the largest node and element numbers before. Throws UserError when the mesh has no usable state.
    """
    refuse_other(mesh)
    try:
        return mesh.Proxy.renumber(mesh)
    except (StateError, engine.load().StateError) as error:
        raise UserError(said("{mesh:text} cannot be renumbered: {why:messages}", mesh=reading.describe(mesh), why=of_error(error))) from error


def recompute(document):
    """Recomputes, and returns the seconds FreeCAD took for it without the meshes.

    Throws UserError that names the feature and FreeCAD's message when a mesh's part has a feature in error that was not
    in error before, or that leaves the mesh as it was, and the mesh's own error when that is what failed.
    """
    refuse_no_document(document)
    meshes = meshes_of(document)
    before = recompute_errors.in_error(document)
    reports = {mesh: mesh.Report for mesh in meshes}
    start = time.perf_counter()
    document.recompute()
    seconds = time.perf_counter() - start
    found = recompute_errors.in_error(document)
    for mesh in meshes:
        is_left = mesh.Automatic and ("Touched" in mesh.State or not found.issuperset(history.edited_behind(mesh)))
        error = recompute_errors.error_of_part(versions.part_of(mesh), found if is_left else found - before)
        if error is not None:
            raise error
        if mesh.Automatic and mesh in found:
            raise UserError(mesh.Proxy.why_not_to_solve(mesh))
        if mesh.Report != reports[mesh]:
            seconds -= mesh.Seconds
    return max(seconds, 0.0)


def set_parameters(document, assignments):
    """Applies edits such as "Pad.Length=12" or "Sketch.HoleX=30"; does not recompute. Throws UserError."""
    refuse_no_document(document)
    for assignment in [assignments] if isinstance(assignments, str) else assignments:
        edits.set_parameter(document, assignment)


def edit(document, assignments):
    """set_parameters and recompute in one; returns the seconds. What FreeCAD cannot recompute when all of it is set at once is set one by one, in this order or in
    the other: since 1.0 a fillet may lose an edge that two dimensions move at once. Throws UserError, and what was set is as it was before."""
    refuse_no_document(document)
    assignments = [assignments] if isinstance(assignments, str) else list(assignments)
    before = [edits.value_before(document, assignment) for assignment in assignments]
    try:
        return _recompute_with(document, assignments)
    except recompute_errors.NotRecomputed:
        for one_by_one in (assignments, assignments[::-1]) if len(assignments) > 1 else ():
            with contextlib.suppress(UserError):
                return sum(_recompute_with(document, step) for step in (before, *one_by_one))
        with contextlib.suppress(UserError):
            _recompute_with(document, before)
        raise


def _recompute_with(document, assignments):
    set_parameters(document, assignments)
    return recompute(document)


def difference(old_part, new_part, resolution=0.0):
    """The feature difference of two objects, from one document or two (see featuremesh_engine.compare)."""
    for part in (old_part, new_part):
        reading.refuse_gone(part)
    return engine.load().compare(reading.read_document(old_part), reading.read_document(new_part), resolution)


def draw_difference(old_part, new_part, found, path):
    """Writes a picture of the difference `found` of two objects: kept, vanished and appeared faces in colours."""
    difference_drawing.draw(old_part, new_part, found["faces"], path)


def tree(part):
    """The feature tree of `part` as the engine understands it (see featuremesh_engine.read_tree)."""
    reading.refuse_gone(part)
    return engine.load().read_tree(reading.read_document(part))


def difference_to_file(part, path):
    """The feature difference between the part of the document in `path` (old) and `part` (new)."""
    reading.refuse_gone(part)
    active = FreeCAD.ActiveDocument
    with tempfile.TemporaryDirectory(prefix="featuremesh-") as folder:
        copy = os.path.join(folder, os.path.basename(path))  # FreeCAD opens no file twice, and `path` may be open
        try:
            shutil.copyfile(path, copy)
        except OSError as error:
            raise UserError(said("cannot read {path:text}: {why:messages}", path=path, why=error.strerror or of_error(error))) from error
        document = documents.open_document(copy)
        try:
            old = reading.find_meshable(document, part.Name if document.getObject(part.Name) else None)
            return plain(difference(old, part))
        finally:
            FreeCAD.closeDocument(document.Name)
            if active is not None:
                FreeCAD.setActiveDocument(active.Name)


def estimate_tets(mesh):
    """About how many elements the mesh would have with its present settings."""
    return estimated_tets(*estimate_input(mesh))


def estimate_input(mesh, raw=None, settings=None):
    """What estimated_tets needs of a mesh object, with other values of its settings than the object's where given.

    `raw` is the part as it was read before, when it is known to be the same still.
    """
    refuse_other(mesh)
    part = part_to_mesh(mesh)
    options = options_of(mesh, part, settings=settings)
    return raw or reading.read_document(part), options


def estimated_tets(raw, options):
    """The estimate itself; touches no FreeCAD object, so any thread may ask for it."""
    return engine.load().estimate_tets(raw, options)


def add_local_size(mesh, references, size=None):
    """Adds an FEM mesh refinement: `size` (mm, by default half the mesh size) on faces, edges or vertices of the part, or in one of several solids.

    `references` are names of the part, such as "Face3", or (object, "Face3") pairs as a selection or the References of another object have them: of the part,
    of a feature of it, or through a link or container; None for none yet. Throws UserError when there are none, or when they are not on the part.
    """
    names = _refined_names(mesh, references, some_solids=True)
    region = ObjectsFem.makeMeshRegion(mesh.Document, mesh, _size_of(mesh, size))
    region.References = _references(mesh, names)
    return region


def add_size_zone(mesh, kind="Box", references=None, placement=None, inner=None, outer=0.0, transition=0.0, **measures):
    """Adds a refinement zone to the mesh: elements of `inner` mm (by default half the mesh size) inside, growing over `transition` mm to `outer` mm (0: the mesh size).

    `kind` is "Box" (length, width, height from the corner of the placement), "Sphere" (radius around it), "Cylinder" (radius, height along its z axis) or
    "Distance" (all that is no further than `distance` from the references, which are as for add_local_size). What is not given is chosen by the part's
    measures. It is a document object; its property Suppressed leaves it out. Throws UserError.
    """
    if kind not in size_zone.KINDS:
        raise UserError(said("a refinement zone is one of {kinds:text}, not {kind:text}", kinds=", ".join(size_zone.KINDS), kind=kind))
    names = _refined_names(mesh, references if kind == size_zone.DISTANCE else None)
    part = versions.part_of(mesh)
    if not reading.has_shape(part):
        raise UserError(reading.no_shape(part))
    unknown = set(measures) - {name.lower() for name in size_zone.MEASURES[kind]}
    if unknown:
        raise UserError(said("a zone of the kind {kind:text} has no {property:text}", kind=kind, property=sorted(unknown)[0]))
    inner, outer, transition = _size_of(mesh, inner), measure_of("outer", outer), measure_of("transition", transition)
    with all_or_nothing(mesh.Document):
        zone = size_zone.add(mesh, kind, inner)
        zone.OuterSize, zone.Transition, zone.References = outer, transition, _references(mesh, names)
        size_zone.fit_to(zone, part)
        for name, value in measures.items():
            setattr(zone, name.capitalize(), measure_of(name, value))
        if placement is not None:
            zone.Placement = placement
        return zone


def refer_size_zone(zone, mesh, references):
    """Lets the distance of a refinement zone of `mesh` be measured from other references, which are as for add_local_size. Throws UserError."""
    reading.refuse_gone(zone, said("a refinement zone"))
    if not size_zone.is_zone(zone):
        raise UserError(said("{object:text} is no refinement zone", object=reading.describe(zone)))
    zone.References = _references(mesh, _refined_names(mesh, references))


def add_group(mesh, references, name="MeshGroup"):
    """Adds an FEM mesh group of solids, faces, edges or vertices of the part; after the next update the mesh has a group of their elements, named
    as the object, and one of their nodes, with "_Nodes" behind.

    `references` as for add_local_size; a whole object stands for its solids. Throws UserError when there are none, or when they are not on the part.
    """
    names = _names_on_part(mesh, references, QT_TRANSLATE_NOOP("FeatureMesh", "select solids, faces, edges or vertices of {part:text}{foreign:messages}"))
    group = ObjectsFem.makeMeshGroup(mesh.Document, mesh, name=name)
    group.References = _references(mesh, names)
    return group


def show_kept(mesh, cut=None):
    """Colours the elements in the window, if there is one: those the last update kept, and new ones. Returns the overlays.Overlay.

    `cut` opens the mesh: "z=5" (whole elements below z = 5 mm stay), "z>5" (those above). Throws UserError when there was no update
    since the document was opened.
    """
    refuse_other(mesh)
    return overlays.show(mesh, overlays.kept(mesh), plane_of(cut))


def show_quality(mesh, measure="dihedral_angle", limits=None, cut=None):
    """Colours the elements in the window, if there is one, by a measure of quality (see quality.MEASURES). Returns the overlays.Overlay.

    `limits` are what is bad and what is good, by default the measure's own; `cut` as for show_kept. Throws UserError.
    """
    refuse_other(mesh)
    return overlays.show(mesh, overlays.quality(mesh, measure, limits), plane_of(cut))


def draw_quality(mesh, path, measure="dihedral_angle", limits=None, cut=None, filled=False):
    """Writes a picture of the elements as show_quality colours them, cut open by whole elements or `filled`. Returns the overlays.Overlay."""
    refuse_other(mesh)
    return mesh_drawing.draw(mesh, path, measure, limits, plane_of(cut), filled)


def show_plain(mesh):
    """Takes colours away again."""
    refuse_other(mesh)
    overlays.hide(mesh)


def export_mesh(mesh, path, file_format=None):
    """Writes the mesh with its groups as one of export.FORMATS (by default what the file's name says). Returns the number of groups."""
    refuse_other(mesh)
    path = os.fsdecode(path)
    groups = export.write(mesh, path, file_format or os.path.splitext(path)[1].lstrip("."))
    if what_it_is_of(mesh):
        FreeCAD.Console.PrintWarning("%s: %s\n" % (mesh.Label, what_it_is_of(mesh)))
    return groups


def transfer_field(old, new, values):
    """Carries nodal values, (n,) or (n,k) with a row per node, from one mesh to another: exact where the node was kept.

    `old` and `new` are mesh objects or arrays as PartMesh.arrays gives them; rows follow arrays["node_numbers"]. For the mesh before an
    update keep `mesh.Proxy.arrays(mesh)`. Returns a dict: values, errors (an estimate in the field's unit), sources (0 the same
    node, 1 interpolated in an old element, 2 outside: from the nearest point of the old boundary) and figures.
    """
    for mesh in (old, new):
        if not isinstance(mesh, dict):
            refuse_other(mesh)
    arrays = [mesh if isinstance(mesh, dict) else mesh.Proxy.arrays(mesh) for mesh in (old, new)]
    return transfer.field(*arrays, values)


def transfer_result(result, mesh, name=None):
    """Adds a result object with the fields of `result`, which may be of another document, on the mesh object `mesh`.

    Returns it and a report with the estimated error of each field. Throws UserError.
    """
    refuse_other(mesh)
    reading.refuse_gone(result, said("a result"))
    if not result.isDerivedFrom("Fem::FemResultObject"):
        raise UserError(said("{result:text} is no result", result=reading.describe(result)))
    return transfer.result(result, mesh, name)


def solve(analysis):
    """Solves an analysis with CalculiX. Returns a solving.Solution: the result object, and its figures by name.

    Throws UserError when something is missing, a mesh is out of date, or CalculiX fails.
    """
    return solving.solve(analysis)


def solve_analysis(analysis, which=None, threads=0, keep="", progress=None):
    """Solves the analysis and leaves FreeCAD's own result object in it. Returns the report.

    `which` is "live" (linear statics, from our mesh's arrays), "ccx" (CalculiX through FreeCAD), or None: live where that knows all
    that the analysis holds, and converges, else CalculiX, which gets a solver object where there is none, and the report's warnings say why. Throws
    UserError.
    """
    if which not in (None, "live", "ccx"):
        raise UserError(said("the solver is live or ccx, not {solver:text}", solver=str(which)))
    analyses.refuse_other(analysis)
    solve_guard.refuse(analysis)
    from . import calculix   # FreeCAD's tools for CalculiX take a while to load
    if which == "ccx":
        return calculix.solve(analysis)
    try:
        fields, report = statics.solve(analysis, keep, threads, progress, statics_result.last_displacements(analysis))
    except (statics.NotUnderstood, engine.load().KernelError) as error:
        if which == "live" or not statics.is_for_calculix(error):
            raise
        report = calculix.solve(analysis)
        report["warnings"].append(said("solved with CalculiX: {why:messages}", why=of_error(error)))
        return report
    start = time.perf_counter()
    result = statics_result.show(analysis, statics.arrays_of(analysis), fields)
    report["result"] = result.Name
    report["seconds"]["result"] = time.perf_counter() - start
    report["seconds"]["total"] += report["seconds"]["result"]
    return report


def live_result(analysis):
    """The live result of the analysis, added and solved where it has none: after each recompute its `Result` is FreeCAD's result object of the part as
    it is. In the window it is solved beside FreeCAD's own thread, in a script at once. `Status` says whether it is up to date. Throws UserError, and leaves
    nothing new behind, where a script cannot solve it."""
    analyses.refuse_other(analysis)
    with all_or_nothing(analysis.Document):
        live = live_results.add(analysis)
        if live.Status != live_results.UP_TO_DATE:
            solve_live(live)
        return live


def solve_live(live):
    """Solves a live result now, whether it is Automatic or not: in the window beside FreeCAD's own thread, in a script at once. Throws UserError."""
    reading.refuse_gone(live, said("a live result"))
    if not live_results.is_live_result(live):
        raise UserError(said("{object:text} is no live result", object=reading.describe(live)))
    if live_results.solve_later is not None:
        live_results.solve_later(live)
    else:
        live.Proxy.solve(live)


def add_study(part, analysis=None):
    """Adds a study of the part to its document: what it varies and asks for are properties. `start` of
    `freecad.featuremesh.study.study_object` runs it.

    `analysis` is by default the one that has the part's mesh, else the only one. Throws UserError.
    """
    reading.refuse_unmeshable(part)
    if analysis is not None:
        analyses.refuse_other(analysis)
    from .study import study_object   # it uses this module
    found = analyses.analyses_of(part.Document)
    of_the_part = [obj for obj in found if any(is_feature_mesh(member) and versions.part_of(member) is part for member in obj.Group)]
    candidates = of_the_part or found
    with all_or_nothing(part.Document):
        return study_object.add(part, analysis or (candidates[0] if len(candidates) == 1 else None))


def find_analysis(document, name=None):
    """The document's analysis, the one of that name where there are several. Throws UserError."""
    refuse_no_document(document)
    found = analyses.analyses_of(document)
    found = reading.called(found, name) if name else found
    if not found:
        raise UserError(said("the document {document:text} has no analysis{name:text}; add one in FreeCAD's FEM workbench",
                             document=document.Label, name=" " + name if name else ""))
    if len(found) > 1:
        raise NotSelected(said("the document has several analyses, select one: {analyses:text}", analyses=", ".join(map(reading.describe, found))), NotSelected.ANALYSIS)
    return found[0]


def meshes_of(document):
    """All FeatureMesh objects of the document."""
    return analyses.meshes_in(document)


def is_mesh_of(mesh, part):
    """Is it the mesh of that part, or of the container or link in which it is shown?"""
    return versions.part_of(mesh) is part or assembled.shows(versions.part_of(mesh), part)


def about():
    """[(name, value)] of what a bug report needs to know: versions, where things are and how they were installed, where the log is."""
    return facts()


def share_mesh(mesh, analysis):
    """Lets a second analysis be solved with `mesh`: it gets an object with the same nodes, elements and numbers and the groups of its own loads,
    supports and materials, which follows every update. Returns it. Throws UserError when the analysis has a mesh already."""
    reading.refuse_gone(mesh, said("a mesh of FeatureMesh"))
    if not analyses.is_ours(mesh):
        refuse_other(mesh)
    return load_cases.share(mesh, analysis)


def copy_analysis(analysis, name=None, mesh="shared"):
    """A copy of an analysis with copies of its loads, supports, materials and solvers, without results: a second load case.

    `mesh` is "shared" (see share_mesh), "own" for a mesh object of its own, or "none". Returns the copy. Throws UserError.
    """
    return load_cases.copy(analysis, name, mesh)


def find_part(document, name=None):
    """What is to be meshed: the object of that name, else the only solid that no other one uses; for a container the object that shows its parts, for a
    link the one that shows that. Throws UserError."""
    refuse_no_document(document)
    named = reading.find_object(document, name, reading.final_parts(document)) if name else None
    part = named if named is not None and assembled.is_container(named) else reading.find_meshable(document, name)
    return assembled.of(part) if assembled.is_to_be_shown(part) else part


def find_mesh(document, part_name=None):
    """The document's mesh object, of that part, container or link when named. Throws UserError: none, or several."""
    refuse_no_document(document)
    meshes = meshes_of(document)
    if part_name:
        part = reading.find_object(document, part_name)
        meshes = [mesh for mesh in meshes if mesh is part or is_mesh_of(mesh, part)]
    if not meshes:
        raise UserError(said("the document {document:text} has no mesh{of_part:messages}; make one with `featuremesh mesh`",
                             document=document.Label, of_part=said(" of {part:text}", part=part_name) if part_name else ""))
    if len(meshes) > 1:
        raise NotSelected(said("the document has several meshes, select one: {meshes:text}", meshes=", ".join(map(reading.describe, meshes))), NotSelected.OBJECT)
    return meshes[0]


def default_size(part, elements=DEFAULT_ELEMENTS):
    """A sensible edge length for a part: its diagonal over `elements`, rounded to two digits, mm."""
    reading.refuse_gone(part)
    if not elements > 0:
        raise UserError(said("the number of elements along the part has to be greater than 0, not {elements:text}", elements=str(elements)))
    size = part.Shape.BoundBox.DiagonalLength / elements
    digits = 1 - int(math.floor(math.log10(size))) if size > 0 else 0
    return round(size, digits)


def _size_of(mesh, value):
    """Of a refinement, mm: half the mesh's where none is given. Throws UserError."""
    size = mesh.Size.Value / 2 if value is None else length_of(value)
    refuse_no_size(size)
    return size


def plane_of(cut):
    """The section.Plane of a text such as "z=5", None for None. Throws UserError."""
    try:
        return None if cut is None else section.plane_from_text(str(cut))
    except ValueError:
        raise UserError(said("a cut is x, y or z with =, < or > and a number, such as z=5, not {cut:text}", cut=str(cut))) from None


def _names_on_part(mesh, references, request):
    """Names of what references (see refusals.pairs_given) mean on the part. Throws UserError with the request when there are none, or for what is not on the part."""
    refuse_other(mesh)
    part = part_to_mesh(mesh)
    if references is None:
        return []
    resolver = resolving.Resolver(part)
    meant = [(obj, sub, [name for name in resolver.names(obj, sub) or [] if resolving.is_element_of(part.Shape, name)])
             for obj, sub in pairs_given(references, part)]
    foreign = [resolving.describe(obj, sub) for obj, sub, names in meant if not names]
    if not meant or foreign:
        raise UserError(said(request, part=reading.describe(part), foreign=said(", not of {foreign:text}", foreign=foreign[0]) if foreign else ""))
    return list(dict.fromkeys(name for _, _, names in meant for name in names))


def _refined_names(mesh, references, some_solids=False):
    """With `some_solids` a part of several solids may be refined in some of them."""
    names = _names_on_part(mesh, references, QT_TRANSLATE_NOOP("FeatureMesh", "select faces, edges or vertices of {part:text}{foreign:messages}"))
    solids = sum(name.startswith("Solid") for name in names)
    if solids and not (some_solids and solids < part_to_mesh(mesh).Shape.countElement("Solid")):
        raise UserError(said("a local size is for faces, edges or vertices; the size of a whole part is the mesh's own"))
    return names


def _references(mesh, names):
    return [(versions.part_of(mesh), name) for name in names]


def check_size(size, part):
    """Throws UserError for a size that is not positive or larger than the part."""
    refuse_no_size(size)
    diagonal = part.Shape.BoundBox.DiagonalLength
    if size > diagonal:
        raise UserError(said("the size {size:length} is larger than the part ({diagonal:length} across); try {better:length}",
                             size=size, diagonal=diagonal, better=default_size(part)))
