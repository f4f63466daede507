/* SPDX-License-Identifier: MIT */
/* Classical methods in one precision: textbook.c includes this file for float and for
 * double. Matrices are for row vectors, whose order in memory is that of GLM and cglm.
 */
typedef struct {
	REAL m[4][4];
} NAME(matrix);

#define MATRIX NAME(matrix)

static MATRIX NAME(unit)(void)
{
	return (MATRIX){ { { 1 }, { 0, 1 }, { 0, 0, 1 }, { 0, 0, 0, 1 } } };
}

static MATRIX NAME(times)(MATRIX a, MATRIX b)
{
	MATRIX r;

	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++)
			r.m[i][j] = a.m[i][0] * b.m[0][j] + a.m[i][1] * b.m[1][j] +
			    a.m[i][2] * b.m[2][j] + a.m[i][3] * b.m[3][j];
	return r;
}

/* Returns the inverse as the adjugate over the determinant. */
static MATRIX NAME(inverse)(MATRIX a)
{
	MATRIX r;
	REAL det = 0;

	for (int i = 0; i < 4; i++)
		for (int j = 0; j < 4; j++) {
			const REAL *p = a.m[(i + 1) % 4];
			const REAL *q = a.m[(i + 2) % 4];
			const REAL *s = a.m[(i + 3) % 4];
			int k = (j + 1) % 4, l = (j + 2) % 4, n = (j + 3) % 4;
			REAL minor = p[k] * (q[l] * s[n] - q[n] * s[l]) +
			    p[l] * (q[n] * s[k] - q[k] * s[n]) +
			    p[n] * (q[k] * s[l] - q[l] * s[k]);

			r.m[j][i] = (i + j) % 2 ? -minor : minor;
		}
	for (int j = 0; j < 4; j++)
		det += a.m[0][j] * r.m[j][0];
	for (int i = 0; i < 16; i++)
		r.m[i / 4][i % 4] *= 1 / det;
	return r;
}

/* Returns the inverse by Gaussian elimination with partial pivoting, as in numpy and
 * Eigen. */
static MATRIX NAME(inverse_lu)(MATRIX a)
{
	MATRIX r = NAME(unit)();

	for (int k = 0; k < 4; k++) {
		int pivot = k;

		for (int i = k + 1; i < 4; i++)
			if (fabs((double)a.m[i][k]) > fabs((double)a.m[pivot][k]))
				pivot = i;
		for (int j = 0; j < 4; j++) {
			REAL b = a.m[k][j], c = r.m[k][j];

			a.m[k][j] = a.m[pivot][j];
			r.m[k][j] = r.m[pivot][j];
			a.m[pivot][j] = b;
			r.m[pivot][j] = c;
		}
		for (int i = k + 1; i < 4; i++) {
			REAL factor = a.m[i][k] / a.m[k][k];

			for (int j = 0; j < 4; j++) {
				a.m[i][j] -= factor * a.m[k][j];
				r.m[i][j] -= factor * r.m[k][j];
			}
		}
	}
	for (int k = 3; k >= 0; k--)
		for (int j = 0; j < 4; j++) {
			for (int i = k + 1; i < 4; i++)
				r.m[k][j] -= a.m[k][i] * r.m[i][j];
			r.m[k][j] /= a.m[k][k];
		}
	return r;
}

static REAL NAME(dot)(const REAL a[3], const REAL b[3])
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void NAME(normalize)(REAL a[3])
{
	REAL length = SQRT(NAME(dot)(a, a));

	for (int i = 0; i < 3; i++)
		a[i] /= length;
}

static void NAME(cross)(const REAL a[3], const REAL b[3], REAL r[3])
{
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;

		r[i] = a[j] * b[k] - a[k] * b[j];
	}
}

static REAL NAME(radians)(double degrees)
{
	return (REAL)degrees * (REAL)0.017453292519943295769;
}

/* Returns the matrix of glm::lookAtRH. */
static MATRIX NAME(look)(const struct camera *c)
{
	MATRIX r = NAME(unit)();
	REAL eye[3], up[3], f[3], s[3], u[3];

	for (int i = 0; i < 3; i++) {
		eye[i] = (REAL)c->eye[i];
		up[i] = (REAL)c->up[i];
		f[i] = (REAL)c->at[i] - eye[i];
	}
	NAME(normalize)(f);
	NAME(cross)(f, up, s);
	NAME(normalize)(s);
	NAME(cross)(s, f, u);
	for (int i = 0; i < 3; i++) {
		r.m[i][0] = s[i];
		r.m[i][1] = u[i];
		r.m[i][2] = -f[i];
	}
	r.m[3][0] = -NAME(dot)(s, eye);
	r.m[3][1] = -NAME(dot)(u, eye);
	r.m[3][2] = NAME(dot)(f, eye);
	return r;
}

