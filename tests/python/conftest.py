# SPDX-License-Identifier: BSD-3-Clause
from pathlib import Path

import matplotlib
import pytest

matplotlib.use("Agg")

import gaitwright as gw  # noqa: E402

ROBOTS = Path(__file__).resolve().parents[2] / "robots"


@pytest.fixture(scope="session")
def a1():
    return gw.load_robot("a1")


@pytest.fixture(scope="session")
def nao():
    return gw.load_robot("nao")


@pytest.fixture(scope="session")
def trot(a1):
    return gw.plan_walk(a1, gait="trot", speed=0.3, distance=0.5)


@pytest.fixture(scope="session")
def playback(trot):
    return gw.play(trot)
