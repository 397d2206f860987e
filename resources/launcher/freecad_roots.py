# SPDX-License-Identifier: GPL-3.0-or-later
"""Roots of other Debian releases, in which the tests run with the FreeCAD and the libraries of that release.

A root comes from the mirror that the machine's apt uses, with apt's own settings for reaching it, its signature checked. It is kept
outside the checkout for some days; the checkout is mounted into it for the time of a run, in a mount namespace that ends with the run.
"""
import contextlib
import datetime
import fcntl
import json
import os
import subprocess
from pathlib import Path

import packages
from cgal_headers import DEFAULT_KEYRING, SYSTEM_SOURCES, debian_source, is_snapshot
from layout import ROOT, SETUP_LOG, Failure, Unavailable
from setup_log import run_logged, say

RELEASE_OF = {"1.0": "trixie", "1.1": "testing"}
USERS_RELEASE_OF = {"0.20": "bookworm", **RELEASE_OF}   # of roots as users have them, without anything to build with
# Debian 13 has no CalculiX; Debian 12's works there with the libraries beside it. Installed, it would take FreeCAD's own away.
FROM_BEFORE = {"trixie": {"release": "bookworm", "unpacked": ("calculix-ccx", "libspooles2.2"), "libraries": ("libarpack2t64", "libopenmpi40")}}
CACHE = Path(os.environ.get("FEATUREMESH_CACHE", "/var/cache/featuremesh"))
FRESH_DAYS = 7
ROOT_PACKAGES = ("debootstrap",)
NOTE = "featuremesh-root.json"
CHECKOUT = "/featuremesh"
CERTIFICATES = "etc/ssl/certs/ca-certificates.crt"
OFFLINE = ("--net",)
# Mounts live in the namespace of this shell and end with it; so do its processes.
MOUNT_AND_RUN = """
set -e
root=$1 checkout=$2 ccache=$3; shift 3
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"
mount --rbind /sys "$root/sys"
mount --bind "$checkout" "$root/featuremesh"
mount --bind "$ccache" "$root/var/cache/ccache"
exec chroot "$root" "$@"
"""
# The packages are part of a root, so that a mirror that fails in the middle is known as such.
INSTALL = f"""
mkdir -p {CHECKOUT}/build
{{ apt-get -q update && apt-get -q -y install --no-install-recommends python3; }} >> {CHECKOUT}/build/setup.log 2>&1 || exit 1
exec /usr/bin/python3 -B -c "import sys; sys.path.insert(0, '{CHECKOUT}/resources/launcher')
import packages
packages.install_missing(packages.$1)"
"""
# A root that breaks is made anew: nothing is waited for until it is on the disk, and nobody reads manuals there.
THROWAWAY = "force-unsafe-io\npath-exclude=/usr/share/doc/*\npath-exclude=/usr/share/man/*\n"
UNPACK = """
set -e
exec >> /featuremesh/build/setup.log 2>&1
sources=/etc/apt/sources.list.d/before.list
trap "rm -f $sources" EXIT
echo "$1" > $sources
apt-get -q update
cd "$(mktemp -d)"
apt-get -q download $2
for package in *.deb; do dpkg -x "$package" /; done
rm $sources
apt-get -q update
apt-get -q -y install --no-install-recommends $3
ldconfig
"""
# Settings by which apt reaches a mirror and trusts it; those about where it keeps its own files stay behind.
TAKEN_ALONG = ("Acquire::http", "Acquire::https", "Acquire::Check-", "Acquire::Retries", "Acquire::ForceIPv")


def run_in_root(version, command):
    """Runs a command of the checkout in the root with that FreeCAD; gives its exit code. Throws Unavailable when there can be no root."""
    prefix = prepare_machine()
    root = CACHE / RELEASE_OF[version]
    make_unless_fresh(RELEASE_OF[version], root, prefix, "FOR_TESTS")
    try:
        return run_mounted(prefix, root, [f"FEATUREMESH_BUILD={CHECKOUT}/build/freecad-{version}"], command)
    finally:
        give_back(prefix)


