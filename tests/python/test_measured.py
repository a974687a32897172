# SPDX-License-Identifier: BSD-3-Clause
"""Measurements of a playback, compared with the state, the forces and the score."""

import gaitwright as gw
import numpy as np
import pytest

GRAVITY_M_S2 = 9.81


def test_balance_follows_from_state_and_forces(playback):
    """The formulas of the linear inverted pendulum, on flat ground."""
    rows = len(playback.time_s)
    assert playback.feet_m.shape == (rows, 4, 3)
    for k in range(0, rows, 50):
        state = gw.RobotState(playback.plan.robot, playback.q[k], playback.v[k])
        centre = state.centre_of_mass
        velocity = state.momentum[:3] / playback.plan.robot.mass_kg
        assert playback.centre_of_mass_m[k] == pytest.approx(centre, abs=1e-12)
        assert playback.centre_of_mass_velocity_m_s[k] == pytest.approx(velocity, abs=1e-12)
        assert playback.dcm_m[k] == pytest.approx(centre[:2] + velocity[:2] * np.sqrt(centre[2] / GRAVITY_M_S2), abs=1e-3)
        for i, foot in enumerate(playback.plan.robot.feet):
            assert playback.feet_m[k, i] == pytest.approx(state.contact_frame(foot)[:3, 3], abs=1e-12)


def test_the_zmp_is_the_centre_of_pressure_of_the_feet(trot):
    """Point feet on flat ground, without the low-pass filter: the mean of the feet, weighted by their normal forces."""
    raw = gw.play(trot, options={"score.zmp_filter_s": 0.0})
    normal = raw.forces_n[:, :, 2]
    pressed = (normal[:, :, None] * raw.feet_m[:, :, :2]).sum(axis=1) / normal.sum(axis=1)[:, None]
    assert np.abs(raw.zmp_m - pressed).max() < 2e-3
    assert np.abs(raw.zmp_m - gw.play(trot).zmp_m).max() > 0.01, "the score's options are the series' own"


def test_margins_are_those_of_the_score(playback):
    margins = playback.zmp_margin_m
    assert not np.isnan(margins).any()
    assert margins.min() == pytest.approx(playback.metrics["zmp_margin_min_m"].value, abs=1e-12)
    corners, zmp = playback.support(0), playback.zmp_m[0]
    along = np.roll(corners, -1, axis=0) - corners
    inward = np.stack([-along[:, 1], along[:, 0]], axis=1) / np.linalg.norm(along, axis=1)[:, None]
    assert corners.shape == (4, 2)
    assert margins[0] == pytest.approx(((zmp - corners) * inward).sum(axis=1).min(), abs=1e-12)
    assert np.array_equal(playback.support(-1), playback.support(len(margins) - 1))
    with pytest.raises(IndexError):
        playback.support(len(margins))


def test_stances_are_when_feet_touch(playback):
    assert playback.contact.shape == (len(playback.time_s), 4)
    feet = playback.plan.robot.feet
    for stance in playback.stances:
        inside = (playback.time_s > stance["touchdown_s"] + 0.005) & (playback.time_s < stance["liftoff_s"] - 0.005)
        assert playback.contact[inside, feet.index(stance["foot"])].all()
        assert stance["slip_m"] >= 0.0
        assert stance["friction_use_max"] <= 1.0 + 1e-6
    assert playback.body_contacts == []


def test_without_ground_under_it_there_is_no_zmp(a1):
    jump = gw.play(gw.plan_walk(a1, gait="bound", speed=0.5, distance=0.4))
    flight = ~jump.contact.any(axis=1)
    assert flight.any()
    assert np.isnan(jump.zmp_m[np.linalg.norm(jump.forces_n, axis=2).sum(axis=1) == 0.0]).all()
    assert np.isnan(jump.zmp_margin_m).any()


def test_a_fall_is_told_by_what_touches(trot):
    fallen = gw.play(trot, push=(0.0, 900.0, 0.0, 0.5, 0.2))
    assert not fallen.passed
    assert fallen.body_contacts
    time_s, link = fallen.body_contacts[0]
    assert 0.5 < time_s
    assert link in trot.robot.links


def test_a_playback_that_breaks_off_at_once_has_its_report(trot):
    class Wild(gw.Controller):
        def update(self, now):
            wild = np.full(trot.robot.num_joints, 1e308)
            return gw.JointCommand(wild, wild, wild, wild, wild)

    broken = gw.play(trot, Wild())
    assert not broken.passed
    assert "not finite" in broken.reason
    assert len(broken.report_html()) < 5_000_000
    assert np.isfinite(broken.q).all()
