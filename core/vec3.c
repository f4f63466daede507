#include "vec3.h"

ex vec3_dot(const ex a[3], const ex b[3])
{
	ex s = ex_mul(a[0], b[0]);

	return ex_add(ex_add(s, ex_mul(a[1], b[1])), ex_mul(a[2], b[2]));
}

void vec3_cross(const ex a[3], const ex b[3], ex r[3])
{
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;

		r[i] = ex_sub(ex_mul(a[j], b[k]), ex_mul(a[k], b[j]));
	}
}

bool vec3_is_zero(const ex a[3])
{
	return ex_sign(a[0]) == 0 && ex_sign(a[1]) == 0 && ex_sign(a[2]) == 0;
}

ex vec3_length(const ex a[3])
{
	return ex_sqrt(vec3_dot(a, a));
}
