# SPDX-License-Identifier: BSD-3-Clause
"""Where robots and gaits are that a wheel brings along; elsewhere the core knows them itself."""

import os
from pathlib import Path

_DATA = Path(__file__).resolve().parent / "data"
if _DATA.is_dir():
    os.environ.setdefault("GAITWRIGHT_ROBOTS", str(_DATA / "robots"))
    os.environ.setdefault("GAITWRIGHT_GAITS", str(_DATA / "gaits.yaml"))
