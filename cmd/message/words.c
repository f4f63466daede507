/* SPDX-License-Identifier: MIT */
#include "words.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

/* Words of other programs, with blanks between them, and the hint (word_hint) for each
 * of these words. Names that other programs have for members are in the tables of
 * cmd/scene. */
static const struct {
	const char *words, *hint;
} synonyms[] = {
	{ "unproject backproject", "project --from device --to world" },
	{ "inverse invert",
	    ": the way back is project --from device --to world; of lookat "
	    "project -m --from view --to world; in 2D d2w, n2w or d2n" },
	{ "ray raycast", "project --ray" },
	{ "transform points", "project" },
	{ "mvp matrix", "project -m --to clip" },
	{ "pose", "project -m --from view --to world" },
	{ "viewport", "project --from ndc --to device" },
	{ "camera view lookat", "lookat" },
	{ "camera", "project --to view" },
	{ "perspective projection", "persp" },
	{ "frustum",
	    ": persp makes one of its left, right, bottom, top, near and far, "
	    "and inspect describes one" },
	{ "orthographic", "ortho" },
	{ "cavalier cabinet", "oblique" },
	{ "window", "w2n" },
	{ "device", "n2d" },
	{ "bounds zoom extent", "fit" },
	{ "info", "inspect" },
	{ "click", "pick" },
	{ "explain", "trace" },
	{ "usage man", "help" },

	{ "format", "--output" },
	{ "json", "--output json" },
	{ "csv", "--input csv" },
	{ "delimiter", "--separator" },
	{ "cols", "--columns" },
	{ "space", "--to" },
	{ "threads", "--jobs" },
	{ "round places", "--decimals" },
	{ "epsilon", "--tolerance" },
	{ "cull", "--visible" },
	{ "verbose", "--progress" },
	{ "convert opengl", "--convention gl" },
	{ "directx direct3d", "--convention d3d" },
	{ "ros", "--convention opencv" },
	{ "d3d gl vulkan webgpu opencv", "--convention *" },
	{ "pixel pixels screen image", "--to device" },
	{ "world view clip ndc device", "--to *" },
	{ "depth", "--plane" },
	{ "float", "--precision single" },

	{ "stdin", ": standard input is - in place of PARAMS or POINTS" },
	{ "quiet", ": notes go to standard error; 2>/dev/null hides them" },
	{ "distortion undistort distortioncoefficients distortionmodel "
	  "distcoeffs dist d k1 k2 k3 p1 p2",
	    ": lenses are not modelled; undistort points first" },
	{ "lens sensorwidth sensorheight sensorsize",
	    ": \"fovx\" is 2 atan(sensor width / 2 / focal length)" },
	{ "size imagesize windowsize resolution",
	    ": give \"width\" and \"height\", of a picture in \"viewport\"" },
	{ "euler rotationeuler",
	    ": give the quaternion of these angles as \"orientation\"" },
	{ "zoom", ": only a window has it; in 3D give a smaller \"fovy\"" },
	{ "scale", ": only a viewport has it; \"world\" can scale points" },
};

enum { SYNONYMS = sizeof synonyms / sizeof *synonyms };

const char *word_hint(const char *word, char first)
{
	for (int i = 0; i < SYNONYMS; i++)
		if ((first == '\0' || *synonyms[i].hint == first) &&
		    word_is_one_of(word, synonyms[i].words))
			return synonyms[i].hint;
	return NULL;
}

/* Returns whether `word` begins with `start` and `start` has at least three letters. */
static bool begins_with(const char *word, const char *start)
{
	size_t n = strlen(start);

	return n > 2 && strncasecmp(word, start, n) == 0;
}

/* Returns whether at most n edits, which word_nearest defines, make b of a. */
static bool edits_reach(const char *a, const char *b, int n)
{
	for (; *a != '\0' && strncasecmp(a, b, 1) == 0; a++)
		b++;
	if (*a == '\0' && *b == '\0')
		return true;
	if (n == 0)
		return false;
	if ((*a != '\0' && edits_reach(a + 1, b, n - 1)) ||
	    (*b != '\0' && edits_reach(a, b + 1, n - 1)))
		return true;
	if (*a == '\0' || *b == '\0')
		return false;
	return edits_reach(a + 1, b + 1, n - 1) ||
	    (strncasecmp(a, b + 1, 1) == 0 && strncasecmp(a + 1, b, 1) == 0 &&
		edits_reach(a + 2, b + 2, n - 1));
}

const char *word_nearest(const char *word, const char *const *words)
{
	const char *const *w;
	size_t length = strlen(word);
	int most = length < 2 ? 0 : length < 6 ? 1 : length < 9 ? 2 : 3;

	for (int i = 0; i < SYNONYMS; i++) {
		const char *last = strrchr(synonyms[i].hint, ' ');

		for (w = words; last != NULL && *w != NULL; w++)
			if (strcmp(last + 1, *w) == 0 &&
			    word_is_one_of(word, synonyms[i].words))
				return *w;
	}
	for (int n = 0; n <= most; n++)
		for (w = words; *w != NULL; w++)
			if (edits_reach(word, *w, n))
				return *w;
	for (; *words != NULL; words++)
		if (begins_with(word, *words) || begins_with(*words, word))
			return *words;
	return NULL;
}

bool word_is_one_of(const char *word, const char *words)
{
	for (const char *s = word; words != NULL; words++) {
		while (*s == '_' || *s == '-')
			s++;
		if (*words == '_')
			continue;
		if (*s == '\0' && (*words == '\0' || *words == ' '))
			return true;
		if (*words > ' ' && tolower((unsigned char)*s) == *words) {
			s++;
			continue;
		}
		words += strcspn(words, " ");
		if (*words == '\0')
			break;
		s = word;
	}
	return false;
}
