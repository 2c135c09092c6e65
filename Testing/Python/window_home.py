"""A home folder for one run of the real ParaView. For window tests."""

import shutil

from paraview import servermanager


def prepare(folder):
    """Makes `folder` new, so that no setting of the user's counts and no welcome dialog shows."""
    shutil.rmtree(folder, ignore_errors=True)
    settings = folder / ".config" / "ParaView"
    settings.mkdir(parents=True)
    folder.chmod(0o700)
    version = servermanager.vtkSMProxyManager.GetParaViewSourceVersion().split()[-1]
    for name in (f"ParaView{version}.ini", "ParaView.ini"):  # up to ParaView 5.13; of 6.1
        (settings / name).write_text("[General]\nGeneralSettings.ShowWelcomeDialog=false\n")
