# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the texts say in rounded words, each phrase beside the measured number and its limits."""

from claims import casting, device, growth, mapping, speed
from claims.values import CHARTS, ROOT, TABLES

CLAIMS = (casting.make_claims() + casting.make_failure_claims() + mapping.make_claims()
          + growth.make_claims() + growth.make_sampling_claims() + device.make_claims()
          + speed.make_claims() + speed.make_map_claims())
