# SPDX-License-Identifier: LGPL-2.1-or-later

# What `cmake --install` installs, and the package that `cpack` makes of it.
# doc/install.md describes both.

include(CMakePackageConfigHelpers)

set(_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/biface)

# ---- library, programs, headers

set(BIFACE_EXPORTED_TARGETS)
foreach(_build ${BIFACE_BUILD_TYPES})
  string(TOLOWER ${_build} _build_lowercase)
  install(TARGETS libbiface.${_build_lowercase} biface.${_build_lowercase}
    EXPORT bifaceTargets
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  get_target_property(_name libbiface.${_build_lowercase} EXPORT_NAME)
  list(APPEND BIFACE_EXPORTED_TARGETS biface::${_name})
endforeach()
install(DIRECTORY ${CMAKE_SOURCE_DIR}/include/biface
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.h)

# ---- find_package(biface)

install(EXPORT bifaceTargets NAMESPACE biface:: DESTINATION ${_cmake_dir})
configure_package_config_file(source/bifaceConfig.cmake.in
  ${CMAKE_BINARY_DIR}/bifaceConfig.cmake INSTALL_DESTINATION ${_cmake_dir})
# before 1.0 each minor version may change what headers declare
write_basic_package_version_file(${CMAKE_BINARY_DIR}/bifaceConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_BINARY_DIR}/bifaceConfig.cmake
  ${CMAKE_BINARY_DIR}/bifaceConfigVersion.cmake
  DESTINATION ${_cmake_dir})

# ---- manual, completion, pages, examples

install(FILES doc/biface.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES source/completion/biface
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES README.md CHANGELOG.md CITATION.cff LICENSE
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY doc/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/doc
  FILES_MATCHING PATTERN *.md PATTERN *.png PATTERN *.bib
  PATTERN paraview/biface.py PATTERN python/tutorial.py PATTERN python/designs.ipynb
  PATTERN real_tires.py PATTERN radial_tire.py PATTERN bottoming.csv
      PATTERN measured_tires.py PATTERN relaxation.py PATTERN *.tir PATTERN example_page.py
  PATTERN parameters EXCLUDE PATTERN performance EXCLUDE)
install(DIRECTORY prm/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples
  FILES_MATCHING PATTERN *.prm PATTERN *.csv PATTERN *.msh PATTERN *.geo)
# so that the links of the pages lead somewhere
install(FILES source/python/biface_tire/aircraft_tires.csv
  DESTINATION ${CMAKE_INSTALL_DOCDIR}/source/python/biface_tire)
install(CODE "file(CREATE_LINK examples
  \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATAROOTDIR}/doc/biface/prm\" SYMBOLIC)")

# ---- the Debian package

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME biface)
set(CPACK_PACKAGE_VENDOR "The biface authors")
set(CPACK_PACKAGE_CONTACT "The biface authors <biface@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Finite elements for layered shells such as inflated tires in contact with a
rigid plane, drum or sphere, with arbitrarily large displacements and rotations.
Program, library with headers, Python package, and examples.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# the second line is what the Python package, biface-report, biface-rubber,
# biface-tire and biface-tire-model need
string(CONCAT CPACK_DEBIAN_PACKAGE_RECOMMENDS
  "libopenblas0-pthread, openmpi-bin, "
  "python3-numpy, python3-pandas, python3-matplotlib, python3-scipy, libjs-three")
# for those who link the library
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libdeal.ii-dev, cmake, paraview")
include(CPack)
