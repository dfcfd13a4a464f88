#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "core/nearest_name.h"
#include "core/problem_list.h"
#include "core/read_file.h"
#include "core/visible_text.h"
#include "print/measurement_columns.h"

namespace morphgrid {
namespace {

constexpr std::uintmax_t kMostBytes = 1 << 20;  // Of a table that is filled in by hand.

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t\r");
  return begin == text.npos ? "" : text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

struct TableCell {
  int column;  ///< Where it begins in its line, from 1.
  std::string text;
};

/// Cells of a line; they may be in quotes, as spreadsheets write what holds a separator.
std::vector<TableCell> cellsOf(const std::string& line, char separator) {
  std::vector<TableCell> cells{{1, ""}};
  bool isQuoted = false;
  for (std::size_t n = 0; n < line.size(); ++n) {
    if (line[n] == '"') {
      if (isQuoted && n + 1 < line.size() && line[n + 1] == '"') {
        cells.back().text += line[n++];
      } else {
        isQuoted = !isQuoted;
      }
    } else if (line[n] == separator && !isQuoted) {
      cells.push_back({static_cast<int>(n) + 2, ""});
    } else {
      cells.back().text += line[n];
    }
  }
  for (TableCell& cell : cells) cell.text = trimmed(cell.text);
  return cells;
}

char separatorIn(const std::string& head) {
  for (const char separator : {';', '\t'}) {
    if (head.find(separator) != head.npos) return separator;
  }
  return ',';
}

bool isComment(const std::string& line) {
  return !line.empty() && (line[0] == '#' || line.rfind("\"#", 0) == 0);
}

class MeasurementsReader {
 public:
  explicit MeasurementsReader(const std::filesystem::path& file) : file_(file.string()) {}

  std::vector<Measurement> read(const std::string& text) {
    std::istringstream lines(text.rfind("\xef\xbb\xbf", 0) == 0 ? text.substr(3) : text);
    for (std::string line; std::getline(lines, line);) {
      ++line_;
      if (!isComment(line)) readLine(line);
    }
    if (columns_.empty()) complain(1, "the line that names the columns is missing");
    problems_.throwIfAny();
    return std::move(rows_);
  }

 private:
  void complain(int column, const std::string& what) {
    problems_.add({file_, std::max(1, line_), column}, visibleText(what));
  }

  void readLine(const std::string& line) {
    if (columns_.empty() && !trimmed(line).empty()) separator_ = separatorIn(line);
    const std::vector<TableCell> cells = cellsOf(line, separator_);
    const bool isEmpty = std::all_of(cells.begin(), cells.end(),
                                     [](const TableCell& cell) { return cell.text.empty(); });
    if (isEmpty) return;
    if (columns_.empty()) {
      readHead(cells);
      problems_.throwIfAny();  // Cells under wrong names tell nothing.
    } else {
      readRow(cells);
    }
  }

  void readHead(const std::vector<TableCell>& names) {
    std::vector<std::string> known;
    for (const MeasurementColumn& column : measurementColumns()) known.emplace_back(column.name);
    for (const auto& [at, name] : names) {
      const auto found = std::find(known.begin(), known.end(), name);
      const MeasurementColumn* column =
          found == known.end() ? nullptr : &measurementColumns()[found - known.begin()];
      if (!column && !name.empty()) {
        const auto near = nearestName(name, known);
        complain(at, fmt::format("{} is no column{}; there are {}", name,
                                 near ? fmt::format(" (is it {}?)", *near) : "",
                                 fmt::join(known, ", ")));
      }
      if (column && std::find(columns_.begin(), columns_.end(), column) != columns_.end()) {
        complain(at, fmt::format("column {} is there twice", name));
      }
      columns_.push_back(column);
    }
    for (const MeasurementColumn& column : measurementColumns()) {
      const bool isThere = std::find(columns_.begin(), columns_.end(), &column) != columns_.end();
      if (column.isRequired && !isThere)
        complain(1, fmt::format("column {} is missing", column.name));
    }
  }

  void readRow(const std::vector<TableCell>& cells) {
    Measurement row{.line = line_};
    bool isGood = true;
    for (std::size_t n = 0; n < std::max(cells.size(), columns_.size()); ++n) {
      const TableCell cell = n < cells.size() ? cells[n] : TableCell{cells.back().column, ""};
      const MeasurementColumn* column = n < columns_.size() ? columns_[n] : nullptr;
      isGood = (column ? readCell(*column, cell, row) : requireEmpty(cell)) && isGood;
    }
    if (isGood) checkRow(row, cells);
  }

  bool requireEmpty(const TableCell& cell) {
    if (cell.text.empty()) return true;
    complain(cell.column, fmt::format("{} is in no column; where commas part cells, numbers have "
                                      "decimal points",
                                      cell.text));
    return false;
  }

  bool readCell(const MeasurementColumn& column, const TableCell& cell, Measurement& row) {
    if (cell.text.empty()) {
      if (!column.mayBeEmpty) complain(cell.column, fmt::format("{} is empty", column.name));
      return column.mayBeEmpty;
    }
    const std::string allowed = column.read(cell.text, row);
    if (allowed.empty()) return true;
    complain(cell.column, fmt::format("{} must be {}, got {}", column.name, allowed, cell.text));
    return false;
  }

  void checkRow(const Measurement& row, const std::vector<TableCell>& cells) {
    if (row.hub >= row.pitch) {
      complain(placeOf("hub_mm", cells),
               fmt::format("hub_mm must be below pitch_mm, {}, got {}", row.pitch, row.hub));
      return;
    }
    checkChange("length_after_mm", cells, row.lengthAfter, row.length());
    checkChange("height_after_mm", cells, row.heightAfter, row.height + row.tube);
    rows_.push_back(row);
  }

  /// Where a column of that name begins in a row.
  int placeOf(std::string_view name, const std::vector<TableCell>& cells) const {
    for (std::size_t n = 0; n < std::min(cells.size(), columns_.size()); ++n) {
      if (columns_[n] && columns_[n]->name == name) return cells[n].column;
    }
    return 1;
  }

  void checkChange(const char* name, const std::vector<TableCell>& cells,
                   const std::optional<double>& after, double printed) {
    const NumberRange range = afterBath(printed);
    if (after && !range.contains(*after)) {
      complain(placeOf(name, cells), fmt::format("{} must be {}, since {} mm were printed, got {}",
                                                 name, describe(range), printed, *after));
    }
  }

  std::string file_;
  int line_ = 0;
  char separator_ = ',';
  std::vector<const MeasurementColumn*> columns_;
  std::vector<Measurement> rows_;
  ProblemList problems_;
};

}  // namespace

std::vector<Measurement> readMeasurements(const std::filesystem::path& file) {
  return MeasurementsReader(file).read(readFile(file, kMostBytes));
}

}  // namespace morphgrid
