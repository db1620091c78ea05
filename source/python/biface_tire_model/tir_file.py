# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tire property files, .tir: sections of entries, in the Orbit format.

Values are those of the file in SI units. Angles among the entries, such as ALPMIN, become
radians; the coefficients of the Magic Formula belong to radians whatever [UNITS] says.
"""

from __future__ import annotations

import math
import re
from pathlib import Path

from biface.errors import BifaceError
from biface.text_file import text_of_file
from . import units
from .coefficients import ALIASES, COEFFICIENTS, CONSTANTS
from .magic_formula import MF52, MF61, MagicFormula

# The formula by FITTYP
FITTYP = {5: MF52, 6: MF52, 21: MF52, 52: MF52, 60: MF61, 61: MF61, 62: MF61}

# Formats with the equations of MF 5.2, for files without FITTYP
FORMATS = {"PAC2002": MF52, "MF_05": MF52}

# Formats with other equations, whatever FITTYP says
OTHER_FORMATS = ("PAC89", "PAC94", "PAC_MC", "PAC-MC", "PAC-TIME", "PAC_TIME", "FIALA", "UA",
                 "5.2.1", "521_EQUATION", "FTIRE")

# Powers of length, force, time, angle, mass and pressure in entries that have units
_LENGTH, _FORCE, _TIME, _ANGLE, _MASS, _PRESSURE = (
    tuple(int(i == j) for j in range(6)) for i in range(6))
_VELOCITY = (1, 0, -1, 0, 0, 0)
_STIFFNESS = (-1, 1, 0, 0, 0, 0)
_DAMPING = (-1, 1, 1, 0, 0, 0)
_INERTIA = (2, 0, 0, 0, 1, 0)
DIMENSIONS = {
    **dict.fromkeys(("UNLOADED_RADIUS", "WIDTH", "RIM_RADIUS", "RIM_WIDTH",
                     "BOTTOMING_RADIUS", "BOTTOM_OFFST", "ROAD_INCREMENT",
                     "ELLIPS_MAX_STEP"), _LENGTH),
    **dict.fromkeys(("FNOMIN", "FZMIN", "FZMAX"), _FORCE),
    **dict.fromkeys(("LONGVL", "VXLOW"), _VELOCITY),
    **dict.fromkeys(("ALPMIN", "ALPMAX", "CAMMIN", "CAMMAX"), _ANGLE),
    **dict.fromkeys(("INFLPRES", "NOMPRES", "IP", "IP_NOM", "PRESMIN", "PRESMAX"),
                    _PRESSURE),
    **dict.fromkeys(("VERTICAL_STIFFNESS", "BOTTOM_STIFF", "LONGITUDINAL_STIFFNESS",
                     "LATERAL_STIFFNESS"), _STIFFNESS),
    "VERTICAL_DAMPING": _DAMPING,
    "YAW_STIFFNESS": (1, 1, 0, -1, 0, 0),
    **dict.fromkeys(("MASS", "BELT_MASS", "MBELT"), _MASS),
    **dict.fromkeys(("IXX", "IYY", "BELT_IXX", "BELT_IYY"), _INERTIA),
    "GRAVITY": (1, 0, -2, 0, 0, 0),
    **dict.fromkeys(("FREQ_LONG", "FREQ_LAT", "FREQ_YAW", "FREQ_WINDUP"),
                    (0, 0, -1, 0, 0, 0)),
    "HMAX_LOCAL": _TIME,
    "TIME_SWITCH_INTEG": _TIME,
}

# Constants that may be empty as well as missing
OPTIONAL = ("UNLOADED_RADIUS", "LONGVL", "INFLPRES", "NOMPRES")

# Numbers without a unit
RATIOS = ("USE_MODE", "KPUMIN", "KPUMAX")

# Those of the columns of tables
TABLES = {"DEFLECTION_LOAD_CURVE": {"PEN": _LENGTH, "FZ": _FORCE},
          "BOTTOMING_CURVE": {"PEN": _LENGTH, "FZ": _FORCE}}

# Where a tire may be mounted
SIDES = ("LEFT", "RIGHT")

# What the program writes
SI_UNITS = {"LENGTH": "meter", "FORCE": "newton", "ANGLE": "radians", "MASS": "kg",
            "TIME": "second"}

# What begins a line of comments
COMMENTS = ("$", "!", "#", "%", ";", "//", "/*", "**")

_SECTION = re.compile(r"\[\s*([^\]]*?)\s*\]\s*((?:[$!#;%]|//).*)?$")
_ENTRY = re.compile(r"([^=\s]+)\s*=\s*(.*)$")
_QUOTED = re.compile(r"(['\"])(.*?)\1\s*((?:[$!#;%]|//).*)?$")
_MARK = re.compile(r"[$!]|(?<=\s)(?:[#;]|//)")


class Section:
    """A section of a file.

    name      in capitals
    entries   values by names in capitals: numbers or text
    comments  the comments behind them, by the same names, without $ or !
    remarks   lines of comments in the section
    columns   the names of the columns of a table, in capitals; empty if it has none
    rows      the numbers of the table, a tuple for each row; empty without one
    places    the lines of the entries in the file
    """

    def __init__(self, name):
        self.name = name
        self.entries, self.comments, self.places = {}, {}, {}
        self.remarks, self.columns, self.rows = [], (), []

    def __eq__(self, other):
        return (isinstance(other, Section) and self.name == other.name
                and self.entries == other.entries and self.columns == other.columns
                and self.rows == other.rows and self.comments == other.comments)

    def set(self, name, value, comment=""):
        """Adds or changes an entry."""
        self.entries[name] = value
        if comment:
            self.comments[name] = comment

    def text(self):
        """The section as text."""
        lines = [f"${self.name.lower():->76}", f"[{self.name}]"]
        lines += [f"! {remark}".rstrip() for remark in self.remarks]
        for name, value in self.entries.items():
            value = f"'{value}'" if isinstance(value, str) else shortest(value)
            comment = self.comments.get(name)
            lines.append(f"{name:24} = {value:20}{f' ${comment}' if comment else ''}"
                         .rstrip())
        if self.columns:
            lines.append("{" + " ".join(self.columns).lower() + "}")
        if self.rows:
            lines += [" ".join(f"{shortest(value):>12}" for value in row)
                      for row in self.rows]
        return "\n".join(lines) + "\n"


class TirFile:
    """A tire property file.

    sections  a dictionary of Section by name, in the order of the file
    remarks   lines of comments before the first section
    path      where it was read from, for messages
    """

    def __init__(self, sections=None, remarks=(), path="the file"):
        self.sections = dict(sections or {})
        self.remarks, self.path = list(remarks), path

    def __eq__(self, other):
        return isinstance(other, TirFile) and self.sections == other.sections

    def section(self, name):
        """A section, made if there is none."""
        return self.sections.setdefault(name, Section(name))

    def find(self, name, otherwise=None):
        """The value of an entry of any section but [UNITS], or of one of the other
        names it has in ALIASES."""
        names = [name, *(alias for alias, target in ALIASES.items() if target == name)]
        for section in self.sections.values():
            for known in names:
                if section.name != "UNITS" and known in section.entries:
                    return section.entries[known]
        return otherwise

    def check_unique(self, names):
        """Raises BifaceError if two sections, or two names of the same, give an entry
        different values. @p names are those in MF 6.1."""
        found = {}
        for section in self.sections.values():
            for name, value in section.entries.items():
                target = ALIASES.get(name, name)
                if section.name == "UNITS" or target not in names or value == "":
                    continue
                other, section_name, first = found.setdefault(
                    target, (name, section.name, value))
                if value != first:
                    raise BifaceError(
                        f"{self.path}: {other} in [{section_name}] is {first:g}, but {name} "
                        f"in [{section.name}] is {value:g}: only one of them can hold.")

    def find_number(self, name, otherwise=None):
        """The value of an entry if it is a number."""
        value = self.find(name)
        return otherwise if value is None or isinstance(value, str) else value

    @property
    def is_mirrored(self):
        """Whether USE_MODE tells to take the tire as its mirror image."""
        return self.find_number("USE_MODE", 0) < 0

    def not_numbers(self):
        """The entries that should be numbers and are none; no formula uses them."""
        return [name for section in self.sections.values() if section.name != "UNITS"
                for name, value in section.entries.items()
                if value == "" or name in DIMENSIONS and isinstance(value, str)]

    def coefficients(self) -> dict[str, float]:
        """The coefficients of the Magic Formula and the constants it needs that the file
        has, by their names in MF 6.1."""
        found = {name: self.find_number(name) for name in (*CONSTANTS, *COEFFICIENTS)}
        return {name: value for name, value in found.items() if value is not None}

    def formula_class(self) -> type[MagicFormula]:
        """Which formula the file belongs to, by FITTYP or PROPERTY_FILE_FORMAT. Raises
        BifaceError for others."""
        fit_type, kind = self.find("FITTYP"), self.find("PROPERTY_FILE_FORMAT")
        if fit_type is not None:
            if str(kind).upper() in OTHER_FORMATS:
                raise BifaceError(f"{self.path}: PROPERTY_FILE_FORMAT is '{kind}', whose "
                                  "equations are not those of MF 5.2 or MF 6.1.")
            if fit_type not in FITTYP:
                raise BifaceError(f"{self.path}: FITTYP is {shortest(fit_type)}, but must "
                                  f"be {units.one_of(map(str, FITTYP))}.")
            return FITTYP[fit_type]
        if kind is None:
            raise BifaceError(f"{self.path} does not tell its formula: [MODEL] needs "
                              "FITTYP, or PROPERTY_FILE_FORMAT = 'PAC2002'.")
        if str(kind).upper() not in FORMATS:
            raise BifaceError(f"{self.path}: PROPERTY_FILE_FORMAT is '{kind}', but must be "
                              f"{units.one_of(FORMATS)} in a file without FITTYP.")
        return FORMATS[str(kind).upper()]

    def formula(self, starred: bool = False) -> MagicFormula:
        """The Magic Formula with the coefficients of the file; @p starred as in
        MagicFormula. USE_MODE below 0 mirrors the tire. Raises BifaceError if it is another
        formula, if FNOMIN is missing, or if an entry has two values."""
        kind = self.formula_class()
        self.check_unique({*CONSTANTS, *COEFFICIENTS})
        try:
            return kind(self.coefficients(), starred, self.is_mirrored)
        except BifaceError as error:
            raise BifaceError(f"{self.path}: {error}") from None

    def side(self):
        """The side of the vehicle that the tire was measured for, LEFT by default."""
        return str(self.find("TYRESIDE", "LEFT")).upper()

    def text(self) -> str:
        """The file as text, in SI units."""
        return ("".join(f"! {remark}".rstrip() + "\n" for remark in self.remarks)
                + "".join(section.text() for section in self.sections.values()))

    def write(self, path):
        """Writes the file, in SI units."""
        Path(path).write_text(self.text(), encoding="utf-8")


def shortest(value):
    """A number with the fewest digits that give it again."""
    return str(int(value)) if value == int(value) and abs(value) < 1e15 else repr(value)


def read_tir(path) -> TirFile:
    """Reads a .tir file. Raises BifaceError with file, line and entry if it is not
    well-formed or has units that are not known."""
    return parse(text_of_file(path), str(path))


def parse(text, path="the file") -> TirFile:
    """The file with a text; @p path is for messages."""
    result, section = TirFile(path=path), None
    for number, line in enumerate(text.splitlines(), 1):
        line, place = line.strip(), f"{path}, line {number}"
        if not line:
            continue
        if line.startswith(COMMENTS):
            (section or result).remarks.extend(remark(line))
        elif line[0] == "[":
            section = begin_section(result, line, place)
        elif section is None and "=" not in line and line[0] != "{":
            result.remarks.append(line)
        elif section is None:
            raise BifaceError(f"{place}: '{line}' stands before the first section.")
        elif line[0] == "{":
            begin_table(section, line, place)
        elif section.columns and "=" not in without_comment(line) \
                or is_row(without_comment(line)):
            add_row(section, line, place)
        else:
            add_entry(section, line, number, place)
    if not result.sections:
        raise BifaceError(f"{path} has no section, such as [MODEL].")
    convert(result)
    return result


def remark(line):
    """The text of a line of comments; none of a mere separator."""
    text = line.lstrip("$!#%;/*").strip()
    return [] if re.match(r"\W-", line) or not text else [text]


def without_comment(text):
    """Text up to a $ or !, or a #, ; or // behind a blank."""
    return _MARK.split(text, maxsplit=1)[0].strip()


