# SPDX-License-Identifier: BSD-3-Clause
import json
import time

import gaitwright as gw
import numpy as np
import pytest


def test_a_plan_is_played_scored_and_plotted_in_few_lines(tmp_path):
    robot = gw.load_robot("a1")
    plan = gw.plan_walk(robot, gait="trot", speed=0.3, distance=0.5)
    assert gw.audit(plan)
    playback = gw.play(plan)
    assert playback.passed, playback.reason
    gw.plot(playback).savefig(tmp_path / "trot.png")
    assert (tmp_path / "trot.png").stat().st_size > 20_000


def test_arrays_are_shared_and_cannot_be_written_to(trot):
    q = trot.q
    assert q.shape == (len(trot.time_s), trot.robot.nq)
    assert trot.v.shape == trot.a.shape == (len(q), trot.robot.nv)
    assert trot.tau.shape == (len(q), trot.robot.num_joints)
    assert trot.forces_n.shape == (len(q), 4, 3)
    assert trot.contact.shape == (len(q), 4)
    assert np.shares_memory(q, trot.q)
    with pytest.raises(ValueError, match="read-only"):
        q[0, 0] = 1.0


def test_arrays_outlive_their_plan(a1):
    q = gw.plan_walk(a1, gait="trot", speed=0.3, distance=0.3).q
    assert np.isfinite(q).all()


def test_the_plan_obeys_its_own_equations(trot):
    """Between rows the base moves with its velocity; the forces balance weight and acceleration."""
    step_s = np.diff(trot.time_s)[:, None]
    moved = np.diff(trot.q[:, :3], axis=0)
    assert np.abs(moved - 0.5 * step_s * (trot.v[1:, :3] + trot.v[:-1, :3])).max() < 1e-5
    for k in range(0, len(trot.q), 40):
        state = gw.RobotState(trot.robot, trot.q[k], trot.v[k])
        wrench = state.inverse_dynamics(trot.a[k])[:3]
        assert wrench == pytest.approx(trot.forces_n[k].sum(axis=0), abs=0.02 * trot.robot.weight_n)


def test_plans_and_logs_go_through_files(trot, playback, tmp_path):
    again = gw.load_plan(trot.save(str(tmp_path / "plan.json")))
    assert again.hash == trot.hash
    assert np.array_equal(again.q, trot.q)
    assert gw.Plan.from_json(trot.to_json()).hash == trot.hash
    log = gw.load_log(playback.save(str(tmp_path / "log.json")), again)
    assert np.array_equal(log.q, playback.q)
    assert log.score == playback.score
    trot.export(str(tmp_path / "motion.csv"))
    imported = gw.import_motion(trot.robot, str(tmp_path / "motion.csv"))
    assert imported.q[-1, :3] == pytest.approx(trot.q[-1, :3], abs=1e-3)


def test_one_cycle_of_a_periodic_walk_is_exported(a1, tmp_path):
    walk = gw.plan_walk(a1, gait="trot", speed=0.8, distance=1.6, options={"trajectory.cycles": "periodic"})
    notes = walk.export(tmp_path / "cycle.json", "frames-json", 60.0, cycle=True)
    assert any("one cycle" in note for note in notes)
    cycle = json.loads((tmp_path / "cycle.json").read_text())
    assert cycle["LoopMode"] == "Wrap"
    assert cycle["Frames"][-1][7:] == pytest.approx(cycle["Frames"][0][7:], abs=2e-6)


def test_a_playback_is_the_same_each_time(trot, playback):
    again = gw.play(trot)
    assert np.array_equal(again.q, playback.q)
    assert again.metrics["goal_error_m"].value == playback.metrics["goal_error_m"].value


def test_a_push_is_felt(trot, playback):
    pushed = gw.play(trot, push=(0.0, 60.0, 0.0, 1.0, 0.1))
    assert np.abs(pushed.v[:, 1]).max() > np.abs(playback.v[:, 1]).max() + 0.05


def test_failures_have_the_programs_words(a1):
    with pytest.raises(gw.BadInputError, match="'galop'|galop"):
        gw.plan_walk(a1, gait="galop")
    with pytest.raises(gw.InfeasibleError) as told:
        gw.plan_walk(a1, gait="crawl", speed=3.0)
    assert told.value.message and told.value.stage
    with pytest.raises(ValueError, match="set the distance"):
        gw.plan_walk(a1, distance=1.0, steps=4)
    with pytest.raises(ValueError, match="swing.height_m|unknown|no option"):
        gw.plan_walk(a1, options={"swing.hight_m": 0.05})
    with pytest.raises(gw.BadInputError):
        gw.load_robot("a2")
    with pytest.raises(TypeError):
        gw.plan_walk("a1")


