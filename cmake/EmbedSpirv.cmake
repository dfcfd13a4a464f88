# cmake -DINPUT=x.spv -DOUTPUT=x.h -DARRAY=name -P: a header with the words of INPUT as an array.
file(READ ${INPUT} bytes HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1,\n" words "${bytes}")
file(WRITE ${OUTPUT} "#pragma once\n#include <cstdint>\nconst std::uint32_t ${ARRAY}[] = {\n${words}};\n")
