# SPDX-License-Identifier: GPL-3.0-or-later
"""The CGAL headers (6.1 or later): Debian's stable releases are too old, so Debian testing's package is unpacked beside the build.

It comes through apt with its signature checked, from the mirror that the machine already uses, with lists of its own, so
that neither the machine's packages nor its package sources change.
"""
import shutil
import subprocess
import tempfile
from pathlib import Path

from layout import CGAL, Failure
from setup_log import run_logged, say

OLDEST = (6, 1)
SYSTEM_SOURCES = Path("/etc/apt")
DEFAULT_KEYRING = "/usr/share/keyrings/debian-archive-keyring.gpg"


def version_of(prefix):
    """(major, minor) of the headers under prefix/usr/include, (0, 0) for none."""
    header = prefix / "usr" / "include" / "CGAL" / "version.h"
    if not header.is_file():
        return 0, 0
    for line in header.read_text(encoding="utf-8").splitlines():
        if line.startswith("#define CGAL_VERSION "):
            major, minor = line.split()[2].split(".")[:2]
            return int(major), int(minor.split("-")[0])
    return 0, 0


def fetch_cgal():
    """Unpacks the headers into build/deps/cgal unless they are there."""
    if version_of(CGAL) >= OLDEST:
        return
    say("fetching the CGAL headers from Debian testing (into build/deps, nothing is installed)")
    source = debian_source(SYSTEM_SOURCES)
    with tempfile.TemporaryDirectory(prefix="featuremesh-apt-") as folder:
        unpacked = CGAL.with_name("cgal.new")
        unpack(["libcgal-dev"], source, Path(folder), unpacked)
    if version_of(unpacked) < OLDEST:
        raise Failure(f"the mirror's libcgal-dev is older than CGAL {OLDEST[0]}.{OLDEST[1]}")
    shutil.rmtree(CGAL, ignore_errors=True)
    unpacked.rename(CGAL)


def unpack(packages, source, folder, target):
    """Downloads packages of Debian testing into a folder, through private lists, and unpacks them into `target`. Gives the names of those
    that there are; one that ends with `?` may be absent."""
    folder.chmod(0o755)
    lists = folder / "lists"
    (lists / "partial").mkdir(parents=True)
    sources_list = folder / "testing.list"
    sources_list.write_text(testing_line(source), encoding="utf-8")
    private = ["-o", f"Dir::Etc::SourceList={sources_list}", "-o", "Dir::Etc::SourceParts=/nonexistent",
               "-o", f"Dir::State::Lists={lists}", "-o", "Dir::Cache::pkgcache=", "-o", "Dir::Cache::srcpkgcache=",
               "-o", "Acquire::Languages=none", "-o", "APT::Update::Error-Mode=any"]
    apt = read_lists(["apt-get", "-q", *private], source)
    of_testing = [*private, "-o", "Dir::State::status=/dev/null"]   # without what is installed here, which testing may not have
    known = set(subprocess.run(["apt-cache", *of_testing, "pkgnames"], stdout=subprocess.PIPE, text=True, check=True).stdout.split())
    names = [name.rstrip("?") for name in packages if not name.endswith("?") or name.rstrip("?") in known]
    run_logged([*apt, "download", *(name + "/testing" for name in names)], f"downloading {' '.join(names)} of Debian testing", cwd=folder)
    shutil.rmtree(target, ignore_errors=True)
    target.mkdir(parents=True)
    for package in sorted(folder.glob("*.deb")):
        run_logged(["dpkg", "-x", package, target], f"unpacking {package.name}")
    return names


def testing_line(source):
    keyring = source["signed_by"]
    if not keyring and Path(DEFAULT_KEYRING).is_file():
        keyring = DEFAULT_KEYRING
    option = f"[signed-by={keyring}] " if keyring else ""
    return f"deb {option}{source['uri']} testing main\n"


def read_lists(apt, source):
    """Reads the private lists; gives the apt command with which that went well.

    An archive that stays as it was (a snapshot, a mirror that is no longer fed) is out of date by design. Its signature is checked all
    the same.
    """
    what = f"reading the package list of Debian testing at {source['uri']}"
    frozen = [*apt, "-o", "Acquire::Check-Valid-Until=false"]
    if is_snapshot(source):
        run_logged([*frozen, "update"], what)
        return frozen
    try:
        run_logged([*apt, "update"], what)
        return apt
    except Failure as failure:
        if "is expired" not in str(failure):
            raise
    say(f"{source['uri']} is frozen (its list of Debian testing is out of date); its signature is still checked")
    run_logged([*frozen, "update"], what)
    return frozen


def is_snapshot(source):
    return "snapshot" in source["uri"] or source["check_valid_until"] in ("no", "false")


def debian_source(etc_apt):
    """The machine's own source of Debian packages: {"uri", "signed_by", "check_valid_until"}."""
    parts = etc_apt / "sources.list.d"
    found = []
    for path in [etc_apt / "sources.list", *sorted(parts.glob("*.list"))]:
        if path.is_file():
            found += one_line_sources(path.read_text(encoding="utf-8"))
    for path in sorted(parts.glob("*.sources")):
        found += deb822_sources(path.read_text(encoding="utf-8"))
    for source in found:
        if source["uri"].rstrip("/").split("/")[-1] == "debian" or "/archive/debian/" in source["uri"]:
            return source
    raise Failure("no Debian mirror found in /etc/apt/sources.list or /etc/apt/sources.list.d; "
                  "unpack libcgal-dev 6.1 or later into build/deps/cgal")


def one_line_sources(text):
    """Sources in the form `deb [options] uri suite components`."""
    sources = []
    for line in text.splitlines():
        words = line.split("#")[0].split()
        if not words or words[0] != "deb":
            continue
        options = {}
        rest = " ".join(words[1:])
        if rest.startswith("["):
            inside, rest = rest[1:].split("]", 1)
            options = dict(word.split("=", 1) for word in inside.split() if "=" in word)
        if rest.split():
            sources.append(source_of(rest.split()[0], options.get("signed-by"), options.get("check-valid-until")))
    return sources


def deb822_sources(text):
    """Sources in the form of stanzas with fields."""
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    sources = []
    for stanza in "\n".join(lines).split("\n\n"):
        fields = {}
        for line in stanza.splitlines():
            if ":" in line and not line[0].isspace():
                name, value = line.split(":", 1)
                fields[name.strip().lower()] = value.strip()
        if "deb" in fields.get("types", "").split() and fields.get("enabled", "yes") != "no":
            sources += [source_of(uri, fields.get("signed-by"), fields.get("check-valid-until"))
                        for uri in fields.get("uris", "").split()]
    return sources


def source_of(uri, signed_by, check_valid_until):
    return {"uri": uri, "signed_by": signed_by or "", "check_valid_until": (check_valid_until or "").lower()}
