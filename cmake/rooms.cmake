# A room is a folder that is built as one static library, which links the rooms below it and no others: a call
# of a room above does not link. (tests/arrows/run checks the includes of headers too.)
#   femsph_room(NAME FOLDER [HURRIED] [FUZZED] [EXCEPT source..] [APART source..] [USES library..]
#     BELOW room..)
# NAME becomes the target femsph_NAME. HURRIED: it computes no results and is compiled with -O1. FUZZED: it
# is instrumented for the fuzzing targets. EXCEPT: sources that belong to a program. APART: sources that are
# never joined with others in one translation unit. USES: libraries that only this room may use. The rooms of
# a top folder are listed in the global property FEMSPH_ROOMS_<top folder>.
function(femsph_room name folder)
  cmake_parse_arguments(room "HURRIED;FUZZED" "" "EXCEPT;APART;USES;BELOW" ${ARGN})
  get_filename_component(root ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/.. ABSOLUTE)
  file(GLOB sources CONFIGURE_DEPENDS ${root}/${folder}/*.cpp)
  foreach(source ${room_EXCEPT})
    list(REMOVE_ITEM sources ${root}/${folder}/${source})
  endforeach()
  list(TRANSFORM room_APART PREPEND ${root}/${folder}/)
  if(room_APART)
    file(GLOB apart CONFIGURE_DEPENDS ${room_APART})
    set_source_files_properties(${apart} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
  list(TRANSFORM room_BELOW PREPEND femsph_)
  if(sources)
    add_library(femsph_${name} STATIC ${sources})
    target_link_libraries(femsph_${name} PUBLIC femsph_flags fmt::fmt ${room_BELOW} PRIVATE ${room_USES})
    if(room_HURRIED)
      target_compile_options(femsph_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
    endif()
    if(room_FUZZED AND FEMSPH_FUZZ)
      target_compile_options(femsph_${name} PRIVATE -fsanitize=fuzzer-no-link)
    endif()
  else() # headers only
    add_library(femsph_${name} INTERFACE)
    target_link_libraries(femsph_${name} INTERFACE femsph_flags ${room_BELOW})
  endif()
  string(REGEX REPLACE "/.*" "" top ${folder})
  set_property(GLOBAL APPEND PROPERTY FEMSPH_ROOMS_${top} femsph_${name})
endfunction()

# A module is a shared object that the program loads on demand (model/numerics/module.hpp): libfemsph_NAME.so,
# beside the programs. It links no room: it uses the symbols of the program that loads it.
#   femsph_module(NAME FOLDER [USES library..])
function(femsph_module name folder)
  cmake_parse_arguments(module "" "" "USES" ${ARGN})
  get_filename_component(root ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/.. ABSOLUTE)
  file(GLOB sources CONFIGURE_DEPENDS ${root}/${folder}/*.cpp)
  add_library(femsph_${name} MODULE ${sources})
  target_link_libraries(femsph_${name} PRIVATE femsph_flags fmt::fmt ${module_USES})
  target_include_directories(femsph_${name} PRIVATE ${CMAKE_BINARY_DIR}/generated)
  add_dependencies(femsph_${name} femsph_provenance)
  set_target_properties(femsph_${name} PROPERTIES
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR} UNITY_BUILD OFF)
  install(TARGETS femsph_${name} LIBRARY DESTINATION lib/femsph)
endfunction()

# Room ROOM loads module NAME: building the room builds the module too.
function(femsph_opens room name)
  target_include_directories(femsph_${room} PRIVATE ${CMAKE_BINARY_DIR}/generated)
  add_dependencies(femsph_${room} femsph_provenance femsph_${name})
endfunction()