def begin_section(result, line, place):
    """A section of the file, which may have begun before."""
    match = _SECTION.match(line)
    if not match or not match.group(1):
        raise BifaceError(f"{place}: '{line}' is not a section, such as [MODEL].")
    return result.section(match.group(1).upper())


def begin_table(section, line, place):
    """The line of a section that names the columns of a table."""
    match = re.match(r"\{([^}]*)\}", line)
    if not match or not match.group(1).split():
        raise BifaceError(f"{place}: '{line}' does not name columns, as {{pen fz}} does.")
    if section.columns:
        raise BifaceError(f"{place}: the section [{section.name}] has a second table.")
    section.columns = tuple(match.group(1).upper().split())


def is_row(text):
    """Whether a line has numbers only, as those of a table whose columns have no names."""
    try:
        return bool([float(word) for word in text.split()])
    except ValueError:
        return False


def add_row(section, line, place):
    """A row of the table of a section."""
    words = without_comment(line).split()
    count = len(section.columns or (section.rows or [words])[0])
    if len(words) != count:
        raise BifaceError(f"{place}: the row has {len(words)} numbers where {count} columns "
                          f"are {'named' if section.columns else 'above'}.")
    columns = section.columns or range(1, count + 1)
    section.rows.append(tuple(
        finite(word, f"{place}: the column {column} of [{section.name}]")
        for column, word in zip(columns, words)))


