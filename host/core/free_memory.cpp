#include "core/free_memory.h"

#include <malloc.h>

namespace morphgrid {

void returnFreedMemory() { malloc_trim(0); }

}  // namespace morphgrid
