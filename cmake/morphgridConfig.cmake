# find_package(morphgrid): targets morphgrid::app, and one for each other folder of host/.
include(${CMAKE_CURRENT_LIST_DIR}/MorphgridDependencies.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/morphgridTargets.cmake)
