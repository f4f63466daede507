/* SPDX-License-Identifier: MIT */
#include "words.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

enum {
	CALL = WORD_COMMAND | WORD_OPTION,
	/* The last word of the hint is also meant where it is a possible value. */
	VALUE = CALL | WORD_VALUE,
	REMARK = WORD_COMMAND | WORD_OPTION | WORD_MEMBER,
};

/* Words of other programs, with blanks between them, where they stand, and the hint
 * (word_hint) for each of these words. Names that other programs have for members are in
 * the tables of cmd/scene. */
/* clang-format off */
static const struct {
	unsigned places; /* as bits of enum word_place */
	const char *words, *hint;
} word_rows[] = {
	{ VALUE, "unproject backproject", "project --from device --to world" },
	{ REMARK, "inverse invert",
	    ": the way back is project --from device --to world; of lookat project -m "
	    "--from view --to world; in 2D d2w, n2w or d2n" },
	{ VALUE, "ray raycast", "project --ray" },
	{ CALL, "transform points", "project" },
	{ VALUE, "mvp matrix", "project -m --to clip" },
	{ VALUE, "pose", "project -m --from view --to world" },
	{ VALUE, "viewport", "project --from ndc --to device" },
	{ CALL, "camera view lookat", "lookat" },
	{ VALUE, "camera", "project --to view" },
	{ CALL, "perspective projection", "persp" },
	{ REMARK, "frustum",
	    ": persp makes one of its left, right, bottom, top, near and far, and inspect "
	    "describes one" },
	{ CALL, "orthographic", "ortho" },
	{ CALL, "cavalier cabinet", "oblique" },
	{ CALL, "window", "w2n" },
	{ CALL, "device", "n2d" },
	{ CALL, "bounds zoom extent", "fit" },
	{ CALL, "info", "inspect" },
	{ CALL, "click", "pick" },
	{ CALL, "explain", "trace" },
	{ CALL, "usage man", "help" },

	{ CALL, "format", "--output" },
	{ VALUE, "json", "--output json" },
	{ VALUE, "csv", "--input csv" },
	{ CALL, "delimiter", "--separator" },
	{ CALL, "cols", "--columns" },
	{ CALL, "space", "--to" },
	{ CALL, "threads", "--jobs" },
	{ CALL, "round places", "--decimals" },
	{ CALL, "epsilon", "--tolerance" },
	{ CALL, "cull", "--visible" },
	{ CALL, "verbose", "--progress" },
	{ VALUE, "convert opengl", "--convention gl" },
	{ VALUE, "directx direct3d", "--convention d3d" },
	{ VALUE, "ros", "--convention opencv" },
	{ CALL, "d3d gl vulkan webgpu opencv", "--convention *" },
	{ VALUE, "pixel pixels screen image", "--to device" },
	{ CALL, "world view clip ndc device", "--to *" },
	{ CALL, "depth", "--plane" },
	{ VALUE, "float", "--precision single" },

	{ REMARK, "stdin", ": standard input is - in place of PARAMS or POINTS" },
	{ CALL, "silent", "--quiet" },
	{ REMARK, "distortion undistort distortioncoefficients distortionmodel "
	    "distcoeffs dist d k1 k2 k3 p1 p2",
	    ": lenses are not modelled; undistort points first" },
	{ REMARK, "lens sensorwidth sensorheight sensorsize",
	    ": \"fovx\" is 2 atan(sensor width / 2 / focal length)" },
	{ REMARK, "size imagesize windowsize resolution",
	    ": give \"width\" and \"height\", of a picture in \"viewport\"" },
	{ REMARK, "euler rotationeuler",
	    ": give the quaternion of these angles as \"orientation\"" },
	{ REMARK, "zoom", ": only a window has it; in 3D give a smaller \"fovy\"" },
	{ REMARK, "scale", ": only a viewport has it; \"world\" can scale points" },
};
/* clang-format on */

enum { WORD_ROWS = sizeof word_rows / sizeof *word_rows };

const char *word_hint(const char *word, enum word_place place, char first)
{
	for (int i = 0; i < WORD_ROWS; i++)
		if ((word_rows[i].places & place) != 0 &&
		    (first == '\0' || *word_rows[i].hint == first) &&
		    word_is_one_of(word, word_rows[i].words))
			return word_rows[i].hint;
	return NULL;
}

/* Returns whether at most n edits, which word_closeness defines, make b of a. */
static bool edits_reach(const char *a, const char *b, int n)
{
	for (; *a != '\0' && strncasecmp(a, b, 1) == 0; a++)
		b++;
	if (n == 0 || (*a == '\0' && *b == '\0'))
		return *a == *b;
	if ((*a != '\0' && edits_reach(a + 1, b, n - 1)) ||
	    (*b != '\0' && edits_reach(a, b + 1, n - 1)))
		return true;
	return *a != '\0' && *b != '\0' &&
	    (edits_reach(a + 1, b + 1, n - 1) ||
		(strncasecmp(a, b + 1, 1) == 0 && strncasecmp(a + 1, b, 1) == 0 &&
		    edits_reach(a + 2, b + 2, n - 1)));
}

int word_closeness(const char *word, const char *name)
{
	const size_t n = strlen(word), m = strlen(name), least = n < m ? n : m;
	const int most = n < 2 ? 0 : n < 6 ? 1 : n < 9 ? 2 : 3;

	for (int edits = 0; edits <= most; edits++)
		if (edits_reach(word, name, edits))
			return WORD_EDITED + 3 - edits;
	return least > 2 && strncasecmp(word, name, least) == 0 ? WORD_BEGINS : 0;
}

void word_offer(struct word_guess *g, int closeness, const char *format, ...)
{
	va_list args;

	if (closeness <= g->closeness)
		return;
	va_start(args, format);
	vsnprintf(g->remedy, sizeof g->remedy, format, args);
	va_end(args);
	g->closeness = closeness;
}

void word_offer_list(struct word_guess *g, const char *const *words, const char *format)
{
	const char *hint = word_hint(g->word, WORD_VALUE, '\0');

	if (hint != NULL && *hint == ':')
		word_offer(g, WORD_KNOWN, "%s", hint + 2);
	for (; *words != NULL; words++)
		word_offer(g,
		    hint != NULL && strcmp(strrchr(hint, ' ') + 1, *words) == 0 ?
			WORD_KNOWN :
			word_closeness(g->word, *words),
		    format, *words);
}

bool word_is_one_of(const char *word, const char *words)
{
	while (words != NULL && *words != '\0') {
		const char *s = word + strspn(word, "_-");

		while (*words > ' ' &&
		    (*words == '_' || tolower((unsigned char)*s) == *words)) {
			s += *words++ != '_';
			s += strspn(s, "_-");
		}
		if (*s == '\0' && *words <= ' ')
			return true;
		words += strcspn(words, " ");
		words += *words == ' ';
	}
	return false;
}

const char *words_join(char out[LIST_ROOM], const char *const *words,
    const char *before_last, const char *quote)
{
	size_t at = 0;

	*out = '\0';
	for (int i = 0; words[i] != NULL && at < LIST_ROOM; i++)
		at += (size_t)snprintf(out + at, LIST_ROOM - at, "%s%s%s%s",
		    i == 0                   ? "" :
			words[i + 1] == NULL ? before_last :
					       ", ",
		    quote, words[i], quote);
	return out;
}