/* Returns a view matrix that is turned by the roll in steps of TURN. */
static MATRIX NAME(turned)(MATRIX view, const struct camera *c)
{
	MATRIX turn = NAME(unit)();
	REAL angle = NAME(radians)(TURN);
	double m[4][4];

	turn.m[0][0] = turn.m[1][1] = COS(angle);
	turn.m[0][1] = SIN(angle);
	turn.m[1][0] = -turn.m[0][1];
	for (double roll = 0; roll < c->roll; roll += TURN)
		view = NAME(times)(view, turn);
	if (!c->orthonormalize)
		return view;
	for (int i = 0; i < 16; i++)
		m[i / 4][i % 4] = (double)view.m[i / 4][i % 4];
	nearest_rotation(m);
	for (int i = 0; i < 16; i++)
		view.m[i / 4][i % 4] = (REAL)m[i / 4][i % 4];
	return view;
}

/* Sets the elements of depth as in glm::perspectiveRH_NO and
 * glm::infinitePerspectiveRH_NO or, reversed too, as in glm::infinitePerspectiveRH_ZO.
 */
static void NAME(put_depth)(const struct scene *s, MATRIX *r)
{
	const struct projection *p = &s->projection;
	REAL n = (REAL)p->near, f = (REAL)p->far;

	r->m[2][3] = -1;
	if (p->reverse_z) {
		r->m[3][2] = n;
	} else if (isinf(p->far)) {
		r->m[2][2] = -1;
		r->m[3][2] = s->convention.depth_minus_one ? -2 * n : -n;
	} else {
		r->m[2][2] = -(f + n) / (f - n);
		r->m[3][2] = -(2 * f * n) / (f - n);
	}
}

static MATRIX NAME(perspective)(const struct scene *s)
{
	const struct projection *p = &s->projection;
	MATRIX r = { 0 };
	REAL t = TAN(NAME(radians)(p->section.angle) / 2);

	r.m[0][0] = 1 / ((REAL)(p->aspect[0] / p->aspect[1]) * t);
	r.m[1][1] = 1 / t;
	NAME(put_depth)(s, &r);
	return r;
}

/* Returns the matrix of glm::frustumRH_NO. */
static MATRIX NAME(frustum)(const struct scene *s)
{
	const struct projection *p = &s->projection;
	MATRIX r = { 0 };
	REAL n = (REAL)p->near;
	REAL x = (REAL)p->section.left, y = (REAL)p->section.bottom;
	REAL width = (REAL)p->section.right - x, height = (REAL)p->section.top - y;

	r.m[0][0] = 2 * n / width;
	r.m[1][1] = 2 * n / height;
	r.m[2][0] = ((REAL)p->section.right + x) / width;
	r.m[2][1] = ((REAL)p->section.top + y) / height;
	NAME(put_depth)(s, &r);
	return r;
}

static MATRIX NAME(given)(const double m[4][4])
{
	MATRIX r;

	for (int i = 0; i < 16; i++)
		r.m[i / 4][i % 4] = (REAL)m[i / 4][i % 4];
	return r;
}

/* Returns whether a volume counts as parallel, by the threshold of Hilton. */
static bool NAME(is_parallel)(const struct projection *p)
{
	return fabs(p->volume.inverse_eye_z) < 1e-6;
}

/* Returns the matrix of a volume without skew: a parallel one, or a perspective whose
 * origin is the eye. */
static MATRIX NAME(volume)(const struct projection *p)
{
	MATRIX r = { 0 };
	REAL zn = (REAL)p->volume.z_near, zf = (REAL)p->volume.z_far, scale = 1;

	if (NAME(is_parallel)(p)) {
		r.m[2][2] = -2 / (zn - zf);
		r.m[3][2] = (zn + zf) / (zn - zf);
		r.m[3][3] = 1;
	} else {
		REAL ez = scale = 1 / (REAL)p->volume.inverse_eye_z;

		r.m[2][2] = (zn + zf - 2 * ez) / (zn - zf);
		r.m[2][3] = -1;
		r.m[3][2] = -2 * (ez - zn) * (ez - zf) / (zn - zf);
	}
	r.m[0][0] = scale / (REAL)p->volume.half_width;
	r.m[1][1] = scale / (REAL)p->volume.half_height;
	return r;
}

static MATRIX NAME(project)(const struct scene *s)
{
	const struct projection *p = &s->projection;

	if (p->type == PROJECTION_VOLUME)
		return NAME(volume)(p);
	if (p->type == PROJECTION_MATRIX)
		return NAME(given)(p->matrix);
	return p->section.way == SECTION_EDGES ? NAME(frustum)(s) :
						 NAME(perspective)(s);
}

