# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of meshes for reports: what was kept, results, quality. Needs VTK and Matplotlib, neither FreeCAD nor the engine.

Meshes come as arrays: points (n,3) mm, tets (m,4) indices of positive volume. Pictures are arrays (height, width, 3) of
bytes until a figure puts them into a file. All drawing happens inside `off_screen()`.
"""
import contextlib
import itertools
import os
import subprocess
import sys

import numpy as np

from section import outer_triangles

KEPT, NEW, RELEASED, CARRIED = 0, 1, 2, 3
COLOURS = {KEPT: "#a9bfd1", NEW: "#f2994a", RELEASED: "#d9605a", CARRIED: "#6fb59a"}
ACTIVE_COLOUR = "#14532d"
LABELS = {KEPT: "kept", NEW: "new", RELEASED: "released", CARRIED: "carried along"}
EDGE_COLOUR, OUTLINE_COLOUR, BACKGROUND = "#5a6875", "#20262d", "#ffffff"
SIZE = (1300, 800)
_MARGIN = 1.04   # of the picture over what is drawn


@contextlib.contextmanager
def off_screen():
    """Gives VTK a screen of its own, so that pictures look the same on a desktop and on a server. Windows and macOS need none."""
    if os.name == "nt" or sys.platform == "darwin":
        yield
        return
    read_end, write_end = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write_end), "-screen", "0", "1600x1200x24", "-nolisten", "tcp", "-noreset"],
                              pass_fds=(write_end,), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(write_end)
    before = os.environ.get("DISPLAY")
    try:
        with os.fdopen(read_end) as answer:
            number = answer.readline().strip()
        if not number:
            raise RuntimeError("Xvfb did not start, so no pictures can be drawn")
        os.environ["DISPLAY"] = ":" + number
        yield
    finally:
        if before is None:
            os.environ.pop("DISPLAY", None)
        else:
            os.environ["DISPLAY"] = before
        server.terminate()
        server.wait()


def behind_plane(points, tets, origin, normal):
    """(m,) bool: the tets whose centre lies behind the plane; drawn alone they show the inside."""
    centres = points[tets].mean(axis=1)
    return (centres - np.asarray(origin)) @ np.asarray(normal) < 0


def inside_any(points, tets, probes):
    """(k,) bool: the probes that lie inside one of the tets; meant for few tets, such as those of a cavity."""
    corner = points[tets[:, 0]]
    to_local = np.linalg.inv(np.stack([points[tets[:, i]] - corner for i in (1, 2, 3)], axis=2))
    found = np.zeros(len(probes), dtype=bool)
    for row, probe in enumerate(probes):
        local = np.einsum("mij,mj->mi", to_local, probe - corner)
        found[row] = np.any((local >= 0).all(axis=1) & (local.sum(axis=1) <= 1))
    return found


class Scene:
    """A scene to be rendered once, from one view."""

    def __init__(self, size=SIZE):
        import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
        from vtkmodules.vtkRenderingCore import vtkLightKit, vtkRenderer, vtkRenderWindow
        self._renderer = vtkRenderer()
        self._renderer.SetBackground(*_rgb(BACKGROUND))
        self._window = vtkRenderWindow()
        self._window.SetOffScreenRendering(1)
        self._window.SetMultiSamples(8)
        self._window.SetSize(*size)
        self._window.AddRenderer(self._renderer)
        lights = vtkLightKit()
        lights.SetKeyLightIntensity(1.0)
        lights.AddLightsToRenderer(self._renderer)

    def add_triangles(self, points, triangles, colours, edges=True, opacity=1.0):
        """Triangles with one colour each, (k,3) shares of red, green and blue; `edges` draws the mesh lines."""
        data = _polygons(points, triangles)
        data.GetCellData().SetScalars(_array((np.asarray(colours) * 255).astype(np.uint8), "colours"))
        actor = self._add(data)
        _material(actor, opacity)
        if edges:
            actor.GetProperty().EdgeVisibilityOn()
            actor.GetProperty().SetEdgeColor(*_rgb(EDGE_COLOUR))
            actor.GetProperty().SetLineWidth(0.5)

    def add_surface(self, triangles, colour, opacity=1.0):
        """(k,3,3) triangles of one colour; glass when the opacity is below 1."""
        corners = np.arange(3 * len(triangles)).reshape(-1, 3)
        actor = self._add(_polygons(np.asarray(triangles).reshape(-1, 3), corners))
        _material(actor, opacity)
        actor.GetProperty().SetColor(*_rgb(colour))
        if opacity < 1:
            self._window.SetAlphaBitPlanes(1)
            self._window.SetMultiSamples(0)
            self._renderer.SetUseDepthPeeling(1)
            self._renderer.SetMaximumNumberOfPeels(12)
            self._renderer.SetOcclusionRatio(0.0)
            self._renderer.UseFXAAOn()

    def add_lines(self, polylines):
        """Lines through (n,3) points."""
        from vtkmodules.vtkCommonCore import vtkIdList
        data = _polygons(np.concatenate([np.zeros((0, 3)), *polylines]), np.zeros((0, 3), dtype=np.int64))
        data.AllocateEstimate(len(polylines), 2)
        start = 0
        for line in polylines:
            corners = vtkIdList()
            for index in range(start, start + len(line)):
                corners.InsertNextId(index)
            data.InsertNextCell(4, corners)  # VTK_POLY_LINE
            start += len(line)
        actor = self._add(data)
        actor.GetProperty().SetColor(*_rgb(OUTLINE_COLOUR))
        actor.GetProperty().SetLineWidth(1.4)
        actor.GetProperty().LightingOff()

    def add_field(self, points, triangles, values, limits):
        """Triangles coloured smoothly by a value per point."""
        from matplotlib import colormaps
        shares = np.clip((values - limits[0]) / max(limits[1] - limits[0], 1e-300), 0, 1)
        data = _polygons(points, triangles)
        data.GetPointData().SetScalars(_array((colormaps["turbo"](shares)[:, :3] * 255).astype(np.uint8), "colours"))
        _material(self._add(data), 1.0)

    def add_outline(self, points, triangles, angle_deg=40.0):
        """The sharp edges of a surface."""
        from vtkmodules.vtkFiltersCore import vtkFeatureEdges
        sharp = vtkFeatureEdges()
        sharp.SetInputData(_polygons(points, triangles))
        sharp.SetFeatureAngle(angle_deg)
        sharp.BoundaryEdgesOff()
        sharp.NonManifoldEdgesOff()
        sharp.ColoringOff()
        sharp.Update()
        actor = self._add(sharp.GetOutput())
        actor.GetProperty().SetColor(*_rgb(OUTLINE_COLOUR))
        actor.GetProperty().SetLineWidth(1.6)
        actor.GetProperty().LightingOff()

    def add_points(self, points, radius, colour):
        """Balls of a radius in mm."""
        from vtkmodules.vtkFiltersCore import vtkGlyph3D
        from vtkmodules.vtkFiltersSources import vtkSphereSource
        ball = vtkSphereSource()
        ball.SetRadius(radius)
        glyphs = vtkGlyph3D()
        glyphs.SetInputData(_polygons(points, np.zeros((0, 3), dtype=np.int64)))
        glyphs.SetSourceConnection(ball.GetOutputPort())
        glyphs.ScalingOff()
        glyphs.Update()
        actor = self._add(glyphs.GetOutput())
        actor.GetProperty().SetColor(*_rgb(colour))

    def render(self, direction, focus=None, height=None):
        """The picture seen along `direction`; of everything, or of `height` mm around `focus`."""
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
        camera = self._renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(0, 0, 0)
        camera.SetPosition(*(-np.asarray(direction, dtype=float)))
        camera.SetViewUp(*((0, 1, 0) if abs(direction[2]) > 0.99 * np.linalg.norm(direction) else (0, 0, 1)))
        self._renderer.ResetCamera()
        self._fit(camera)
        if focus is not None:
            shift = np.asarray(focus) - np.asarray(camera.GetFocalPoint())
            camera.SetFocalPoint(*focus)
            camera.SetPosition(*(np.asarray(camera.GetPosition()) + shift))
            camera.SetParallelScale(height / 2)
        self._renderer.ResetCameraClippingRange()
        self._window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self._window)
        grab.ReadFrontBufferOff()
        grab.Update()
        self._window.Finalize()
        self._window = None   # VTK 9.5 lets go of the screen only with the window, and the screen may be gone when Python frees the scene
        image = grab.GetOutput()
        width, rows, _ = image.GetDimensions()
        return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, width, -1)[::-1, :, :3].copy()

    def _fit(self, camera):
        """Makes everything as large as the picture allows."""
        corners = np.array(list(itertools.product(*np.reshape(self._renderer.ComputeVisiblePropBounds(), (3, 2)))))
        back = np.asarray(camera.GetViewPlaneNormal())
        right = np.cross(camera.GetViewUp(), back)
        right /= np.linalg.norm(right)
        up = np.cross(back, right)
        middle, width, height = np.zeros(3), np.ptp(corners @ right), np.ptp(corners @ up)
        for axis in (right, up, back):
            middle += axis * ((corners @ axis).min() + (corners @ axis).max()) / 2
        shift = middle - np.asarray(camera.GetFocalPoint())
        camera.SetFocalPoint(*middle)
        camera.SetPosition(*(np.asarray(camera.GetPosition()) + shift))
        columns, rows = self._window.GetSize()
        camera.SetParallelScale(_MARGIN * max(height, width * rows / columns) / 2)

    def _add(self, data):
        from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(data)
        actor = vtkActor()
        actor.SetMapper(mapper)
        self._renderer.AddActor(actor)
        return actor


def draw_elements(points, tets, classes, view, active=None, plane=None, size=SIZE):
    """Tets coloured by class (KEPT, NEW, RELEASED, CARRIED), cut open by a plane (origin, normal), with active nodes as balls.

    `view` has the arguments of Scene.render.
    """
    scene = Scene(size)
    shown = behind_plane(points, tets, *plane) if plane else np.ones(len(tets), dtype=bool)
    triangles, owner = outer_triangles(tets[shown])
    table = np.array([_rgb(COLOURS[kind]) for kind in sorted(COLOURS)])
    scene.add_triangles(points, triangles, table[classes[shown][owner]])
    if active is not None and len(active):
        if plane:
            active = active[(active - np.asarray(plane[0])) @ np.asarray(plane[1]) < 0.6 * edge_length(points, tets)]
        scene.add_points(active, 0.16 * edge_length(points, tets), ACTIVE_COLOUR)
    return scene.render(**view)


def draw_stress(points, tets, stress, displacement, scale, limits, view, size=SIZE):
    """The deformed part (displacement times scale) coloured by stress, with the undeformed outline."""
    scene = Scene(size)
    triangles, _ = outer_triangles(tets)
    deformed = points + scale * displacement
    scene.add_field(deformed, triangles, stress, limits)
    scene.add_outline(points, triangles)
    return scene.render(**view)


def edge_length(points, tets):
    """Median length of an edge of the mesh, mm."""
    sample = tets[:: max(1, len(tets) // 5000)]
    return float(np.median(np.linalg.norm(points[sample[:, 0]] - points[sample[:, 1]], axis=1)))


def trim(pictures, border=12):
    """The pictures without the empty margins that all of them share."""
    drawn = np.any([(picture != 255).any(axis=2) for picture in pictures], axis=0)
    rows, columns = np.flatnonzero(drawn.any(axis=1)), np.flatnonzero(drawn.any(axis=0))
    if not len(rows):
        return pictures
    top, left = max(rows[0] - border, 0), max(columns[0] - border, 0)
    return [picture[top:rows[-1] + border, left:columns[-1] + border] for picture in pictures]


def write_panels(path, panels, kinds=(), bar=None, active=False, width=13.0, legend=()):
    """Pictures side by side with titles, a legend of element classes or of (colour, label), or a bar (label, low, high)."""
    pyplot = _pyplot()
    panels = list(zip((title for title, _ in panels), trim([picture for _, picture in panels])))
    height = width / len(panels) * panels[0][1].shape[0] / panels[0][1].shape[1]
    figure, axes = pyplot.subplots(1, len(panels), figsize=(width, height + 0.8), squeeze=False)
    for axis, (title, picture) in zip(axes[0], panels):
        axis.imshow(picture, interpolation="lanczos")
        axis.set_title(title.replace("$", r"\$"), fontsize=12, color="#20262d", loc="left")
        axis.set_axis_off()
    figure.subplots_adjust(left=0.005, right=0.995, top=1 - 0.36 / (height + 0.8), bottom=0.42 / (height + 0.8), wspace=0.01)
    entries = [(COLOURS[kind], LABELS[kind] + " elements") for kind in kinds] + list(legend)
    if entries:
        figure.legend(handles=_legend(pyplot, entries, active), loc="lower center", ncol=6, frameon=False, fontsize=11)
    if bar:
        label, low, high = bar
        colours = pyplot.cm.ScalarMappable(pyplot.Normalize(low, high), "turbo")
        place = figure.add_axes([0.3, 0.26 / (height + 0.8), 0.4, 0.14 / (height + 0.8)])
        figure.colorbar(colours, cax=place, orientation="horizontal")
        figure.text(0.29, 0.33 / (height + 0.8), label, ha="right", va="center", fontsize=11)
    figure.savefig(path, dpi=140)
    pyplot.close(figure)


def write_quality(path, series):
    """Histograms of the smallest dihedral angle and of the radius ratio; series are (name, angles, ratios)."""
    pyplot = _pyplot()
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(13, 3.6))
    colours = ("#5b7c99", "#f2994a", "#6fb59a", "#8d6cab")
    for colour, (name, angles, ratios) in zip(colours, series):
        for axis, values, bins in ((left, angles, np.linspace(0, 75, 76)), (right, ratios, np.linspace(0, 1, 81))):
            weights = np.full(len(values), 100.0 / max(len(values), 1))
            axis.hist(values, bins, weights=weights, histtype="step", color=colour, linewidth=1.7, label=name)
    left.set_xlabel("smallest dihedral angle of an element, degrees")
    right.set_xlabel("radius ratio 3 r / R of an element (1 is regular)")
    for axis in (left, right):
        axis.set_ylabel("share of elements, %")
        axis.spines[["top", "right"]].set_visible(False)
        axis.grid(axis="y", color="#e3e7eb")
        axis.set_axisbelow(True)
        axis.margins(x=0)
    left.legend(frameon=False, loc="upper left")
    figure.tight_layout()
    figure.savefig(path, dpi=140)
    pyplot.close(figure)


def _pyplot():
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    return pyplot


def _legend(pyplot, entries, active):
    handles = [pyplot.Rectangle((0, 0), 1, 1, facecolor=colour, edgecolor=EDGE_COLOUR, label=label)
               for colour, label in entries]
    if active:
        handles.append(pyplot.Line2D([], [], marker="o", linestyle="", color=ACTIVE_COLOUR, label="active nodes"))
    return handles


def _rgb(colour):
    return tuple(int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5))


def _polygons(points, triangles):
    from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    places = vtkPoints()
    places.SetData(_array(points, "points"))
    rows = np.hstack([np.full((len(triangles), 1), 3, dtype=np.int64), triangles.astype(np.int64)])
    cells = vtkCellArray()
    cells.SetCells(len(triangles), numpy_to_vtkIdTypeArray(rows.ravel(), deep=1))
    data = vtkPolyData()
    data.SetPoints(places)
    data.SetPolys(cells)
    return data


def _array(values, name):
    from vtkmodules.util.numpy_support import numpy_to_vtk
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
    array.SetName(name)
    return array


def _material(actor, opacity):
    surface = actor.GetProperty()
    surface.SetInterpolationToFlat()
    surface.SetAmbient(0.3)
    surface.SetDiffuse(0.75)
    surface.SetSpecular(0.0)
    surface.SetOpacity(opacity)
