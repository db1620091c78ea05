# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tire sizes: dimensions, ratings and service description from all usual notations."""

import csv
import re
from dataclasses import dataclass, replace
from pathlib import Path

from biface.errors import BifaceError
from .rim import INCH, TRUCK_WIDTHS
from .service import LOAD_RANGES, SPEEDS, load_of

KINDS = ("passenger", "light truck", "truck", "utility", "agricultural", "motorcycle",
         "aircraft", "bicycle")

# Diameters in mm of the seats of bicycle rims @cite ISO5775
FRENCH = {"700A": 642, "700B": 635, "700C": 622, "700D": 587, "650A": 590, "650B": 584,
          "650C": 571, "600A": 541, "550A": 490, "500A": 440, "450A": 390, "400A": 340}
DECIMAL = {"12": 203, "14": 254, "16": 305, "18": 355, "20": 406, "24": 507, "26": 559,
           "27.5": 584, "28": 622, "29": 622}

# Change of the section width over that of the rim width @cite UNECE30
WIDTH_BY_RIM = 0.4

EXAMPLES = ("195/65 R15 91V, LT235/85R16, 185R14C, 7.50-16 6PR, 4.80/4.00-8, 11R22.5, "
            "14.9-28, 31x10.50R15LT, 49x17 26PR, H44.5x16.5-21 28PR, 700x25C, 25-622, "
            "26x4.00")

NUMBER = r"(\d+(?:\.\d+)?)"


@dataclass(frozen=True)
class TireSize:
    """What a size says. Lengths in mm, loads in N.

    text              as it was written
    kind              one of KINDS, by which rules are chosen
    is_radial         the construction; else it is a bias tire
    width             nominal section width, on the theoretical rim
    diameter          overall diameter
    rim_diameter      at the seats of the beads; None if the size does not say it
    dimensions        the rule by which width and diameter follow
    theoretical_rim   the rim width on which the section has its width
    measuring_rim     the rim width of the tables, or nearly so
    rim_rule          the rule of the latter
    ply_rating, load_range, load_index, speed_symbol, is_reinforced
                      of the service description; None if not given
    databook          rows of the table of aircraft tires with these dimensions
    """

    text: str
    kind: str
    is_radial: bool
    width: float
    diameter: float
    rim_diameter: float | None
    dimensions: str
    theoretical_rim: float
    measuring_rim: float
    rim_rule: str
    ply_rating: int | None = None
    load_range: str | None = None
    load_index: int | None = None
    speed_symbol: str | None = None
    is_reinforced: bool = False
    databook: tuple = ()

    @property
    def rated_load(self):
        """N, of the load index; None without one."""
        return None if self.load_index is None else load_of(self.load_index)

    @property
    def speed(self):
        """km/h, of the speed symbol; None without one."""
        return SPEEDS.get(self.speed_symbol)

    @property
    def section_height(self):
        """From the seat of the bead to the crown; None if the rim is not known."""
        return (None if self.rim_diameter is None
                else (self.diameter - self.rim_diameter) / 2)

    def width_on(self, rim_width):
        """The section width on a rim, S = S_1 + 0.4 (A - A_1) @cite UNECE30."""
        return self.width + WIDTH_BY_RIM * (rim_width - self.theoretical_rim)


def read_databook():
    """The rows of the table of aircraft tires."""
    path = Path(__file__).with_name("aircraft_tires.csv")
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def find_rows(name):
    """The rows of the databook of a size such as `49x17`."""
    return tuple(row for row in read_databook() if row["name"].split()[0] == name)


def half_inches(width):
    """A rim width in mm, rounded to half an inch."""
    return round(2 * width / INCH) / 2 * INCH


def nearest_truck_rim(width):
    """A rim width in mm of those with seats at 15 degrees."""
    return min(TRUCK_WIDTHS, key=lambda inches: abs(inches * INCH - width)) * INCH