def test_a_refusal_has_the_law_and_a_speed_that_can_be_planned():
    nao = gw.load_robot("nao")
    with pytest.raises(gw.InfeasibleError) as told:
        gw.plan_walk(nao, speed=1.0, distance=0.3)
    refused = told.value
    assert refused.code in gw.FAILURE_CODES
    assert refused.violation["law"] in gw.AUDIT_LAWS
    assert abs(refused.violation["value"]) > abs(refused.violation["limit"])
    slower = refused.suggestions[0]
    assert slower["what"] == "speed" and slower["certainty"] in ("planned", "estimated")
    assert len(refused.hints) >= len(refused.suggestions)
    planned = gw.plan_walk(nao, speed=slower["value"], distance=0.3)
    assert gw.audit(planned).passed
    for adjustment in planned.adjustments:
        assert adjustment["why"] in gw.FAILURE_CODES and adjustment["asked"] != adjustment["given"]


def test_options_are_those_of_the_program(a1):
    high = gw.plan_walk(a1, gait="trot", speed=0.3, distance=0.3, options={"swing.height_m": 0.09})
    low = gw.plan_walk(a1, gait="trot", speed=0.3, distance=0.3, options={"swing.height_m": 0.04})
    assert high.hash != low.hash
    assert gw.audit(high, options={"derate_torque": 0.02}).violations[0].law == "joint_torque"


def test_the_ground_can_be_made_of_numbers(a1):
    x, y = np.meshgrid(np.arange(-1.0, 3.0, 0.02), np.arange(-1.0, 1.0, 0.02))
    ground = gw.Terrain("waves").with_heights(0.01 * np.sin(4.0 * x), 0.02, x_m=-1.0, y_m=-1.0)
    assert ground.ground_at(0.4, 0.0)["height_m"] == pytest.approx(0.01 * np.sin(1.6), abs=1e-4)
    assert ground.ground_at(9.0, 0.0)["surface"] is None
    assert np.isnan(ground.heights([0.0, 9.0], [0.0])).tolist() == [[False, True]]
    plan = gw.plan_walk(a1, gait="crawl", terrain=ground, distance=0.3)
    assert np.ptp([step["pose"][2, 3] for step in plan.footholds]) > 0.002


def test_other_threads_go_on_while_it_plans(a1):
    """The interpreter's lock is released: a thread counts while the main one plans."""
    import threading

    counted, stop = [0], threading.Event()

    def count():
        while not stop.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    began = time.monotonic()
    gw.plan_walk(a1, gait="trot", speed=0.3, distance=3.0)
    lasted_s = time.monotonic() - began
    while_it_planned = counted[0]
    stop.set()
    thread.join()
    assert while_it_planned > 20 * lasted_s


def test_ground_that_cannot_be_is_refused():
    with pytest.raises(gw.BadInputError, match="friction is -1"):
        gw.flat_terrain(-1.0)
    with pytest.raises(gw.BadInputError, match="resolution_m is 1e-300"):
        gw.flat_terrain().with_heights(np.zeros((3, 3)), 1e-300)
    with pytest.raises(gw.BadInputError, match="is not within"):
        gw.flat_terrain().with_marker("desk", np.nan, 0.0)
    with pytest.raises(gw.BadInputError, match="needs a name"):
        gw.flat_terrain().with_marker(" ", 0.0, 0.0)
    with pytest.raises(gw.BadInputError, match="is not within"):
        gw.flat_terrain().ground_at(np.inf, 0.0)
    with pytest.raises(gw.BadInputError, match="corner is 60 m high"):
        gw.flat_terrain().with_patch([[0.0, 0.0, 60.0], [1.0, 0.0, 60.0], [1.0, 1.0, 60.0]])


def test_both_engines_are_played_and_both_must_pass(trot):
    both = gw.play(trot, engine="both")
    assert (both.engine, both.second.engine) == ("bullet", "mujoco")
    assert both.passed and both.second.passed and both.second.second is None
    assert both.agreement["engines"] == ["bullet", "mujoco"]
    assert {"quantity", "largest", "tolerance", "parts_s"} <= both.agreement["quantities"][0].keys()
    alone = gw.play(trot, engine="mujoco")
    assert np.array_equal(alone.q, both.second.q) and alone.second is None and alone.agreement is None
    with pytest.raises(ValueError, match="engine"):
        gw.play(trot, engine="ode")


def test_a_world_stands_in_each_engine(a1):
    for engine in ("bullet", "mujoco"):
        world = gw.World(a1, engine=engine)
        assert world.step_s == 0.001
    with pytest.raises(ValueError, match="both"):
        gw.World(a1, engine="both")
