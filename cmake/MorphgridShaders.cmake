# morphgrid_shaders(TARGET FOLDER): compiles shaders/FOLDER/*.{comp,vert,frag} to SPIR-V, embedded as
# C arrays in headers `FOLDER/NAME_STAGE.h` (array `NAME_STAGE_spirv`), rebuilt when an include changes.
find_program(GLSLANG_VALIDATOR glslangValidator REQUIRED)

function(morphgrid_shaders target folder)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/shaders/${folder}/*.comp
       ${CMAKE_SOURCE_DIR}/shaders/${folder}/*.vert ${CMAKE_SOURCE_DIR}/shaders/${folder}/*.frag)
  set(output_folder ${CMAKE_BINARY_DIR}/spirv)
  file(MAKE_DIRECTORY ${output_folder}/${folder})
  foreach(source IN LISTS sources)
    get_filename_component(file ${source} NAME)
    string(REPLACE "." "_" name ${file})
    set(header ${output_folder}/${folder}/${name}.h)
    add_custom_command(
      OUTPUT ${header}
      COMMAND ${GLSLANG_VALIDATOR} --target-env vulkan1.2 -I${CMAKE_SOURCE_DIR}/shaders
              --depfile ${header}.d --vn ${name}_spirv -o ${header} ${source}
      DEPENDS ${source}
      DEPFILE ${header}.d
      COMMENT "Compiling shaders/${folder}/${file}"
      VERBATIM)
    list(APPEND headers ${header})
  endforeach()
  add_custom_target(${target}_compile DEPENDS ${headers})
  add_library(${target} INTERFACE)
  add_dependencies(${target} ${target}_compile)
  target_include_directories(${target} INTERFACE ${output_folder})
endfunction()
