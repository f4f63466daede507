/* Other people's libraries, each used as its own users would when they care
 * for speed: one composed matrix, then a product and a division a point. */
#ifndef PEERS_BENCH_H
#define PEERS_BENCH_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A camera, a perspective and a viewport in Direct3D's convention: z into the
 * screen, depth from 0 to 1, y down. */
struct view {
	double eye[3], at[3], up[3];
	double fovy; /* degrees */
	double near, far;
	double width, height;
};

/* What a peer has not been written for is NULL. */
struct peer {
	const char *name, *version;
	int single; /* points in memory are floats, not doubles */
	void (*prepare)(const struct view *);
	/* n points, x y z side by side. */
	void (*carry)(const void *in, void *out, size_t n);
	/* Lines of three numbers from standard input to standard output. */
	void (*filter)(void);
};

/* Each ends with a name NULL; what is not installed is not there. */
extern const struct peer peers_glm[], peers_cglm[], peers_eigen[];

#ifdef __cplusplus
}
#endif

#endif
