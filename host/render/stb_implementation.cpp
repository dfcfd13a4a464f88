// The one place where the bodies of the header-only libraries are compiled.
#include <zlib.h>

#include <cstdlib>

namespace {

/// For stb, whose own packing leaves pictures half as large again; it frees what it gets.
unsigned char* packWithZlib(unsigned char* bytes, int count, int* packedCount, int level) {
  uLongf size = compressBound(static_cast<uLong>(count));
  auto* packed = static_cast<unsigned char*>(std::malloc(size));
  if (packed != nullptr &&
      compress2(packed, &size, bytes, static_cast<uLong>(count), level) != Z_OK) {
    std::free(packed);
    return nullptr;
  }
  *packedCount = static_cast<int>(size);
  return packed;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS packWithZlib
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_RECT_PACK_IMPLEMENTATION
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_image_write.h>
// Dear ImGui calls these bodies too, and packs rectangles itself: without the first header
// stb_truetype would take them for others.
#include <stb/stb_rect_pack.h>
#include <stb/stb_truetype.h>
