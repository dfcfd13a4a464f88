#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "surface/mesh_formats.h"
#include "surface/polygon_mesh.h"
#include "surface/text_reader.h"

namespace morphgrid {
namespace {

/// Walks statements by words. A backslash at a line's end goes on with the next line, unless it
/// ends a comment; # begins one, anywhere in a line.
class ObjStatements {
 public:
  explicit ObjStatements(const MeshSource& source) : text_(source) {}

  /// Goes to the next line that begins a statement; false at the end of the file.
  bool next() {
    while (!word().empty()) {
    }
    return text_.nextLine();
  }

  /// The next word of this statement; empty at its end.
  std::string_view word() {
    for (;;) {
      std::string_view word = text_.word();
      const std::size_t comment = word.find('#');
      if (comment != std::string_view::npos) {
        text_.skipLine();
        return word.substr(0, comment);
      }
      const bool isLast = text_.rest().find_first_not_of(" \t") == std::string_view::npos;
      const bool goesOn = word.ends_with('\\') && isLast && text_.nextLine();
      if (!goesOn) return word;
      word.remove_suffix(1);
      if (!word.empty()) return word;
    }
  }

  const TextReader& text() const { return text_; }

 private:
  TextReader text_;
};

class ObjReader {
 public:
  explicit ObjReader(const MeshSource& source) : source_(source), statements_(source) {}

  NotedMesh read() {
    while (statements_.next()) readStatement();
    requireRange();
    const bool isEmpty = polygons_.cornerCounts.empty();
    if (isEmpty && freeFormLine_ > 0) {
      throw source_.errorAtLine(freeFormLine_,
                                freeForm() +
                                    " cannot be read: export it as a mesh of polygons, or write "
                                    "the 16 points of one bicubic patch into a patch file");
    }
    return {triangulate(polygons_), notices()};
  }

 private:
  void readStatement() {
    const std::string_view keyword = statements_.word();
    if (keyword == "v") readVertex();
    if (keyword == "f") readFace();
    if (keyword == "surf" && freeFormLine_ == 0) freeFormLine_ = statements_.text().line();
    if (keyword == "cstype" && freeFormLine_ == 0) readFreeFormType();
  }

  void readVertex() {
    for (const char* const name : {"x", "y", "z"}) {
      polygons_.coordinates.push_back(statements_.text().number(statements_.word(), name));
    }
  }

  void readFace() {
    const std::size_t first = polygons_.corners.size();
    for (std::string_view word = statements_.word(); !word.empty(); word = statements_.word()) {
      polygons_.corners.push_back(readCorner(word));
    }
    const std::size_t count = polygons_.corners.size() - first;
    if (count > kMostCorners) {
      throw statements_.text().error(
          fmt::format("a face must have 3 to {} vertices, got {}", kMostCorners, count));
    }
    if (count >= 3) {
      polygons_.cornerCounts.push_back(static_cast<int>(count));
    } else {
      polygons_.corners.resize(first);
      ++smallFaces_;
    }
  }

  /// A corner is `i`, `i/t`, `i//n` or `i/t/n`. Negative indices count back from the latest vertex.
  int readCorner(std::string_view word) const {
    int index = 0;
    const std::size_t length = std::min(word.find('/'), word.size());
    const auto [end, problem] = std::from_chars(word.data(), word.data() + length, index);
    const bool isIndex = problem == std::errc() && end == word.data() + length && index != 0;
    if (!isIndex || word.find_first_not_of("-0123456789/") != std::string_view::npos ||
        std::ranges::count(word, '/') > 2) {
      throw statements_.text().error(
          fmt::format("a vertex of a face must be an integer other than 0, alone or as i/t, i//n "
                      "or i/t/n, got {}",
                      inQuotes(word)));
    }
    return index > 0 ? index - 1 : static_cast<int>(polygons_.coordinates.size() / 3) + index;
  }

  /// `cstype bezier`, or `cstype rat bezier`.
  void readFreeFormType() {
    freeFormType_.clear();
    for (std::string_view word = statements_.word(); !word.empty(); word = statements_.word()) {
      freeFormType_ = word;
    }
  }

  std::string freeForm() const {
    return "free-form geometry" +
           (freeFormType_.empty() ? "" : " (" + oneLine(freeFormType_.substr(0, 32)) + ")");
  }

  /// When all is read: faces may come before the vertices.
  void requireRange() const {
    if (const auto bad = findBadCorner(polygons_)) {
      throw source_.error(fmt::format("face {}: vertex {} does not exist, there are 1 to {}",
                                      bad->polygon + 1, bad->index + 1,
                                      polygons_.coordinates.size() / 3));
    }
  }

  std::vector<std::string> notices() const {
    std::vector<std::string> notices = noticesOnFaces(smallFaces_);
    if (freeFormLine_ > 0) {
      notices.push_back(
          fmt::format("{}, from line {} on, was passed over", freeForm(), freeFormLine_));
    }
    return notices;
  }

  const MeshSource& source_;
  ObjStatements statements_;
  PolygonMesh polygons_;
  std::size_t smallFaces_ = 0;  ///< Of fewer than three corners.
  int freeFormLine_ = 0;        ///< Of the first surface that is no polygon; 0: none.
  std::string freeFormType_;
};

}  // namespace

NotedMesh readObj(const MeshSource& source) { return ObjReader(source).read(); }

}  // namespace morphgrid
