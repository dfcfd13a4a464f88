#include "core/toml_nesting.h"

#include <algorithm>
#include <vector>

namespace morphgrid {
namespace {

class NestingScan {
 public:
  explicit NestingScan(std::string_view text) : text_(text) {}

  /// Behind the first byte that opens a level too many; nothing where there is none.
  std::optional<std::size_t> run() {
    while (at_ < text_.size()) {
      step();
      if (levels() > kMostTomlLevels) return at_;
    }
    return std::nullopt;
  }

 private:
  int levels() const { return header_ + static_cast<int>(dots_.size()) - 1 + dotCount_; }

  void step() {
    const char c = text_[at_];
    const bool startsLine = isLineStart_;
    isLineStart_ = c == '\n' || (startsLine && (c == ' ' || c == '\t'));
    if (c == '"' || c == '\'') return skipString(c);
    if (c == '#') return skipComment();
    ++at_;
    if (c == '[' && startsLine && dots_.size() == 1) {
      inHeader_ = true;
      header_ = headerDots_ = 0;
    }
    if (c == '[' || c == '{') dots_.push_back(0);
    if (c == '.') addDot();
    if (c == ',' || c == '\n') forgetDots();
    if ((c == ']' || c == '}') && dots_.size() > 1) {
      forgetDots();
      dots_.pop_back();
    }
    if (c == '\n' && inHeader_) {
      header_ = 1 + headerDots_;
      inHeader_ = false;
    }
  }

  void addDot() {
    ++dots_.back();
    ++dotCount_;
    if (inHeader_) ++headerDots_;
  }

  void forgetDots() {
    dotCount_ -= dots_.back();
    dots_.back() = 0;
  }

  void skipComment() { at_ = std::min(text_.find('\n', at_), text_.size()); }

  bool startsThree(char quote) const {
    return text_.substr(at_, 3) == std::string_view(quote == '"' ? "\"\"\"" : "'''");
  }

  /// A string of one line ends with the line at the latest: the parser takes no other.
  void skipString(char quote) {
    const bool isLong = startsThree(quote);
    at_ += isLong ? 3 : 1;
    while (at_ < text_.size()) {
      if (text_[at_] == '\\' && quote == '"') {
        ++at_;
      } else if (text_[at_] == quote && (!isLong || startsThree(quote))) {
        break;
      } else if (text_[at_] == '\n' && !isLong) {
        return;
      }
      ++at_;
    }
    // Behind three quotes two more may end the string.
    for (int n = 0; n < (isLong ? 5 : 1) && at_ < text_.size() && text_[at_] == quote; ++n) ++at_;
    at_ = std::min(at_, text_.size());
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<int> dots_{0};  ///< Of the key at hand: outside brackets, then in each open one.
  int dotCount_ = 0;          ///< Their sum.
  int header_ = 0;            ///< Levels of the table that the lines belong to.
  int headerDots_ = 0;
  bool inHeader_ = false;
  bool isLineStart_ = true;
};

}  // namespace

std::optional<TextPosition> findTooDeepNesting(std::string_view text) {
  const auto end = NestingScan(text).run();
  if (!end) return std::nullopt;
  const std::string_view before = text.substr(0, *end - 1);
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const std::size_t lineStart = before.rfind('\n') + 1;  // 0 where there is no line break.
  return TextPosition{static_cast<int>(lines) + 1, static_cast<int>(before.size() - lineStart) + 1};
}

}  // namespace morphgrid
