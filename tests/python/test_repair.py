# SPDX-License-Identifier: BSD-3-Clause
import json

import gaitwright as gw
import numpy as np
import pytest


def frames_of(plan, rate_hz=50.0, lift_m=0.0):
    """A plan as arrays, lifted by some height."""
    time_s = np.arange(plan.time_s[0], plan.time_s[-1], 1.0 / rate_hz)
    q = np.column_stack([np.interp(time_s, plan.time_s, column) for column in plan.q.T])
    q[:, 2] += lift_m
    return {
        "fps": rate_hz,
        "root_pos": q[:, :3],
        "root_rot": q[:, 3:7],
        "dof_pos": q[:, 7:],
        "joint_names": list(plan.robot.joints),
    }


def test_arrays_that_float_become_a_sound_plan(a1, trot):
    motion = frames_of(trot, lift_m=0.02)
    repaired = gw.repair(a1, motion)
    assert repaired.passed and bool(repaired) and not repaired.kept
    assert repaired.before is not None and not repaired.before.passed
    assert repaired.audit.passed and gw.audit(repaired.plan).passed
    assert any("lifted: the base was moved down by" in change for change in repaired.changes), repaired.changes
    assert json.loads(repaired.to_json())["verdict"] == "pass"
    assert "after: audit: pass" in str(repaired)
    groups = repaired.distance["groups"]
    assert set(groups) == {"legs", "base", "feet"}
    assert groups["legs"]["unit"] == "rad" and 0 < groups["legs"]["rms"] <= groups["legs"]["largest"]
    assert groups["base"]["rms"] == pytest.approx(0.02, abs=0.01) == repaired.distance["base_rms_m"]

    frames = repaired.frames(50.0)
    assert frames["dof_pos"].shape[1] == a1.num_joints == len(frames["joint_names"])
    order = [motion["joint_names"].index(name) for name in frames["joint_names"]]
    rows = min(len(frames["dof_pos"]), len(motion["dof_pos"]))
    off = frames["dof_pos"][:rows] - motion["dof_pos"][:rows, order]
    assert np.sqrt(np.mean(off**2)) < 0.1
    assert np.mean(frames["root_pos"][:rows, 2] - motion["root_pos"][:rows, 2]) == pytest.approx(-0.02, abs=0.01)


def test_what_comes_out_goes_in_again(a1, trot):
    first = gw.repair(a1, frames_of(trot, lift_m=0.01), play=False)
    again = gw.repair(a1, first.frames(100.0), play=False)
    assert first.passed and again.passed
    rows = slice(0, 100)
    assert np.abs(again.frames(50.0)["dof_pos"][rows] - first.frames(50.0)["dof_pos"][rows]).mean() < 0.01


def test_a_file_is_taken_like_arrays(a1, trot, tmp_path):
    motion = frames_of(trot, lift_m=0.02)
    np.savez_compressed(tmp_path / "motion.npz", **motion)
    of_file = gw.repair(a1, tmp_path / "motion.npz", play=False)
    of_arrays = gw.repair(a1, motion, play=False)
    assert np.array_equal(of_file.plan.q, of_arrays.plan.q)


def test_wrong_arrays_say_what_is_wrong(a1, trot):
    motion = frames_of(trot)
    del motion["root_rot"]
    with pytest.raises(gw.BadInputError, match="array 'root_rot' is missing"):
        gw.repair(a1, motion)
    motion = frames_of(trot)
    motion["dof_pos"] = motion["dof_pos"][:, :5]
    with pytest.raises(gw.BadInputError, match="array 'dof_pos' has shape"):
        gw.repair(a1, motion)
    with pytest.raises(gw.BadInputError, match="stretch"):
        gw.repair(a1, frames_of(trot), stretch=0.5)


def test_weights_keep_what_matters_nearer(a1, trot, tmp_path):
    motion = frames_of(trot, lift_m=0.02)
    usual = gw.repair(a1, motion, play=False)
    legs = gw.repair(a1, motion, weights={"always": {"legs": 100.0}}, play=False)
    assert legs.passed
    assert legs.distance["groups"]["legs"]["rms"] < usual.distance["groups"]["legs"]["rms"]
    (tmp_path / "weights.yaml").write_text('{"always": {"legs": 100.0}}')
    of_file = gw.repair(a1, motion, weights=tmp_path / "weights.yaml", play=False)
    assert np.array_equal(of_file.plan.q, legs.plan.q)
    with pytest.raises(gw.BadInputError, match="wings"):
        gw.repair(a1, motion, weights={"always": {"wings": 2.0}})
