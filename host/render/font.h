#pragma once
#include <array>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "render/image.h"

struct stbtt_fontinfo;

namespace morphgrid {

using Color = std::array<std::uint8_t, 3>;  ///< Red, green, blue.

/// A TrueType font that writes on images.
class Font {
 public:
  /// Throws InputError when the file cannot be read or is no font.
  explicit Font(const std::filesystem::path& file);
  Font(Font&&) noexcept;
  ~Font();

  /// DejaVu Sans where Linux distributions put it. Throws InputError that says what to install.
  static Font findSans();
  /// DejaVu Sans Mono, alike: for tables.
  static Font findMono();
  /// Their files.
  static std::filesystem::path sansFile();
  static std::filesystem::path monoFile();

  /// In pixels, of UTF-8 text in letters of `size` pixels from ascender to descender.
  double widthOf(std::string_view text, double size) const;

  /// Writes UTF-8 text from x, with its baseline at y; what lies outside of the image is left out.
  void write(Image& image, std::string_view text, double size, double x, double y,
             const Color& color) const;

 private:
  float scaleFor(double size) const;
  double kerning(int codepoint, int next, double scale) const;

  std::vector<std::uint8_t> file_;
  std::unique_ptr<stbtt_fontinfo> info_;
};

/// Code points of UTF-8 text; U+FFFD for what is not UTF-8.
std::vector<int> decodeUtf8(std::string_view text);

}  // namespace morphgrid
