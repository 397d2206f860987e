# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the pictures and the page of the demo from what run_demo.py wrote: draw_report.py FOLDER."""
import json
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "Mod" / "FeatureMesh" / "freecad" / "featuremesh"))

import pictures  # noqa: E402
import quality  # noqa: E402
from report_page import Page  # noqa: E402

HOLE = (107.5, 70, 7.5)
CUT = ((0, 70, 0), (0, 1, 0))
ACROSS = (-0.45, -1, -0.75)
FROM_FRONT = (0.5, 1, -0.7)
DEFORMATION_SHARE = 0.06


def draw(folder):
    numbers = json.loads((folder / "numbers.json").read_text(encoding="utf-8"))
    old, new = dict(np.load(folder / "old.npz")), dict(np.load(folder / "new.npz"))
    old["class"] = np.where(old["tet_kept"], pictures.KEPT, pictures.RELEASED)
    new["class"] = np.where(new["tet_origin"] >= 0, pictures.KEPT, pictures.NEW)
    # Survivors that no longer are inside the part were no use as start positions.
    new["active"] = new["active"][pictures.inside_any(new["points"], new["tets"][new["class"] == pictures.NEW], new["active"])]
    (folder / "pictures").mkdir(exist_ok=True)
    with pictures.off_screen():
        draw_kept(folder / "pictures" / "kept.png", old, new, {"direction": ACROSS})
        draw_kept(folder / "pictures" / "kept_close.png", old, new, {"direction": ACROSS, "focus": HOLE, "height": 36})
        draw_stress(folder / "pictures" / "stress.png", old, new)
    pictures.write_quality(folder / "pictures" / "quality.png", [quality_series("first mesh", old), quality_series("updated mesh", new)])
    write_page(folder, numbers)
    for name in ("old.npz", "new.npz"):   # for the pictures alone
        (folder / name).unlink()


def quality_series(name, mesh):
    smallest, _, ratios = quality.tet_quality(mesh["points"], mesh["tets"])
    return name, smallest, ratios


def draw_kept(path, old, new, view):
    before = pictures.draw_elements(old["points"], old["tets"], old["class"], view, plane=CUT)
    after = pictures.draw_elements(new["points"], new["tets"], new["class"], view, plane=CUT, active=new["active"])
    pictures.write_panels(path, [("before the edit", before), ("after the update", after)],
                          kinds=(pictures.KEPT, pictures.RELEASED, pictures.NEW), active=len(new["active"]) > 0)


def draw_stress(path, old, new):
    """Both states in the same colours and deformed by the same scale, so that they can be compared."""
    high = float(np.percentile(np.concatenate([old["stress"], new["stress"]]), 99.8))
    largest = max(np.linalg.norm(mesh["displacement"], axis=1).max() for mesh in (old, new))
    scale = DEFORMATION_SHARE * np.linalg.norm(np.ptp(old["points"], axis=0)) / largest
    panels = [(title, pictures.draw_stress(mesh["points"], mesh["tets"], mesh["stress"], mesh["displacement"], scale, (0, high),
                                           {"direction": FROM_FRONT}))
              for title, mesh in (("before the edit", old), ("after the update", new))]
    pictures.write_panels(path, panels, bar=("von Mises stress, MPa", 0, high))


