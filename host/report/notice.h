#pragma once
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace morphgrid {

/// What a notice is about, the most important first.
enum class Severity {
  result,    ///< The result is not what was asked for, or cannot be.
  printing,  ///< It cannot be printed as it is.
  advice,    ///< What was changed or would help.
};

/// What the user should know of a run, a sentence.
struct Notice {
  std::string text;
  Severity severity = Severity::advice;

  Notice(std::string what, Severity how = Severity::advice)
      : text(std::move(what)), severity(how) {}
  Notice(const char* what) : text(what) {}
  operator const std::string&() const { return text; }
  bool operator==(const Notice&) const = default;
};

/// Those of one severity stay in their order.
inline void putMostImportantFirst(std::vector<Notice>& notices) {
  std::ranges::stable_sort(notices, {}, &Notice::severity);
}

inline std::vector<std::string> textsOf(const std::vector<Notice>& notices) {
  return {notices.begin(), notices.end()};
}

}  // namespace morphgrid
