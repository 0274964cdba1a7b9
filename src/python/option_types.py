# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the types of the options of the Python module, of their table.

    option_types.py PROGRAM FILE
"""

import json
import subprocess
import sys

HEAD = '''\
# SPDX-License-Identifier: GPL-3.0-or-later
# Made by option_types.py of the table of options.
from os import PathLike
from typing import Any, Mapping, Sequence, TypedDict, Union

Text = Union[str, float, bool, "PathLike[str]", Sequence[Union[str, float]]]
'''

KINDS = {"boolean": "bool", "number": "float", "integer": "int", "duration": "Union[str, float]",
         "size": "Union[str, int]", "choice": "str"}


def type_of(row):
    if row["long"] == "declare":
        return "Union[Mapping[str, Any], str, Sequence[str]]"
    if row["long"] == "antialias":
        return "Union[bool, float]"
    return KINDS.get(row["type"], "Text")


def main(program, path):
    table = subprocess.run([program, "--describe", "json", "options"], capture_output=True, check=True).stdout
    # The functions take a callback of this name.
    rows = [row for row in json.loads(table) if row.get("long", "progress") != "progress"]
    text = HEAD
    for name, groups in (("FilmOptions", ("film",)), ("Options", None)):
        text += f"\nclass {name}(TypedDict, total=False):\n"
        for row in rows:
            if groups is None or row["group"] in groups or row["long"] == "threads":
                text += f"    {row['long'].replace('-', '_')}: {type_of(row)}\n"
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


main(*sys.argv[1:])
