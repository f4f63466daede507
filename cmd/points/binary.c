#include "binary.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Inline, so that the compiler makes a copy with constant bounds for the usual
 * kind of point, three doubles. The machine is little-endian, as the numbers
 * are. */
static inline void unpack(struct chunk *c, size_t n, size_t reads, bool wide)
{
	const char *restrict text = c->text;

	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < reads; k++) {
			float narrow;

			if (wide) {
				memcpy(&c->in[k][i], text + 8 * (reads * i + k),
				    8);
				continue;
			}
			memcpy(&narrow, text + 4 * (reads * i + k), 4);
			c->in[k][i] = (double)narrow;
		}
}

static bool all_within(const struct chunk *c, size_t n, size_t reads)
{
	int beyond = 0;

	for (size_t k = 0; k < reads; k++)
		for (size_t i = 0; i < n; i++)
			beyond |= fabs(c->in[k][i]) > MAGNITUDE_MAX;
	return !beyond;
}

/* Complains of points beyond the range. The first of them ends the chunk,
 * unless the job keeps going. Returns how many points it goes on with. */
static size_t refuse_beyond(const struct job *j, struct chunk *c, size_t n,
    size_t reads)
{
	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < reads; k++) {
			if (!(fabs(c->in[k][i]) > MAGNITUDE_MAX))
				continue;
			chunk_complain(c, c->n_lines + i,
			    "a coordinate is beyond 1e150 in magnitude; "
			    "choose another unit");
			if (!j->keep_going) {
				c->text = c->end;
				return i;
			}
			c->in[k][i] = (double)NAN;
			break;
		}
	return n;
}

size_t binary_read(const struct job *j, struct chunk *c)
{
	size_t size = point_size(j->layout.in, j->layout.reads);
	size_t n = (size_t)(c->end - c->text) / size;
	size_t reads = (size_t)j->layout.reads;
	bool wide = j->layout.in == FORMAT_F64;

	if (n > POINTS_BLOCK)
		n = POINTS_BLOCK;
	if (wide && reads == 3)
		unpack(c, n, 3, true);
	else
		unpack(c, n, reads, wide);
	c->text += n * size;
	if (!all_within(c, n, reads))
		n = refuse_beyond(j, c, n, reads);
	c->n_lines += n;
	return n;
}

/* v, coordinate k of the image of point p, as a float. With precision exact it
 * is computed anew: what is rounded to a double and then to a float may not be
 * the nearest float. */
static float narrowed(const struct job *j, const struct chunk *c, size_t p,
    int k, double v)
{
	double in[4];

	if (j->rays || j->accuracy.precision != PRECISION_EXACT)
		return (float)v;
	for (int i = 0; i < 4; i++)
		in[i] = c->in[i][p];
	return point_single(&j->transform, in, k, v);
}

void binary_write(const struct job *j, struct chunk *c, size_t p,
    const double *v)
{
	size_t size = point_size(j->layout.out, j->layout.writes);
	char *at = chunk_reserve(c, size);

	for (int k = 0; k < j->layout.writes; k++) {
		double wide = v[k] + 0.0; /* -0 is 0 */
		float narrow = j->layout.out == FORMAT_F32 && !isnan(wide) ?
		    narrowed(j, c, p, k, wide) + 0.0f :
		    (float)wide;

		if (isinf(narrow))
			narrow = NAN;
		if (j->layout.out == FORMAT_F64)
			memcpy(at + 8 * k, &wide, 8);
		else
			memcpy(at + 4 * k, &narrow, 4);
	}
	c->size += size;
}

static inline void pack(const struct chunk *c, char *restrict at, size_t n,
    size_t writes)
{
	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < writes; k++) {
			double v = c->image[k][i] + 0.0; /* -0 is 0 */

			memcpy(at + 8 * (writes * i + k), &v, 8);
		}
}

static bool all_finite(const struct chunk *c, size_t n, size_t writes)
{
	int bad = 0;

	for (size_t k = 0; k < writes; k++)
		for (size_t i = 0; i < n; i++)
			bad |= !(fabs(c->image[k][i]) <= DBL_MAX);
	return !bad;
}

void binary_write_block(const struct job *j, struct chunk *c, size_t n,
    size_t first_line)
{
	size_t writes = (size_t)j->layout.writes;
	size_t size = n * point_size(FORMAT_F64, j->layout.writes);
	char *at = chunk_reserve(c, size);

	if (!all_finite(c, n, writes))
		for (size_t i = 0; i < n; i++)
			chunk_mark(c, &j->layout, i, first_line + i);
	if (writes == 3)
		pack(c, at, n, 3);
	else
		pack(c, at, n, writes);
	c->size += size;
}
