#!/usr/bin/env python3
"""An SDK for the Linux wheel of VTK: what find_package(VTK) needs to build against the installed `vtk`.

    linux_sdk.py FOLDER

PyPI has Kitware's vtk-sdk of this version for macOS only. Headers, hierarchy files and CMake package of that
file fit Linux as well, since all wheels of a version are configured alike; they are unpacked into FOLDER and
their libraries redirected to those of the `vtk` package of the Python that runs this script. Nothing of VTK
is compiled. The wrapping tools of the SDK are programs of macOS; those of an installed VTK or ParaView take
their place (ISTHMUS_WRAP_TOOLS: their folder), else those of Debian 12's paraview package, which is
downloaded and unpacked, not installed. The archive is that of the machine's apt configuration, or ISTHMUS_MIRROR.

The last line of the output is the folder for VTK_DIR. A complete FOLDER is left as it is.
"""
import hashlib
import importlib.metadata
import importlib.util
import lzma
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import textwrap
import urllib.request
import zipfile

ARCHIVE_SCRIPT = pathlib.Path(__file__).resolve().parents[1] / "archive.sh"
KEYRING = pathlib.Path("/usr/share/keyrings/debian-archive-keyring.gpg")
TOOLS_SUITE, TOOLS_PACKAGE = "bookworm", "paraview"
TOOLS = ("vtkWrapHierarchy", "vtkWrapPython", "vtkWrapPythonInit")
# Files of the SDK that fit: the processor decides about vtkMathConfigure.h.
PLATFORMS = {"x86_64": "macosx_10_9_x86_64", "aarch64": "macosx_11_0_arm64"}
DEBIAN_PROCESSORS = {"x86_64": "amd64", "aarch64": "arm64"}


def run(*command, **options):
    return subprocess.run(command, check=True, **options)


def vtk_of_this_python():
    """Version of the installed vtk, and the folder of its libraries."""
    try:
        version = importlib.metadata.version("vtk")
    except importlib.metadata.PackageNotFoundError:
        sys.exit(f"linux_sdk.py: {sys.executable} has no vtk: install the version that pyproject.toml pins.")
    # Located, not imported: an import would load modules that a build does not need.
    modules = importlib.util.find_spec("vtkmodules")
    return version, pathlib.Path(modules.origin).parent


def unpack_sdk(version, work, folder):
    """Headers, hierarchy files and CMake package of the SDK, in FOLDER/vtk-VERSION.data/headers."""
    run(sys.executable, "-m", "pip", "download", "--quiet", "--disable-pip-version-check", "--no-deps",
        "--only-binary", ":all:", "--implementation", "cp", "--python-version", "3.10", "--platform",
        PLATFORMS.get(platform.machine(), PLATFORMS["x86_64"]), "--dest", str(work), f"vtk-sdk=={version}")
    (wheel,) = work.glob("vtk_sdk-*.whl")
    prefix = "vtk_sdk/content/"
    with zipfile.ZipFile(wheel) as archive:
        for name in archive.namelist():
            if name.startswith(f"{prefix}vtk-{version}.data/headers/") and not name.endswith("/"):
                target = folder / name[len(prefix):]
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(archive.read(name))
    (cmake,) = folder.glob("vtk-*.data/headers/cmake")
    return cmake


def edit(path, *replacements):
    """Regular expressions with what replaces each; one that is not found is an error."""
    text = path.read_text()
    for pattern, replacement in replacements:
        text, count = re.subn(pattern, replacement, text, flags=re.MULTILINE)
        if not count:
            sys.exit(f"linux_sdk.py: {path.name} has no {pattern!r}: this SDK is of another form.")
    path.write_text(text)


