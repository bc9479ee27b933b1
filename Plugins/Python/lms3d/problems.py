# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""What can go wrong, in words for the user, each kind with its exit code."""


class Problem(Exception):
    """The job cannot be done. The text says what, where and what to do."""

    exit_code = 1


class UsageProblem(Problem):
    """The command cannot be carried out as it was given."""

    exit_code = 2
