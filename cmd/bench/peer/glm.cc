// GLM in float and in double.
#include "peer.h"

#if __has_include(<glm/glm.hpp>)

#include <cstdio>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/glm.hpp>

template <class T> struct scene {
	glm::mat<4, 4, T> m;
	glm::vec<4, T> viewport;
};

template <class T> static scene<T> current;

template <class T> static glm::vec<3, T> vector(const double v[3])
{
	return { T(v[0]), T(v[1]), T(v[2]) };
}

template <class T> static void prepare(const struct view *v)
{
	auto view = glm::lookAtLH(vector<T>(v->eye), vector<T>(v->at),
	    vector<T>(v->up));
	auto projection = glm::perspectiveLH_ZO(glm::radians(T(v->fovy)),
	    T(v->width / v->height), T(v->near), T(v->far));

	current<T>.m = projection * view;
	current<T>.viewport = { T(0), T(v->height), T(v->width),
		T(-v->height) };
}

// As glm::projectZO, which would multiply by two matrices.
template <class T>
static inline glm::vec<3, T> project(const scene<T> &s, glm::vec<3, T> p)
{
	glm::vec<4, T> q = s.m * glm::vec<4, T>(p, T(1));

	q /= q.w;
	return { (q.x * T(0.5) + T(0.5)) * s.viewport.z + s.viewport.x,
		(q.y * T(0.5) + T(0.5)) * s.viewport.w + s.viewport.y, q.z };
}

template <class T> static void carry(const void *in, void *out, size_t n)
{
	auto p = static_cast<const glm::vec<3, T> *>(in);
	auto q = static_cast<glm::vec<3, T> *>(out);
	const scene<T> s = current<T>;

	for (size_t i = 0; i < n; i++)
		q[i] = project(s, p[i]);
}

template <class T> static void filter(void)
{
	const int digits = sizeof(T) == sizeof(float) ? 9 : 17;
	double x, y, z;

	while (scanf("%lf %lf %lf", &x, &y, &z) == 3) {
		auto q = project(current<T>, { T(x), T(y), T(z) });

		printf("%.*g %.*g %.*g\n", digits, double(q.x), digits,
		    double(q.y), digits, double(q.z));
	}
}

#define TEXT(x) #x
#define VERSION(a, b, c, d) TEXT(a) "." TEXT(b) "." TEXT(c) "." TEXT(d)

static const char version[] = VERSION(GLM_VERSION_MAJOR, GLM_VERSION_MINOR,
    GLM_VERSION_PATCH, GLM_VERSION_REVISION);

const struct peer peers_glm[] = {
	{ "GLM float", version, 1, prepare<float>, carry<float>,
	    filter<float> },
	{ "GLM double", version, 0, prepare<double>, carry<double>,
	    filter<double> },
	{},
};

#else

const struct peer peers_glm[] = { {} };

#endif
