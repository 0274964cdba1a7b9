# SPDX-License-Identifier: GPL-3.0-or-later
"""What `pip install .` calls (PEP 517). It makes a wheel by CMake, and needs nothing but the standard library.

The wheel has the module, the libraries that it opens itself, and the standard library of scenes. It is for
this Python and this system, whose libraries it uses. CANDELABRA_BUILD, or the setting build-dir, names a build
folder to use instead of build/wheel. With the setting carry-libraries the wheel has the libraries of the system, too,
with their licences, so that it needs only a C library as new as here, and that of C++; patchelf has them find each
other. OpenImageIO, which needs hundreds of libraries, is left out of it, and with it TGA, WebP and other rare formats.
"""

import base64
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SUMMARY = "A scene language and ray tracer for scenes lit by thousands of luminaires"


def version():
    return re.search(r"VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text().split("project(")[1])[1]


def metadata():
    return (f"Metadata-Version: 2.1\nName: candelabra\nVersion: {version()}\nSummary: {SUMMARY}\n"
            "License: GPL-3.0-or-later\nRequires-Python: >=3.9\nRequires-Dist: numpy\n")


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{re.sub('[^0-9a-zA-Z]', '_', sysconfig.get_platform())}"


def cmake(*arguments):
    subprocess.run(["cmake", *map(str, arguments)], check=True, cwd=ROOT)


def files_of(build, staging):
    """Pairs of a path in the wheel and a file."""
    cmake("--install", build, "--component", "python", "--prefix", staging, "--strip")
    for module in pathlib.Path(staging).rglob("candelabra"):
        for file in sorted(module.iterdir()):
            yield f"candelabra/{file.name}", file
    for file in sorted(build.glob("libcandelabra_*.so")):
        yield f"candelabra/{file.name}", file
    for file in sorted((ROOT / "stdlib").rglob("*")):
        if file.is_file():
            yield f"candelabra/stdlib/{file.relative_to(ROOT / 'stdlib')}", file


# What every system has: the C library and that of C++ (Debian's own apt needs it).
OF_ANY_SYSTEM = re.compile(r"(lib(c|m|dl|rt|pthread|resolv|stdc\+\+|gcc_s)|ld-linux.*)\.so.*")


def libraries_of(file):
    """Paths of the libraries that a file needs, and that these need."""
    told = subprocess.run(["ldd", file], check=True, capture_output=True, text=True).stdout
    return [pathlib.Path(path) for path in re.findall(r"=> (/\S+)", told)
            if not OF_ANY_SYSTEM.fullmatch(pathlib.Path(path).name)]


def licence_of(library):
    """The package of a library and the text of its licence."""
    path = os.path.realpath(library)
    for name in (path, path.removeprefix("/usr"), str(library)):
        found = subprocess.run(["dpkg-query", "--search", name], capture_output=True, text=True)
        owners = [line for line in found.stdout.splitlines() if not line.startswith("diversion by ")]
        if owners:
            package = owners[0].split(":")[0]
            return package, pathlib.Path("/usr/share/doc", package, "copyright").read_bytes()
    raise SystemExit(f"no package has {library}, so its licence is not known")


def carried(files, folder):
    """The files with the libraries that they need, each of which looks for others beside it, and their licences."""
    made, licences = {}, {}
    for path, file in files:
        if pathlib.Path(path).name == "libcandelabra_oiio.so":
            continue
        if not path.endswith(".so"):
            made[path] = file
            continue
        for source in [file, *libraries_of(file)]:
            target = pathlib.Path(folder) / (file.name if source == file else source.name)
            if target.exists():
                continue
            shutil.copy(source, target)
            target.chmod(0o755)
            subprocess.run(["patchelf", "--set-rpath", "$ORIGIN", target], check=True)
            made[f"candelabra/{target.name}"] = target
            if source != file:
                package, text = licence_of(source)
                licences[f"candelabra/licences/{package}"] = text
    return made, licences


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    chosen = (config_settings or {}).get("build-dir") or os.environ.get("CANDELABRA_BUILD")
    build = pathlib.Path(chosen).resolve() if chosen else ROOT / "build" / "wheel"
    if not (build / "CMakeCache.txt").exists():
        cmake("-S", ROOT, "-B", build, "-DCANDELABRA_TESTS=OFF", "-DCANDELABRA_PYTHON=ON",
              f"-DPython3_EXECUTABLE={sys.executable}")
    cmake("--build", build, "--target", "python_package", "--parallel")
    name = f"candelabra-{version()}"
    info = f"{name}.dist-info"
    records = []
    wheel = f"{name}-{tag()}.whl"
    with tempfile.TemporaryDirectory() as staging, tempfile.TemporaryDirectory() as found, \
            zipfile.ZipFile(pathlib.Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        def add(path, content):
            archive.writestr(path, content)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            records.append(f"{path},sha256={digest},{len(content)}\n")

        files, licences = dict(files_of(build, staging)), {}
        if (config_settings or {}).get("carry-libraries"):
            files, licences = carried(files.items(), found)
        for path, file in files.items():
            add(path, file.read_bytes())
        for path, text in licences.items():
            add(path, text)
        add(f"{info}/METADATA", metadata().encode())
        add(f"{info}/WHEEL", f"Wheel-Version: 1.0\nGenerator: candelabra\nRoot-Is-Purelib: false\nTag: {tag()}\n"
            .encode())
        archive.writestr(f"{info}/RECORD", "".join(records) + f"{info}/RECORD,,\n")
    return wheel
