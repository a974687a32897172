# SPDX-License-Identifier: BSD-3-Clause
"""Plots of plans and playbacks with matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from gaitwright._core import Plan, Playback

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

PLANNED, MEASURED = "#8a9aa8", "#0072b2"


def plot(what: Plan | Playback) -> Figure:
    """From above, height of the base, contacts and torques; of a playback planned and measured.

    Raises:
        ImportError: matplotlib is not installed.
    """
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise ImportError("plots need matplotlib (Debian: python3-matplotlib, or pip install matplotlib)") from error
    plan = what.plan if isinstance(what, Playback) else what
    played = what if isinstance(what, Playback) else None
    figure, ((above, height), (contact, torque)) = pyplot.subplots(2, 2, figsize=(11, 7), layout="constrained")
    _plot_above(above, plan, played)
    _plot_height(height, plan, played)
    _plot_contact(contact, plan, played)
    _plot_torque(torque, plan, played)
    figure.suptitle(repr(what)[1:-1].removeprefix("gaitwright."))
    return figure


def _plot_above(axes: Axes, plan: Plan, played: Playback | None) -> None:
    for i, foot in enumerate(plan.robot.feet):
        places = np.array([step["pose"][:2, 3] for step in plan.footholds if step["foot"] == foot])
        if len(places):
            axes.plot(*places.T, "o", markersize=3, color=f"C{i + 1}", label=foot)
    axes.plot(*plan.zmp_m.T, color=PLANNED, linewidth=0.8, label="ZMP planned")
    axes.plot(*plan.centre_of_mass_m[:, :2].T, color="black", linewidth=1.2, label="centre of mass planned")
    if played:
        axes.plot(*played.q[:, :2].T, color=MEASURED, linewidth=1.2, label="base measured")
    axes.set(title="From above", xlabel="x [m]", ylabel="y [m]", aspect="equal", adjustable="datalim")
    axes.legend(fontsize="x-small")


def _plot_height(axes: Axes, plan: Plan, played: Playback | None) -> None:
    _plot_both(axes, plan, played, lambda q: q[:, 2], "q")
    axes.set(title="Height of the base", xlabel="time [s]", ylabel="z [m]")


def _plot_contact(axes: Axes, plan: Plan, played: Playback | None) -> None:
    feet = plan.robot.feet
    for i in range(len(feet)):
        axes.fill_between(plan.time_s, i - 0.35, i + 0.35, where=plan.contact[:, i], color=PLANNED, alpha=0.5, linewidth=0)
        if played:
            touching = np.linalg.norm(played.forces_n[:, i], axis=1) > 0.0
            axes.fill_between(played.time_s, i - 0.2, i + 0.2, where=touching, color=MEASURED, linewidth=0)
    axes.set(title="Contacts", xlabel="time [s]", yticks=range(len(feet)), yticklabels=feet)


def _plot_torque(axes: Axes, plan: Plan, played: Playback | None) -> None:
    limit = np.where(np.isfinite(plan.robot.effort_limit), plan.robot.effort_limit, np.nan)
    _plot_both(axes, plan, played, lambda tau: 100.0 * _largest(np.abs(tau) / limit), "tau")
    axes.set(title="Largest share of a torque limit", xlabel="time [s]", ylabel="[%]")


def _largest(rows: np.ndarray) -> np.ndarray:
    known = ~np.all(np.isnan(rows), axis=0)
    return rows[:, known].max(axis=1) if known.any() else np.full(len(rows), np.nan)


def _plot_both(axes: Axes, plan: Plan, played: Playback | None, figure_of: Any, column: str) -> None:
    axes.plot(plan.time_s, figure_of(getattr(plan, column)), color=PLANNED, label="planned")
    if played:
        axes.plot(played.time_s, figure_of(getattr(played, column)), color=MEASURED, linewidth=0.9, label="measured")
        axes.legend(fontsize="x-small")
