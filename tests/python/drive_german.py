# SPDX-License-Identifier: GPL-3.0-or-later
"""Every panel in German, whose words are longer, in FreeCAD's dock as it is at first: nothing is cut off. What goes wrong is told in German, too.

Run by test_window.py; see drive_window.py for the result and the pictures.
"""
import os
import re
import sys
import tempfile
from pathlib import Path
from unittest import mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import window  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402
from window import figures, is_whole, panel, picture, spin  # noqa: E402


def check_panel(kind, command=None, edited=None):
    """Opens it by its command, or by the object that is edited in it."""
    if edited is None:
        Gui.runCommand(command)
    else:
        Gui.activeDocument().setEdit(edited.Name)
    spin()
    shown = panel(kind)
    picture("german_" + kind)
    assert is_whole(shown.form), (kind, shown.form.width(), shown.form.visibleRegion().boundingRect().width())
    figures.append("%s %d" % (kind, shown.form.width()))
    Gui.Control.closeDialog()
    Gui.activeDocument().resetEdit()
    spin()


def select(obj):
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)


def check_error(name, german, work, *words):
    """What `work` throws is shown in a box, in German."""
    from freecad.featuremesh.gui import errors
    try:
        work(*words)
    except Exception as error:
        errors.show(error)
    assert window.messages and window.messages[-1].startswith(german), (name, window.messages[-1:])
    box = QtGui.QMessageBox(QtGui.QMessageBox.Warning, "FeatureMesh", german, QtGui.QMessageBox.Ok, Gui.getMainWindow())
    box.show()
    picture("german_error_" + name)
    box.close()


def check_errors(document, body, mesh, study):
    from freecad.featuremesh import about, api, documents, edits, transfer
    from freecad.featuremesh.study import design, study_object
    from freecad.featuremesh.user_words import in_words
    check_error("document", "Die Datei /nirgends/x.FCStd gibt es nicht", documents.open_document, "/nirgends/x.FCStd")
    check_error("folder", "/nirgends/x.FCStd kann nicht geschrieben werden: den Ordner /nirgends gibt es nicht", documents.save_document, document,
                "/nirgends/x.FCStd")
    check_error("edit", "Die Änderung „Plate“ ist nicht lesbar, sie muss OBJEKT.EIGENSCHAFT=WERT sein", edits.set_parameter, document, "Plate")
    check_error("value", "lang ist keine Zahl für Plate.Length", edits.set_parameter, document, "Plate.Length=lang")
    check_error("property", "Plate hat keine Eigenschaft Lenght; war Length oder Length2 gemeint?", edits.set_parameter, document, "Plate.Lenght=3")
    check_error("object", "Das Dokument hat kein Objekt Plat; war Plate", edits.set_parameter, document, "Plat.Length=3")
    check_error("transfer", "Das Dokument Deutsch hat kein Ergebnis Nirgends mit Werten an den Knoten", transfer.find_result,
                document, "Nirgends")
    check_error("size", "Die Größe muss größer als 0 mm sein, nicht -1", api.add_mesh, body, -1.0)
    check_error("study", "Nichts ändert sich: ein Maß anhaken und ihm einen Bereich geben", study_object.study_of, study, "")
    check_error("range", "Der Bereich von Plate.Length muss ansteigen, nicht 9:5; das untere Ende zuerst schreiben", design.check, design.Study(
        "", [design.parse_parameter("Plate.Length=9:5")], [], cases=3))
    assert "in einem eigenen Prozess" in about.text(in_words) and "in a process of its own" in about.text(), about.text(in_words)


def check_numbers(canvas):
    """Some have decimals, none with a point."""
    canvas.draw()
    plots = canvas.figure.axes
    shown = [label.get_text() for plot in plots for label in (*plot.get_xticklabels(), *plot.get_yticklabels(), *plot.texts)]
    numbers = [text.split("\n")[0] for text in shown]
    assert any("," in number for number in numbers) and not any("." in number for number in numbers), numbers


