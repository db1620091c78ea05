#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later

# Headers are included in one direction only: each folder of include/biface/
# and source/ may include its own headers and those of the folders listed for
# it here. See doc/architecture.md.

set -eu
cd "$(dirname "$0")/.."

may_include()
{
  case $1 in
    base) echo ;;
    input) echo base ;;
    surface | laminate | contact) echo base input ;;
    element) echo base input surface laminate ;;
    model) echo base input surface laminate contact element ;;
    solver) echo "$(may_include model) model" ;;
    stepping) echo "$(may_include solver) solver" ;;
    output) echo "$(may_include stepping) stepping" ;;
    restart) echo "$(may_include output) output" ;;
    problem) echo "$(may_include restart) restart" ;;
    analysis) echo "$(may_include problem) problem" ;;
    study) echo "$(may_include analysis) analysis" ;;
    program) echo "$(may_include study) study" ;;
    *) return 1 ;;
  esac
}

# the rooms of model, likewise
may_include_in_model()
{
  case $1 in
    mesh) echo ;;
    state) echo mesh ;;
    air) echo mesh state ;;
    forces) echo mesh state air ;;
    contact) echo mesh state air forces ;;
    equations) echo mesh state air forces contact ;;
    quantities) echo mesh state air forces contact equations ;;
    heat | time) echo mesh state air forces contact equations quantities ;;
    *) return 1 ;;
  esac
}

failed=0
complain()
{
  echo "$1" >&2
  failed=1
}

# check_folders PARENT RULE: that the folders in include/biface/PARENT and
# source/PARENT include each other only as RULE allows
check_folders()
{
  for path in include/biface/"$1"*/ source/"$1"*/; do
    folder=$(basename "$path")
    # not C++
    case $folder in completion | python) continue ;; esac
    allowed=$("$2" "$folder") || {
      complain "$path: no folder of this name is known; tell $0 its place."
      continue
    }
    # lines of the form file:included_folder
    # shellcheck disable=SC2013
    for line in $(grep -rH "^ *# *include *[<\"]biface/$1" "$path" |
      sed "s|^\([^:]*\):[^<\"]*[<\"]biface/$1\([^/]*\)/.*|\1:\2|"); do
      included=${line#*:}
      case " $folder $allowed " in
        *" $included "*) ;;
        *) complain "${line%:*} includes a header of $included, but $folder may include only: $folder $allowed" ;;
      esac
    done
  done
}

check_folders "" may_include
check_folders model/ may_include_in_model

# units, headers with their sources, do not include each other in circles
circles=$(grep -rHo '^# *include *<biface/[^>]*>' include/biface source |
  sed 's,^include/biface/,,; s,^source/,,; s,\.[a-z]*:.*<biface/\(.*\)\.h>, \1,' |
  sort -u | tsort 2>&1 >/dev/null | grep -v 'contains a loop' || true)
[ -z "$circles" ] || complain "These include each other in circles: $circles"

# main.cc uses the folder program only
if grep -H '#include <biface/' source/main.cc | grep -v '<biface/program/'; then
  complain "source/main.cc may include headers of program only."
fi
exit $failed
