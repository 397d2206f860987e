# SPDX-License-Identifier: GPL-3.0-or-later
"""What scripts share that drive FreeCAD's real window: waiting, finding panels and dialogs, pictures, and how they end."""
import faulthandler
import gc
import os
import time
import traceback
import unittest

import FreeCADGui as Gui
import numpy as np
from PySide import QtCore, QtGui

PICTURES = os.environ.get("FEATUREMESH_PICTURES")
_TURNS = 5   # of the window's loop, however slow the machine is
VIEW = slice(240, 740), slice(300, 1180)   # rows and columns of the screen without panels and the navigation cube
messages = []
shown = []   # what shows a message to a person, in place of `messages`
figures = []   # what was measured on the way, told with the result


def spin(seconds=0.2):
    """Lets the window work for that long, and in any case a few times: what is drawn is asked for in one turn and drawn in a later one."""
    end, turns = time.monotonic() + seconds, 0
    while time.monotonic() < end or turns < _TURNS:
        QtGui.QApplication.processEvents()
        time.sleep(0.01)
        turns += 1


def picture(name):
    if PICTURES:
        spin(0.8)
        QtGui.QGuiApplication.primaryScreen().grabWindow(0).save(os.path.join(PICTURES, name + ".png"))


def pixels():
    """The 3D view as it is on the screen, (height, width, 3) of bytes; the report view, which FreeCAD 0.20 opens below it for an error, is closed first."""
    for dock in Gui.getMainWindow().findChildren(QtGui.QDockWidget, "Report view"):
        dock.hide()
    spin(0.3)
    return on_the_screen()


def hues(seen):
    """How many pixels have a strong colour."""
    return int(((seen.max(axis=2) - seen.min(axis=2)) > 90).sum())


def greens(seen):
    """How many pixels are green, which neither the background nor FreeCAD's own colour of a mesh is."""
    return int((seen[:, :, 1] - seen[:, :, (0, 2)].max(axis=2) > 50).sum())


def on_the_screen():
    """The same without waiting for anything."""
    image = QtGui.QGuiApplication.primaryScreen().grabWindow(0).toImage().convertToFormat(QtGui.QImage.Format_RGB32)
    buffer = image.constBits()
    data = np.frombuffer(buffer if isinstance(buffer, (bytes, memoryview)) else buffer.asstring(image.sizeInBytes()), dtype=np.uint8)
    return data.reshape(image.height(), image.width(), 4)[VIEW[0], VIEW[1], 2::-1].astype(int)


def panel(kind):
    """The open panel of that class."""
    shown, = [obj for obj in gc.get_objects() if type(obj).__name__ == kind and is_shown(obj.form)]
    return shown


def is_shown(widget):
    try:
        return widget.isVisible()
    except (AttributeError, RuntimeError):   # FreeCAD or Qt has let go of it
        return False


def wait_for(condition, seconds=120):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "waited %d s in vain" % seconds
        spin(0.05)


def is_whole(widget):
    """Is a widget seen in all its width?"""
    return widget.visibleRegion().boundingRect().width() == widget.width()


def click(widget):
    """The left button of the mouse, pressed and let go in the middle of a widget that can be seen; of a check box on the box."""
    assert widget.isVisible() and widget.isEnabled(), widget.text()
    place = widget.rect().center()
    if isinstance(widget, QtGui.QCheckBox):
        place.setX(10)
    send_mouse(widget, place, QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease)


def double_click(widget, place):
    """At a place of the widget."""
    send_mouse(widget, place, QtCore.QEvent.MouseMove, QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease,
               QtCore.QEvent.MouseButtonDblClick, QtCore.QEvent.MouseButtonRelease)


