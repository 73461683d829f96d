// What a program draws into, and the picture that comes back.
#pragma once

#include "base/picture.h"
#include "gl/object.h"

namespace dioptre
{

// A float32 RGBA colour target in which draws add up.
struct AccumulationTarget {
    int width = 0;  // pixels
    int height = 0; // pixels
    Texture colour;
    Framebuffer framebuffer;
    VertexArray vertexArray; // empty: core profile wants one bound
};

// Makes the target, clears it to zero, binds it and sets the viewport to it. Throws noOpenGl if float targets
// are missing.
AccumulationTarget makeAccumulationTarget(int width, int height);

// Sets every pixel back to zero.
void clear(const AccumulationTarget& target);

// Draws the full-screen triangle with the current program into [x, x+width) x [y, y+height), adding to what
// is there.
void drawAdding(const AccumulationTarget& target, int x, int y, int width, int height);

// Draws the full-screen triangle over all of the target, in place of what is there.
void drawReplacing(const AccumulationTarget& target);

// Reads the target back: rows from the bottom up, sums as they stand.
Picture readBack(const AccumulationTarget& target);

// The same of the target's lower left `width` x `height` pixels, into a float32 picture with its lower left
// corner at (x, y).
void readBackInto(Picture& picture, int x, int y, const AccumulationTarget& target, int width, int height);

// The longest side that a target can have here, in pixels.
int longestTargetSide();

} // namespace dioptre
