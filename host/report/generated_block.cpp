#include "report/generated_block.h"

#include <fmt/format.h>

#include "core/error.h"

namespace morphgrid {

std::string withBlock(const std::string& document, const std::string& name,
                      const std::string& content) {
  const std::string begin = fmt::format("<!-- begin {} -->\n", name);
  const std::string end = fmt::format("<!-- end {} -->\n", name);
  const auto first = document.find(begin);
  const auto last = document.find(end, first == document.npos ? 0 : first);
  if (first == document.npos || last == document.npos) {
    throw InputError(fmt::format("a line {} and, below it, a line {} are missing",
                                 begin.substr(0, begin.size() - 1), end.substr(0, end.size() - 1)));
  }
  return document.substr(0, first + begin.size()) + content + document.substr(last);
}

}  // namespace morphgrid
