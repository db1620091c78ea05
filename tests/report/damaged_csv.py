# SPDX-License-Identifier: LGPL-2.1-or-later

# A damaged CSV file is reported by one sentence that names file and line.

from report_test import check, complaint, copy_of, require

require("matplotlib")


def complaint_after(name, change):
    """What is said once the text of a file is changed."""
    directory = copy_of("bias_tire")
    path = directory / name
    text = path.read_text()
    changed = change(text)
    check(changed != text, f"{name} is unchanged")
    path.write_text(changed)
    return complaint(directory)


def without_field(text):
    lines = text.split("\n")
    lines[2] = lines[2].rsplit(",", 1)[0]
    return "\n".join(lines)


for file, change, words in (
        ("history.csv", without_field, "history.csv, line 3, is damaged"),
        ("history.csv", lambda text: text.replace("inflation,0,", "inflation,O,"),
         "'O' in the column 'approach' is not a number"),
        ("history.csv", lambda text: text.split("\n")[0] + "\n", "has no step"),
        ("history.csv", lambda text: text.replace("force", "strength"),
         "does not name the column 'force'"),
        ("contact-0005.csv", without_field, "contact-0005.csv, line 3, is damaged"),
        ("contact-0005.csv", lambda text: text[:-5], "last line is cut off"),
        ("contact-0005.csv", lambda text: text.split("\n")[0] + "\n",
         "does not belong to history.csv"),
        ("profile-0005.csv", without_field, "profile-0005.csv, line 3, is damaged")):
    sentence = complaint_after(file, change)
    check(words in sentence, f"'{words}' is not in: {sentence}")
