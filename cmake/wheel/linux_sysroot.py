#!/usr/bin/env python3
"""An older C library to link the Linux wheel with, so that it loads on more systems than those as new as this machine.

    linux_sysroot.py FOLDER

Debian 11's C and C++ libraries (glibc 2.31), and from Debian 12, whose other libraries need no newer ones, the rest, are unpacked
into FOLDER, not installed. The compiler is this machine's: what its C++ library has beyond Debian 11's (from_chars of floating-point
numbers) is linked statically. The archive is as in linux_sdk.py. The output is the file for CMAKE_TOOLCHAIN_FILE. A complete FOLDER
is left as it is.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from debian_archive import Archive, Unreachable  # noqa: E402

PACKAGES = {
    "bullseye": "libc6 libc6-dev linux-libc-dev libcrypt1 libcrypt-dev libgcc-s1 libstdc++6",
    "bookworm": "libgmp10 libgmpxx4ldbl libgmp-dev libmpfr6 libmpfr-dev libisal2 libisal-dev libbz2-1.0 libbz2-dev zlib1g zlib1g-dev "
                "libcgal-dev libeigen3-dev gemmi-dev tao-pegtl-dev nlohmann-json3-dev libboost-dev libboost1.74-dev"}


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1]).resolve()
    root, toolchain = folder / "root", folder / "toolchain.cmake"
    if not toolchain.exists():
        shutil.rmtree(folder, ignore_errors=True)
        root.mkdir(parents=True)
        try:
            for suite, names in PACKAGES.items():
                with tempfile.TemporaryDirectory() as work:
                    archive = Archive(suite, pathlib.Path(work))
                    archive.update()
                    archive.unpack(names.split(), root)
        except Unreachable as reason:
            sys.exit(f"There is no C library of Debian 11. {reason}")
        for link in root.rglob("*.so*"):
            if link.is_symlink() and os.readlink(link).startswith("/"):
                target = root / os.readlink(link)[1:]
                link.unlink()
                link.symlink_to(os.path.relpath(target, link.parent))
        # Debian's Python keeps a part of its headers there.
        for headers in pathlib.Path("/usr/include").glob("*-linux-gnu/python3.*"):
            (root / str(headers)[1:]).symlink_to(headers)
        (shared,) = root.glob("usr/lib/*-linux-gnu/libstdc++.so.6")
        (support,) = root.rglob("libgcc_s.so.1")
        static = subprocess.run(["g++", "-print-file-name=libstdc++.a"], capture_output=True, text=True, check=True).stdout.strip()
        (folder / "first").mkdir()
        # What is linked statically reads this variable of glibc 2.32, which says whether it may do without atomic operations.
        subprocess.run(["gcc", "-x", "c", "-c", "-fPIC", "-o", folder / "first/threads.o", "-"], text=True, check=True,
                       input='__attribute__((visibility("hidden"))) char __libc_single_threaded;\n')
        (folder / "first/libstdc++.so").write_text(f"INPUT({shared} {static} {folder}/first/threads.o)\n")
        (folder / "first/libgcc_s.so").write_text(f"GROUP({support} -lgcc)\n")
        # The compiler would look in this machine's folders before it looks in those of CMAKE_SYSROOT. The shared library comes first
        # and in any case, or what other libraries need of it would be taken from the static one.
        flags = (f"-L{folder}/first -B{shared.parent} -Wl,--exclude-libs,libstdc++.a "
                 f"-Wl,--push-state,--no-as-needed,{shared},--pop-state")
        toolchain.write_text(f'set(CMAKE_SYSROOT "{root}")\nset(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)\n' + "".join(
            f'set(CMAKE_{kind}_LINKER_FLAGS_INIT "{flags}")\n' for kind in ("EXE", "SHARED", "MODULE")))
    print(toolchain)


if __name__ == "__main__":
    main()
