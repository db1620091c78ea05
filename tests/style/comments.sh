#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later

# A comment on an interface stands alone, also as a tooltip: it does not begin
# with a word that refers to what the header says before.
#   comments.sh [FILE...]

set -eu
cd "$(dirname "$0")/../.."
# shellcheck disable=SC2046
[ $# -gt 0 ] || set -- $(find include -name '*.h')
awk '
  # the text of a line without what marks it as a comment
  function text(line)
  {
    sub(/^.*\/\*\*[ \t]*/, "", line)
    sub(/^[ \t]*(\/\/\/|\*)[ \t]*/, "", line)
    return line
  }
  FNR == 1 { in_lines = expected = 0 }
  {
    starts = ($0 ~ /\/\*\*($|[ \t])/)
    is_line = ($0 ~ /^[ \t]*\/\/\//)
    if (starts || (is_line && !in_lines))
      expected = 1
    in_lines = is_line
    words = text($0)
    if (!expected || words == "")
      next
    expected = 0
    if (words ~ /^(Of|By|In|As|See|Likewise|Those|These|That of|The same|Their|Its|It|They|Then)([^A-Za-z_:(]|$)/)
      {
        print FILENAME ":" FNR ": " words
        failed = 1
      }
  }
  END {
    if (failed)
      print "Say in these comments what the thing is, without what stands before."
    exit failed
  }' "$@" >&2
