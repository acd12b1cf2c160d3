# Contents of `cmake --install build/release --prefix DIR` and of the package by `cpack`. The program finds
# its studies relative to itself (../share/femsph/studies), so the folder may be moved.
#   bin/femsph   lib/femsph/ (modules)   share/femsph/{studies,scenes}   share/man   share/bash-completion
#                share/doc
include(GNUInstallDirs)
set(femsph_docs ${CMAKE_INSTALL_DATAROOTDIR}/doc/femsph)

install(TARGETS femsph RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
# Shared objects that the program loads on demand; FEMSPH_MODULES lists their targets.
get_property(modules GLOBAL PROPERTY FEMSPH_MODULES)
foreach(module ${FEMSPH_MODULES} ${modules})
  install(TARGETS ${module} LIBRARY DESTINATION lib/femsph RUNTIME DESTINATION lib/femsph)
endforeach()

install(DIRECTORY studies DESTINATION ${CMAKE_INSTALL_DATADIR}/femsph PATTERN run EXCLUDE)
install(DIRECTORY tests/scenes/ DESTINATION ${CMAKE_INSTALL_DATADIR}/femsph/scenes
  FILES_MATCHING PATTERN cantilever.toml PATTERN bad EXCLUDE)
install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION ${femsph_docs})
install(DIRECTORY docs/ DESTINATION ${femsph_docs}/docs
  FILES_MATCHING PATTERN *.md PATTERN *.png PATTERN *.toml)
foreach(room model/scene model/material model/motion model/results sph)
  install(FILES ${room}/README.md DESTINATION ${femsph_docs}/${room})
endforeach()

# The program writes its manual page and the completion of bash.
set(manual ${CMAKE_BINARY_DIR}/generated/femsph.1)
set(completion ${CMAKE_BINARY_DIR}/generated/femsph.bash)
add_custom_command(OUTPUT ${manual} ${completion}
  COMMAND femsph manual > ${manual}
  COMMAND femsph manual --completion bash > ${completion}
  DEPENDS femsph COMMENT "Writing the manual page")
add_custom_target(manual ALL DEPENDS ${manual} ${completion})
install(FILES ${manual} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${completion} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME femsph)

# cpack -G DEB --config build/release/CPackConfig.cmake. Configure with -DFEMSPH_ARCH=x86-64-v2 for
# packages that run on other machines.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME femsph)
set(CPACK_PACKAGE_CONTACT "the owner of femsph")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # libraries that the program and its modules link
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS gnuplot-nox) # figures of studies
include(CPack)
