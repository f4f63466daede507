/* The rotation that is nearest to a matrix. */
#ifndef ROTATION_H
#define ROTATION_H

#include "mat.h"

/* The quaternion x y z w, of any norm and within 2^-250 of it, of the rotation
 * nearest to the upper 3x3 of a camera's matrix: its polar factor. Returns NULL, or
 * the member and the reason. */
const char *nearest_rotation(const double matrix[4][4], struct sum q[4]);

#endif