def write_page(folder, numbers):
    update, full = numbers["update"], numbers["full"]
    seconds = {name: numbers[name]["seconds"]["engine_total"] for name in ("first", "update", "full")}
    page = Page("FeatureMesh: a bracket is edited, its mesh is updated",
                f"In this part {numbers['edit']}. The mesh is not made again: it is kept where nothing changed and filled anew around the hole.")
    page.add_tiles([(f"{update['kept']['nodes_share']:.1%}", "of the nodes kept, bit for bit, with their numbers", True),
                    (f"{seconds['update'] / seconds['full']:.0%}", f"of a full mesh's time ({seconds['update']:.2f} s against {seconds['full']:.2f} s)", True),
                    (f"{update['tets']:,}", f"elements of size {numbers['size']:g} mm", False),
                    (f"{update['quality']['min_dihedral']:.1f}°", f"smallest dihedral angle (full mesh: {full['quality']['min_dihedral']:.1f}°)", False)])
    page.add_heading("What was kept")
    page.add_figure(folder / "pictures" / "kept.png", "The part cut open through the middle of the moved hole; every tet is drawn whole.")
    page.add_figure(folder / "pictures" / "kept_close.png", "The same close up. Active nodes survived as start positions and were then moved to where they serve best.")
    add_difference(page, numbers)
    add_meshes(page, numbers)
    page.add_figure(folder / "pictures" / "quality.png", "Quality of all elements of the mesh before and after the update.")
    add_results(page, numbers)
    page.add_figure(folder / "pictures" / "stress.png", "Both solutions in the same colours, deformations drawn at the same scale.")
    page.write(folder / "report.html", "Made by ./featuremesh demo. Times are those of this run on this machine.")


def add_difference(page, numbers):
    read = numbers["read"]
    page.add_heading("What changed, feature by feature")
    page.add_text(f"The tree of the part has {len(read['features'])} features, which cut space into {read['cells']} cells; "
                  f"the final shape has {read['faces']} faces.")
    shown = {name for name, _, _ in read["features"]}
    rows = [(f["label"], f["what_happened"], f["detail"] or "", f"{f['old_volume']:,.1f}", f"{f['new_volume']:,.1f}",
             ", ".join(name for name in f["new_faces"] if name)) for f in numbers["update"]["difference"]["features"] if f["label"] in shown]
    page.add_table(("feature", "what happened", "in detail", "volume before, mm³", "after, mm³", "faces concerned"), rows, words=(1, 2, 5))
    if numbers["update"]["fallback"]:
        page.add_text(f"Not kept: {numbers['update']['fallback']}")


def add_meshes(page, numbers):
    page.add_heading("The meshes")
    rows = []
    for title, name in (("first mesh", "first"), ("updated mesh", "update"), ("full mesh, to compare", "full")):
        report, quality = numbers[name], numbers[name]["quality"]
        rows.append((title, f"{report['nodes']:,}", f"{report['tets']:,}", f"{report['seconds']['engine_total']:.2f}",
                     f"{quality['min_dihedral']:.1f}°", f"{quality['mean_min_dihedral']:.1f}°", f"{quality['mean_radius_ratio']:.3f}", quality["below_20"]))
    page.add_table(("", "nodes", "elements", "seconds", "smallest dihedral", "mean of smallest", "mean radius ratio", "below 20°"), rows)
    steps = sorted({step for name in ("update", "full") for step in numbers[name]["seconds"]} & set(STEPS), key=STEPS.index)
    page.add_table(("seconds by step", *steps),
                   [(title, *(f"{numbers[name]['seconds'].get(step, 0):.3f}" for step in steps))
                    for title, name in (("update", "update"), ("full mesh", "full"))])


STEPS = ["read", "difference", "keep", "surface", "volume", "optimise", "validate", "measure", "engine_total"]


def add_results(page, numbers):
    page.add_heading("Solved before and after")
    page.add_text("The analysis was not touched: the fixed face, the force and the material found their nodes and elements in the updated mesh.")
    rows = [(solver, title, f"{numbers[name]['displacement']:.4f}", f"{numbers[name]['stress']:.1f}", f"{numbers[name]['seconds']:.1f}")
            for solver, title, name in (("CalculiX", "before the edit", "first_solution"), ("CalculiX", "after the update", "second_solution"),
                                        ("live", "before the edit", "first_live"), ("live", "after the update", "second_live")) if numbers[name]]
    page.add_table(("solver", "state", "largest displacement, mm", "largest von Mises stress, MPa", "seconds"), rows)


draw(Path(sys.argv[1]))
