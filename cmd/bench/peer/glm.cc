// SPDX-License-Identifier: MIT
// GLM in float and in double.
#include "peer.h"

#if __has_include(<glm/glm.hpp>)

#define GLM_FORCE_INTRINSICS

#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/glm.hpp>

template <class T> using mat4 = glm::mat<4, 4, T>;

template <class T> static mat4<T> current;

template <class T> static glm::vec<3, T> vector(const double v[3])
{
	return { T(v[0]), T(v[1]), T(v[2]) };
}

// For an infinite far, GLM 0.9.9 has only depth from -1 to 1.
template <class T> static mat4<T> perspective(const struct view *v)
{
	T fovy = glm::radians(T(v->fovy)), aspect = T(v->width / v->height);

	if (!std::isinf(v->far))
		return glm::perspectiveLH_ZO(fovy, aspect, T(v->near), T(v->far));
	mat4<T> half(T(1));

	half[2][2] = half[3][2] = T(0.5);
	return half * glm::infinitePerspectiveLH(fovy, aspect, T(v->near));
}

template <class T> static void prepare(const struct view *v)
{
	const T x = T(v->width / 2), y = T(v->height / 2);
	const mat4<T> viewport(x, 0, 0, 0, 0, -y, 0, 0, 0, 0, 1, 0, x, y, 0, 1);

	current<T> = viewport * perspective<T>(v) *
	    glm::lookAtLH(vector<T>(v->eye), vector<T>(v->at), vector<T>(v->up));
}

// Transforms points. In double, vectors of four are the fastest, as they have
// intrinsics; in float, vectors of three, which the compiler vectorizes.
template <class T, int L, glm::qualifier Q>
static void carry(const void *in, void *out, size_t n)
{
	auto p = static_cast<const glm::vec<L, T, Q> *>(in);
	auto q = static_cast<glm::vec<L, T, Q> *>(out);
	const glm::mat<4, 4, T, Q> m(current<T>);

	for (size_t i = 0; i < n; i++) {
		glm::vec<4, T, Q> image;

		if constexpr (L == 3)
			image = m * glm::vec<4, T, Q>(p[i], T(1));
		else
			image = m * p[i];
		q[i] = glm::vec<L, T, Q>(image) * (T(1) / image.w);
	}
}

#define TEXT(x) #x
#define VERSION(a, b, c, d) TEXT(a) "." TEXT(b) "." TEXT(c) "." TEXT(d)

static const char version[] = VERSION(GLM_VERSION_MAJOR, GLM_VERSION_MINOR,
    GLM_VERSION_PATCH, GLM_VERSION_REVISION);

const struct peer peers_glm[] = {
	{ "GLM, double", version, false, { QUADS }, prepare<double>,
	    carry<double, 4, glm::aligned_highp>, nullptr },
	{ "GLM, float", version, true, { TRIPLES }, prepare<float>,
	    carry<float, 3, glm::packed_highp>, nullptr },
	{},
};

#else

const struct peer peers_glm[] = { {} };

#endif
