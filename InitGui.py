# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD runs this when its window opens: registers the EdgeScan workbench."""

import FreeCADGui


class EdgeScanWorkbench(FreeCADGui.Workbench):
    """Edges of scanned point clouds; what it needs is imported when it is first opened."""

    MenuText = "EdgeScan"
    ToolTip = "Find the true sharp edges of a scanned point cloud"

    def __init__(self):
        # FreeCAD executes this file without a name of its own: the package knows where we are.
        from pathlib import Path

        import freecad_edgescan

        folder = Path(freecad_edgescan.__file__).resolve().parents[1]
        self.__class__.Icon = str(folder / "icons" / "EdgeScan_Workbench.svg")

    def Initialize(self):
        from freecad_edgescan.gui import commands, preferences
        from freecad_edgescan.gui.translation import learn_languages

        learn_languages()
        commands.register()
        for title, names in commands.TOOLBARS.items():
            self.appendToolbar(title, names)
        self.appendMenu("EdgeScan", commands.menu())
        preferences.add_page()

    def ContextMenu(self, recipient):
        from freecad_edgescan.gui.commands import for_selection

        names = for_selection()
        if names:
            self.appendContextMenu("EdgeScan", names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


def _watch_documents():
    # Edges in files written without a screen are dressed as soon as a file is opened, whichever
    # workbench is active.
    from freecad_edgescan.gui.view_provider_observer import start_watching

    start_watching()


FreeCADGui.addWorkbench(EdgeScanWorkbench())
_watch_documents()