def add_entry(section, line, number, place):
    """A line with an entry."""
    match = _ENTRY.match(line)
    if not match:
        raise BifaceError(f"{place}: '{line}' is neither an entry, such as LCX = 1, nor a "
                          "section nor a comment.")
    name, text = match.group(1).upper(), match.group(2)
    quoted = _QUOTED.match(text)
    if text[:1] in ("'", '"') and not quoted:
        raise BifaceError(f"{place}: the text of {name} has no closing quote.")
    value = value_of(section, name, quoted, text, place)
    if section.entries.get(name, value) != value:
        raise BifaceError(f"{place}: {name} occurs twice in [{section.name}], with different "
                          "values.")
    comment = quoted.group(3) if quoted else text[len(_MARK.split(text)[0]):]
    section.set(name, value, (comment or "").lstrip("$!#;%/").strip())
    section.places[name] = number


def is_number(section, name):
    """Whether an entry must be a number, since a formula uses it."""
    name = ALIASES.get(name, name)
    return section.name != "UNITS" and (name in COEFFICIENTS or name in CONSTANTS
                                        or name == "FITTYP")


def value_of(section, name, quoted, value, place):
    """The value of an entry: text in quotes, or else a number if it is one."""
    word = quoted.group(2).strip() if quoted else without_comment(value)
    if is_number(section, name) and not (
            word == "" and ALIASES.get(name, name) in OPTIONAL):
        return finite(word, f"{place}: {name}")
    if quoted and name not in DIMENSIONS and name not in RATIOS:
        return word
    try:
        number = float(fortran(word))
    except ValueError:
        return word
    return number if math.isfinite(number) else word


