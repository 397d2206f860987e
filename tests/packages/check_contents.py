# SPDX-License-Identifier: GPL-3.0-or-later
"""What is inside the packages in dist: libraries, tags, sizes, licences, and nothing that is not meant to be there."""
import hashlib
import json
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from installed import DIST, one_of, unpack  # noqa: E402

MEGABYTE = 1_000_000
# What every machine has that runs FreeCAD (manylinux names the same).
OF_THE_SYSTEM = {"libc.so.6", "libm.so.6", "libdl.so.2", "libpthread.so.0", "librt.so.1", "libgcc_s.so.1", "libstdc++.so.6", "libz.so.1",
                 "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"}


def dynamic(path):
    """(libraries needed, folders in which they are looked for) of a library."""
    shown = subprocess.run(["readelf", "-dW", str(path)], stdout=subprocess.PIPE, text=True, check=True).stdout
    return (set(re.findall(r"\(NEEDED\).*\[(.*)\]", shown)),
            {folder for folders in re.findall(r"\((?:RPATH|RUNPATH)\).*\[(.*)\]", shown) for folder in folders.split(":")})


class Wheels(unittest.TestCase):
    def setUp(self):
        self.wheels = sorted(DIST.glob("*.whl"))
        self.assertGreater(len(self.wheels), 1)

    def each_unpacked(self):
        for wheel in self.wheels:
            with tempfile.TemporaryDirectory() as folder, self.subTest(wheel.name):
                unpack(wheel, Path(folder))
                yield wheel, Path(folder)

    def test_tag_and_size(self):
        for wheel in self.wheels:
            python, abi, platform = wheel.stem.split("-")[-3:]
            self.assertEqual(python, abi)
            self.assertRegex(python, r"^cp3\d\d$")
            self.assertLessEqual(min(int(minor) for minor in re.findall(r"manylinux_2_(\d+)_", platform)), 35)
            self.assertLess(wheel.stat().st_size, 20 * MEGABYTE)

    def test_libraries_are_inside_or_of_the_system(self):
        for _, folder in self.each_unpacked():
            libraries = folder / "featuremesh_engine.libs"
            inside = {path.name for path in libraries.iterdir()}
            for path in [*folder.glob("*.so"), *libraries.iterdir()]:
                needed, places = dynamic(path)
                self.assertLessEqual(needed, inside | OF_THE_SYSTEM, path.name)
                self.assertLessEqual(places, {"$ORIGIN", "$ORIGIN/featuremesh_engine.libs"}, path.name)
            self.assertTrue(any(name.startswith("libTKernel-") for name in inside))
            for name in inside:
                self.assertRegex(name, r"-[0-9a-f]{8}\.so", "not renamed")

    def test_symbols_are_hidden_and_stripped(self):
        for _, folder in self.each_unpacked():
            module = next(folder.glob("*.so"))
            shown = subprocess.run(["nm", "-D", "--defined-only", str(module)], stdout=subprocess.PIPE, text=True, check=True).stdout
            strong = [line.split()[-1] for line in shown.splitlines() if line.split()[-2] in "TDB"]
            self.assertEqual([name for name in strong if "featuremesh" in name and name != "PyInit_featuremesh_engine"], [])
            sections = subprocess.run(["readelf", "-SW", str(module)], stdout=subprocess.PIPE, text=True, check=True).stdout
            self.assertNotIn(".debug_info", sections)
            self.assertNotIn(".symtab", sections)

    def test_metadata_licences_and_bills(self):
        for _, folder in self.each_unpacked():
            info = next(folder.glob("*.dist-info"))
            metadata = (info / "METADATA").read_text(encoding="utf-8")
            self.assertIn("Name: featuremesh-engine\n", metadata)
            self.assertNotIn("Requires-Dist", metadata)
            licences = {path.name for path in (info / "licenses").iterdir()}
            for word in ("LICENSE", "GPL-3", "LGPL-2.1", "LGPL-3", "Apache-2.0", "libtbb12.copyright", "libgmp10.copyright", "libmpfr6.copyright",
                         "libcgal-dev.copyright", "pybind11-dev.copyright", "libboost-dev.copyright"):
                self.assertIn(word, licences)
            self.assertTrue(any(name.startswith("libocct-modeling-algorithms") for name in licences))
            bills = [json.loads(path.read_text(encoding="utf-8")) for path in (info / "sboms").iterdir()]
            named = " ".join(component["name"] for bill in bills for component in bill.get("components", []))
            for word in ("cgal", "pybind11", "boost", "libtbb12"):
                self.assertIn(word, named)

    def test_the_record_is_true(self):
        for wheel, folder in self.each_unpacked():
            lines = (next(folder.glob("*.dist-info")) / "RECORD").read_text(encoding="utf-8").split()
            recorded = {line.split(",")[0] for line in lines}
            with zipfile.ZipFile(wheel) as archive:
                self.assertEqual(recorded, {name for name in archive.namelist() if not name.endswith("/")})


