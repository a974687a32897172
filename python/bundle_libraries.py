# SPDX-License-Identifier: BSD-3-Clause
"""Copies shared libraries that a minimal system lacks into a folder beside the programs that need them.

    bundle_libraries.py FOLDER FILE...

copies the libraries of the programs and modules FILE to FOLDER, and changes FILE and the copies so that they find
each other from any folder. Each copy has a unique name, so that a process can also load another version of the library.
The licences of the copies go to FOLDER/licences, if Debian's packages have them. Needs patchelf.
"""

import hashlib
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

# Libraries of glibc and of the compiler, which every system with the same or a newer glibc has.
SYSTEM = re.compile(r"(linux-vdso|ld-linux[-\w]*|lib(c|m|dl|rt|pthread|util|resolv|anl|gcc_s|stdc\+\+))\.so\.\d+")


def output_of(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def libraries_of(file):
    """Name and path of each library that a file loads, directly or indirectly, except those of the system."""
    found = {}
    for line in output_of("ldd", str(file)).splitlines():
        name, arrow, path = line.strip().partition(" => ")
        if not arrow or SYSTEM.fullmatch(name):
            continue
        if not path.startswith("/"):
            raise SystemExit(f"{file} needs {name}, which is not on this machine")
        found[name] = Path(path.split(" (")[0]).resolve()
    return found


def needed_by(file):
    return output_of("patchelf", "--print-needed", str(file)).split()


def own_name(name, path):
    """libx.so.1 as libx-HASH.so.1."""
    mark = hashlib.sha256(path.read_bytes()).hexdigest()[:8]
    return name.replace(".so", f"-{mark}.so", 1)


def patch(file, names, search):
    """Makes a file load the copies from the folder `search`, a path relative to the file."""
    rename = [word for old in needed_by(file) if old in names for word in ("--replace-needed", old, names[old])]
    # In separate calls: patchelf 0.14 mixes up strings if it does both in one call.
    if rename:
        subprocess.run(["patchelf", *rename, str(file)], check=True)
    subprocess.run(["patchelf", "--force-rpath", "--set-rpath", search, str(file)], check=True)


def packages_of(files):
    """Debian package of each file that belongs to one. A single query, since each query reads all package lists."""
    asked = subprocess.run(["dpkg-query", "-S", *files], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    rows = (line.partition(": ") for line in asked.stdout.splitlines())
    return {file: owners.partition(",")[0].partition(":")[0] for owners, _, file in rows}


def copy_licences(paths, folder):
    if not shutil.which("dpkg-query"):
        return
    folder.mkdir(exist_ok=True)
    names = {path: (str(path), "/" + str(path).removeprefix("/usr/")) for path in paths}  # /lib is a link to /usr/lib
    package_of = packages_of([name for both in names.values() for name in both])
    for both in names.values():
        package = next((package_of[name] for name in both if name in package_of), "")
        text = Path("/usr/share/doc") / package / "copyright"
        if package and text.exists():
            shutil.copyfile(text, folder / f"{package}.txt")


def bundle(folder, files):
    """@return the paths of the copies."""
    if not shutil.which("patchelf"):
        raise SystemExit("shared libraries cannot be bundled without patchelf (Debian: apt-get install patchelf)")
    libraries = {name: path for file in files for name, path in libraries_of(file).items()}
    names = {name: own_name(name, path) for name, path in libraries.items()}
    folder.mkdir(parents=True, exist_ok=True)
    copies = []
    for name, path in libraries.items():
        copy = folder / names[name]
        shutil.copyfile(path, copy)
        copy.chmod(0o755)
        subprocess.run(["patchelf", "--set-soname", names[name], str(copy)], check=True)
        patch(copy, names, "$ORIGIN")
        copies.append(copy)
    for file in files:
        patch(file, names, os.path.join("$ORIGIN", os.path.relpath(folder, file.parent)))
    copy_licences(libraries.values(), folder / "licences")
    return copies


if __name__ == "__main__":
    bundle(Path(sys.argv[1]).resolve(), [Path(file).resolve() for file in sys.argv[2:]])
