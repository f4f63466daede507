// SPDX-License-Identifier: MIT
// Eigen in double and float, on arrays of columns, whose expressions it
// vectorizes.
#include "peer.h"

#if __has_include(<eigen3/Eigen/Dense>)

#include <eigen3/Eigen/Dense>

static Eigen::Matrix4d current;

// Eigen has neither a camera nor a perspective.
static void prepare(const struct view *v)
{
	current = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(
	    &v->matrix[0][0]);
}

template <class T> static void carry(const void *in, void *out, size_t n)
{
	using column = Eigen::Array<T, PEER_BLOCK, 1>;
	using segment = Eigen::Array<T, Eigen::Dynamic, 1, 0, PEER_BLOCK, 1>;
	auto p = static_cast<const column *>(in);
	auto q = static_cast<column *>(out);
	const Eigen::Index size = Eigen::Index(n);
	const Eigen::Matrix<T, 4, 4> m = current.cast<T>();
	const auto x = p[0].head(size), y = p[1].head(size), z = p[2].head(size);
	const segment w = (m(3, 0) * x + m(3, 1) * y + m(3, 2) * z + m(3, 3)).inverse();

	for (int k = 0; k < 3; k++)
		q[k].head(size) = (m(k, 0) * x + m(k, 1) * y + m(k, 2) * z + m(k, 3)) *
		    w;
}

#define TEXT(x) #x
#define VERSION(a, b, c) TEXT(a) "." TEXT(b) "." TEXT(c)

static const char version[] = VERSION(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
    EIGEN_MINOR_VERSION);

const struct peer peers_eigen[] = {
	{ "Eigen, double", version, false, { COLUMNS }, prepare, carry<double>,
	    nullptr },
	{ "Eigen, float", version, true, { COLUMNS }, prepare, carry<float>, nullptr },
	{},
};

#else

const struct peer peers_eigen[] = { {} };

#endif
