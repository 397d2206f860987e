# SPDX-License-Identifier: GPL-3.0-or-later
"""Opening bad files and saving without ever leaving half a document."""
import importlib.util
import math
import os
import shutil
import tempfile
import unittest
import zipfile
from xml.etree import ElementTree

import FreeCAD
import ObjectsFem
from freecad.featuremesh import documents
from freecad.featuremesh.errors import UserError
from parts import new_document, plate_with_hole


class Files(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.path = os.path.join(self.folder, "part.FCStd")
        self.document = new_document()
        plate_with_hole(self.document)
        self.document.saveCopy(self.path)

    def bytes(self):
        with open(self.path, "rb") as stream:
            return stream.read()

    def write(self, name, content):
        path = os.path.join(self.folder, name)
        with open(path, "wb") as stream:
            stream.write(content)
        return path

    def refused(self, path, message):
        before = set(FreeCAD.listDocuments())
        with self.assertRaisesRegex(UserError, message):
            documents.open_document(path)
        self.assertEqual(set(FreeCAD.listDocuments()), before)

    def test_what_is_saved_can_be_opened(self):
        opened = documents.open_document(self.path)
        self.assertAlmostEqual(opened.getObject("Body").Shape.Volume, self.document.getObject("Body").Shape.Volume)

    def test_missing(self):
        self.refused(os.path.join(self.folder, "none.FCStd"), "no file")

    def test_text(self):
        self.refused(self.write("text.FCStd", b"this is no document"), "not a FreeCAD document")

    def test_empty(self):
        self.refused(self.write("empty.FCStd", b""), "not a FreeCAD document")

    def test_cut_short_anywhere(self):
        whole = self.bytes()
        for share in (0.1, 0.5, 0.9, 0.99):
            self.refused(self.write("cut.FCStd", whole[:int(share * len(whole))]), "not a FreeCAD document|damaged")

    def test_flipped_byte_in_a_member(self):
        whole = bytearray(self.bytes())
        with zipfile.ZipFile(self.path) as archive:
            info = archive.getinfo("Document.xml")
        whole[info.header_offset + 200] ^= 0xFF
        self.refused(self.write("flipped.FCStd", bytes(whole)), "damaged")

    def test_a_password(self):
        path = os.path.join(self.folder, "secret.FCStd")
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr("Document.xml", "<Document/>")
        with open(path, "rb") as stream:
            content = bytearray(stream.read())
        for flags in (content.index(b"PK\x03\x04") + 6, content.index(b"PK\x01\x02") + 8):
            content[flags] |= 1   # encrypted
        self.refused(self.write("secret.FCStd", bytes(content)), "secret.FCStd is damaged: .*encrypted")

    def test_another_zip(self):
        path = os.path.join(self.folder, "other.FCStd")
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr("readme.txt", "hello")
        self.refused(path, "^[^ ]*other.FCStd is not a FreeCAD document: it has no Document.xml$")

    def test_failed_save_leaves_the_old_file(self):
        before = self.bytes()

        class Broken:
            FileName = ""

            @staticmethod
            def saveCopy(path):
                with open(path, "wb") as stream:
                    stream.write(b"half")
                raise OSError("no space left on device")
        with self.assertRaisesRegex(UserError, "no space left"):
            documents.save_document(Broken, self.path)
        self.assertEqual(self.bytes(), before)
        self.assertEqual(os.listdir(self.folder), ["part.FCStd"])

    def test_folder_that_does_not_exist(self):
        with self.assertRaisesRegex(UserError, "cannot write"):
            documents.save_document(self.document, os.path.join(self.folder, "none", "part.FCStd"))

    def altered(self, change):
        """A copy of the document whose Document.xml was changed, opened."""
        path = os.path.join(self.folder, "altered.FCStd")
        with zipfile.ZipFile(self.path) as old, zipfile.ZipFile(path, "w") as new:
            for name in old.namelist():
                content = old.read(name)
                new.writestr(name, change(content) if name == "Document.xml" else content)
        return documents.open_document(path)

    def not_replaced(self, opened, message):
        with open(opened.FileName, "rb") as stream:
            before = stream.read()
        with self.assertRaisesRegex(UserError, message):
            documents.save_document(opened, opened.FileName)
        with open(opened.FileName, "rb") as stream:
            self.assertEqual(stream.read(), before)
        documents.save_document(opened, os.path.join(self.folder, "elsewhere.FCStd"))

    def test_what_freecad_does_not_know_is_not_lost(self):
        opened = self.altered(lambda xml: xml.replace(b'type="PartDesign::Body" name="Body"', b'type="Later::Body" name="Body"'))
        self.not_replaced(opened, r"cannot read all of .*altered.FCStd: not Body \(Later::Body\), and writing it would lose that")

    def test_what_ends_too_soon_is_not_replaced(self):
        opened = self.altered(lambda xml: xml[:int(0.8 * len(xml))])
        self.not_replaced(opened, "cannot read all of .*altered.FCStd, and writing it would lose that")

    def test_a_document_that_was_read_whole_is_replaced(self):
        opened = self.altered(lambda xml: xml)
        for _ in range(2):
            documents.save_document(opened, opened.FileName)
        opened.removeObject("HoleSketch")   # what was there and is not wanted any longer
        documents.save_document(opened, opened.FileName)

    def test_what_another_program_saved_meanwhile_is_not_undone(self):
        opened = self.altered(lambda xml: xml)
        self.document.saveCopy(opened.FileName)
        self.not_replaced(opened, "altered.FCStd was saved by another program meanwhile")

    def test_a_copy_elsewhere_has_its_links_to_other_documents(self):
        """By an object and by an expression; FreeCAD's own copy looks for them in its own folder."""
        self.document.saveAs(os.path.join(self.folder, "Teil & 'ä' 50%.FCStd"))
        linking = FreeCAD.newDocument("Linking")
        self.addCleanup(lambda: FreeCAD.closeDocument(linking.Name) if linking in FreeCAD.listDocuments().values() else None)
        linking.saveAs(os.path.join(self.folder, "linking.FCStd"))
        link = linking.addObject("App::Link", "Link")
        link.LinkedObject = self.document.getObject("Body")
        linking.addObject("Part::Box", "Box").setExpression("Height", self.document.Name + "#Plate.Length")
        linking.recompute()
        linking.save()
        os.mkdir(os.path.join(self.folder, "study"))
        path = os.path.join(self.folder, "study", "copy.FCStd")
        documents.save_document(linking, path)
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        linking = documents.open_document(path)
        self.assertIsNotNone(linking.Link.LinkedObject)
        linking.Link.LinkedObject.Document.getObject("Plate").Length = 12
        linking.Link.LinkedObject.Document.recompute()
        linking.recompute()
        self.assertAlmostEqual(linking.Link.Shape.BoundBox.ZLength, 12)
        self.assertEqual(linking.Box.Height.Value, 12)

    def test_colours_of_the_file_survive(self):
        view = b'<?xml version="1.0"?><Document><ViewProviderData><ViewProvider name="Body"><Property file="DiffuseColor"/></ViewProvider></ViewProviderData></Document>'
        with zipfile.ZipFile(self.path, "a") as archive:
            archive.writestr("GuiDocument.xml", view)
            archive.writestr("DiffuseColor", b"\x01\x02")
        opened = documents.open_document(self.path)
        target = os.path.join(self.folder, "copy.FCStd")
        documents.save_document(opened, target)
        with zipfile.ZipFile(target) as archive:
            self.assertEqual(archive.read("GuiDocument.xml"), view)
            self.assertEqual(archive.read("DiffuseColor"), b"\x01\x02")

    def test_a_new_mesh_is_shown_in_place_of_its_part(self):
        view = (b'<Document><ViewProviderData Count="1"><ViewProvider name="Body"><Properties Count="1"><Property name="Visibility">'
                b'<Bool value="true"/></Property></Properties></ViewProvider></ViewProviderData></Document>')
        found = self.saved_view(view, add_mesh=True)
        self.assertEqual(found, {"Body": "false", "FeatureMesh": "true"})

    def test_what_is_shown_survives_a_scripts_own_saving(self):
        from freecad.featuremesh import api
        view = (b'<Document><ViewProviderData Count="1"><ViewProvider name="Body"><Properties Count="2"><Property name="Visibility"><Bool value="true"/></Property>'
                b'<Property name="DiffuseColor"><ColorList file="DiffuseColor"/></Property></Properties></ViewProvider></ViewProviderData></Document>')
        with zipfile.ZipFile(self.path, "a") as archive:
            archive.writestr("GuiDocument.xml", view)
            archive.writestr("DiffuseColor", b"\x01\x02")
        document = FreeCAD.openDocument(self.path)
        api.add_mesh(document.Body, 20.0, order=1)
        other = os.path.join(self.folder, "other.FCStd")
        for save in (document.save, document.save, lambda: document.saveAs(other), document.save):
            save()
            with zipfile.ZipFile(document.FileName) as archive:
                self.assertEqual(shown_in(archive), {"Body": "false", "FeatureMesh": "true"})
                self.assertEqual((archive.read("DiffuseColor"), archive.testzip()), (b"\x01\x02", None))
        self.assertEqual([name for name in os.listdir(self.folder) if name.startswith(".")], [])
        FreeCAD.closeDocument(document.Name)
        document = new_document()
        api.add_mesh(plate_with_hole(document), 20.0, order=1)
        document.saveAs(self.path)
        with zipfile.ZipFile(self.path) as archive:
            self.assertEqual(shown_in(archive), {"FeatureMesh": "true"})

    def test_a_document_that_shows_nothing_shows_its_parts(self):
        found = self.saved_view(None, add_mesh=False)
        self.assertEqual(found, {"Body": "true", "Hole": "true"})
        with zipfile.ZipFile(os.path.join(self.folder, "target.FCStd")) as archive:
            settings = ElementTree.fromstring(archive.read("GuiDocument.xml")).find("Camera").get("settings")
        camera = {line.split()[0]: [float(number) for number in line.split()[1:]] for line in settings.splitlines()[2:-1]}
        ahead = FreeCAD.Rotation(FreeCAD.Vector(*camera["orientation"][:3]), math.degrees(camera["orientation"][3])).multVec(FreeCAD.Vector(0, 0, -1))
        seen = FreeCAD.Vector(*camera["position"]) + ahead * camera["focalDistance"][0]
        self.assertLess((seen - FreeCAD.Vector(30, 20, 5)).Length, 1e-3)   # the middle of the plate
        self.assertGreaterEqual(camera["height"][0], FreeCAD.Vector(60, 40, 10).Length - 1e-6)

    def test_what_fem_would_have_made_in_a_window_opens_its_panel_there(self):
        plain = b'<Document><ViewProviderData Count="1"><ViewProvider name="Body"><Properties Count="0"/></ViewProvider></ViewProviderData></Document>'
        for view in (None, plain):
            document = new_document()
            source, target = (os.path.join(self.folder, name + ".FCStd") for name in ("source", "target"))
            plate_with_hole(document)
            document.saveAs(source)
            if view:
                with zipfile.ZipFile(source, "a") as archive:
                    archive.writestr("GuiDocument.xml", view)
            ObjectsFem.makeMaterialSolid(document, "Steel")
            result = ObjectsFem.makeResultMechanical(document, "Result")
            result.Mesh = ObjectsFem.makeMeshResult(document, "Mesh")
            documents.save_document(document, target)
            FreeCAD.closeDocument(document.Name)
            with zipfile.ZipFile(target) as archive:
                root = ElementTree.fromstring(archive.read("GuiDocument.xml"))
            found = {provider.get("name"): provider.find(".//Python").attrib for provider in root.iter("ViewProvider") if provider.find(".//Python") is not None}
            self.assertEqual(set(found), {"Steel", "Result", "Mesh"})
            for attributes in found.values():
                with open(importlib.util.find_spec(attributes["module"]).origin, encoding="utf-8") as stream:
                    self.assertRegex(stream.read(), r"(?m)^class %s\b" % attributes["class"])

    def saved_view(self, view, add_mesh):
        """{object: is it shown} in a document saved from a plate with this view."""
        from freecad.featuremesh import api
        document = new_document()
        body = plate_with_hole(document)
        source, target = os.path.join(self.folder, "source.FCStd"), os.path.join(self.folder, "target.FCStd")
        document.saveAs(source)
        if view:
            with zipfile.ZipFile(source, "a") as archive:
                archive.writestr("GuiDocument.xml", view)
        if add_mesh:
            api.add_mesh(body, 20.0, order=1)
        documents.save_document(document, target)
        FreeCAD.closeDocument(document.Name)
        with zipfile.ZipFile(target) as archive:
            return shown_in(archive)


def shown_in(archive):
    """{object: is it shown} in a document's file."""
    root = ElementTree.fromstring(archive.read("GuiDocument.xml"))
    assert root.find("ViewProviderData").get("Count") == str(len(root.findall(".//ViewProvider")))
    return {provider.get("name"): provider.find(".//Bool").get("value") for provider in root.iter("ViewProvider")}