def item_of_tree(label):
    """(the tree, where on it the object of that label is), after everything above it was opened."""
    tree, = [w for w in Gui.getMainWindow().findChildren(QtGui.QTreeWidget) if w.metaObject().className() == "Gui::TreeWidget" and w.isVisible()]
    model = tree.model()
    index, = model.match(model.index(0, 0), QtCore.Qt.DisplayRole, label, 1, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive)
    above = index.parent()
    while above.isValid():
        tree.expand(above)
        above = above.parent()
    tree.scrollTo(index)
    spin()
    return tree.viewport(), tree.visualRect(index).center()


def send_mouse(widget, place, *kinds):
    """What the mouse does at a place of a widget, with its left button."""
    for kind in kinds:
        moves = kind == QtCore.QEvent.MouseMove
        pressed = kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonDblClick)
        QtGui.QApplication.postEvent(widget, QtGui.QMouseEvent(
            kind, QtCore.QPointF(place), QtCore.QPointF(widget.mapToGlobal(place)), QtCore.Qt.NoButton if moves else QtCore.Qt.LeftButton,
            QtCore.Qt.LeftButton if pressed else QtCore.Qt.NoButton, QtCore.Qt.NoModifier))
        spin(0.1)
    spin()


def press_at(widget, place):
    """The left button at a place of the widget, where the mouse goes first."""
    send_mouse(widget, place, QtCore.QEvent.MouseMove, QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease)


def tick(shown, target):
    """The box of a dimension in the panel of a study."""
    item = shown.dimensions.item_of(target)
    shown.dimensions.scrollToItem(item)
    spin()
    box = shown.dimensions.visualItemRect(item)
    press_at(shown.dimensions.viewport(), QtCore.QPoint(box.left() + 10, box.center().y()))
    return item


def turn_wheel(widget):
    """One step of the mouse's wheel, up, over the middle of a widget."""
    place = widget.rect().center()
    QtGui.QApplication.postEvent(widget, QtGui.QWheelEvent(QtCore.QPointF(place), QtCore.QPointF(widget.mapToGlobal(place)), QtCore.QPoint(), QtCore.QPoint(0, 120),
                                                           QtCore.Qt.NoButton, QtCore.Qt.NoModifier, QtCore.Qt.NoScrollPhase, False))
    spin(0.1)


def type_into(widget, text):
    """Types a text in place of the one that a widget has, and leaves it by the Tab key; Enter would press OK."""
    send_key(widget, QtCore.Qt.Key_A, QtCore.Qt.ControlModifier)
    for letter in text:
        send_key(widget, 0, QtCore.Qt.NoModifier, letter)
    send_key(widget, QtCore.Qt.Key_Tab)
    spin()


def send_key(widget, key, modifiers=QtCore.Qt.NoModifier, text=""):
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        QtGui.QApplication.postEvent(widget, QtGui.QKeyEvent(kind, key, modifiers, text))
    QtGui.QApplication.processEvents()


def button_of(command):
    """The button of a command, by its name, in its toolbar, which is opened at its end where it has no room for all."""
    bar, action = next((bar, action) for bar in Gui.getMainWindow().findChildren(QtGui.QToolBar) if bar.isVisible()
                       for action in bar.actions() if command in (action.objectName(), action.data()))
    button = bar.widgetForAction(action)
    if not button.isVisible():
        click(bar.findChild(QtGui.QToolButton, "qt_toolbar_ext_button"))
        wait_for(button.isVisible)
    return button


def click_button_of(command):
    """Clicks the button of a command as soon as that is possible, of which FreeCAD looks now and then."""
    button = button_of(command)
    wait_for(button.isEnabled)
    click(button)


def choose_tab(text):
    """The tab of a view below the views."""
    bar, = Gui.getMainWindow().findChild(QtGui.QMdiArea).findChildren(QtGui.QTabBar)
    place = next(bar.tabRect(index).center() for index in range(bar.count()) if bar.tabText(index).startswith(text))
    send_mouse(bar, place, QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease)


