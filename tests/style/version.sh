#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later

# The version in CMakeLists.txt is the one in CITATION.cff and CHANGELOG.md.
#   version.sh VERSION

set -eu
cd "$(dirname "$0")/../.."
failed=0
complain()
{
  echo "$1 has no line '$2', but the version of CMakeLists.txt is $3." >&2
  failed=1
}
grep -qx "version: $1" CITATION.cff || complain CITATION.cff "version: $1" "$1"
grep -q "^## \[$1\]" CHANGELOG.md || complain CHANGELOG.md "## [$1]" "$1"
exit $failed
