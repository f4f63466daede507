/* SPDX-License-Identifier: MIT */
/* cglm, which has only float, on vectors of four, for which it has intrinsics.
 */
#include "peer.h"

#if __has_include(<cglm/cglm.h>)

#include <math.h>

#define CGLM_FORCE_LEFT_HANDED
#define CGLM_FORCE_DEPTH_ZERO_TO_ONE
#include <cglm/cglm.h>
#include <cglm/version.h>

static mat4 current;

static void vector(const double v[3], vec3 f)
{
	for (int i = 0; i < 3; i++)
		f[i] = (float)v[i];
}

static void prepare(const struct view *v)
{
	const float x = (float)v->width / 2, y = (float)v->height / 2;
	mat4 viewport = { { x, 0, 0, 0 }, { 0, -y, 0, 0 }, { 0, 0, 1, 0 },
		{ x, y, 0, 1 } };
	mat4 view, projection;
	vec3 eye, at, up;

	vector(v->eye, eye);
	vector(v->at, at);
	vector(v->up, up);
	glm_lookat(eye, at, up, view);
	glm_perspective(glm_rad((float)v->fovy), (float)(v->width / v->height),
	    (float)v->near, (float)v->far, projection);
	if (isinf(v->far)) { /* cglm 0.8 has no function for an infinite far */
		projection[2][2] = 1;
		projection[3][2] = (float)-v->near;
	}
	glm_mat4_mulN((mat4 *[]){ &viewport, &projection, &view }, 3, current);
}

static void carry(const void *in, void *out, size_t n)
{
	const vec4 *p = in;
	vec4 *q = out;

	for (size_t i = 0; i < n; i++) {
		vec4 point, image;

		glm_vec4_copy((float *)p[i], point);
		glm_mat4_mulv(current, point, image);
		glm_vec4_divs(image, image[3], q[i]);
	}
}

#define TEXT(x) #x
#define VERSION(a, b, c) TEXT(a) "." TEXT(b) "." TEXT(c)

const struct peer peers_cglm[] = {
	{ "cglm, float",
	    VERSION(CGLM_VERSION_MAJOR, CGLM_VERSION_MINOR, CGLM_VERSION_PATCH), true,
	    { QUADS }, prepare, carry, NULL },
	{ 0 },
};

#else

const struct peer peers_cglm[] = { { 0 } };

#endif
