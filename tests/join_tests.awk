# SPDX-License-Identifier: LGPL-2.1-or-later

# Joins tests NAME.cc into one source: their includes first, then each test in the
# namespace test_NAME, its main() with arguments and a result.
#   awk -f tests/join_tests.awk NAME.cc ...

FNR == 1 {
  if (NR > 1)
    text = text "}\n"
  name = FILENAME
  sub(".*/", "", name)
  sub("[.]cc$", "", name)
  text = text "namespace test_" name "\n{\n#line 1 \"" FILENAME "\"\n"
}

/^#include/ {
  if (!($2 in included))
    print
  included[$2] = 1
  $0 = ""
}

/^main\(/ {
  sub(/\(\)/, "(int, char **)")
  in_main = 1
}

# flowing off the end is a privilege of ::main()
/^}/ && in_main {
  $0 = "  return 0; }"
  in_main = 0
}

{ text = text $0 "\n" }

END { print text "}" }
