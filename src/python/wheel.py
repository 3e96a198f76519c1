# SPDX-License-Identifier: MIT
"""What pip asks for a wheel (PEP 517): the parts of Meson's install that have the tag
python-runtime, and what pyproject.toml says. Debian's meson-python would pack all of the install.
The libraries that the extension is linked with go along, each with its licence.

Everything is built in a folder of its own; the tree stays as it is."""
import base64
import hashlib
import json
import os
import re
import subprocess
import sysconfig
import tempfile
import tomllib
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TAG = "python-runtime"
OPTIONS = ["-Dpython=enabled", "-Dreference=disabled", "-Dtests=disabled", "-Dembree=disabled",
           "-Dlibraries=false", "-Dopenmp=disabled"]
BORROWED = {"libgmp.so.10": "libgmp10", "libjansson.so.4": "libjansson4",
            "libpopt.so.0": "libpopt0"}  # and Debian's packages, which have the licences
LICENCES = Path("/usr/share/doc")
EPOCH = 1980, 1, 1, 0, 0, 0  # the same bytes whenever it is made


def run(*command):
    subprocess.run(list(map(str, command)), check=True)


def built(folder):
    run("meson", "setup", folder / "build", ROOT, "--buildtype=release", *OPTIONS)
    run("meson", "compile", "-C", folder / "build", "python-package")


def installed(folder, about):
    """{path in the wheel: file} of what is built in the folder, and of what it borrows."""
    run("meson", "install", "-C", folder / "build", "--no-rebuild", "--tags", TAG,
        "--destdir", folder / "root")
    packages = [path for path in (folder / "root").rglob("surehit") if path.is_dir()]
    extension, = (folder / "root").rglob("_surehit.*.so")
    return {f"surehit/{path.relative_to(package)}": path.read_bytes()
            for package in packages for path in sorted(package.rglob("*"))
            if path.is_file()} | borrowed(extension, about)


def borrowed(extension, about):
    """{path in the wheel: contents}: of each library that has its licence here, both."""
    linked = subprocess.run(["ldd", extension], check=True, capture_output=True, text=True).stdout
    files = {}
    for name, path in re.findall(r"(\S+) => (/\S+)", linked):
        licence = LICENCES / BORROWED.get(name, "") / "copyright"
        if name not in BORROWED:
            continue
        if not licence.is_file():
            print(f"wheel.py: {licence}: not there, so {name} is left to the system")
            continue
        files[f"surehit/{name}"] = Path(path).read_bytes()
        files[f"{about}/{BORROWED[name]}"] = licence.read_bytes()
    return files


def version_of(folder):
    project = folder / "build/meson-info/intro-projectinfo.json"
    return json.loads(project.read_text(encoding="utf-8"))["version"]


def described(project, version, tag):
    """Metadata and the like, by name."""
    words = [("Metadata-Version", "2.1"), ("Name", project["name"]), ("Version", version),
             ("Summary", project["description"]), ("License", project["license"]["text"]),
             ("Requires-Python", project["requires-python"]),
             *(("Requires-Dist", needed) for needed in project["dependencies"])]
    wheel = [("Wheel-Version", "1.0"), ("Generator", "surehit"), ("Root-Is-Purelib", "false"),
             ("Tag", tag)]
    return {"METADATA": words, "WHEEL": wheel}


def digest_of(contents):
    digest = base64.urlsafe_b64encode(hashlib.sha256(contents).digest()).rstrip(b"=").decode()
    return f"sha256={digest},{len(contents)}"


def write(path, files, record):
    files[record] = "".join(f"{name},{digest_of(contents)}\n" for name, contents in
                            files.items()).encode() + f"{record},,\n".encode()
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, contents in files.items():
            entry = zipfile.ZipInfo(name, EPOCH)
            entry.external_attr = (0o755 if name.endswith(".so") else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, contents)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    tag = f"cp311-abi3-{platform}"
    with tempfile.TemporaryDirectory() as made:
        built(Path(made))
        version = version_of(Path(made))
        about = f"{project['name']}-{version}.dist-info"
        files = installed(Path(made), about)
    for name, words in described(project, version, tag).items():
        files[f"{about}/{name}"] = "".join(f"{key}: {value}\n" for key, value in words).encode()
    files[f"{about}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    path = f"{project['name']}-{version}-{tag}.whl"
    write(os.path.join(wheel_directory, path), files, f"{about}/RECORD")
    return path
