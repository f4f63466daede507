/* SPDX-License-Identifier: MIT */
/* What a program gets that computes images as textbooks say, in floats or in doubles:
 * it answers whether these are enough for a scene. */
#pragma once

#include "frustum.h"

/* Writes the greatest distance in x and y between the textbook's image of a point and
 * the exact one, in device units or, without a viewport, ndc: error[0] of a program
 * that works in floats, error[1] in doubles. The points are 5 x 5 x 5 in the view
 * volume, from end to end, rounded to the type. The program multiplies the matrices of
 * world, camera and projection, then each point by the product, and rounds every
 * operation. An error is nan without near and far planes, without an inverse, and where
 * w of the type is not positive or a number is not finite. */
bool textbook_errors(const struct scene *, double error[2], struct refusals *faults);
