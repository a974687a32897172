# SPDX-License-Identifier: BSD-3-Clause
"""Exceptions of the package, with the same messages as the program."""

from __future__ import annotations


class GaitwrightError(Exception):
    """A request that has no result, with the reason.

    Attributes:
        message: one plain sentence that names the offender, its value and what is accepted.
        code: the reason, one of ``gaitwright.FAILURE_CODES``, such as ``urdf_loop``.
        stage: the stage that failed, such as ``LoadRobot``; may be empty.
        hints: remedies, as text.
        suggestions: the hints that name a flag or an option, each ``{"what", "value", "certainty"}``: the option
            without dashes, the value or None, and ``planned`` (a plan with it was made), ``estimated`` or ``untried``.
        violation: the constraint that forbids the plan, ``{"law", "at_s", "where", "value", "limit", "unit"}``, or None.
    """

    def __init__(
        self,
        message: str,
        code: str = "",
        stage: str = "",
        hints: list[str] | None = None,
        suggestions: list[dict] | None = None,
        violation: dict | None = None,
    ) -> None:
        super().__init__(message)
        self.message = message
        self.code = code
        self.stage = stage
        self.hints = list(hints or [])
        self.suggestions = list(suggestions or [])
        self.violation = violation

    def __str__(self) -> str:
        return self.message + (f" (try: {'; or: '.join(self.hints)})" if self.hints else "")


class BadInputError(GaitwrightError, ValueError):
    """A file or an argument is wrong."""


class InfeasibleError(GaitwrightError):
    """No plan exists within the limits; the message names the constraint that forbids it."""
