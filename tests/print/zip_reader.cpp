#include "tests/print/zip_reader.h"

#include <zlib.h>

#include <cstdint>
#include <stdexcept>

namespace morphgrid {
namespace {

std::uint32_t numberAt(const std::string& bytes, std::size_t at, int size) {
  std::uint32_t number = 0;
  for (int n = size - 1; n >= 0; --n) {
    number = number << 8 | static_cast<unsigned char>(bytes.at(at + n));
  }
  return number;
}

/// What 32 bits cannot hold, or what the writer did not know before, stands elsewhere (ZIP64).
constexpr std::uint32_t kElsewhere = 0xFFFFFFFF;

/// Of an entry's extra fields, that of ZIP64: what its header left out, in this order.
class LargeNumbers {
 public:
  LargeNumbers(const std::string& bytes, std::size_t begin, std::size_t end) : bytes_(bytes) {
    for (at_ = begin; at_ < end; at_ += 4 + numberAt(bytes, at_ + 2, 2)) {
      if (numberAt(bytes, at_, 2) == 1) break;
    }
    at_ += 4;
  }
  std::size_t orElsewhere(std::uint32_t number) {
    if (number != kElsewhere) return number;
    at_ += 8;
    return numberAt(bytes_, at_ - 8, 4);
  }

 private:
  const std::string& bytes_;
  std::size_t at_;
};

std::string inflated(const std::string& packed, std::size_t size) {
  std::string text(size, '\0');
  z_stream stream{};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(text.data());
  stream.avail_out = static_cast<uInt>(size);
  inflateInit2(&stream, -MAX_WBITS);
  const int result = inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  if (result != Z_STREAM_END || stream.total_out != size) throw std::runtime_error("bad deflate");
  return text;
}

}  // namespace

std::map<std::string, std::string> readZip(const std::string& bytes) {
  const std::size_t end = bytes.rfind("PK\5\6");
  if (end == bytes.npos) throw std::runtime_error("no ZIP archive");
  std::map<std::string, std::string> files;
  std::size_t entry = numberAt(bytes, end + 16, 4);
  std::uint32_t count = numberAt(bytes, end + 10, 2);
  if (entry == kElsewhere) {
    const std::size_t large = bytes.rfind("PK\6\6");
    if (large == bytes.npos) throw std::runtime_error("no end of the ZIP64 archive");
    entry = numberAt(bytes, large + 48, 4);
    count = numberAt(bytes, large + 32, 4);
  }
  for (std::uint32_t n = count; n > 0; --n) {
    if (bytes.compare(entry, 4, "PK\1\2") != 0) throw std::runtime_error("no ZIP entry");
    const auto method = numberAt(bytes, entry + 10, 2), crc = numberAt(bytes, entry + 16, 4);
    const auto nameSize = numberAt(bytes, entry + 28, 2);
    const std::size_t extra = entry + 46 + nameSize;
    LargeNumbers numbers(bytes, extra, extra + numberAt(bytes, entry + 30, 2));
    const std::size_t size = numbers.orElsewhere(numberAt(bytes, entry + 24, 4));
    const std::size_t packed = numbers.orElsewhere(numberAt(bytes, entry + 20, 4));
    const std::size_t local = numbers.orElsewhere(numberAt(bytes, entry + 42, 4));
    const std::size_t data =
        local + 30 + numberAt(bytes, local + 26, 2) + numberAt(bytes, local + 28, 2);
    std::string text = bytes.substr(data, packed);
    if (method != 0) text = inflated(text, size);
    const auto found =
        crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()));
    if (found != crc) throw std::runtime_error("wrong checksum");
    files[bytes.substr(entry + 46, nameSize)] = text;
    entry += 46 + nameSize + numberAt(bytes, entry + 30, 2) + numberAt(bytes, entry + 32, 2);
  }
  return files;
}

}  // namespace morphgrid