def run_in_users_root(version, command):
    """Runs a command in a root that has that FreeCAD and pip, but nothing to build with and no network; gives its exit code. Throws Unavailable."""
    prefix = prepare_machine(OFFLINE)
    root = CACHE / (USERS_RELEASE_OF[version] + "-users")
    make_unless_fresh(USERS_RELEASE_OF[version], root, prefix, "FOR_USERS")
    try:
        return run_mounted(prefix, root, [], command, OFFLINE)
    finally:
        give_back(prefix)


def run_mounted(prefix, root, variables, command, unshared=()):
    """Runs a command in a root with the checkout at CHECKOUT and the release's compiler cache; gives its exit code. `unshared` are more options of
    unshare."""
    ccache = CACHE / ("ccache-" + root.name.split(".")[0])
    run_logged([*prefix, "mkdir", "-p", ccache, root / CHECKOUT.lstrip("/"), root / "var/cache/ccache"], "preparing the root")
    environment = ["env", "-i", "PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin", "HOME=/root", "LC_ALL=C.UTF-8",
                   "CCACHE_DIR=/var/cache/ccache", *proxies(), *variables]
    return subprocess.run([*prefix, "unshare", "--mount", "--pid", "--fork", "--kill-child", *unshared, "sh", "-c", MOUNT_AND_RUN, "sh",
                           root, ROOT, ccache, *environment, *command], stdin=subprocess.DEVNULL).returncode


def prepare_machine(unshared=()):
    """Installs debootstrap and sees whether mounts are allowed; gives the words to become root. `unshared` are more options of unshare."""
    try:
        packages.install_missing(ROOT_PACKAGES)
        prefix = packages.root_prefix(ROOT_PACKAGES)
        run_logged([*prefix, "unshare", "--mount", "--pid", "--fork", *unshared, "mount", "--make-rprivate", "/"], "mounting in a namespace")
        run_logged([*prefix, "mkdir", "-p", CACHE], "making the cache folder")
    except Failure as failure:
        raise Unavailable(f"a root of another Debian release cannot be made here: {failure}") from None
    return prefix


