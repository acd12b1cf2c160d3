# Tests that need no build or only the program, and the documentation of the headers.
if(FEMSPH_TESTS)
  find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
  foreach(check arrows style)
    add_test(NAME ${check} COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tests/${check}/run)
    add_test(NAME ${check}.self_test
      COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tests/${check}/run --self-test)
    set_tests_properties(${check} ${check}.self_test PROPERTIES LABELS style)
  endforeach()
  add_test(NAME manual
    COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tests/manual/run $<TARGET_FILE:femsph>)
  add_test(NAME install
    COMMAND ${CMAKE_SOURCE_DIR}/tests/install/run ${CMAKE_BINARY_DIR})
  set_tests_properties(manual install PROPERTIES LABELS program)
endif()

# cmake --build --preset release --target docs: build/release/docs/html. Warnings are errors.
find_program(DOXYGEN doxygen)
if(DOXYGEN)
  configure_file(docs/Doxyfile.in ${CMAKE_BINARY_DIR}/docs/Doxyfile @ONLY)
  add_custom_target(docs COMMAND ${DOXYGEN} ${CMAKE_BINARY_DIR}/docs/Doxyfile
    WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} VERBATIM
    COMMENT "Documenting the headers: ${CMAKE_BINARY_DIR}/docs/html")
endif()
