// The one place where the bodies of the header-only libraries are compiled.
#include <libdeflate.h>

#include <cstdlib>
#include <memory>

namespace {

/// In less than half of zlib's time as small as zlib's best.
constexpr int kLevel = 6;

/// For stb, whose own packing leaves pictures half as large again; it frees what it gets.
unsigned char* packBytes(unsigned char* bytes, int count, int* packedCount, int /*quality*/) {
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(kLevel), libdeflate_free_compressor);
  if (!compressor) return nullptr;
  const auto size = static_cast<std::size_t>(count);
  const std::size_t most = libdeflate_zlib_compress_bound(compressor.get(), size);
  auto* packed = static_cast<unsigned char*>(std::malloc(most));
  if (packed == nullptr) return nullptr;
  *packedCount =
      static_cast<int>(libdeflate_zlib_compress(compressor.get(), bytes, size, packed, most));
  return packed;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS packBytes
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_RECT_PACK_IMPLEMENTATION
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_image_write.h>
// Dear ImGui calls these bodies too, and packs rectangles itself: without the first header
// stb_truetype would take them for others.
#include <stb/stb_rect_pack.h>
#include <stb/stb_truetype.h>

namespace {

/// Rows as they are: pictures are flat areas and thin lines, of which filters make more bytes, and
/// trying them all takes longer than packing.
[[maybe_unused]] const int kFilter = stbi_write_force_png_filter = 0;

}  // namespace