def place_in_view(point):
    """(the widget of the 3D view, where on it a point of the model is)."""
    view = Gui.activeDocument().activeView()
    widget, = [w.viewport() for w in Gui.getMainWindow().findChildren(QtGui.QGraphicsView)
               if w.isVisible() and w.metaObject().className().endswith(("QuarterWidget", "View3DInventorViewer"))]
    x, y = (getattr(view, "getPointOnViewport", None) or view.getPointOnScreen)(point)
    width, height = view.getSize()   # in pixels of the screen, from the lower left
    return widget, QtCore.QPoint(x * widget.width() // width, (height - y) * widget.height() // height)


def click_in_view(point):
    """The left button over a point of the model in the 3D view."""
    send_mouse(*place_in_view(point), QtCore.QEvent.MouseMove, QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease)


def click_in_panel(name):
    """One of "Ok", "Apply", "Cancel" and "Close" over the open task panel."""
    click(button_in_panel(name))


def button_in_panel(name):
    box, = [box for box in Gui.getMainWindow().findChildren(QtGui.QDialogButtonBox) if box.isVisible()]
    return box.button(getattr(QtGui.QDialogButtonBox, name))


def answer_with(text, seen):
    """Clicks the button of that text in the next message box, and appends what the box says to `seen`. Keep what it returns until then."""
    def look():
        box = QtGui.QApplication.activeModalWidget()
        if isinstance(box, QtGui.QMessageBox) and box.isVisible():
            timer.stop()
            seen.append(box.text())
            click(next(button for button in box.buttons() if button.text().replace("&", "") == text))
    timer = QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(50)
    return timer


def delete(obj):
    """FreeCAD's Delete; what it asks is answered with Yes. Returns what it asked."""
    asked = []
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)
    timer = answer_with("Yes", asked)
    Gui.runCommand("Std_Delete")
    timer.stop()
    spin()
    return asked


def report_view():
    """What FreeCAD's report view has."""
    return next(view.toPlainText() for view in Gui.getMainWindow().findChildren(QtGui.QTextEdit) if view.objectName() == "Report view"
                or "Report" in type(view).__name__ or "Report" in (view.parent().objectName() if view.parent() else ""))


def texts_of(action):
    """The texts in the menu of an action."""
    menu = action.menu()
    return [entry.text() for entry in menu.actions()] if menu is not None else []


def open_dialog():
    """The one dialog that is open."""
    dialog, = [w for w in QtGui.QApplication.topLevelWidgets() if isinstance(w, QtGui.QDialog) and w.isVisible()]
    return dialog


def choose_workbench(width=1280, height=800):
    """Our workbench for the first time, in a window of that size; its welcome is closed."""
    Gui.getMainWindow().setGeometry(0, 0, width, height)
    Gui.activateWorkbench("FeatureMeshWorkbench")
    spin()
    open_dialog().close()


def run(drive):
    """Ends FreeCAD after `drive`, with its result in the file FEATUREMESH_RESULT: "ok" and what was measured, why it was skipped, or what went wrong.

    After FEATUREMESH_SECONDS it ends, too, and the file beside that one, with .stuck, says where it was.
    """
    result_file = os.environ["FEATUREMESH_RESULT"]
    stuck = open(result_file + ".stuck", "w", encoding="utf-8")
    faulthandler.dump_traceback_later(float(os.environ["FEATUREMESH_SECONDS"]), exit=True, file=stuck)
    QtGui.QMessageBox.warning = staticmethod(lambda *words: messages.append(words[2]))   # FreeCAD's
    from freecad.featuremesh.gui import message_box
    shown.append(message_box.warn)
    message_box.warn = messages.append
    try:
        drive()
        result = "\n".join(["ok", *figures])
    except unittest.SkipTest as reason:
        result = "skipped: %s" % reason
    except BaseException:
        result = traceback.format_exc() + "\nmessages: %s" % messages
    with open(result_file, "w", encoding="utf-8") as stream:
        stream.write(result)
    os._exit(0)