def redirect_libraries(cmake, libraries):
    """The targets of the CMake package are the files of the installed wheel."""
    this_python = f"{sys.version_info.major}.{sys.version_info.minor}"
    lib = libraries.as_posix()
    # Files are not checked: there are less of them on Linux, by modules that only macOS has.
    unchecked = (r"^list\(APPEND _(?:cmake_import|IMPORT)_(?:check|CHECK)_.*$", "")
    for targets in (cmake / "VTK-targets-release.cmake", *cmake.glob("viskores/*argets-release.cmake")):
        edit(targets,
             (r"\$\{_IMPORT_PREFIX\}/build/lib\.macosx-[^\"/]*/vtkmodules/\.dylibs", lib),
             (r"@rpath/", ""),
             (r"(lib[\w.-]+)\.dylib", r"\1.so"),
             unchecked)
    edit(cmake / "VTK-targets-release.cmake",
         (r"(libvtkWrappingPythonCore)3\.\d+", rf"\g<1>{this_python}"))
    edit(cmake / "VTKPython-targets-release.cmake",
         (r"\$\{_IMPORT_PREFIX\}/\./vtkmodules", lib),
         (r"\.cpython-310-darwin\.so", sysconfig.get_config_var("EXT_SUFFIX")),
         unchecked)
    edit(cmake / "VTK-targets.cmake", (r";-framework Cocoa", ""))
    edit(cmake / "VTK-vtk-module-find-packages.cmake", (r"^ *3\.10$", f"    {this_python}"))


def match_binary(cmake, headers, libraries):
    """Compiled code must agree with the libraries in details that the headers do not define, or define for macOS."""
    core = (libraries / "libvtkCommonCore.so").read_bytes()
    # manylinux2014 is compiled with the C++ library's strings of before 2011.
    new_strings = b"__cxx11" in core
    with (cmake / "vtk-config.cmake").open("a") as config:
        config.write(textwrap.dedent(f"""
            # As the libraries of the vtk wheel are compiled.
            add_compile_definitions(_GLIBCXX_USE_CXX11_ABI={int(new_strings)})
            """))
    # The backends of threads decide about the size of an object.
    smp = (headers / "vtkSMP.h").read_text()
    for number, backend in enumerate(("SEQUENTIAL", "STDTHREAD", "TBB", "OPENMP")):
        built = f"vtkSMPToolsImplILNS1_11BackendTypeE{number}EE10Initialize".encode() in core
        if built != bool(re.search(rf"define VTK_SMP_ENABLE_{backend} 1", smp)):
            sys.exit(f"linux_sdk.py: vtkSMP.h and libvtkCommonCore.so disagree about {backend}.")


def checked_download(address, path, sha256):
    urllib.request.urlretrieve(address, path)
    if hashlib.sha256(path.read_bytes()).hexdigest() != sha256:
        sys.exit(f"linux_sdk.py: the SHA-256 of {address} is not the one that the archive states; try again.")


def download_tools(work, folder):
    """Debian's wrapping tools, unpacked."""
    asked = subprocess.run(["bash", "-c", 'source "$0" && archive_address', str(ARCHIVE_SCRIPT)],
                           capture_output=True, text=True)
    if asked.returncode:
        sys.exit(f"linux_sdk.py: {asked.stderr.strip()} ISTHMUS_WRAP_TOOLS=FOLDER names installed tools instead.")
    archive = asked.stdout.strip()
    suite = f"{archive}/dists/{TOOLS_SUITE}"
    release, signature = work / "Release", work / "Release.gpg"
    urllib.request.urlretrieve(f"{suite}/Release", release)
    # Each file is checked against the one that lists it, and the first by its signature, otherwise by TLS.
    if shutil.which("gpgv") and KEYRING.exists():
        urllib.request.urlretrieve(f"{suite}/Release.gpg", signature)
        run("gpgv", "--quiet", "--keyring", str(KEYRING), str(signature), str(release))
    elif not archive.startswith(("https:", "file:")):
        sys.exit(f"linux_sdk.py: the signature of {suite}/Release cannot be verified: install gpgv and "
                 "debian-archive-keyring, or set ISTHMUS_MIRROR to an address with https.")
    packages = f"main/binary-{DEBIAN_PROCESSORS[platform.machine()]}/Packages.xz"
    listed = re.search(rf"^SHA256:\n(?: .+\n)*? (\w+) +\d+ {packages}$", release.read_text(), re.MULTILINE)[1]
    index, deb = work / "Packages.xz", work / "tools.deb"
    checked_download(f"{suite}/{packages}", index, listed)
    entry = re.search(rf"^Package: {TOOLS_PACKAGE}\n(?:.+\n)*", lzma.open(index, "rt").read(), re.MULTILINE)[0]
    checked_download(f"{archive}/{re.search('^Filename: (.+)$', entry, re.MULTILINE)[1]}", deb,
                     re.search("^SHA256: (.+)$", entry, re.MULTILINE)[1])
    unpacked = work / "tools"
    unpacked.mkdir()
    # A .deb is an archive of `ar`, of which every compiler's tools have one.
    run("ar", "x", str(deb), cwd=unpacked)
    (data,) = unpacked.glob("data.tar*")
    run("tar", "xf", data.name, cwd=unpacked)
    kept = folder / "tools"
    kept.mkdir(exist_ok=True)
    for path in [*unpacked.glob("usr/bin/vtkWrap*"), *unpacked.glob("usr/lib/*/libvtkWrappingTools*")]:
        shutil.copy(path, kept, follow_symlinks=True)
    return kept


