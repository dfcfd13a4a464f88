#pragma once
#include <optional>
#include <string_view>

#include "surface/mesh_source.h"

namespace morphgrid {

/// The whole word as a number, which may be NaN or infinite; nothing when it is none, or beyond a
/// double.
std::optional<double> parseNumber(std::string_view word);

/// Walks a file's text by words and lines. Lines end in LF, CRLF or CR; words in spaces and tabs. A
/// mark of UTF-8 is passed over.
class TextReader {
 public:
  /// Throws InputError when the text is UTF-16.
  explicit TextReader(const MeshSource& source);

  /// Goes to the beginning of the next line; false at the end of the file.
  bool nextLine();
  /// The next word of this line; empty at its end.
  std::string_view word();
  /// The next word, on this line or a later one; empty at the end of the file.
  std::string_view wordOfAnyLine();
  /// What is left of this line.
  std::string_view rest() const { return rest_; }
  /// Leaves out what is left of this line.
  void skipLine() { rest_ = {}; }

  /// The word, just read, as a finite number. Throws InputError when it is none, calling it `name`.
  double number(std::string_view word, std::string_view name) const;

  int line() const { return line_; }
  /// Offset of what is not read yet, in bytes.
  std::size_t offset() const { return rest_.empty() ? next_ : rest_.data() - source_.bytes.data(); }
  InputError error(std::string_view what) const { return source_.errorAtLine(line_, what); }

 private:
  const MeshSource& source_;
  std::string_view rest_;  ///< What is left of the line.
  std::size_t next_ = 0;   ///< Offset of the next line.
  int line_ = 0;
};

}  // namespace morphgrid
