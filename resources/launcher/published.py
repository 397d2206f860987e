# SPDX-License-Identifier: GPL-3.0-or-later
"""What is published besides the wheels: the addon as the Addon Manager wants it, the portable zip, Debian's package, checksums."""
import hashlib
import os
import re
import shutil
import subprocess
import tempfile
import zipfile
from pathlib import Path

import wheels
from layout import ROOT, WORKBENCH, Failure
from setup_log import run_logged

NAME = "FeatureMesh"
SOURCES = ROOT / "resources" / "packages"
DEPENDENCY = re.compile(r'\n\s*<depend type="python">featuremesh-engine</depend>')
MAINTAINER = "The FeatureMesh developers <featuremesh@example.org>"


def addon_files():
    """{path in the addon: bytes}: the workbench with its licence, and a readme with pictures."""
    files = {path.relative_to(WORKBENCH).as_posix(): path.read_bytes() for path in sorted(WORKBENCH.rglob("*"))
             if path.is_file() and "__pycache__" not in path.parts}
    readme = (SOURCES / "addon-readme.md").read_text(encoding="utf-8")
    pictures = re.findall(r"\((docs/pictures/[^)]+)\)", readme)
    files.update({"README.md": readme.encode(), "LICENSE": (ROOT / "LICENSE").read_bytes()})
    files.update({name: (ROOT / name).read_bytes() for name in pictures})
    return files


def without_dependency(files):
    """The addon's files for a package that brings the engine itself."""
    text = files["package.xml"].decode()
    if not DEPENDENCY.search(text):
        raise Failure("package.xml does not name the engine as this expects")
    return {**files, "package.xml": DEPENDENCY.sub("", text).encode()}


def make_addon_zip(dist):
    """The addon alone, package.xml at the top."""
    return write_zip(dist / f"featuremesh-addon-{wheels.project_version()}.zip", addon_files())


def make_portable_zip(dist, made):
    """The folder FeatureMesh with the addon and the engines of all wheels, to be unpacked into FreeCAD's folder Mod."""
    files = without_dependency(addon_files())
    for wheel in made:
        with zipfile.ZipFile(wheel) as archive:
            for name in archive.namelist():
                data, place = archive.read(name), "engines/" + name
                if name.endswith((".dist-info/RECORD", ".dist-info/WHEEL")) or "/sboms/" in name:
                    place = f"engines/{Path(name).parent.as_posix()}/{python_of(wheel)}-{Path(name).name}"   # each wheel has its own
                elif files.get(place, data) != data:
                    raise Failure(f"{name} differs between the wheels")
                files[place] = data
    return write_zip(dist / f"featuremesh-portable-{wheels.project_version()}-linux_{os.uname().machine}.zip",
                     {f"{NAME}/{name}": data for name, data in files.items()})


def python_of(wheel):
    return wheel.name.split("-")[2]


def write_zip(path, files):
    with zipfile.ZipFile(path, "w") as archive:
        for name, data in sorted(files.items()):
            wheels.write_entry(archive, name, data)
    return path


def make_debian_package(python, module, dist):
    """A package for the Debian on which this runs, with its own OCCT and FreeCAD. lintian must find no error in it."""
    with tempfile.TemporaryDirectory(prefix="featuremesh-deb-") as folder:
        Path(folder).chmod(0o755)
        root, info = Path(folder) / "root", f"featuremesh_engine-{wheels.project_version()}.dist-info"
        packages = root / "usr/lib/python3/dist-packages"
        files = without_dependency(addon_files())
        del files["LICENSE"]   # Debian has it
        for name, data in files.items():
            write(root / "usr/share/freecad/Mod" / NAME / name, data)
        write(packages / module.name, module.read_bytes())
        write(packages / info / "METADATA", wheels.metadata().replace("License-File: LICENSE\n", "").encode())
        run_logged(["strip", "--strip-unneeded", packages / module.name], "stripping the engine")
        write_documents(root / "usr/share/doc/featuremesh")
        write(root / "DEBIAN/control", control(python, root, packages / module.name).encode())
        write(root / "DEBIAN/postinst", script(f"py3compile -p featuremesh -V {python.version}"))
        write(root / "DEBIAN/prerm", script("py3clean -p featuremesh"))
        sums = [f"{hashlib.md5(path.read_bytes()).hexdigest()}  {path.relative_to(root)}\n" for path in sorted(root.rglob("*"))
                if path.is_file() and "DEBIAN" not in path.parts]
        write(root / "DEBIAN/md5sums", "".join(sums).encode())
        package = dist / f"featuremesh_{wheels.project_version()}_{architecture()}.deb"
        run_logged(["env", f"SOURCE_DATE_EPOCH={wheels.source_date()}", "dpkg-deb", "--root-owner-group", "-Zxz", "--build", root, package],
                   "building Debian's package")
    run_logged(["lintian", "--fail-on", "error", "--allow-root", package], "checking Debian's package with lintian")
    return package


