/* SPDX-License-Identifier: MIT */
/* Cuts faces into triangles. */
#pragma once

#include "mesh.h"

/* Cuts the face whose n corners, n > 2, are the points of these indices into triangles
 * without new corners. It may be concave, and need not be flat. Writes at most n - 2
 * triangles, and returns how many: none has a corner twice. */
size_t triangulate(const double (*point)[3], const unsigned *corner, size_t n,
    struct mesh_triangle *out);
