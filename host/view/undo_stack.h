#pragma once
#include <string>
#include <utility>
#include <vector>

namespace morphgrid {

/// A state with its past and its future.
template <typename State>
class UndoStack {
 public:
  explicit UndoStack(State state) : present_(std::move(state)) {}

  const State& present() const { return present_; }
  bool canUndo() const { return !past_.empty(); }
  bool canRedo() const { return !future_.empty(); }

  /// Changes of one thing, in seconds less than kPause apart, are undone as one.
  void change(State state, const std::string& what, double seconds) {
    if (what != lastChanged_ || seconds - lastSeconds_ >= kPause) {
      past_.push_back(std::move(present_));
    }
    present_ = std::move(state);
    future_.clear();
    lastChanged_ = what;
    lastSeconds_ = seconds;
  }

  /// canUndo() must hold.
  void undo() { move(past_, future_); }
  /// canRedo() must hold.
  void redo() { move(future_, past_); }

 private:
  static constexpr double kPause = 1;

  void move(std::vector<State>& from, std::vector<State>& to) {
    to.push_back(std::exchange(present_, std::move(from.back())));
    from.pop_back();
    lastChanged_.clear();
  }

  State present_;
  std::vector<State> past_;
  std::vector<State> future_;
  std::string lastChanged_;
  double lastSeconds_ = 0;
};

}  // namespace morphgrid
