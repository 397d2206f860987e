# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the wheels of the engine: one build of the engine, one module per Python, with the libraries that it needs inside.

Of a Python only its headers are needed. They come from Debian testing, unpacked beside the build, from this machine, and from other
Pythons on it. The libraries are put in and renamed by auditwheel.
"""
import base64
import hashlib
import json
import os
import re
import shutil
import subprocess
import sysconfig
import tempfile
import time
import zipfile
from pathlib import Path
from typing import NamedTuple

import cgal_headers
from engine_build import PYTHON, processes_at_once
from layout import BUILD, CGAL, ROOT, Failure
from setup_log import run_logged, say

MODULE = "featuremesh_engine"
VERSIONS = ("3.10", "3.11", "3.12", "3.13", "3.14")
TOOLS = BUILD / "deps" / "packaging"
MODULES = BUILD / "package"   # the build folder
SYSTEM_HEADERS = Path("/usr/include")
TOOL_PACKAGES = ("python3-auditwheel", "python3-pyelftools", "python3-packaging", "pybind11-dev")
NEWEST_GLIBC = (2, 35)
# On every machine that runs FreeCAD; auditwheel leaves them out.
NOT_BUNDLED = ("libc6", "libgcc-s1", "libstdc++6", "zlib1g")
COMMON_LICENCES = ("GPL-3", "LGPL-2.1", "LGPL-3", "Apache-2.0")
HEADER_ONLY = {"libcgal-dev": CGAL, "pybind11-dev": TOOLS, "libboost-dev": Path("/")}


class Python(NamedTuple):
    version: str   # "3.11"
    headers: tuple  # folders

    @property
    def tag(self):
        """What the module's file name says about the Python."""
        return f"cpython-{self.version.replace('.', '')}-{multiarch()}"

    @property
    def wheel_tag(self):
        short = "cp" + self.version.replace(".", "")
        return f"{short}-{short}-linux_{os.uname().machine}"


def multiarch():
    return sysconfig.get_config_var("MULTIARCH")


