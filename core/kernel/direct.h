/* SPDX-License-Identifier: MIT */
/* Rows of three doubles to rows of three, in exact, without columns between: they are
 * read twice, for their extent and to be carried. */

/* Each lane keeps to one coordinate while groups of WIDTH rows pass. */
static void extents_of(const char *rows, size_t n, struct extent extent[3])
{
	double low[3 * WIDTH], high[3 * WIDTH];
	V lows[3], highs[3];

	for (int k = 0; k < 3; k++)
		lows[k] = ALL(HUGE_VAL), highs[k] = ALL(-HUGE_VAL);
	for (size_t i = 0; i < n; i += WIDTH)
		for (int k = 0; k < 3; k++) {
			V x = LOAD_BYTES(rows + 24 * i + 8 * WIDTH * k);

			lows[k] = MIN(x, lows[k]);
			highs[k] = MAX(x, highs[k]);
		}
	for (int k = 0; k < 3; k++) {
		STORE(low + WIDTH * k, lows[k]);
		STORE(high + WIDTH * k, highs[k]);
	}
	for (int k = 0; k < 3; k++)
		extent[k] = (struct extent){ low[k], high[k] };
	for (int k = 3; k < 3 * WIDTH; k++) {
		struct extent *e = &extent[k % 3];

		e->low = fmin(e->low, low[k]);
		e->high = fmax(e->high, high[k]);
	}
}

static inline __attribute__((always_inline)) enum direct_state
direct(const struct kernel_map *m, const char *restrict in, char *restrict out,
    size_t n, double most, enum kernel_kind kind)
{
	struct extent extent[3];

	extents_of(in, n, extent);
	for (int k = 0; k < 3; k++)
		if (!(extent[k].low >= -most && extent[k].high <= most))
			return DIRECT_BEYOND;
	const struct block b = block_of(m, extent, kind);
	bool sure = true;

	for (size_t i = 0; i < n; i += WIDTH) {
		V p[3], q[3];

		split_three(in + 24 * i, p);
		sure &= image_of(&b, p, q, kind);
		for (int k = 0; k < 3; k++)
			q[k] = q[k] + ALL(0); /* -0 becomes 0 */
		join_three(out + 24 * i, q);
	}
	return sure ? DIRECT_DONE : DIRECT_UNSURE;
}

#define LOOP(KIND, name)                                          \
	static enum direct_state name(const struct kernel_map *m, \
	    const char *in, char *out, size_t n, double most)     \
	{                                                         \
		return direct(m, in, out, n, most, KIND);         \
	}

LOOP(KERNEL_AFFINE, direct_affine)
LOOP(KERNEL_DEPTH, direct_depth)
LOOP(KERNEL_PROJECTIVE, direct_projective)
#undef LOOP