def metric(text, kind, width, aspect, rim, is_radial):
    """A size by section width and aspect ratio, in mm and percent."""
    if not 20 <= aspect <= 105:
        raise BifaceError(f"the size '{text}' has the aspect ratio {aspect:g}, but must "
                          "have one between 20 and 105.")
    if not 50 <= width <= 1100:
        raise BifaceError(f"the size '{text}' has the width {width:g} mm, but must have "
                          "one between 50 and 1100 mm.")
    # theoretical rims and measuring rims over the width @cite ISO4000, @cite UNECE30
    if kind == "truck":
        theory, measuring = 0.75 * width, nearest_truck_rim(0.75 * width)
        rule = "0.75 of the width, the nearest 15° rim"
    elif kind == "agricultural":
        theory, measuring = 0.8 * width, half_inches(0.8 * width)
        rule = "0.8 of the width, to half an inch (estimate)"
    else:
        part = (0.7 if aspect >= 75 else 0.75 if aspect >= 60 else 0.8 if aspect >= 50
                else 0.85 if aspect >= 45 else 0.9)
        theory = (0.7 if aspect >= 50 else 0.85) * width
        measuring = half_inches(part * width)
        rule = f"{part:g} of the width, to half an inch (ISO 4000-1)"
    return TireSize(text, kind, is_radial, width, rim + 2 * width * aspect / 100, rim,
                    "D = d + 2 S a/100", theory, measuring, rule)


def numeric(text, kind, code, height_code, rim, is_radial):
    """A size by a width code in inches."""
    if not 1 <= code <= 45:
        raise BifaceError(f"the size '{text}' has the width {code:g} inches, but must have "
                          "one between 1 and 45 inches.")
    if kind in ("truck", "agricultural"):
        part = 0.87 if kind == "truck" else 0.85
        width, height = code * INCH, part * code * INCH
        measuring = (nearest_truck_rim if kind == "truck" else half_inches)(
            (0.75 if kind == "truck" else 0.8) * width)
        words = f"S = the code, H = {part:g} S (estimate)"
    else:
        # the means of 4.00-8, 5.00-8, 6.00-9, 6.50-10, 7.50-16 and 10.00-20; of two
        # codes the first is the width itself
        width = (1.08 if height_code == code else 1) * code * INCH
        height, measuring = 1.05 * height_code * INCH, half_inches(0.75 * height_code * INCH)
        words = ("S = 1.08 of the code" if height_code == code else "S = the first code"
                 ) + ", H = 1.05 of " + ("it" if height_code == code else "the second") \
            + " (estimate)"
    return TireSize(text, kind, is_radial, width, rim + 2 * height, rim, words,
                    measuring, measuring, "0.75 of the code, to half an inch (estimate)"
                    if kind not in ("truck", "agricultural")
                    else "0.75 to 0.8 of the width (estimate)")


def three_part(text, kind, diameter, width, rim, is_radial, prefix):
    """A size by diameter, width and rim in inches, such as 31x10.50R15."""
    if not rim < diameter:
        raise BifaceError(f"the size '{text}' has a rim of {rim:g} inches in a tire of "
                          f"{diameter:g} inches.")
    part = {"": 0.75, "H": 0.65, "B": 0.65, "C": 0.55}[prefix]
    measuring = part * width * INCH
    rule = ("0.65 of the width, the middle of 0.6 to 0.7" if part == 0.65 else
            "0.55 of the width, the middle of 0.5 to 0.6" if part == 0.55 else
            "0.75 of the width, to half an inch") + " (estimate)"
    if not prefix:
        measuring = half_inches(measuring)
    return TireSize(text, kind, is_radial, width * INCH, diameter * INCH, rim * INCH,
                    "as the size says", measuring, measuring, rule)


def bicycle(text, width, rim):
    """A size by width and diameter of the seat, in mm."""
    if not 16 <= width <= 150:
        raise BifaceError(f"the size '{text}' is {width:g} mm wide, but a bicycle tire "
                          "must be 16 to 150 mm wide.")
    if not 100 <= rim <= 700:
        raise BifaceError(f"the size '{text}' has the rim diameter {rim:g} mm, but that of "
                          "a bicycle tire must lie between 100 and 700 mm.")
    measuring = round(0.65 * width)
    return TireSize(text, "bicycle", False, width, rim + 2 * width, rim,
                    "D = d + 2 S (ISO 5775-1)", measuring, measuring,
                    "0.65 of the width (estimate)")


def aircraft(text, name, diameter, width):
    """A size of Type VII by diameter and width in inches; the databook has the rest."""
    rows = find_rows(name)
    if rows:
        row = rows[0]
        return TireSize(text, "aircraft", False, float(row["W_mm"]), float(row["D_mm"]),
                        float(row["rim_diameter_mm"]), "databook, mean of the range",
                        float(row["rim_width_mm"]), float(row["rim_width_mm"]), "databook",
                        databook=rows)
    measuring = 0.795 * width * INCH
    return TireSize(text, "aircraft", False, width * INCH, diameter * INCH, None,
                    "as the size says", measuring, measuring,
                    "0.795 of the width, the mean of the databook")


