#!/usr/bin/env python3
"""The recipes of a release, as they are submitted.

    fill.py isthmus-VERSION.tar.gz OWNER FOLDER    writes recipe.yaml (conda-forge), and isthmus.cmake with the lines for
                                                   versions.cmake (ParaView's superbuild) into FOLDER

The tarball is the one that is attached to the release vVERSION of OWNER's repository: the hashes are those of this file.
"""
import hashlib
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    tarball, owner, folder = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3])
    recipe = (HERE / "conda-forge.yaml").read_text().replace("ISTHMUS_OWNER", owner)
    version = re.search(r'^  version: "(.*)"$', recipe, re.MULTILINE)[1]
    if tarball.name != f"isthmus-{version}.tar.gz":
        sys.exit(f"{tarball.name} is not the tarball of version {version}, which conda-forge.yaml has.")
    content = tarball.read_bytes()
    address = re.search(r"url: (\S+\$.*)", recipe)[1].replace("${{ version }}", version)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "recipe.yaml").write_text(
        re.sub(r'sha256: "0+"', f'sha256: "{hashlib.sha256(content).hexdigest()}"', recipe))
    (folder / "isthmus.cmake").write_text((HERE / "superbuild.cmake").read_text())
    (folder / "versions.cmake").write_text(
        f'superbuild_set_revision(isthmus\n  URL     "{address}"\n  URL_MD5 {hashlib.md5(content).hexdigest()})\n')


if __name__ == "__main__":
    main()
