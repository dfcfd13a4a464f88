#pragma once
#include "core/interrupt.h"

namespace morphgrid {

/// Of a program that Ctrl-C has ended.
inline constexpr int kInterruptedCode = 130;

enum class InterruptAct {
  stop,  ///< There is something to save: interruptRequested() becomes true.
  end,   ///< There is nothing: the program ends.
};

/// While it lives, that is done on Ctrl-C and SIGTERM, and the line is told on stderr. line: of
/// static storage; empty: none.
class OnInterrupt {
 public:
  OnInterrupt(InterruptAct act, const char* line);
  ~OnInterrupt();
  OnInterrupt(const OnInterrupt&) = delete;
  OnInterrupt& operator=(const OnInterrupt&) = delete;

 private:
  InterruptAct actBefore_;
  const char* lineBefore_;
};

/// Ends the program in so many seconds as a second Ctrl-C does, with the line of the innermost
/// OnInterrupt, unless it has ended by itself. 0: no longer.
void endIn(double seconds);

/// Has a file removed when the program is ended by Ctrl-C. path: lives until keepWhenEnded() is
/// told the number that this returns.
int removeWhenEnded(const char* path);
void keepWhenEnded(int number);

}  // namespace morphgrid
