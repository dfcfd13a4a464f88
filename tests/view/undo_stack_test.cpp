#include "view/undo_stack.h"

#include <gtest/gtest.h>

namespace morphgrid {
namespace {

TEST(UndoStack, GoesBackAndForth) {
  UndoStack<int> stack(1);
  EXPECT_FALSE(stack.canUndo());
  stack.change(2, "a", 0);
  stack.change(3, "b", 0);
  stack.undo();
  EXPECT_EQ(stack.present(), 2);
  stack.undo();
  EXPECT_EQ(stack.present(), 1);
  EXPECT_FALSE(stack.canUndo());
  stack.redo();
  stack.redo();
  EXPECT_EQ(stack.present(), 3);
  EXPECT_FALSE(stack.canRedo());
}

TEST(UndoStack, TakesADragForOneChange) {
  UndoStack<int> stack(1);
  for (int n = 0; n < 100; ++n) {
    stack.change(n, "slider", 0.05 * n);
  }
  stack.undo();
  EXPECT_EQ(stack.present(), 1);
}

TEST(UndoStack, TellsChangesOfOneThingApartAfterAPause) {
  UndoStack<int> stack(1);
  stack.change(2, "slider", 0);
  stack.change(3, "slider", 1.5);
  stack.undo();
  EXPECT_EQ(stack.present(), 2);
}

TEST(UndoStack, ANewChangeForgetsTheFuture) {
  UndoStack<int> stack(1);
  stack.change(2, "a", 0);
  stack.undo();
  stack.change(4, "a", 0.1);
  EXPECT_FALSE(stack.canRedo());
  stack.undo();
  EXPECT_EQ(stack.present(), 1);
}

}  // namespace
}  // namespace morphgrid
