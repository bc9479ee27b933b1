# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A simulated SICK LMS 200 on a pseudo-terminal, for programs that have a driver for the device.

The parts:
- telegrams, crc and measured_values encode and decode bytes, without any state;
- device, with state, commands, configuration and status, is the LMS 200 without a terminal. Its
  methods take the time as an argument;
- terminal, rates and link are the pseudo-terminal, and have no part of the protocol;
- fans, platform and poses measure the ranges that the device reports;
- emulator joins them.

Page numbers in comments and tests are the page numbers of SICK's telegram listing (TL) 8007954,
2006-08-01, for firmware V2.30.
"""