class Zips(unittest.TestCase):
    def names(self, pattern):
        with zipfile.ZipFile(one_of(pattern)) as archive:
            return archive.namelist()

    def test_the_addon(self):
        names = self.names("featuremesh-addon-*.zip")
        for name in ("package.xml", "README.md", "LICENSE", "uninstall.py", "freecad/featuremesh/init_gui.py", "docs/pictures/kept.jpg"):
            self.assertIn(name, names)
        self.assertEqual([name for name in names if name.endswith((".so", ".pyc", ".pyd"))], [])
        with zipfile.ZipFile(one_of("featuremesh-addon-*.zip")) as archive:
            package = ElementTree.fromstring(archive.read("package.xml"))
        needed = [node.text for node in package.iter() if node.tag.endswith("depend") and node.get("type") == "python"]
        self.assertEqual(needed, ["featuremesh-engine"])

    def test_the_portable_one(self):
        path = one_of("featuremesh-portable-*.zip")
        self.assertLess(path.stat().st_size, 30 * MEGABYTE)
        names = self.names("featuremesh-portable-*.zip")
        self.assertEqual({name.split("/")[0] for name in names}, {"FeatureMesh"})
        modules = [name for name in names if re.match(r"FeatureMesh/engines/featuremesh_engine\..*\.so$", name)]
        self.assertEqual(len(modules), len(list(DIST.glob("*.whl"))))
        with zipfile.ZipFile(path) as archive:
            self.assertNotIn(b"featuremesh-engine</depend>", archive.read("FeatureMesh/package.xml"))


class Deb(unittest.TestCase):
    def test_uses_debians_own_libraries(self):
        package = one_of("featuremesh_*.deb")
        depends = subprocess.run(["dpkg-deb", "-f", str(package), "Depends"], stdout=subprocess.PIPE, text=True, check=True).stdout
        for word in ("libocct-modeling-algorithms", "freecad", "libtbb12", "python3 (<<"):
            self.assertIn(word, depends)
        self.assertLess(package.stat().st_size, 5 * MEGABYTE)

    def test_lintian_finds_no_error(self):
        done = subprocess.run(["lintian", "--fail-on", "error", "--allow-root", str(one_of("featuremesh_*.deb"))], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)


class Checksums(unittest.TestCase):
    def test_fit_every_file(self):
        lines = (DIST / "SHA256SUMS").read_text(encoding="utf-8").splitlines()
        sums = {name: digest for digest, name in (line.split("  ") for line in lines)}
        self.assertEqual(set(sums), {path.name for path in DIST.iterdir()} - {"SHA256SUMS"})
        for name, digest in sums.items():
            self.assertEqual(hashlib.sha256((DIST / name).read_bytes()).hexdigest(), digest)


if __name__ == "__main__":
    unittest.main(verbosity=2)