def parse_size(text, kind=None):
    """The TireSize of a text. kind, one of KINDS, replaces the one that follows from the
    notation. Raises BifaceError with one sentence if the text is not understood."""
    if kind is not None and kind not in KINDS:
        raise BifaceError(f"the kind '{kind}' is not known: it must be one of "
                          f"{', '.join(KINDS)}.")
    words = re.sub(r"\s+", " ", text.upper().replace("×", "X").strip())
    words = re.sub(r"(\d),(\d)", r"\1.\2", words)
    if not words:
        raise BifaceError(f"the size is empty: it must be one such as {EXAMPLES}.")
    size, rest = split(words, text, kind)
    return with_service(size, rest, kind)


def split(words, text, kind):
    """The size by its dimensions, and the words after them."""
    rim = r"(\d{1,2}(?:\.5)?)(?![.\d])"
    if match := re.match(r"(P|LT|ST|T)? ?(\d{2,3})/(\d{2,3}) ?(-|Z?RF? ?|D ?|B ?)? ?"
                         + rim + r" ?(C\b|LT\b)?", words):
        prefix, width, aspect, letter, code, suffix = match.groups()
        rest = words[match.end():]
        is_radial = "R" in (letter or "")
        return metric(text, kind or kind_of_metric(
            prefix, suffix, float(width), float(aspect), float(code), is_radial, rest),
            float(width), float(aspect), float(code) * INCH, is_radial), rest
    if match := re.match(r"(\d{1,2}\.\d)/(\d{2}) ?(-|R) ?" + rim, words):
        width, aspect, letter, code = match.groups()
        return metric(text, kind or "agricultural", float(width) * INCH, float(aspect),
                      float(code) * INCH, letter == "R"), words[match.end():]
    if match := re.match(r"(\d{3}) ?[SHV]?R ?" + rim + r" ?(C\b|LT\b)?", words):
        width, code, suffix = match.groups()
        size = metric(text, kind or ("light truck" if suffix else "passenger"),
                      float(width), 80, float(code) * INCH, True)
        return replace(size, dimensions="D = d + 2 S a/100, a = 80 where none is said "
                                        "(estimate)"), words[match.end():]
    if match := re.match(r"(400|450|500|550|600|650|700) ?X ?(\d{2,3}) ?([ABCD]?)(?![\w.])",
                         words):
        name = match[1] + (match[3] or ("C" if match[1] == "700" else ""))
        if name not in FRENCH:
            letters = [other[-1] for other in FRENCH if other.startswith(match[1])]
            raise BifaceError(f"the size '{text}' needs one of the letters "
                              f"{', '.join(letters)} that name its rim, as in "
                              f"{match[1]}x{match[2]}{letters[-1]}.")
        return bicycle(text, float(match[2]), FRENCH[name]), words[match.end():]
    if match := re.match(r"(\d{2,3})-(\d{3})(?![\d.])", words):
        return bicycle(text, float(match[1]), float(match[2])), words[match.end():]
    if match := re.match(r"([HBC])? ?" + NUMBER + " ?X ?" + NUMBER + " ?(-|R|D) ?" + rim
                         + r" ?(LT\b)?", words):
        prefix, diameter, width, letter, code, _ = match.groups()
        own = ("aircraft" if prefix else "light truck" if letter == "R" else "utility")
        return three_part(text, kind or own, float(diameter), float(width), float(code),
                          letter == "R", prefix or ""), words[match.end():]
    if match := re.match(NUMBER + " ?X ?" + NUMBER + r"(?![\w.])", words):
        diameter, width = match.groups()
        rest = words[match.end():]
        name = f"{float(diameter):g}x{float(width):g}"
        if kind == "aircraft" or kind is None and (find_rows(name) or "PR" in rest):
            return aircraft(text, name, float(diameter), float(width)), rest
        if f"{float(diameter):g}" not in DECIMAL or kind not in (None, "bicycle"):
            raise BifaceError(
                f"the size '{text}' does not say its rim: add it, as in {diameter}x{width}"
                "-15, or a ply rating if this is an aircraft tire.")
        return bicycle(text, float(width) * INCH, DECIMAL[f"{float(diameter):g}"]), rest
    if match := re.match(NUMBER + r"(?:/(\d{1,2}\.\d{2}))? ?(L)? ?(-|R|D) ?" + rim
                         + r" ?(C\b|LT\b)?", words):
        code, second, wide, letter, inches, suffix = match.groups()
        own = ("truck" if inches.endswith(".5") else
               "agricultural" if wide or re.fullmatch(r"\d{1,2}\.\d", code) else
               "light truck" if letter == "R" or suffix else "utility")
        return numeric(text, kind or own, float(code), float(second or code),
                       float(inches) * INCH, letter == "R"), words[match.end():]
    raise BifaceError(f"the size '{text}' is not understood: it must be one such as "
                      f"{EXAMPLES}.")


