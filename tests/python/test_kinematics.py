# SPDX-License-Identifier: BSD-3-Clause
import gaitwright as gw
import numpy as np
import pytest
from conftest import ROBOTS
from urdf_chain import Urdf

STATES = 200


def random_state(robot, random):
    lower, upper = np.maximum(robot.lower, -np.pi), np.minimum(robot.upper, np.pi)
    quaternion = random.normal(size=4)
    quaternion /= np.linalg.norm(quaternion)
    q = np.concatenate([random.uniform(-2, 2, 3), quaternion, random.uniform(lower, upper)])
    return q, random.normal(size=robot.nv)


@pytest.mark.parametrize("name", ["a1", "nao"])
def test_poses_and_jacobians_agree_with_products_of_matrices(name):
    robot, urdf, random = gw.load_robot(name), Urdf(ROBOTS / name / "robot.urdf"), np.random.default_rng(7)
    state = gw.RobotState(robot)
    for _ in range(STATES):
        q, v = random_state(robot, random)
        state.set(q, v)
        for foot in robot.feet:
            X, J = urdf.forward(robot, q, foot)
            assert np.abs(state.pose(foot) - X).max() < 1e-10
            assert np.abs(state.jacobian(foot) - J).max() < 1e-10
            assert np.abs(state.velocity(foot) - J @ v).max() < 1e-10


@pytest.mark.parametrize("name", ["a1", "nao"])
def test_the_centre_of_mass_agrees_with_the_urdf(name):
    robot, urdf, random = gw.load_robot(name), Urdf(ROBOTS / name / "robot.urdf"), np.random.default_rng(8)
    state = gw.RobotState(robot)
    for _ in range(20):
        q, v = random_state(robot, random)
        state.set(q, v)
        centre, mass = urdf.centre_of_mass(robot, q)
        assert mass == pytest.approx(robot.mass_kg, rel=1e-12)
        assert np.abs(state.centre_of_mass - centre).max() < 1e-10
        assert state.momentum[:3] == pytest.approx(mass * state.centre_of_mass_jacobian() @ v, abs=1e-9)


def test_dynamics_obey_their_laws(a1):
    random = np.random.default_rng(9)
    for _ in range(STATES):
        q, v = random_state(a1, random)
        a = random.normal(size=a1.nv)
        state = gw.RobotState(a1, q, v)
        M = state.mass_matrix()
        assert np.abs(M - M.T).max() < 1e-10
        assert np.linalg.eigvalsh(M).min() > 0.0
        # tau = M a + h, and the power of h minus that of gravity is only that of the rate of M.
        assert state.inverse_dynamics(a) == pytest.approx(M @ a + state.inverse_dynamics(), abs=1e-8)
        at_rest = gw.RobotState(a1, q)
        assert at_rest.inverse_dynamics()[2] == pytest.approx(a1.weight_n, rel=1e-12)
        assert state.energy_j - at_rest.energy_j == pytest.approx(0.5 * v @ M @ v, rel=1e-9)


def test_forward_dynamics_and_derivatives_agree_with_inverse_dynamics(a1):
    random = np.random.default_rng(10)
    q, v = random_state(a1, random)
    a, along = random.normal(size=a1.nv), random.normal(size=a1.nv)
    state = gw.RobotState(a1, q, v)
    assert state.forward_dynamics(state.inverse_dynamics(a)) == pytest.approx(a, abs=1e-8)
    by_q, by_v, M = state.inverse_dynamics_derivatives(a)
    assert by_q.shape == by_v.shape == (a1.nv, a1.nv)
    assert M == pytest.approx(state.mass_matrix(), abs=1e-12)
    step = 1e-6
    ahead, behind = gw.RobotState(a1, q, v + step * along), gw.RobotState(a1, q, v - step * along)
    difference = (ahead.inverse_dynamics(a) - behind.inverse_dynamics(a)) / (2.0 * step)
    assert by_v @ along == pytest.approx(difference, abs=1e-6)
    joint = np.zeros(a1.nv - 6)
    joint[4] = step
    moved = gw.RobotState(a1, q + np.concatenate([np.zeros(7), joint]), v)
    assert (moved.inverse_dynamics(a) - state.inverse_dynamics(a)) / step == pytest.approx(by_q[:, 10], abs=1e-3)
    with pytest.raises(ValueError):
        state.forward_dynamics(np.zeros(3))


def test_a_leg_is_brought_to_where_a_foot_was(a1):
    random = np.random.default_rng(10)
    for foot in a1.feet:
        columns = [a1.joints.index(joint) for joint in gw.leg_joints(a1, foot)]
        for _ in range(50):
            q = a1.standing
            q[7:] = q[7:] + random.uniform(-0.2, 0.2, a1.num_joints)
            state = gw.RobotState(a1, q)
            in_base = np.linalg.inv(state.pose(a1.links[0])) @ state.pose(foot)
            joints = gw.solve_leg(a1, foot, in_base, q[7:][columns])
            assert joints == pytest.approx(q[7:][columns], abs=1e-9)


def test_what_cannot_be_reached_is_told(a1):
    far = np.eye(4)
    far[:3, 3] = [0.0, 0.0, -2.0]
    with pytest.raises(gw.InfeasibleError, match="out of reach|reach") as told:
        gw.solve_leg(a1, a1.feet[0], far)
    assert told.value.code == "out_of_reach"


def test_wrong_states_are_refused_in_words(a1):
    with pytest.raises(ValueError, match="q has 3 numbers; .a1. needs 19"):
        gw.RobotState(a1, np.zeros(3))
    with pytest.raises(gw.BadInputError, match="not finite"):
        gw.RobotState(a1, np.full(a1.nq, np.nan))
    with pytest.raises(gw.BadInputError, match="FL_foot"):
        gw.RobotState(a1).pose("FL_fot")


def test_motors_of_a_transmission_are_held_to_their_own_limits(tmp_path):
    yaml = tmp_path / "robot.yaml"
    motor = "{{name: {}, ratios: [1, {}], effort_nm: 10, velocity_rad_s: 4}}"
    yaml.write_text(
        "transmissions:\n  - name: leg\n    joints: [FL_hip_joint, FL_thigh_joint]\n    motors:\n"
        f"      - {motor.format('front', 1)}\n      - {motor.format('rear', -1)}\n"
    )
    robot = gw.load_robot(ROBOTS / "a1" / "robot.urdf", yaml=yaml)
    (transmission,) = robot.transmissions
    hip, thigh = (robot.joints.index(joint) for joint in transmission["joints"])
    assert [robot.motors[hip], robot.motors[thigh]] == transmission["motors"] == ["front", "rear"]
    assert robot.motor_effort_limit[hip] == 10.0 and robot.effort_limit[hip] == 20.0
    torques = np.zeros(robot.num_joints)
    torques[[hip, thigh]] = 15.0
    assert np.allclose(robot.motor_torques(torques)[[hip, thigh]], [15.0, 0.0])
    assert np.allclose(transmission["ratios"].T @ [10.0, 0.0], robot.clamp_torques(torques)[[hip, thigh]])
    assert np.allclose(robot.motor_speeds(torques)[[hip, thigh]], [30.0, 0.0])
    with pytest.raises(gw.GaitwrightError):
        robot.motor_torques(torques[1:])
