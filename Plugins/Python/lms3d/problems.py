# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Errors with a message for the user and an exit code."""


class Problem(Exception):
    """The job failed. The text says what failed, where, and what to do."""

    exit_code = 1


class UsageProblem(Problem):
    """The command is invalid."""

    exit_code = 2
