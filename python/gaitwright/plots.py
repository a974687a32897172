# SPDX-License-Identifier: BSD-3-Clause
"""Plots of plans and playbacks with matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from gaitwright._core import Plan, Playback

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

PLANNED, MEASURED, SUPPORT = "#8a9aa8", "#0072b2", "#f0e442"
OF_PLAN = [["above", "height"], ["contact", "torque"]]
OF_PLAYBACK = [["above", "above"], ["margin", "contact"], ["height", "torque"]]


def plot(what: Plan | Playback) -> Figure:
    """Plots the top view, contacts, base height and torques. For a playback: planned and measured, and the ZMP margin.

    Raises:
        ImportError: matplotlib is not installed.
    """
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise ImportError("plots need matplotlib (Debian: python3-matplotlib, or pip install matplotlib)") from error
    plan = what.plan if isinstance(what, Playback) else what
    played = what if isinstance(what, Playback) else None
    figure, axes = pyplot.subplot_mosaic(OF_PLAYBACK if played else OF_PLAN, figsize=(11, 8), layout="constrained")
    _plot_above(axes["above"], plan, played)
    _plot_contact(axes["contact"], plan, played)
    _plot_height(axes["height"], plan, played)
    _plot_torque(axes["torque"], plan, played)
    if played:
        _plot_margin(axes["margin"], played)
    figure.suptitle(repr(what)[1:-1].removeprefix("gaitwright."))
    if getattr(type(figure.canvas), "required_interactive_framework", None) is None:
        pyplot.close(figure)  # without a window: a notebook shows a returned figure, and would show an open one again
    return figure


def _plot_above(axes: Axes, plan: Plan, played: Playback | None) -> None:
    for corners in _supports(played) if played else ():
        axes.fill(*corners.T, facecolor=SUPPORT, edgecolor=PLANNED, alpha=0.12, linewidth=0.8)
    for i, foot in enumerate(plan.robot.feet):
        places = np.array([step["pose"][:2, 3] for step in plan.footholds if step["foot"] == foot])
        if len(places):
            axes.plot(*places.T, "o", markersize=3, color=f"C{i + 1}", label=foot)
    axes.plot(*plan.zmp_m.T, color=PLANNED, linewidth=0.8, label="ZMP planned")
    axes.plot(*plan.centre_of_mass_m[:, :2].T, color="black", linewidth=1.2, label="centre of mass planned")
    if played:
        axes.plot(*played.zmp_m.T, color=MEASURED, linewidth=0.5, alpha=0.7, label="ZMP measured")
        axes.plot(*played.centre_of_mass_m[:, :2].T, color=MEASURED, linewidth=1.2, label="centre of mass measured")
    axes.set(title="From above", xlabel="x [m]", ylabel="y [m]", aspect="equal", adjustable="datalim")
    axes.legend(fontsize="x-small", loc="upper left", bbox_to_anchor=(1.0, 1.0))


def _supports(played: Playback) -> list[np.ndarray]:
    """One support polygon for each set of stance feet, taken in the middle of its interval."""
    changes = np.flatnonzero(np.any(np.diff(played.contact, axis=0), axis=1)) + 1
    spans = zip(np.r_[0, changes], np.r_[changes, len(played.contact)])
    return [corners for begin, end in spans if len(corners := played.support(int(begin + end) // 2))]


def _plot_margin(axes: Axes, played: Playback) -> None:
    axes.axhline(0.0, color="black", linewidth=0.8)
    axes.plot(played.time_s, 1000.0 * played.zmp_margin_m, color=MEASURED, linewidth=0.9)
    axes.set(title="ZMP inside of the support polygon", xlabel="time [s]", ylabel="distance to its edge [mm]")


def _plot_height(axes: Axes, plan: Plan, played: Playback | None) -> None:
    _plot_both(axes, plan, played, lambda q: q[:, 2], "q")
    axes.set(title="Height of the base", xlabel="time [s]", ylabel="z [m]")


def _plot_contact(axes: Axes, plan: Plan, played: Playback | None) -> None:
    feet = plan.robot.feet
    for i in range(len(feet)):
        axes.fill_between(plan.time_s, i - 0.35, i + 0.35, where=plan.contact[:, i], color=PLANNED, alpha=0.5, linewidth=0)
        if played:
            axes.fill_between(played.time_s, i - 0.2, i + 0.2, where=played.contact[:, i], color=MEASURED, linewidth=0)
    axes.set(title="Contacts", xlabel="time [s]", yticks=range(len(feet)), yticklabels=feet)


def _plot_torque(axes: Axes, plan: Plan, played: Playback | None) -> None:
    robot = plan.robot
    limit = np.where(np.isfinite(robot.motor_effort_limit), robot.motor_effort_limit, np.nan)
    to_motors = np.array([robot.motor_torques(joint) for joint in np.eye(robot.num_joints)])
    _plot_both(axes, plan, played, lambda tau: 100.0 * _largest(np.abs(tau @ to_motors) / limit), "tau")
    axes.set(title="Largest share of a torque limit", xlabel="time [s]", ylabel="[%]")


def _largest(rows: np.ndarray) -> np.ndarray:
    known = ~np.all(np.isnan(rows), axis=0)
    return rows[:, known].max(axis=1) if known.any() else np.full(len(rows), np.nan)


def _plot_both(axes: Axes, plan: Plan, played: Playback | None, figure_of: Any, column: str) -> None:
    axes.plot(plan.time_s, figure_of(getattr(plan, column)), color=PLANNED, label="planned")
    if played:
        axes.plot(played.time_s, figure_of(getattr(played, column)), color=MEASURED, linewidth=0.9, label="measured")
        axes.legend(fontsize="x-small")