@contextlib.contextmanager
def alone(prefix):
    """One at a time makes or renews roots."""
    lock_file = CACHE / "lock"
    run_logged([*prefix, "sh", "-c", f"touch '{lock_file}' && chmod a+rw '{lock_file}'"], "locking the cache folder")
    with open(lock_file, "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def is_fresh(root, now=None):
    """Was this root made by us, to its end, within the last days?"""
    try:
        made = datetime.datetime.fromisoformat(json.loads((root / NOTE).read_text(encoding="utf-8"))["made"])
    except (OSError, ValueError, KeyError):
        return False
    return datetime.timedelta(0) <= (now or datetime.datetime.now()) - made < datetime.timedelta(days=FRESH_DAYS)


def make_unless_fresh(name, root, prefix, wanted):
    """Who finds a fresh root does not wait for those who make another."""
    if is_fresh(root):
        return
    with alone(prefix):
        if not is_fresh(root):
            make_root(name, root, prefix, wanted)


def make_root(name, root, prefix, wanted):
    """Makes the root anew beside its place, with that group of `packages`, and moves it there when it is whole."""
    say(f"making a root of Debian {name} in {root} (up to 3 GB with its packages, kept for {FRESH_DAYS} days)")
    fresh = root.with_name(root.name + ".new")
    try:
        source = debian_source(SYSTEM_SOURCES)
        run_logged([*prefix, "rm", "-rf", "--one-file-system", fresh], "removing half a root")
        keyring = source["signed_by"] or DEFAULT_KEYRING
        run_logged([*prefix, "env", *debootstrap_proxies(), "debootstrap", "--variant=minbase", "--force-check-gpg", f"--keyring={keyring}",
                    name, fresh, source["uri"], *debootstrap_script(name)], f"debootstrap of Debian {name} from {source['uri']}")
    except Failure as failure:
        raise Unavailable(f"no root of Debian {name}: {failure}") from None
    write(prefix, fresh / "etc/apt/sources.list", sources_list(name, source))
    write(prefix, fresh / "etc/dpkg/dpkg.cfg.d/throwaway", THROWAWAY)
    write(prefix, fresh / "etc/apt/apt.conf.d/99machine", "".join(machine_settings()))
    if Path("/", CERTIFICATES).is_file():
        write(prefix, fresh / CERTIFICATES, Path("/", CERTIFICATES).read_text(encoding="utf-8"))
    if run_mounted(prefix, fresh, [], ["sh", "-c", INSTALL, "sh", wanted]):
        raise Unavailable(f"no root of Debian {name}: its packages could not be installed, see {SETUP_LOG}")
    if wanted == "FOR_TESTS" and name in FROM_BEFORE and run_mounted(prefix, fresh, [], ["sh", "-c", UNPACK, "sh", *from_before(name, source)]):
        say(f"Debian {name} lacks a package that could not be taken from the release before, see {SETUP_LOG}; what needs it is skipped")
    write(prefix, fresh / NOTE, json.dumps({"made": datetime.datetime.now().isoformat(), "release": name}))
    run_logged([*prefix, "rm", "-rf", "--one-file-system", root], "removing the old root")
    run_logged([*prefix, "mv", fresh, root], "moving the new root to its place")


def debootstrap_script(name):
    """A debootstrap older than the release has no script of its name; all releases of today share one."""
    scripts = Path("/usr/share/debootstrap/scripts")
    return [] if (scripts / name).exists() else [str(scripts / "sid")]


def sources_list(name, source):
    options = []
    if is_snapshot(source):
        options.append("check-valid-until=no")
    return f"deb {'[' + ' '.join(options) + '] ' if options else ''}{source['uri']} {name} main\n"


def from_before(name, source):
    """What UNPACK has to know: the source of the release before, the packages to unpack and the libraries that they need."""
    taken = FROM_BEFORE[name]
    return sources_list(taken["release"], source).strip(), " ".join(taken["unpacked"]), " ".join(taken["libraries"])


def machine_settings():
    """Lines of the machine's apt settings that tell how mirrors are reached and when their lists are too old."""
    shown = subprocess.run(["apt-config", "dump"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=True).stdout
    return [line + "\n" for line in shown.splitlines() if line.startswith(TAKEN_ALONG) and not line.endswith(' "";')]


def debootstrap_proxies():
    """Debootstrap knows nothing of apt's settings: the same proxy as environment variables."""
    found = []
    for line in machine_settings():
        setting, value = line.rstrip(";\n").split(" ", 1)
        if setting.lower() in ("acquire::http::proxy", "acquire::https::proxy") and value.strip('"') not in ("", "DIRECT"):
            found.append(setting.split("::")[1].lower() + "_proxy=" + value.strip('"'))
    return found


def proxies():
    """The user's proxy variables, which an emptied environment would lose."""
    return [f"{name}={value}" for name, value in sorted(os.environ.items()) if name.lower() in ("http_proxy", "https_proxy", "no_proxy")]


def write(prefix, path, text):
    """Writes a file that only root may write."""
    run_logged([*prefix, "mkdir", "-p", path.parent], "preparing the root")
    done = subprocess.run([*prefix, "tee", path], input=text, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        raise Failure(f"{path} could not be written: {done.stderr.strip()}")


def give_back(prefix):
    """What the run built belongs to the checkout's owner again."""
    owner = ROOT.stat()
    if prefix and (ROOT / "build").exists():
        run_logged([*prefix, "chown", "-R", f"{owner.st_uid}:{owner.st_gid}", ROOT / "build"], "giving the build folder back")
