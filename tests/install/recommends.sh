#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later

# The Debian package recommends every package that `doc/install.sh report`
# installs for biface-report.
#   recommends.sh BUILD_DIRECTORY

set -eu
recommends=$(sed -n 's/^set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "\(.*\)")$/\1/p' \
  "$1/CPackConfig.cmake")
needed=$(sed -n 's/.*report="\(.*\)"$/\1/p' "$(dirname "$0")/../../doc/install.sh" |
  tr ' ' '\n')
[ "$(echo "$needed" | wc -l)" -ge 3 ]
for package in $needed; do
  case ", $recommends," in
    *", $package,"*) ;;
    *)
      echo "$package is missing in: $recommends" >&2
      exit 1
      ;;
  esac
done