def find_tools(work, folder):
    """Folder and version suffix (-pv5.11, -9.1) of programs that wrap classes."""
    given = os.environ.get("ISTHMUS_WRAP_TOOLS")
    for place in [given] if given else os.environ.get("PATH", "").split(os.pathsep) + ["/usr/bin"]:
        for tool in sorted(pathlib.Path(place).glob("vtkWrapPython*")):
            suffix = tool.name[len("vtkWrapPython"):]
            if re.fullmatch(r"-pv5\.1[0-9]|-9\.[1-4]|", suffix) and all(
                    (tool.parent / f"{name}{suffix}").exists() for name in TOOLS):
                return tool.parent, suffix
    if given:
        sys.exit(f"linux_sdk.py: no wrapping tools of VTK 9.1 to 9.4 in ISTHMUS_WRAP_TOOLS ({given}).")
    kept = download_tools(work, folder)
    (tool,) = [path for path in kept.glob("vtkWrapPython-*")]
    return kept, tool.name[len("vtkWrapPython"):]


def install_tools(work, folder, headers):
    """The tools by the names of the SDK. They are of an older VTK than the headers."""
    place, suffix = find_tools(work, folder)
    programs = folder / "bin"
    programs.mkdir(exist_ok=True)
    start = "#!/usr/bin/env bash\nset -e\n"
    if place == folder / "tools":
        start += f"export LD_LIBRARY_PATH={place}${{LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}}\n"
    # Without -MF, which older tools do not support: CMake gets an empty list of dependencies.
    wrap = textwrap.dedent("""\
        arguments=()
        while [ $# -gt 0 ]; do
          if [ "$1" = -MF ]; then : >"$2"; shift 2; continue; fi
          arguments+=("$1"); shift
        done
        exec {tool} "${{arguments[@]}}"
        """)
    # Older tools write the initialisation of a module as two files.
    initialise = textwrap.dedent("""\
        {tool} "$1" "$2.init" "$2.body"
        cat "$2.init" "$2.body" >"$2"
        rm "$2.init" "$2.body"
        """)
    for name in TOOLS:
        program = programs / name
        body = initialise if name == "vtkWrapPythonInit" else wrap
        program.write_text(start + body.format(tool=f"{place}/{name}{suffix}"))
        program.chmod(0o755)
    # Attributes that they do not support.
    edit(headers / "vtkWrappingHints.h",
         (r"^#define (VTK_UNBLOCKTHREADS|VTK_MARSHAL\w+(?:\(\w+\))?) \[\[.*$", r"#define \1"))
    # Python 2 names in their output, which later headers of VTK no longer define.
    with (headers / "vtkPythonCompatibility.h").open("a") as header:
        header.write("\n#ifndef PyInt_Type\n#define PyInt_Type PyLong_Type\n#define PyIntObject PyLongObject\n#endif\n")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    if sys.platform != "linux":
        sys.exit("linux_sdk.py: elsewhere than on Linux, vtk-sdk itself is the SDK.")
    folder = pathlib.Path(sys.argv[1]).resolve()
    version, libraries = vtk_of_this_python()
    done = folder / "complete.txt"
    made_for = f"vtk {version} in {libraries}, Python {sysconfig.get_config_var('EXT_SUFFIX')}\n"
    if not (done.exists() and done.read_text() == made_for):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        with tempfile.TemporaryDirectory() as work:
            work = pathlib.Path(work)
            cmake = unpack_sdk(version, work, folder)
            (headers,) = cmake.parent.glob("vtk-*.*")
            redirect_libraries(cmake, libraries)
            match_binary(cmake, headers, libraries)
            install_tools(work, folder, headers)
        done.write_text(made_for)
    (cmake,) = folder.glob("vtk-*.data/headers/cmake")
    print(cmake)


if __name__ == "__main__":
    main()