def fortran(word):
    """A number whose exponent may have the letter D."""
    return re.sub("[dD]", "e", word) if re.fullmatch(r"[-+.\ddD]+", word) else word


def finite(word, what):
    """A finite number."""
    try:
        value = float(fortran(word))
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        form = "a number with a decimal point" if "," in word else "a number"
        raise BifaceError(f"{what} is '{word}', but must be {form}.")
    return value


def convert(file):
    """Changes the values of a file to SI units."""
    section = file.sections.get("UNITS")
    if section is None:
        return
    sizes = {"LENGTH": 1, "FORCE": 1, "TIME": 1, "ANGLE": 1, "MASS": 1, "PRESSURE": 1}
    for name, value in section.entries.items():
        place = f"{file.path}, line {section.places[name]}"
        if name == "TEMPERATURE":
            continue
        if name not in sizes:
            raise BifaceError(f"{place}: [UNITS] has the entry {name}, but only has "
                              f"{units.one_of(sizes)}.")
        sizes[name] = units.factor(units.OF_FILE[name], str(value), f"{place}: {name}")
    if "PRESSURE" not in section.entries:
        sizes["PRESSURE"] = sizes["FORCE"] / sizes["LENGTH"] ** 2

    def size(dimension):
        return math.prod(unit ** power for unit, power in zip(sizes.values(), dimension))

    for other in file.sections.values():
        if other is section:
            continue
        for name, value in other.entries.items():
            if name in DIMENSIONS and not isinstance(value, str):
                other.entries[name] = value * size(DIMENSIONS[name])
        if not other.columns:
            continue
        factors = [size(TABLES.get(other.name, {}).get(column, (0,) * 6))
                   for column in other.columns]
        other.rows = [tuple(value * unit for value, unit in zip(row, factors))
                      for row in other.rows]
    section.entries = {**SI_UNITS, **({"PRESSURE": "pascal"}
                                      if "PRESSURE" in section.entries else {})}
