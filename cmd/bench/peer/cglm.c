/* cglm, which has float only: glm_project. */
#include "peer.h"

#if __has_include(<cglm/cglm.h>)

#include <stdio.h>

#define CGLM_FORCE_LEFT_HANDED
#define CGLM_FORCE_DEPTH_ZERO_TO_ONE
#include <cglm/cglm.h>
#include <cglm/version.h>

static mat4 current;
static vec4 viewport;

static void vector(const double v[3], vec3 f)
{
	for (int i = 0; i < 3; i++)
		f[i] = (float)v[i];
}

static void prepare(const struct view *v)
{
	vec3 eye, at, up;
	mat4 view, projection;

	vector(v->eye, eye);
	vector(v->at, at);
	vector(v->up, up);
	glm_lookat(eye, at, up, view);
	glm_perspective(glm_rad((float)v->fovy), (float)(v->width / v->height),
	    (float)v->near, (float)v->far, projection);
	glm_mat4_mul(projection, view, current);
	viewport[0] = 0;
	viewport[1] = (float)v->height;
	viewport[2] = (float)v->width;
	viewport[3] = (float)-v->height;
}

static void carry(const void *in, void *out, size_t n)
{
	const float *p = in;
	float *q = out;

	for (size_t i = 0; i < n; i++) {
		vec3 point = { p[3 * i], p[3 * i + 1], p[3 * i + 2] };

		glm_project(point, current, viewport, q + 3 * i);
	}
}

static void filter(void)
{
	vec3 p, q;

	while (scanf("%f %f %f", &p[0], &p[1], &p[2]) == 3) {
		glm_project(p, current, viewport, q);
		printf("%.9g %.9g %.9g\n", (double)q[0], (double)q[1],
		    (double)q[2]);
	}
}

#define TEXT(x) #x
#define VERSION(a, b, c) TEXT(a) "." TEXT(b) "." TEXT(c)

const struct peer peers_cglm[] = {
	{ "cglm float",
	    VERSION(CGLM_VERSION_MAJOR, CGLM_VERSION_MINOR, CGLM_VERSION_PATCH),
	    1, prepare, carry, filter },
	{ 0 },
};

#else

const struct peer peers_cglm[] = { { 0 } };

#endif