def write_documents(folder):
    """What Debian's policy wants to find in a package's documentation."""
    version = wheels.project_version()
    date = subprocess.run(["date", "-R", "-u", "-d", f"@{wheels.source_date()}"], stdout=subprocess.PIPE, text=True, check=True).stdout.strip()
    write(folder / "changelog.gz", packed(f"featuremesh ({version}) unstable; urgency=medium\n\n  * See the project's CHANGELOG.md.\n\n"
                                          f" -- {MAINTAINER}  {date}\n"))
    write(folder / "copyright", ("Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\n"
                                 "Upstream-Name: FeatureMesh\n\nFiles: *\nCopyright: The FeatureMesh developers\nLicense: GPL-3+\n"
                                 " On Debian systems the text of this licence is in /usr/share/common-licenses/GPL-3.\n").encode())


def packed(text):
    return subprocess.run(["gzip", "-9n"], input=text.encode(), stdout=subprocess.PIPE, check=True).stdout


def control(python, root, module):
    """Debian's description of the package; the libraries are found in the module."""
    major, minor = python.version.split(".")
    size = sum(path.stat().st_size for path in root.rglob("*") if path.is_file()) // 1024
    return (f"Package: featuremesh\nVersion: {wheels.project_version()}\nArchitecture: {architecture()}\nMaintainer: {MAINTAINER}\n"
            f"Installed-Size: {size}\nSection: science\nPriority: optional\n"
            f"Depends: {libraries(module)}, freecad-python3, python3 (>= {python.version}~), python3 (<< {major}.{int(minor) + 1}), python3-numpy\n"
            "Description: FEM meshes of FreeCAD parts that are updated when the part is edited\n"
            " FeatureMesh gives a FreeCAD part a tetrahedral FEM mesh that stays alive: when\n"
            " the part is edited, the mesh is updated, not thrown away. What did not change\n"
            " keeps its numbers, its groups and its loads.\n")


def libraries(module):
    """The packages of the libraries that the module needs, as Debian's own tool finds them."""
    with tempfile.TemporaryDirectory(prefix="featuremesh-shlibs-") as folder:
        write(Path(folder) / "debian/control", b"Source: featuremesh\n\nPackage: featuremesh\nArchitecture: any\n")
        done = subprocess.run(["dpkg-shlibdeps", "-O", "--ignore-missing-info", str(module)], cwd=folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True)
    if done.returncode:
        raise Failure(f"the packages of the engine's libraries could not be found: {done.stderr}")
    return done.stdout.strip().partition("=")[2]


def script(command):
    """A maintainer's script that runs a command where it is installed."""
    program = command.split()[0]
    return f"#!/bin/sh\nset -e\nif command -v {program} >/dev/null; then {command}; fi\n".encode()


def architecture():
    return subprocess.run(["dpkg", "--print-architecture"], stdout=subprocess.PIPE, text=True, check=True).stdout.strip()


def write(path, data):
    """Writes a file that everybody may read, with its folders; scripts may be run."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)
    path.chmod(0o755 if data.startswith(b"#!") else 0o644)


def write_checksums(dist):
    lines = [f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in sorted(dist.iterdir()) if path.name != "SHA256SUMS"]
    (dist / "SHA256SUMS").write_text("".join(lines), encoding="utf-8")


def make_all(dist, programs):
    """Everything, in a folder that has nothing else afterwards; gives the files."""
    fresh = dist.with_name(dist.name + ".new")
    shutil.rmtree(fresh, ignore_errors=True)
    fresh.mkdir()
    modules = wheels.build_modules(wheels.pythons(programs))
    made = [wheels.make_wheel(python, module, fresh) for python, module in modules.items()]
    make_addon_zip(fresh)
    make_portable_zip(fresh, made)
    own = next((python for python in modules if python.version == debians_python()), None)
    if own is None:
        raise Failure("the headers of this machine's Python are missing")
    make_debian_package(own, modules[own], fresh)
    write_checksums(fresh)
    shutil.rmtree(dist, ignore_errors=True)
    fresh.rename(dist)
    return sorted(dist.iterdir())


def debians_python():
    return subprocess.run([wheels.PYTHON, "-c", "import sysconfig; print(sysconfig.get_python_version())"], stdout=subprocess.PIPE, text=True,
                          check=True).stdout.strip()
