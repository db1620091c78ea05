# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of text from other programs."""

import codecs
from pathlib import Path

from .errors import BifaceError


def text_of_file(path) -> str:
    """The text of a file in UTF-8, in UTF-16 with a byte order mark, or otherwise in the
    encoding 1252 of Windows. Raises BifaceError if it cannot be read or is not a text."""
    try:
        data = Path(path).read_bytes()
    except OSError as error:
        raise BifaceError(f"{path} cannot be read ({error.strerror}).") from None
    is_utf_16 = data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    for encoding in ("utf-16",) if is_utf_16 else ("utf-8-sig", "cp1252"):
        try:
            text = data.decode(encoding)
        except UnicodeDecodeError:
            continue
        if "\0" not in text:
            return text
    raise BifaceError(f"{path} is not a text file.")
