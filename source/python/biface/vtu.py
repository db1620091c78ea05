# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the arrays of a VTU file of biface, without VTK."""

import base64
import re
import zlib

import numpy as np

from .errors import BifaceError
from .tables import read_text

TYPES = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "UInt32": "<u4",
         "Int64": "<i8", "UInt64": "<u8", "UInt8": "u1", "Int8": "i1"}
# Arrays with values of cells; all others have them at points
OF_CELLS = ("connectivity", "offsets", "types")


class Arrays(dict):
    """The arrays of a file by name. One that is missing is an error of the file."""

    def __init__(self, path, arrays):
        super().__init__(arrays)
        self.path = path

    def __missing__(self, name):
        raise BifaceError(f"{self.path} is damaged: it has no array {name}.")


def read_vtu(path):
    """The arrays of all pieces by name, 'Points' for the positions; the numbers of
    points in 'connectivity' count through all pieces."""
    parts, n_points = {}, 0
    text_of_file = read_text(path)
    if not text_of_file.rstrip().endswith("</VTKFile>"):
        raise BifaceError(f"{path} is damaged: it is cut off.")
    for piece in re.findall(r"<Piece.*?</Piece>", text_of_file, re.DOTALL):
        n = 0
        for attributes, text in re.findall(
                r"<DataArray([^>]*)>(.*?)</DataArray>", piece, re.DOTALL):
            values = dict(re.findall(r'(\w+)\s*=\s*"([^"]*)"', attributes))
            name = values.get("Name", "Points")
            array = decode(text.strip(), TYPES[values["type"]],
                           values.get("format"), path)
            count = int(values.get("NumberOfComponents", 1))
            if count > 1:
                array = array.reshape(-1, count)
            if name == "Points":
                n = len(array)
            if name == "connectivity":
                array = array + n_points
            parts.setdefault(name, []).append(array)
        n_points += n
    result = Arrays(path, {name: np.concatenate(arrays)
                           for name, arrays in parts.items()})
    count, cells = len(result["Points"]), result["connectivity"]
    if (not np.isfinite(result["Points"]).all()
            or ((cells < 0) | (cells >= count)).any()
            or any(len(array) != count for name, array in result.items()
                   if name not in OF_CELLS)):
        raise BifaceError(f"{path} is damaged: its arrays do not fit together.")
    return result


def decode(text, kind, layout, path):
    """The numbers of an array: as text, or compressed in blocks."""
    if layout == "ascii":
        return np.array(text.split(), dtype=kind)
    try:
        head = np.frombuffer(base64.b64decode(text[:8])[:4], "<u4")[0]
        # numbers of blocks and bytes, then the compressed bytes of each block
        length = -(-4 * (3 + int(head)) // 3) * 4
        sizes = np.frombuffer(base64.b64decode(text[:length]), "<u4")[3:3 + head]
        data = base64.b64decode(text[length:])
        ends = np.cumsum(sizes)
        return np.frombuffer(
            b"".join(zlib.decompress(data[end - size:end])
                     for size, end in zip(sizes, ends)), kind)
    except (ValueError, IndexError, zlib.error):
        raise BifaceError(f"{path} is damaged: an array cannot be decoded.") \
            from None


def corners(data):
    """The points of each quadrilateral, one per row, in their order around it."""
    return data["connectivity"].reshape(-1, 4).astype(int)
