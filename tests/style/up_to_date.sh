#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later

# A generated page is what its script generates now.
#   up_to_date.sh PYTHON SCRIPT PROGRAM PAGE

set -eu
page=$(mktemp)
trap 'rm -f "$page"' EXIT
"$1" "$2" "$3" "$page"
diff "$4" "$page" || {
  echo "$4 is out of date: cmake --build build --target reference" >&2
  exit 1
}
