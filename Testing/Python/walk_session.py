"""Writes the names of the pipeline's sources, whenever they change, for WalkWindow.py."""

import os
from pathlib import Path

from paraview import servermanager

folder = Path(os.environ["ISTHMUS_SESSION_DIR"])
proxies = servermanager.ProxyManager().SMProxyManager


def write(*_):
    names = [proxies.GetProxyName("sources", i) for i in range(proxies.GetNumberOfProxies("sources"))]
    (folder / "sources.tmp").write_text("\n".join(
        f"{proxies.GetProxy('sources', name).GetXMLName()}\t{name}" for name in names))
    (folder / "sources.tmp").rename(folder / "sources.txt")


for event in ("RegisterEvent", "UnRegisterEvent"):
    proxies.AddObserver(event, write)
write()
