# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by a freecadcmd of its own, see tools/install_check.py: the Addon Manager installs or removes.

BALLOON_TASK names a JSON file: "do" is install or remove, "from" the zip file of the branch "branch".
"""

import json
import os
import sys
from pathlib import Path

import FreeCAD as App

sys.path.append(str(Path(App.getResourceDir()) / "Mod" / "AddonManager"))

task = json.loads(Path(os.environ["BALLOON_TASK"]).read_text(encoding="utf-8"))
from Addon import Addon  # noqa: E402

addon = Addon("BalloonWorkbench", task["from"], Addon.Status.NOT_INSTALLED, task["branch"])
if task["do"] == "install":
    from addonmanager_installer import AddonInstaller

    done = AddonInstaller(addon).run()
else:
    from addonmanager_uninstaller import AddonUninstaller

    done = AddonUninstaller(addon).run()
Path(os.environ["BALLOON_TASK"]).with_name("seen.json").write_text(json.dumps({"done": bool(done)}))
sys.stdout.flush()
os._exit(0)