def project_version():
    """The version that CMakeLists.txt gives the project."""
    return re.search(r"project\(FeatureMesh VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)


def source_date():
    """Seconds of the last commit's time, so that two runs give the same files; a fixed time outside of a clone."""
    if "SOURCE_DATE_EPOCH" in os.environ:
        return int(os.environ["SOURCE_DATE_EPOCH"])
    shown = subprocess.run(["git", "-C", str(ROOT), "log", "-1", "--format=%ct"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    return int(shown or 1767225600)


def fetch_tools():
    """Unpacks auditwheel, pybind11's headers and those of Pythons that this machine has not, unless they are there."""
    done = TOOLS / "unpacked.json"
    if done.is_file():
        return
    say("fetching auditwheel and headers of other Pythons from Debian testing (into build/deps, nothing is installed)")
    with tempfile.TemporaryDirectory(prefix="featuremesh-apt-") as folder:
        headers = [f"libpython{version}-dev?" for version in VERSIONS]
        names = cgal_headers.unpack([*TOOL_PACKAGES, *headers], cgal_headers.debian_source(cgal_headers.SYSTEM_SOURCES), Path(folder), TOOLS)
    done.write_text(json.dumps(names), encoding="utf-8")


def pythons(programs):
    """The Pythons whose headers are here, the oldest first; `programs` are interpreters that come with theirs."""
    found = {}
    for program in interpreters_here():
        python = python_of(program)
        if python:
            found.setdefault(python.version, python)
    for place in (TOOLS / "usr" / "include", SYSTEM_HEADERS):
        for version in VERSIONS:
            if (place / f"python{version}" / "Python.h").is_file():
                found[version] = Python(version, (str(place / f"python{version}"), *([str(place)] if place != SYSTEM_HEADERS else [])))
    for program in programs:
        python = python_of(program)
        if python is None:
            raise Failure(f"{program} is no Python {VERSIONS[0]} to {VERSIONS[-1]} with headers")
        found[python.version] = python
    return [found[version] for version in VERSIONS if version in found]


def interpreters_here():
    """Interpreters of other Pythons on this machine: on the path, and those that pyenv keeps, the newest first."""
    on_path = [shutil.which(f"python{version}") for version in VERSIONS]
    kept = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv")) / "versions"
    return [*filter(None, on_path), *sorted(map(str, kept.glob("3.*/bin/python3")), reverse=True)]


def python_of(program):
    """The Python of an interpreter, or None for one without headers, of another version or that does not start."""
    try:
        done = subprocess.run([program, "-c", "import sysconfig; print(sysconfig.get_python_version(), sysconfig.get_path('include'))"],
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    except OSError:
        return None
    version, _, headers = done.stdout.strip().partition(" ")
    if done.returncode or version not in VERSIONS or not Path(headers, "Python.h").is_file():
        return None
    return Python(version, (headers,))


def build_modules(wanted):
    """Builds the engine once and a module for each Python; gives {Python: file}."""
    say(f"building the engine for Python {', '.join(python.version for python in wanted)}")
    run_logged(["cmake", "--preset", "release", "-B", MODULES, "-DFEATUREMESH_TESTS=OFF", "-DFEATUREMESH_BINDINGS=OFF",
                "-DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON",   # no optional library: a wheel has what every mesh needs
                f"-DFEATUREMESH_CGAL_DIR={CGAL / 'usr'}", f"-DFEATUREMESH_PYBIND11_DIR={TOOLS / 'usr' / 'include'}",
                "-DFEATUREMESH_PYTHONS=" + ";".join(f"{python.tag}={':'.join(python.headers)}" for python in wanted)],
               "configuring the build", cwd=ROOT)
    run_logged(["cmake", "--build", MODULES, "-j", str(processes_at_once())], "building", cwd=ROOT)
    return {python: MODULES / "bindings" / python.tag / f"{MODULE}.{python.tag}.so" for python in wanted}


def make_wheel(python, module, dist):
    """A wheel with the libraries of the module inside, in the folder `dist`; gives its path."""
    with tempfile.TemporaryDirectory(prefix="featuremesh-wheel-") as folder:
        plain = Path(folder) / f"{MODULE}-{project_version()}-{python.wheel_tag}.whl"
        write_wheel(plain, contents(python, module))
        repaired = Path(folder) / "repaired"
        environment = {"PYTHONPATH": str(TOOLS / "usr/lib/python3/dist-packages"), "SOURCE_DATE_EPOCH": str(source_date())}
        run_logged(["env", *(f"{name}={value}" for name, value in environment.items()), PYTHON, "-B", "-m", "auditwheel", "repair", "--strip",
                    "-z", "9", "-w", repaired, plain], "putting the libraries into the wheel")
        made = next(repaired.glob("*.whl"))
        if glibc_of(made.name) > NEWEST_GLIBC:
            raise Failure(f"{made.name} needs a newer glibc than {'.'.join(map(str, NEWEST_GLIBC))}")
        target = dist / made.name
        target.write_bytes(made.read_bytes())
    return target


def glibc_of(wheel_name):
    """The oldest glibc with which a wheel runs, from the first of its platform tags (the others name the same platform)."""
    versions = [tuple(map(int, found)) for found in re.findall(r"manylinux_(\d+)_(\d+)_", wheel_name)]
    if not versions:
        raise Failure(f"{wheel_name} is no manylinux wheel")
    return min(versions)


def contents(python, module):
    """{path in the wheel: bytes}, but for the record."""
    info = f"{MODULE}-{project_version()}.dist-info"
    files = {module.name: module.read_bytes(), f"{MODULE}.pyi": (ROOT / "bindings" / f"{MODULE}.pyi").read_bytes(),
             f"{info}/METADATA": metadata().encode(),
             f"{info}/WHEEL": f"Wheel-Version: 1.0\nGenerator: featuremesh\nRoot-Is-Purelib: false\nTag: {python.wheel_tag}\n".encode(),
             f"{info}/sboms/{MODULE}.cdx.json": json.dumps(bill_of_headers(), indent=1).encode()}
    files.update({f"{info}/licenses/{name}": text for name, text in licences(module).items()})
    return files


def metadata():
    """Without any dependency: numpy and another OCCT from a package index have broken FreeCAD's own before."""
    readme = (ROOT / "resources" / "packages" / "engine-readme.md").read_text(encoding="utf-8")
    return ("Metadata-Version: 2.4\n"
            f"Name: featuremesh-engine\nVersion: {project_version()}\n"
            "Summary: The compiled engine of FeatureMesh, FEM meshes of FreeCAD parts that are updated locally\n"
            "License-Expression: GPL-3.0-or-later\nLicense-File: LICENSE\n"
            f"Requires-Python: >={VERSIONS[0]}\nDescription-Content-Type: text/markdown\n\n{readme}")


def licences(module):
    """{name: text} of the licences of all that is inside: ours, those of the bundled libraries and of the headers compiled in."""
    texts = {"LICENSE": (ROOT / "LICENSE").read_bytes()}
    for package in bundled_packages(module):
        texts[f"{package}.copyright"] = Path("/usr/share/doc", package, "copyright").read_bytes()
    for package, root in HEADER_ONLY.items():
        found = sorted((root / "usr/share/doc").glob(package.replace("-dev", "*-dev") + "/copyright"))
        if not found:
            raise Failure(f"the licence of {package} is not in {root / 'usr/share/doc'}")
        texts[f"{package}.copyright"] = found[-1].read_bytes()
    texts.update({name: Path("/usr/share/common-licenses", name).read_bytes() for name in COMMON_LICENCES})
    return texts


def bundled_packages(module):
    """The Debian packages of the libraries that the module needs, without those that are on every machine."""
    shown = subprocess.run(["ldd", str(module)], stdout=subprocess.PIPE, text=True, check=True).stdout
    paths = [os.path.realpath(path) for path in re.findall(r"=> (/\S+)", shown)]
    # dpkg knows the files by the paths of before /lib became a link
    owners = subprocess.run(["dpkg-query", "-S", *paths, *(path[len("/usr"):] for path in paths if path.startswith("/usr/"))],
                            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    return sorted({line.split(":")[0] for line in owners.splitlines()} - set(NOT_BUNDLED))


def bill_of_headers():
    """What is compiled in from headers alone; auditwheel lists the libraries that it puts in."""
    versions = {"pybind11": version_in(TOOLS / "usr/include/pybind11/detail/common.h", r"define PYBIND11_VERSION_(?:MAJOR|MINOR|MICRO)\s+(\d+)"),
                "cgal": ".".join(map(str, cgal_headers.version_of(CGAL))),
                "boost": version_in(Path("/usr/include/boost/version.hpp"), r'define BOOST_LIB_VERSION "([\d_]+)"').replace("_", ".")}
    return {"bomFormat": "CycloneDX", "specVersion": "1.4", "version": 1,
            "metadata": {"component": {"type": "library", "name": "featuremesh-engine", "version": project_version()}},
            "components": [{"type": "library", "name": name, "version": version} for name, version in versions.items()]}


def version_in(header, pattern):
    return ".".join(re.findall(pattern, header.read_text(encoding="utf-8")))


def write_wheel(path, files):
    """Writes a wheel with its record, the same bytes each time."""
    info = f"{MODULE}-{project_version()}.dist-info"
    lines = [f"{name},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b'=').decode()},{len(data)}"
             for name, data in sorted(files.items())]
    record = "\n".join([*lines, f"{info}/RECORD,,", ""])
    with zipfile.ZipFile(path, "w") as archive:
        for name, data in [*sorted(files.items()), (f"{info}/RECORD", record.encode())]:
            write_entry(archive, name, data)


def write_entry(archive, name, data):
    """A file of an archive with the time of the sources and the usual rights."""
    entry = zipfile.ZipInfo(name, time.gmtime(source_date())[:6])
    entry.external_attr = (0o100755 if name.endswith(".so") else 0o100644) << 16
    archive.writestr(entry, data, zipfile.ZIP_DEFLATED, 9)