/* Returns the view matrix, and sets origin to the point that becomes the origin. */
static MATRIX NAME(view)(const struct scene *s, REAL origin[3])
{
	const struct projection *p = &s->projection;
	MATRIX r = NAME(unit)();

	if (s->has_camera) {
		for (int i = 0; i < 3; i++)
			origin[i] = (REAL)s->camera.eye[i];
		return NAME(turned)(NAME(look)(&s->camera), &s->camera);
	}
	if (p->type == PROJECTION_VOLUME && !NAME(is_parallel)(p)) {
		origin[2] = 1 / (REAL)p->volume.inverse_eye_z;
		r.m[3][2] = -origin[2];
	}
	return r;
}

/* Returns T(-cx, -cy) S(2/W, 2/H) of the zoomed window, whose centre is cx, cy. */
static MATRIX NAME(window)(const struct window *w, REAL center[3])
{
	MATRIX r = NAME(unit)();
	const double size[2] = { w->width, w->height };
	REAL zoom = (REAL)w->zoom;

	for (int i = 0; i < 2; i++) {
		REAL about = (REAL)w->about[i];

		center[i] = about + ((REAL)w->center[i] - about) / zoom;
		r.m[i][i] = 2 / ((REAL)size[i] / zoom);
		r.m[3][i] = -center[i] * r.m[i][i];
	}
	return r;
}

static MATRIX NAME(viewport)(const struct scene *s)
{
	const struct viewport *v = &s->viewport;
	MATRIX r = NAME(unit)();
	REAL w = (REAL)v->width / 2, h = (REAL)v->height / 2;
	REAL min = (REAL)v->min_z, max = (REAL)v->max_z;

	r.m[0][0] = w;
	r.m[1][1] = h;
	r.m[2][2] = s->convention.depth_minus_one ? (max - min) / 2 : max - min;
	r.m[3][0] = (REAL)v->x + w;
	r.m[3][1] = (REAL)v->y + h;
	r.m[3][2] = s->convention.depth_minus_one ? (max + min) / 2 : min;
	return r;
}

/* The matrices that a point passes. The offset before is subtracted from a point before
 * the stage taken, and after is added after the last stage. */
typedef struct {
	int n, taken;
	MATRIX stage[4];
	REAL before[3], after[3];
} NAME(path);

#define PATH NAME(path)

static void NAME(turn_back)(PATH *p, enum way way)
{
	PATH there = *p;

	for (int i = 0; i < p->n; i++) {
		MATRIX m = there.stage[p->n - 1 - i];

		p->stage[i] = way == LU ? NAME(inverse_lu)(m) : NAME(inverse)(m);
	}
	memcpy(p->after, p->before, sizeof p->after);
	memset(p->before, 0, sizeof p->before);
}

static PATH NAME(path_of)(const struct scene *s, enum way way, bool back)
{
	PATH r = { 0 };
	REAL origin[3] = { 0 };

	if (s->has_world)
		r.stage[r.n++] = NAME(given)(s->world.matrix);
	r.taken = r.n;
	if (s->has_window) {
		r.stage[r.n++] = NAME(window)(&s->window, origin);
	} else {
		r.stage[r.n++] = NAME(view)(s, origin);
		r.stage[r.n++] = NAME(project)(s);
	}
	r.stage[r.n++] = NAME(viewport)(s);
	if (way == RELATIVE) {
		memcpy(r.before, origin, sizeof origin);
		memset(r.stage[r.taken].m[3], 0, sizeof origin);
	}
	if (way == SINGLE || way == COMPOSED || way == LU) {
		for (int i = 1; i < r.n; i++)
			r.stage[0] = NAME(times)(r.stage[0], r.stage[i]);
		r.n = 1;
	}
	if (back)
		NAME(turn_back)(&r, way);
	return r;
}

static void NAME(carry)(const struct scene *s, enum way way, bool back, double (*in)[3],
    double (*out)[4], size_t n)
{
	PATH path = NAME(path_of)(s, way, back);

	for (size_t k = 0; k < n; k++) {
		REAL p[4] = { [3] = 1 }, w = 1;

		for (int i = 0; i < 3; i++)
			p[i] = (REAL)in[k][i];
		for (int l = 0; l < path.n; l++) {
			REAL q[4] = { 0 };

			for (int i = 0; i < 3 && l == path.taken; i++)
				p[i] -= path.before[i];
			for (int j = 0; j < 4; j++)
				for (int i = 0; i < 4; i++)
					q[j] += p[i] * path.stage[l].m[i][j];
			for (int j = 0; j < 4; j++)
				p[j] = q[j] / q[3];
			w *= q[3];
		}
		for (int j = 0; j < 3; j++)
			out[k][j] = (double)(p[j] + path.after[j]);
		out[k][3] = (double)w;
	}
}

#undef MATRIX
#undef PATH
