# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Chart F: what a real device does to ranges and maps."""

from claims.values import ACCURACY, GUIDE, Claim, effect


def make_claims():
    """Chart F."""
    noise = effect("noise", "map to scene mean mm")
    bias = effect("bias", "map to scene mean mm") / effect("bias", "median mm")
    return [
        Claim(ACCURACY, "Noise and steps change nearly every range a little",
              effect("noise", "changed %"), 75, 100),
        Claim(ACCURACY, "its mean error stays near a millimetre", noise, 0.7, 1.5),
        Claim(ACCURACY, "A bias moves all surfaces by its size", bias, 0.6, 1),
        Claim(ACCURACY, "changes only the ranges at edges",
              effect("width of the beam", "changed %"), 0.1, 5),
        Claim(ACCURACY, "but there by up to metres",
              effect("width of the beam", "max mm") / 1000, 1, 10),
        Claim(ACCURACY, "so its error does not grow",
              effect("mirror off the axis", "map to scene mean mm")
              / effect("ideal", "map to scene mean mm"), 0.3, 1.2),
        Claim(ACCURACY, "At 5 cm/s this is by far the largest error",
              effect("motion", "map to scene mean mm") / effect("bias", "map to scene mean mm"),
              3, 100),
        Claim(GUIDE, "about eleven times as long with 7 rays",
              effect("width of the beam", "x ideal"), 9, 13),
        Claim(ACCURACY, "The width costs most time",
              effect("width of the beam", "x ideal") / effect("motion", "x ideal"), 1, 10),
        Claim(ACCURACY, "All effects together stay below thirty times the time of the ideal scan",
              effect("all", "x ideal"), 5, 30),
    ]
