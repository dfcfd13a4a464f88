# The libraries that morphgrid needs, for its build and for those who build with it: installed beside its CMake
# package. GoogleTest is of the tests alone.
find_package(CLI11 REQUIRED)
find_package(Eigen3 3.4 REQUIRED)
find_package(embree 3 REQUIRED)
find_package(fmt REQUIRED)
find_package(glfw3 3.3 REQUIRED)
find_package(glm REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(spdlog REQUIRED)
find_package(TBB REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(Vulkan 1.3 REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(Deflate REQUIRED IMPORTED_TARGET libdeflate)
pkg_check_modules(WebP REQUIRED IMPORTED_TARGET libwebp libwebpmux)
find_package(CGAL REQUIRED) # Last: it brings find modules of its own, one for Eigen among them.

# Dear ImGui has no CMake package. Debian's library takes stb from another; it holds its backends too, which
# call Vulkan and GLFW.
find_path(IMGUI_HEADERS imgui.h PATH_SUFFIXES imgui REQUIRED)
find_library(IMGUI_LIBRARY imgui REQUIRED)
find_library(STB_LIBRARY stb REQUIRED)
add_library(imgui STATIC IMPORTED)
set_target_properties(imgui PROPERTIES IMPORTED_LOCATION ${IMGUI_LIBRARY})
target_include_directories(imgui SYSTEM INTERFACE ${IMGUI_HEADERS})
target_link_libraries(imgui INTERFACE ${STB_LIBRARY} Vulkan::Vulkan glfw)

# Its pkg-config file names libraries of its own whose headers Debian leaves out.
find_path(LIB3MF_HEADERS Model/COM/NMR_DLLInterfaces.h PATH_SUFFIXES lib3mf REQUIRED)
find_library(LIB3MF_LIBRARY 3MF REQUIRED)
add_library(lib3mf SHARED IMPORTED)
set_target_properties(lib3mf PROPERTIES IMPORTED_LOCATION ${LIB3MF_LIBRARY})
target_include_directories(lib3mf SYSTEM INTERFACE ${LIB3MF_HEADERS})
