/* Vectors of three expansions. */
#ifndef VEC3_H
#define VEC3_H

#include <stdbool.h>

#include "exact.h"

/* Exact. */
ex vec3_dot(const ex a[3], const ex b[3]);
void vec3_cross(const ex a[3], const ex b[3], ex r[3]);
bool vec3_is_zero(const ex a[3]);

/* As ex_sqrt. */
ex vec3_length(const ex a[3]);

#endif
