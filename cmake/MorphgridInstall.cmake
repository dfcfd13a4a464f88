# What `cmake --install build/release` leaves: the program with scenes, printers and materials (component program), and the
# library with its headers and a CMake package (component development). `cpack --config build/release/CPackConfig.cmake`
# makes a Debian package of each.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(MORPHGRID_INCLUDES ${CMAKE_INSTALL_INCLUDEDIR}/morphgrid)

function(install_program)
  install(TARGETS morphgrid COMPONENT program)
  install(DIRECTORY scenes printers materials DESTINATION ${CMAKE_INSTALL_DATADIR}/morphgrid COMPONENT program
          FILES_MATCHING PATTERN "*.toml")
  install(FILES scenes/meshes/torso.ply DESTINATION ${CMAKE_INSTALL_DATADIR}/morphgrid/scenes/meshes COMPONENT program)
  install(FILES LICENSE CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
endfunction()

# morphgrid::NAME for each module.
function(install_library)
  get_property(modules GLOBAL PROPERTY MORPHGRID_MODULES)
  set(folder ${CMAKE_INSTALL_LIBDIR}/cmake/morphgrid)
  foreach(module IN LISTS modules)
    string(REPLACE "morphgrid_" "" name ${module})
    set_property(TARGET ${module} PROPERTY EXPORT_NAME ${name})
  endforeach()
  install(TARGETS ${modules} shader_types gpu_solve_shaders gpu_render_shaders EXPORT morphgrid COMPONENT development)
  install(EXPORT morphgrid NAMESPACE morphgrid:: DESTINATION ${folder} FILE morphgridTargets.cmake COMPONENT development)
  install(DIRECTORY host/ shaders/shared DESTINATION ${MORPHGRID_INCLUDES} COMPONENT development FILES_MATCHING PATTERN "*.h")
  write_basic_package_version_file(${CMAKE_BINARY_DIR}/morphgridConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES cmake/morphgridConfig.cmake cmake/MorphgridDependencies.cmake
                ${CMAKE_BINARY_DIR}/morphgridConfigVersion.cmake DESTINATION ${folder} COMPONENT development)
endfunction()

# What the library's users need of Debian: what its build needs but GoogleTest.
function(library_packages result)
  file(READ ${CMAKE_SOURCE_DIR}/tools/packages.txt text)
  string(REGEX REPLACE "\n\\[test\\].*" "" text "${text}")
  string(REGEX MATCHALL "\n(lib|nlohmann|zlib)[^\n]+" packages "${text}")
  list(TRANSFORM packages STRIP)
  list(FILTER packages EXCLUDE REGEX "gtest|gmock")
  string(JOIN ", " packages morphgrid pkg-config ${packages})
  set(${result} ${packages} PARENT_SCOPE)
endfunction()

macro(describe_packages)
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_CONTACT "morphgrid authors")
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Design, simulate and print multi-tiered 4D grids")
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_STRIP_FILES ON)
  set(CPACK_COMPONENTS_ALL program development)
  set(CPACK_COMPONENTS_GROUPING IGNORE)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME morphgrid)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
  # It loads drivers, and the font of its pictures, by name.
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "mesa-vulkan-drivers, fonts-dejavu-core")
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libmorphgrid-dev)
  library_packages(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
  include(CPack)
endmacro()

function(morphgrid_install)
  install_program()
  install_library()
  describe_packages()
endfunction()
