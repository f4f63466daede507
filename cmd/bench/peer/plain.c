/* No library: the loop over columns that anybody can write, for the compiler to
 * make the best of. */
#include <math.h>

#include "peer.h"

static void multiply(double a[4][4], double b[4][4], double m[4][4])
{
	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++) {
			m[i][j] = 0;
			for (int k = 0; k < 4; k++)
				m[i][j] += a[i][k] * b[k][j];
		}
}

static double dot(const double a[3], const double b[3])
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double c[3])
{
	for (int k = 0; k < 3; k++)
		c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] -
		    a[(k + 2) % 3] * b[(k + 1) % 3];
}

static void look_at(const struct view *v, double m[4][4])
{
	double axes[3][3], length;

	for (int k = 0; k < 3; k++)
		axes[2][k] = v->at[k] - v->eye[k];
	cross(v->up, axes[2], axes[0]);
	cross(axes[2], axes[0], axes[1]);
	for (int i = 0; i < 3; i++) {
		length = sqrt(dot(axes[i], axes[i]));
		for (int k = 0; k < 3; k++)
			m[i][k] = axes[i][k] /= length;
		m[i][3] = -dot(axes[i], v->eye);
		m[3][i] = 0;
	}
	m[3][3] = 1;
}

void view_matrix(const struct view *v, double m[4][4])
{
	double y = 1 / tan(v->fovy * (3.14159265358979323846 / 360));
	double depth = isinf(v->far) ? 1 : v->far / (v->far - v->near);
	double projection[4][4] = { { y * v->height / v->width, 0, 0, 0 },
		{ 0, y, 0, 0 }, { 0, 0, depth, -depth * v->near },
		{ 0, 0, 1, 0 } };
	double viewport[4][4] = { { v->width / 2, 0, 0, v->width / 2 },
		{ 0, -v->height / 2, 0, v->height / 2 }, { 0, 0, 1, 0 },
		{ 0, 0, 0, 1 } };
	double view[4][4], both[4][4];

	look_at(v, view);
	multiply(projection, view, both);
	multiply(viewport, both, m);
}

static double matrix[4][4];

static void prepare(const struct view *v)
{
	view_matrix(v, matrix);
}

#define CARRY(name, real)                                             \
	static void name(const void *in, void *out, size_t n)         \
	{                                                             \
		const real *restrict x = in, *y = x + PEER_BLOCK,     \
				     *z = y + PEER_BLOCK;             \
		real *restrict p = out, *q = p + PEER_BLOCK,          \
			       *r = q + PEER_BLOCK, m[4][4];          \
                                                                      \
		for (int i = 0; i < 16; i++)                          \
			m[i / 4][i % 4] = (real)matrix[i / 4][i % 4]; \
		for (size_t i = 0; i < n; i++) {                      \
			real w = 1 /                                  \
			    (m[3][0] * x[i] + m[3][1] * y[i] +        \
				m[3][2] * z[i] + m[3][3]);            \
                                                                      \
			p[i] = (m[0][0] * x[i] + m[0][1] * y[i] +     \
				   m[0][2] * z[i] + m[0][3]) *        \
			    w;                                        \
			q[i] = (m[1][0] * x[i] + m[1][1] * y[i] +     \
				   m[1][2] * z[i] + m[1][3]) *        \
			    w;                                        \
			r[i] = (m[2][0] * x[i] + m[2][1] * y[i] +     \
				   m[2][2] * z[i] + m[2][3]) *        \
			    w;                                        \
		}                                                     \
	}

CARRY(carry_double, double)
CARRY(carry_float, float)

const struct peer peers_plain[] = {
	{ "loop, double", NULL, false, { COLUMNS }, prepare, carry_double },
	{ "loop, float", NULL, true, { COLUMNS }, prepare, carry_float },
	{ 0 },
};
