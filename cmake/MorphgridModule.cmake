# morphgrid_module(NAME DEPENDENCY...): the library of host/NAME. A dependency that is a module's
# name links that module.
function(morphgrid_module name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/host/${name}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  set(target morphgrid_${name})
  add_library(${target} STATIC ${sources})
  morphgrid_batches(${target})
  # A module sees its own folder and, through its dependencies, theirs: nothing else.
  set(view ${CMAKE_BINARY_DIR}/include/${name})
  file(MAKE_DIRECTORY ${view})
  file(CREATE_LINK ${CMAKE_SOURCE_DIR}/host/${name} ${view}/${name} SYMBOLIC)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${view}> $<INSTALL_INTERFACE:${MORPHGRID_INCLUDES}>)
  set_property(GLOBAL APPEND PROPERTY MORPHGRID_MODULES ${target})
  morphgrid_compile_options(${target})
  target_precompile_headers(${target} REUSE_FROM module_headers)
  foreach(dependency IN LISTS ARGN)
    if(TARGET morphgrid_${dependency})
      target_link_libraries(${target} PUBLIC morphgrid_${dependency})
    else()
      target_link_libraries(${target} PUBLIC ${dependency})
    endif()
  endforeach()
endfunction()

function(morphgrid_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wno-missing-field-initializers)
  if(MORPHGRID_SANITIZE)
    target_compile_options(
      ${target} PUBLIC -fsanitize=address,undefined,fuzzer-no-link -fno-sanitize-recover=all -fno-omit-frame-pointer
                       -fsanitize-ignorelist=${CMAKE_SOURCE_DIR}/cmake/sanitizer_ignorelist.txt)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
endfunction()
