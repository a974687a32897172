# SPDX-License-Identifier: BSD-3-Clause
"""Plans and playbacks as values: copied, pickled and shown; single trials are repeated."""

import copy
import pickle

import gaitwright as gw
import matplotlib
import numpy as np
import pytest
from matplotlib import pyplot


def test_plans_and_playbacks_are_pickled(trot, playback):
    plan = pickle.loads(pickle.dumps(trot))
    assert plan.hash == trot.hash
    again = pickle.loads(pickle.dumps(playback))
    assert np.array_equal(again.q, playback.q)
    assert again.score == playback.score
    assert copy.deepcopy(trot).hash == trot.hash


def test_a_trial_is_played_again_by_its_seed(trot):
    for disturbances in ("standard", {"friction": {"uniform": [0.4, 0.6]}}, "friction: {uniform: [0.4, 0.6]}"):
        report = gw.trials(trot, 3, disturbances=disturbances, seed=5)
        alone = gw.play_trial(trot, report.seeds[1], disturbances=disturbances)
        assert alone.score == report.scores[1]
        assert alone.metrics["zmp_margin_min_m"].value == report.column("zmp_margin_min_m")[1]


def test_columns_of_trials_are_listed(trot):
    report = gw.trials(trot, 2)
    assert {"friction", "zmp_margin_min_m"} <= set(report.columns)
    assert all(len(report.column(name)) == 2 for name in report.columns)
    with pytest.raises(ValueError, match="'friction'"):
        report.column("fricton")


def test_options_take_what_numpy_has_and_sets_of_sensors(trot):
    plain = gw.play(trot, options={"play.joint_losses": np.bool_(False), "play.friction": np.float32(0.5)})
    assert plain.passed
    hobby = gw.play(trot, options={"state": "estimated", "sensors": "hobby"})
    good = gw.play(trot, options={"state": "estimated", "sensors": "good"})
    assert not np.array_equal(hobby.q, good.q)
    with pytest.raises(gw.BadInputError, match="'hobby'"):
        gw.play(trot, options={"sensors": "hoby"})


def test_paths_and_names_of_grounds_are_taken_everywhere(a1, trot, tmp_path):
    path = tmp_path / "plan.json"
    trot.save(path)
    assert gw.load_plan(path).hash == trot.hash
    trot.export(tmp_path / "motion.csv")
    assert gw.import_motion(a1, tmp_path / "motion.csv", terrain=gw.flat_terrain()).duration_s > 1.0
    assert gw.World(a1, "flat").time_s == 0.0


def test_a_plan_is_shown_in_3d(trot):
    assert "<canvas" in gw.show(trot).text or "gw-viewer" in gw.show(trot).text
    with pytest.raises(TypeError, match="Robot"):
        gw.show(trot.robot)


def test_plots_leave_nothing_open(trot):
    assert matplotlib.get_backend().lower() == "agg"
    before = pyplot.get_fignums()
    gw.plot(trot)
    assert pyplot.get_fignums() == before
