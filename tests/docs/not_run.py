# SPDX-License-Identifier: BSD-3-Clause
"""Blocks marked `sh no-run`: the page and the block's first line, and why a test cannot run it."""

NOT_RUN = {
    ("README.md", "./run      # sets everything up, walks a Unitree A1 for 3 m at a trot in physics, and writes report.html"):
        "sets the machine up and builds, as was done before any test runs; and ./test would run itself",
    ("README.md", "build/release/standing_control --plot pushes.svg    # the largest push that joints, ankles, DCM, hips, whole body and steps withstand"):
        "minutes of searching for the largest pushes, and a stream in real time, which a busy machine does not keep; tests/examples runs both",
    ("docs/first-walk.md", "./run"): "sets the machine up and builds, as was done before any test runs",
    ("docs/cluster.md", "mpirun -np 4 gaitwright trials plan.json -n 500 --disturbances examples/disturbances/a1_hobby.yaml"
                        " --state estimated --sensors hobby --out result.json"):
        "500 trials take minutes; tests/cli/cluster_test.cc runs fewer under mpirun",
    ("docs/cluster.md", "sbatch job.sh"): "there is no Slurm here",
    ("docs/live.md", "gaitwright live --robot a1                # http://127.0.0.1:8017/; opens the page if there is a desktop"):
        "serves until it is stopped; tests/cli/live_test.cc starts and stops it",
    ("docs/install.md", "./run --version"):
        "installs into the machine; tests/consumer and tests/python/test_installed.py install into a folder",
    ("docs/install.md", "apt-get install dpkg-dev file"):
        "changes the machine; tests/package/check_in_empty_root.sh installs and purges the package",
    ("docs/install.md", "apt-get install patchelf"):
        "changes the machine; tests/package/check_archive.sh unpacks and runs the archive",
    ("docs/install.md", "apt-get install pybind11-dev python3-dev python3-numpy python3-pip python3-setuptools python3-wheel patchelf"):
        "changes the machine; tests/python/test_installed.py builds and installs the wheel",
    ("docs/install.md", "docker build -t gaitwright ."): "needs a Docker daemon and an image from the network",
    ("docs/python.md", "apt-get install pybind11-dev python3-dev python3-numpy patchelf    # and what ./run installs"):
        "changes the machine; tests/python/test_installed.py builds and installs the wheel",
    ("docs/sweep.md", "gaitwright sweep --robot a1 --gait trot --distance 1 --over speed=0.1:1.5:20 --over gait.cycle_s=0.3:0.8:10 \\"):
        "hundreds of walks take minutes; the block before it sweeps over six",
    ("docs/tune.md", "gaitwright tune --robot a1 --gait trot --speed 0.5 --distance 1 --over gait.cycle_s=0.3:0.8"
                     " --over stabilised.dcm_gain=1:2.5 \\"):
        "1800 playbacks take minutes; the block before it tunes with few",
    ("docs/tune.md", "gaitwright tune --robot nao --steps 6 --step-length 0.04 --state estimated --sensors hobby \\"):
        "takes 23 minutes on two cores",
    ("docs/words.md", "GAITWRIGHT_API_KEY=... gaitwright do \"make yourself small and greet everyone\" --robot nao"
                      " --interpreter https://HOST/v1 --model NAME"):
        "needs a language model on the network; tests/cli/do_test.cc has one that answers as it is told",
}
