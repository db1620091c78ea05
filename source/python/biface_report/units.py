# SPDX-License-Identifier: LGPL-2.1-or-later
"""The units in labels and tables: those that the entry 'Units' of the input names,
such as 'mm, N, s', or else the words length, force and time."""

# Exponents of length, force and time in each kind of quantity
KINDS = {
    "length": (1, 0, 0), "area": (2, 0, 0), "volume": (3, 0, 0),
    "force": (0, 1, 0), "tension": (-1, 1, 0), "stiffness": (-1, 1, 0),
    "pressure": (-2, 1, 0), "moment": (1, 1, 0), "energy": (1, 1, 0),
    "power": (1, 1, -1), "time": (0, 0, 1), "frequency": (0, 0, -1),
    "velocity": (1, 0, -1), "mass": (-1, 1, 2)}

# Names of their own: of a kind, for some names of length, force and time
NAMES = {
    "pressure": {("mm", "N"): "MPa", ("mm", "kN"): "GPa", ("m", "N"): "Pa",
                 ("m", "kN"): "kPa", ("m", "MN"): "MPa", ("in", "lbf"): "psi"},
    "energy": {("m", "N"): "J", ("mm", "N"): "mJ", ("m", "kN"): "kJ"},
    "power": {("m", "N", "s"): "W", ("mm", "N", "s"): "mW",
              ("m", "kN", "s"): "kW"},
    "frequency": {("s",): "Hz"},
    "mass": {("mm", "N", "s"): "t", ("m", "N", "s"): "kg", ("m", "kN", "s"): "t"}}

GENERIC = ("length", "force", "time")


class Units:
    """What to call the unit of each kind of quantity."""

    def __init__(self, text=""):
        """From the names of the units of length, force and time, separated by
        commas; where they are not three words, the generic ones."""
        names = tuple(name.strip() for name in (text or "").split(","))
        self.are_named = (len(names) == len(GENERIC)
                          and all(name.isalpha() for name in names))
        self.names = names if self.are_named else GENERIC

    def __getitem__(self, kind):
        """The unit of a kind of quantity; '' for one without a unit."""
        if kind == "":
            return ""
        exponents = KINDS[kind]
        own = tuple(name for name, power in zip(self.names, exponents) if power)
        return NAMES.get(kind, {}).get(own) or product(self.names, exponents)

    def per(self, kind, other):
        """The unit of a quotient of two kinds of quantities, such as N/MPa."""
        divisor = self[other]
        return f"{self[kind]}/" + (f"({divisor})" if "/" in divisor else divisor)

    def label(self, name, kind):
        """The name of a quantity with its unit, for an axis."""
        return f"{name} [{self[kind]}]" if kind else name

    def sentence(self):
        """On the units, for the head of a page."""
        if self.are_named:
            return f"Units: {', '.join(self.names)}. Angles are in degrees."
        return ("Units are those of the input: [length] and [force] are its units "
                "of length and force. Angles are in degrees.")


def units_of(results):
    """The units of a run."""
    return Units(results.setting("Units"))


def product(names, exponents):
    """Powers of units, such as force/length²."""
    above, below = ([power_of(names[i], abs(exponents[i])) for i in (1, 0, 2)
                     if exponents[i] * sign > 0] for sign in (1, -1))
    return "/".join([" · ".join(above) or "1"] + below)


def power_of(name, exponent):
    """A unit with a small power."""
    return name + ("", "", "²", "³")[exponent]
