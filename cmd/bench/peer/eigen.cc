// Eigen in double.
#include "peer.h"

#if __has_include(<eigen3/Eigen/Geometry>)

#include <cmath>
#include <eigen3/Eigen/Geometry>

using Eigen::Matrix4d;
using Eigen::Vector3d;

static Matrix4d current;

// Eigen has neither of these two matrices, so its users write them out.
static Matrix4d look_at(const struct view *v)
{
	Vector3d eye(v->eye), z = (Vector3d(v->at) - eye).normalized();
	Vector3d x = Vector3d(v->up).cross(z).normalized(), y = z.cross(x);
	Matrix4d m;

	m << x.transpose(), -x.dot(eye), y.transpose(), -y.dot(eye),
	    z.transpose(), -z.dot(eye), 0, 0, 0, 1;
	return m;
}

static Matrix4d perspective(const struct view *v)
{
	double y = 1 / std::tan(v->fovy * (double(EIGEN_PI) / 360));
	double depth = v->far / (v->far - v->near);
	Matrix4d m;

	m << y * v->height / v->width, 0, 0, 0, 0, y, 0, 0, 0, 0, depth,
	    -depth * v->near, 0, 0, 1, 0;
	return m;
}

static void prepare(const struct view *v)
{
	Matrix4d viewport;

	viewport << v->width / 2, 0, 0, v->width / 2, 0, -v->height / 2, 0,
	    v->height / 2, 0, 0, 1, 0, 0, 0, 0, 1;
	current = viewport * perspective(v) * look_at(v);
}

static void carry(const void *in, void *out, size_t n)
{
	auto p = static_cast<const double *>(in);
	auto q = static_cast<double *>(out);
	const Matrix4d m = current;

	for (size_t i = 0; i < n; i++)
		Vector3d::Map(q + 3 * i) =
		    (m * Vector3d::Map(p + 3 * i).homogeneous()).hnormalized();
}

#define TEXT(x) #x
#define VERSION(a, b, c) TEXT(a) "." TEXT(b) "." TEXT(c)

const struct peer peers_eigen[] = {
	{ "Eigen double",
	    VERSION(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
		EIGEN_MINOR_VERSION),
	    0, prepare, carry, nullptr },
	{},
};

#else

const struct peer peers_eigen[] = { {} };

#endif
