# SPDX-License-Identifier: BSD-3-Clause
import _thread
import json
import threading

import gaitwright as gw
import numpy as np
import pytest


@pytest.fixture(scope="module")
def report(trot):
    return gw.trials(trot, 4, seed=3)


def test_trials_are_the_same_for_any_number_of_threads(trot, report):
    told = []
    one = gw.trials(trot, 4, seed=3, threads=1, progress=lambda done, wanted: told.append((done, wanted)))
    assert one.to_json() == report.to_json()
    assert told == [(k, 4) for k in range(1, 5)]
    assert report.n == 4 and 0 <= report.survived <= 4
    low, high = report.survival_interval
    assert 0.0 <= low <= report.survival <= high <= 1.0


def test_what_was_drawn_and_measured_is_a_column_each(report):
    friction = report.column("friction")
    assert friction.shape == (4,) and np.all((friction >= 0.5) & (friction <= 1.0))
    assert report.column("goal_error_m").shape == (4,)
    with pytest.raises(ValueError, match="no value 'frictoin'"):
        report.column("frictoin")


def test_disturbances_can_be_a_text(trot):
    light = gw.trials(trot, 2, disturbances="mass_scale: {uniform: [0.9, 0.95]}\nfriction: 0.7\n")
    assert np.all(light.column("mass_scale") < 0.951)
    with pytest.raises(gw.BadInputError, match="mass_scale"):
        gw.trials(trot, 2, disturbances="mas_scale: 0.9\n\n")


def test_an_exception_of_the_progress_comes_back(trot):
    def no(done, wanted):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        gw.trials(trot, 4, progress=no)


def test_ctrl_c_ends_trials(trot):
    threading.Timer(1.0, _thread.interrupt_main).start()
    with pytest.raises(KeyboardInterrupt):
        gw.trials(trot, 100_000)


def test_reports_and_viewer_show_inline(playback, report, tmp_path):
    page = gw.show(playback)
    assert page._repr_html_().startswith("<iframe srcdoc=") and "<html" in page.text
    assert gw.show(playback, viewer=True).text != page.text
    assert page.save(tmp_path / "report.html").stat().st_size == len(page.text.encode())
    assert "survived" in gw.show(report).text
    with pytest.raises(TypeError, match="no motion to show of a TrialsReport"):
        gw.show(report, viewer=True)
    assert playback._repr_html_().startswith("<iframe")


def test_figures_are_those_of_the_program(playback):
    log = json.loads(playback.to_json())
    assert log["format"] == "gaitwright-playback-log"
    assert playback.metrics["fell"].value == 0.0
    assert playback.metrics["goal_error_m"].planned is not None
    assert str(playback).startswith("PASS")
    assert "pass" in repr(playback)
