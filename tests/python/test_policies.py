# SPDX-License-Identifier: BSD-3-Clause
"""Networks against NumPy, and learned policies in physics."""

import subprocess
import sys
from pathlib import Path

import gaitwright as gw
import numpy as np
import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples/policies"
sys.path.insert(0, str(EXAMPLES))
from onnx_file import model, node  # noqa: E402

ACTIVATIONS = {
    "Elu": lambda x: np.where(x > 0, x, np.expm1(np.minimum(x, 0))),
    "Relu": lambda x: np.maximum(x, 0),
    "Tanh": np.tanh,
    "Sigmoid": lambda x: 1 / (1 + np.exp(-x)),
    "Softplus": lambda x: np.logaddexp(0, x),
    "LeakyRelu": lambda x: np.where(x >= 0, x, 0.01 * x),
}


def random_network(random, activation):
    """A network as exporters write it: normalised inputs, dense layers, a slice beside them; and the same in NumPy."""
    sizes = [int(random.integers(5, 50))] + [int(n) for n in random.integers(3, 80, random.integers(1, 4))] + [12]
    constants = {"mean": random.normal(size=sizes[0]).astype("f"), "deviation": random.uniform(0.5, 2, sizes[0]).astype("f")}
    nodes = [node("Sub", ["obs", "mean"], ["centred"]), node("Div", ["centred", "deviation"], ["x0"])]
    layers = []
    for i, (n, m) in enumerate(zip(sizes, sizes[1:])):
        w, b = random.normal(scale=n**-0.5, size=(m, n)).astype("f"), random.normal(size=m).astype("f")
        layers.append((w, b))
        if i % 2:
            constants |= {f"w{i}": w.T.copy(), f"b{i}": b}
            nodes += [node("MatMul", [f"x{i}", f"w{i}"], [f"p{i}"]), node("Add", [f"p{i}", f"b{i}"], [f"y{i}"])]
        else:
            constants |= {f"w{i}": w, f"b{i}": b}
            nodes.append(node("Gemm", [f"x{i}", f"w{i}", f"b{i}"], [f"y{i}"], transB=1, alpha=1.0, beta=1.0))
        if i + 2 < len(sizes):
            nodes.append(node(activation, [f"y{i}"], [f"x{i + 1}"]))
    constants |= {"first": np.array([0]), "last": np.array([2]), "axis": np.array([1])}
    nodes += [
        node("Slice", ["obs", "first", "last", "axis"], ["some"]),
        node("Concat", [f"y{len(layers) - 1}", "some"], ["action"], axis=-1),
    ]

    def in_numpy(obs):
        x = (obs.astype(float) - constants["mean"]) / constants["deviation"]
        for i, (w, b) in enumerate(layers):
            x = w.astype(float) @ x + b
            if i + 1 < len(layers):
                x = ACTIVATIONS[activation](x)
        return np.concatenate([x, obs[:2]])

    return model(nodes, constants, sizes[0], 14), sizes[0], in_numpy


@pytest.mark.parametrize("activation", ACTIVATIONS)
@pytest.mark.parametrize("seed", range(5))
def test_random_networks_equal_numpy(tmp_path, activation, seed):
    random = np.random.default_rng(seed)
    file, inputs, in_numpy = random_network(random, activation)
    (tmp_path / "network.onnx").write_bytes(file)
    network = gw.Network(tmp_path / "network.onnx")
    assert (network.input_size, network.output_size) == (inputs, 14)
    for _ in range(5):
        obs = random.normal(scale=3, size=inputs).astype("f")
        expected = in_numpy(obs)
        assert np.linalg.norm(expected) > 0.1
        np.testing.assert_allclose(network(obs), expected, rtol=1e-4, atol=1e-4)


@pytest.fixture
def standing(tmp_path):
    """A robot, and the contract of a policy that stands in its posture."""
    robot = gw.load_robot("a1")
    n = len(robot.joints)
    posture = robot.standing[7:]
    text = f"joint_names: [{', '.join(robot.joints)}]\nstep_dt: 0.02\nstiffness: {[100.0] * n}\ndamping: {[2.0] * n}\n"
    text += f"default_joint_pos: {[float(x) for x in posture]}\nactions: {{JointPositionAction: {{scale: 0.25}}}}\n"
    text += "observations: {projected_gravity: {}, joint_pos_rel: {}, last_action: {}}\n"
    (tmp_path / "deploy.yaml").write_text(text)
    return robot, tmp_path / "deploy.yaml", 3 + 2 * n, n


def test_a_callable_and_its_network_play_the_same(tmp_path, standing):
    robot, contract, inputs, outputs = standing
    gains = np.zeros((outputs, inputs), "f")
    gains[0, 1] = 0.1
    (tmp_path / "policy.onnx").write_bytes(
        model([node("Gemm", ["obs", "w"], ["action"], transB=1)], {"w": gains}, inputs, outputs)
    )
    network = gw.play_policy(robot, tmp_path / "policy.onnx", contract, duration=1.0)
    seen = []

    def policy(obs):
        seen.append(obs)
        return gains @ obs

    function = gw.play_policy(robot, policy, contract, duration=1.0)
    assert network.metrics["fell"].value == 0
    assert network.controller == "policy"
    assert len(seen) == 65  # 1 s and 0.3 s of hold, each 0.02 s
    np.testing.assert_allclose(network.q, function.q, atol=1e-6)


def test_a_policy_is_tried_like_a_plan(tmp_path, standing):
    robot, contract, inputs, outputs = standing
    (tmp_path / "policy.onnx").write_bytes(
        model([node("Gemm", ["obs", "w"], ["action"], transB=1)], {"w": np.zeros((outputs, inputs), "f")}, inputs, outputs)
    )
    of_file = gw.Policy(robot, tmp_path / "policy.onnx", contract, duration=1.0)
    assert robot.joints[0] in str(of_file)
    report = gw.trials(of_file, 4, disturbances={"friction": 0.5}, seed=3)
    assert (report.n, report.survived) == (4, 4)
    function = gw.Policy(robot, lambda obs: np.zeros(outputs, "f"), contract, duration=1.0)
    again = gw.trials(function, 4, disturbances={"friction": 0.5}, seed=3, threads=2)
    np.testing.assert_allclose(again.scores, report.scores, atol=1e-6)
    assert again.seeds == report.seeds
    with pytest.raises(ValueError, match="its own controller"):
        gw.trials(function, 1, controller="tracking")


def test_a_wrong_size_is_refused(tmp_path, standing):
    robot, contract, inputs, outputs = standing
    weights = {"w": np.zeros((outputs, inputs + 1), "f")}
    (tmp_path / "policy.onnx").write_bytes(
        model([node("Gemm", ["obs", "w"], ["action"], transB=1)], weights, inputs + 1, outputs)
    )
    with pytest.raises(gw.BadInputError, match="the contract gives 27 observations .* the network has 28 inputs"):
        gw.play_policy(robot, tmp_path / "policy.onnx", contract)
    with pytest.raises(ValueError, match="gave 3 numbers; 12 are needed"):
        gw.play_policy(robot, lambda obs: np.zeros(3), contract, duration=0.5)


def test_the_example_is_written_by_its_script(tmp_path):
    subprocess.run([sys.executable, "-B", EXAMPLES / "a1_trot.py", tmp_path], check=True)
    for name in ("a1_trot.onnx", "a1_trot.yaml"):
        assert (tmp_path / name).read_bytes() == (EXAMPLES / name).read_bytes(), name
