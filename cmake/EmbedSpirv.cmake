# cmake -DINPUT=x.spv -DOUTPUT=x.h -DNAME=x.comp -DVARIABLE=x_comp_spirv -P: a header with INPUT as a
# ShaderCode.
file(READ ${INPUT} bytes HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1,\n" words "${bytes}")
file(WRITE ${OUTPUT} "#pragma once
#include \"gpu/shader_code.h\"
const std::uint32_t ${VARIABLE}_words[] = {\n${words}};
const morphgrid::ShaderCode ${VARIABLE}{\"${NAME}\", ${VARIABLE}_words};
")
