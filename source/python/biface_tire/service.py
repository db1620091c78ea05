# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a tire carries and how fast it may go: load index, speed symbol, load range."""

from biface.errors import BifaceError

STANDARD_GRAVITY = 9.80665  # m/s^2

# kg of the load indices 0 to 79; each further 80 are ten times as much @cite UNECE54
_MASSES = (
    45, 46.25, 47.5, 48.75, 50, 51.5, 53, 54.5, 56, 58, 60, 61.5, 63, 65, 67, 69, 71, 73,
    75, 77.5, 80, 82.5, 85, 87.5, 90, 92.5, 95, 97.5, 100, 103, 106, 109, 112, 115, 118,
    121, 125, 128, 132, 136, 140, 145, 150, 155, 160, 165, 170, 175, 180, 185, 190, 195,
    200, 206, 212, 218, 224, 230, 236, 243, 250, 257.5, 265, 272.5, 280, 290, 300, 307.5,
    315, 325, 335, 345, 355, 365, 375, 387.5, 400, 412.5, 425, 437.5)
LARGEST_LOAD_INDEX = 279

# km/h @cite UNECE54
SPEEDS = {
    "A1": 5, "A2": 10, "A3": 15, "A4": 20, "A5": 25, "A6": 30, "A7": 35, "A8": 40, "B": 50,
    "C": 60, "D": 65, "E": 70, "F": 80, "G": 90, "J": 100, "K": 110, "L": 120, "M": 130,
    "N": 140, "P": 150, "Q": 160, "R": 170, "S": 180, "T": 190, "U": 200, "H": 210,
    "V": 240, "W": 270, "Y": 300}

# ply ratings of load ranges, of bias tires for trucks and trailers [49 CFR 571.119]
LOAD_RANGES = {"A": 2, "B": 4, "C": 6, "D": 8, "E": 10, "F": 12, "G": 14, "H": 16,
               "J": 18, "L": 20, "M": 22, "N": 24}


def mass_of(load_index):
    """The mass in kg that a load index stands for, as tables print it: without
    fractions from 100 kg on, with one digit below. Raises BifaceError if there is no
    such index."""
    if not 0 <= load_index <= LARGEST_LOAD_INDEX:
        raise BifaceError(f"the load index is {load_index}, but must lie between 0 and "
                          f"{LARGEST_LOAD_INDEX}.")
    mass = _MASSES[load_index % 80] * 10 ** (load_index // 80)
    return int(mass) if mass >= 100 else int(10 * mass) / 10


def load_of(load_index):
    """The rated load in N of a load index."""
    return mass_of(load_index) * STANDARD_GRAVITY
