# morphgrid_shaders(TARGET FOLDER): compiles shaders/FOLDER/*.{comp,vert,frag} to SPIR-V, embedded as
# headers `FOLDER/NAME_STAGE.h` (ShaderCode `NAME_STAGE_spirv`), rebuilt when an include changes.
# spirv-opt unrolls loops: Mesa's own passes need three times as long for it at every start of a program,
# and leave arrays in memory, 15 times slower, where they cannot count a loop.
find_program(GLSLANG_VALIDATOR glslangValidator REQUIRED)
find_program(SPIRV_OPT spirv-opt REQUIRED)

function(morphgrid_shaders target folder)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/shaders/${folder}/*.comp
       ${CMAKE_SOURCE_DIR}/shaders/${folder}/*.vert ${CMAKE_SOURCE_DIR}/shaders/${folder}/*.frag)
  set(output_folder ${CMAKE_BINARY_DIR}/spirv)
  file(MAKE_DIRECTORY ${output_folder}/${folder})
  foreach(source IN LISTS sources)
    get_filename_component(file ${source} NAME)
    string(REPLACE "." "_" name ${file})
    set(plain ${output_folder}/${folder}/${name}.plain.spv)
    set(optimised ${output_folder}/${folder}/${name}.spv)
    set(header ${output_folder}/${folder}/${name}.h)
    add_custom_command(
      OUTPUT ${plain}
      COMMAND ${GLSLANG_VALIDATOR} --quiet --target-env vulkan1.2 -I${CMAKE_SOURCE_DIR}/shaders
              --depfile ${plain}.d -o ${plain} ${source}
      DEPENDS ${source}
      DEPFILE ${plain}.d
      COMMENT "Compiling shaders/${folder}/${file}"
      VERBATIM)
    add_custom_command(
      OUTPUT ${header}
      COMMAND ${SPIRV_OPT} --target-env=vulkan1.2 -O ${plain} -o ${optimised}
      COMMAND ${CMAKE_COMMAND} -DINPUT=${optimised} -DOUTPUT=${header} -DNAME=${file} -DVARIABLE=${name}_spirv
              -P ${CMAKE_SOURCE_DIR}/cmake/EmbedSpirv.cmake
      DEPENDS ${plain} ${CMAKE_SOURCE_DIR}/cmake/EmbedSpirv.cmake
      COMMENT "Optimising shaders/${folder}/${file}"
      VERBATIM)
    list(APPEND headers ${header})
  endforeach()
  add_custom_target(${target}_compile DEPENDS ${headers})
  add_library(${target} INTERFACE)
  add_dependencies(${target} ${target}_compile)
  target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${output_folder}>)
endfunction()