def check_study_results(document, study, folder):
    """The window and the page of a study, some of whose cases were done, failed or could not be made."""
    from freecad.featuremesh.gui import study_window
    from freecad.featuremesh.messages import said
    from freecad.featuremesh.study import design
    from freecad.featuremesh.study.folder import StudyFolder
    path = os.path.join(folder, "study")
    made = StudyFolder(path, new=True)
    for place in (made.base_path, os.path.join(folder, "part.FCStd")):
        document.saveCopy(place)
    responses = list(map(design.parse_response, ("mass", "max_mises@Face3")))
    plan = design.Study(os.path.join(folder, "part.FCStd"), [design.parse_parameter("Plate.Length=50:70")], responses, cases=9)

    def fill(made):
        ids = made.database.add_cases([({"Plate.Length": 50.0 + n}, said("the constraint {constraint:text} is not kept", constraint="Plate.Length < 58")
                                        if n == 8 else None) for n in range(9)], "lhs")
        for n, case in enumerate(ids[:7]):
            values = {"mass": 1.0 + 0.1 * n, "max_mises@Face3": 90.5 - n}
            made.database.finish(case, {"state": "done", "responses": values, "mesh": {"kept_share": 0.9}, "seconds": {"total": 1.5}})
        made.database.finish(ids[7], {"state": "failed", "message": said("it was ended from outside ({signal:text})", signal="SIGKILL")})
    made.create(plan, {"nodes": 1200, "elements": 1, "solver": "live", "remarks": [], "base_values": {"Plate.Length": 60.0}}, fill)
    study.Folder = path
    QtCore.QLocale.setDefault(QtCore.QLocale("de_DE"))
    results = study_window.show(study)
    results.tabs.setCurrentIndex(3)
    spin()
    texts = [results.table.item(row, column).text() for row in range(9) for column in (1, 5)]
    assert texts[-4:] == ["fehlgeschlagen", "er wurde von außen beendet (SIGKILL)", "nicht machbar", "die Bedingung Plate.Length < 58 ist nicht eingehalten"], texts
    picture("german_study_cases")
    results.tabs.setCurrentIndex(2)
    window.wait_for(lambda: results.plots[2].canvas is not None)
    assert "Änderung von" in results.plots[2].canvas.figure.axes[0].get_xlabel()
    headers = [results.table.horizontalHeaderItem(column).text() for column in range(results.table.columnCount())]
    assert headers[2:5] == ["Plate.Length", "Masse, kg", "größte Vergleichsspannung an Face3, MPa"], headers
    for tab in (0, 1):
        results.tabs.setCurrentIndex(tab)
        window.wait_for(lambda: results.plots[tab].canvas is not None)
        check_numbers(results.plots[tab].canvas)
    picture("german_study_tornado")
    with mock.patch.object(QtGui.QDesktopServices, "openUrl"):
        results.activateWindow()   # a click only makes it the active one else
        spin()
        window.click(results.report_button)
    QtCore.QLocale.setDefault(QtCore.QLocale.c())
    page = Path(path, "report.html").read_text(encoding="utf-8")
    words = ("Studie von part.FCStd", "7 fertig, 1 nicht machbar, 1 fehlgeschlagen", "(1200 Knoten, 1 Element); mitlaufend gelöst", "Was wichtig ist", "Haupteffekt",
             "kleinster Wert 1 kg in Fall 1", "er wurde von außen beendet")
    assert not [text for text in words if text not in page], page[:4000]
    cells = re.findall(r"<td>(-?[0-9][^<]*)", page)
    assert "1,6" in cells and not any("." in cell for cell in cells), cells
    results.close()


def drive():
    from freecad.featuremesh import api
    from parts import plate_with_hole
    from test_document_solving import STEEL, analysis_of
    Gui.getMainWindow().setGeometry(0, 0, 1280, 800)
    Gui.setLocale("de")
    Gui.activateWorkbench("FeatureMeshWorkbench")
    spin()
    window.open_dialog().close()
    document = FreeCAD.newDocument("Deutsch")
    body = plate_with_hole(document)
    analysis = analysis_of(document, body, [("Steel", STEEL, [])])
    mesh = api.add_mesh(body, 4.0, order=1)
    document.recompute()
    zone = api.add_size_zone(mesh, inner=2.0)
    study = api.add_study(body, analysis)
    document.recompute()
    select(mesh)
    check_panel("MeshPanel", edited=mesh)
    check_panel("ZonePanel", edited=zone)
    check_panel("QualityPanel", "FeatureMesh_ShowQuality")
    check_panel("KeptPanel", "FeatureMesh_ShowKept")
    check_panel("StudyPanel", edited=study)
    if not engine_lacks_statics():
        check_panel("LivePanel", "FeatureMesh_LiveResult")
    check_errors(document, body, mesh, study)
    with tempfile.TemporaryDirectory() as folder:
        check_study_results(document, study, folder)


def engine_lacks_statics():
    from freecad.featuremesh import engine
    return engine.load().statics_missing()


window.run(drive)
