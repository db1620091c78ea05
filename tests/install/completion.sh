#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later

# Bash completes options, parameter files, and entries, with or without a quote.
#   completion.sh SOURCE_DIRECTORY PROGRAM

set -eu
source=$1
program=$2
. "$source/source/completion/biface"
compopt() { :; } # is for bash's own calls

# expect REPLIES WORD...: what the last word is completed to
expect()
{
  local expected=$1 last
  shift
  COMP_WORDS=(biface "$@")
  COMP_CWORD=$#
  last=${!#}
  # bash passes a word without its quote
  _biface "$program" "${last#[\"\']}" "${COMP_WORDS[COMP_CWORD - 1]}"
  [ "$(printf '%s|' "${COMPREPLY[@]}")" = "$expected|" ] || {
    printf "%s is completed to: %s\n" "$last" "${COMPREPLY[*]}" >&2
    exit 1
  }
}

cd "$source/prm"
expect "Stage 1/Pressure=" --set '"Stage 1/Pres'
expect 'Stage\ 1/Pressure=' --set 'Stage\ 1/Pres'
expect "Contact/Tread/Height=|Contact/Tread/Modulus=|Contact/Tread/Void ratio=" \
  --set "'Contact/Tread/"
# the second stage is that of the file
expect "" --set '"Stage 2/Trav'
expect "Stage 2/Travel=" bias_tire.prm --set '"Stage 2/Trav'
expect "--print-parameters" --pr
expect "roll_up.prm" roll_
