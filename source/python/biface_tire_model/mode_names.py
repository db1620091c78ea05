# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which modes of a tire on a fixed rim are those of its belt as a rigid ring: the four
frequencies of a .tir file of MF 6.1.

A mode that holds more than half of the mass or of the moment of inertia for a rigid
motion is the only one that does, since the effective masses of all modes together are at
most the whole. Where none does, the tire does not move as a rigid ring, and there is no
name.
"""

from collections import namedtuple

import numpy as np

# What must be exceeded to be the only one
MOST = 0.5

# Frequencies of a pair differ by less than this part: meshes are not the same all around
PAIR = 0.01

# A mode has no translation if it holds less than this part of the mass
NONE = 0.01

# A motion that nothing holds has a frequency of less than this part of the highest one
RIGID = 1e-4

MEANINGS = {"FREQ_LONG": "fore and aft and vertical",
            "FREQ_LAT": "lateral",
            "FREQ_YAW": "yaw and camber",
            "FREQ_WINDUP": "rotation about the axle"}

# frequency  [Hz], of a pair the mean; modes are their numbers in modes.csv; share is what
#            they hold of the mass or of the moment of inertia, NaN where shapes are missing
Named = namedtuple("Named", "frequency modes share")


def unfit(modes) -> str | None:
    """Why modes are not those of a tire on a fixed rim in the air, or None."""
    if modes.is_on_ground:
        return "is on the ground"
    if not modes.is_steady:
        return "spins, or is not stable"
    if not modes.pressure > 0:
        return "is not inflated"
    if not np.isfinite(modes.waves).all():
        return "is no full turn"
    if modes.frequency.min() < RIGID * modes.frequency.max():
        return "is not held at the rim"
    return None


def pairs(modes):
    """The pairs of modes with one wave around the axis, as tuples of positions."""
    found, one = [], [i for i, waves in enumerate(modes.waves) if waves == 1]
    while len(one) > 1:
        first, second = one[:2]
        if abs(modes.frequency[second] / modes.frequency[first] - 1) < PAIR:
            found.append((first, second))
            one = one[2:]
        else:
            one = one[1:]
    return found


def name_modes(modes):
    """The Named modes by the entries of MEANINGS, and for each of the others why it is
    not certain."""
    found, reasons = {}, {}
    zero = [(i,) for i, waves in enumerate(modes.waves) if waves == 0]
    one = pairs(modes)
    has_shapes = np.isfinite(modes.rotations).all(1)

    def choose(name, groups, shares, what):
        """The group whose smallest share is more than half."""
        parts = [min(share) for share in shares]
        best = max(range(len(groups)), key=parts.__getitem__, default=None)
        if best is not None and parts[best] > MOST:
            found[name] = Named(float(modes.frequency[list(groups[best])].mean()),
                                tuple(int(modes.numbers[i]) for i in groups[best]),
                                parts[best])
        else:
            largest = ("there is none" if best is None else
                       f"the largest has {100 * parts[best]:.0f} %")
            reasons[name] = f"no {what}: {largest}"

    def of_pair(values, axes):
        return [[sum(values[i, axis] for i in pair) for axis in axes] for pair in one]

    choose("FREQ_LONG", one, of_pair(modes.masses, (0, 2)),
           "pair with one wave holds more than half of the mass along x and z")
    choose("FREQ_LAT", zero, [[modes.masses[i, 1]] for i, in zero],
           "mode without waves holds more than half of the mass along y")
    if all(has_shapes[i] for pair in one for i in pair):
        choose("FREQ_YAW", one, of_pair(modes.rotations, (0, 2)),
               "pair with one wave holds more than half of the moment of inertia about x "
               "and z")
    else:
        name_yaw(modes, one, found, reasons)
    if all(has_shapes[i] for i, in zero):
        choose("FREQ_WINDUP", zero, [[modes.rotations[i, 1]] for i, in zero],
               "mode without waves holds more than half of the moment of inertia about y")
    else:
        reasons["FREQ_WINDUP"] = ("modes without waves and translation may also be radial "
                                  "ones, and without 'Write VTU' there are no shapes to "
                                  "tell")
    return found, reasons


def name_yaw(modes, one, found, reasons):
    """The yaw mode without shapes: the only pair that does not translate and moves the
    meridian to one side."""
    fits = [pair for pair in one
            if all(modes.half_waves[i] == 1 and modes.masses[i].max() < NONE
                   for i in pair)]
    if len(fits) == 1:
        found["FREQ_YAW"] = Named(float(modes.frequency[list(fits[0])].mean()),
                                  tuple(int(modes.numbers[i]) for i in fits[0]), np.nan)
    else:
        count = "several pairs" if fits else "no pair"
        reasons["FREQ_YAW"] = (f"{count} with one wave, one half wave along the meridian "
                               "and no translation, and without 'Write VTU' there are no "
                               "shapes to tell")
