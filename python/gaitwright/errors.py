# SPDX-License-Identifier: BSD-3-Clause
"""What goes wrong, in the same words as the program's."""

from __future__ import annotations


class GaitwrightError(Exception):
    """Why there is no result.

    Attributes:
        message: one plain sentence that names the offender, its value and what is accepted.
        code: why, one of ``gaitwright.FAILURE_CODES``, such as ``urdf_loop``.
        stage: the stage that failed, such as ``LoadRobot``; may be empty.
        hints: what would help, in words.
        suggestions: those hints that name a flag or an option, each ``{"what", "value", "certainty"}``: the option without
            dashes, the value or None, and ``planned`` (a plan with it was made), ``estimated`` or ``untried``.
        violation: the law that forbids it, ``{"law", "at_s", "where", "value", "limit", "unit"}``, or None.
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
    """No plan exists within the limits; the message names what forbids it."""