def kind_of_metric(prefix, suffix, width, aspect, rim, is_radial, rest):
    """The kind of a metric size."""
    if "M/C" in rest or not is_radial and width < 150:
        return "motorcycle"
    if rim % 1 == 0.5:
        return "truck"
    if prefix in ("LT", "ST") or suffix:
        return "light truck"
    if (re.search(r"\d{3} ?(A[1-8]|B|D)\b", rest)
            or rim >= 24 and aspect >= 60):
        return "agricultural"
    return "passenger"


# Words after a size that say nothing about its dimensions
IGNORED = r"TL|TT|TUBELESS|TUBE TYPE|M\+S|M/C|RUN ?FLAT|ROF|SSR|RFT|NHS|TYPE VII|\*+"


def with_service(size, rest, kind):
    """The size with ply rating, load range, load index and speed symbol."""
    found = {}

    def take(pattern, use):
        nonlocal rest
        if match := re.search(pattern, rest):
            rest = rest[:match.start()] + " " + rest[match.end():]
            use(match)

    take(r"(?<!\S)(\d{1,2}) ?-?(PR|PLY RATING|PLY)(?!\S)",
         lambda match: found.update(ply_rating=int(match[1])))
    take(r"(?<!\S)(XL|EXTRA LOAD|REINFORCED|REINF|RF)(?!\S)",
         lambda match: found.update(is_reinforced=True))
    take(r"(?<!\S)(?:LR ?|LOAD RANGE )([A-N])(?!\S)",
         lambda match: found.update(load_range=match[1]))
    take(r"(?<!\S)\(?(\d{1,3})(?:/\d{1,3})? ?(A[1-8]|[A-Z])\)?(?!\S)",
         lambda match: found.update(load_index=int(match[1]), speed_symbol=match[2]))
    take(r"(?<!\S)(\d{2,3})(?:/\d{2,3})?(?!\S)",
         lambda match: found.setdefault("load_index", int(match[1])))
    take(r"(?<!\S)([B-HJL-N])(?!\S)",
         lambda match: found.setdefault("load_range", match[1]))
    rest = re.sub(rf"(?<!\S)({IGNORED})(?!\S)", " ", rest).strip()
    if rest:
        raise BifaceError(f"'{rest}' in the size '{size.text}' is not understood: after "
                          "the dimensions come a ply rating (4PR), a load range (LRC), a "
                          "load index with a speed symbol (91V), XL, TL or TT.")
    if found.get("speed_symbol") and found["speed_symbol"] not in SPEEDS:
        raise BifaceError(f"the speed symbol {found['speed_symbol']} in '{size.text}' is "
                          f"not known: it must be one of {', '.join(SPEEDS)}.")
    if "load_index" in found:
        load_of(found["load_index"])
    if "load_range" in found and found["load_range"] not in LOAD_RANGES:
        raise BifaceError(f"the load range {found['load_range']} in '{size.text}' is not "
                          f"known: it must be one of {', '.join(LOAD_RANGES)}.")
    if found.get("ply_rating", 2) not in range(2, 61):
        raise BifaceError(f"the ply rating in '{size.text}' is {found['ply_rating']}, but "
                          "must lie between 2 and 60.")
    if "load_range" in found:
        found.setdefault("ply_rating", LOAD_RANGES[found["load_range"]])
    size = replace(size, **found)
    return size if kind else replace(size, kind=kind_by_service(size))


def kind_by_service(size):
    """A size of a passenger tire with a ply rating is one of a light truck."""
    if size.kind == "passenger" and size.ply_rating:
        return "light truck"
    return size.kind
