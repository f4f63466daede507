/* SPDX-License-Identifier: MIT */
/* Reads any bytes as a document, for libFuzzer. The first byte chooses the
 * document_wants. The functions here replace those of message.c. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../message/message.h"
#include "../scene/convention_member.h"
#include "../scene/document.h"
#include "../table/plan.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

struct message_state message_state;

/* The program must not end, whatever the document is. */
void die(int status, const char *what, const char *remedy)
{
	(void)status, (void)what, (void)remedy;
	abort();
}

/* Nothing is printed. */
void say_at(int status, const struct place *place, const char *what, const char *remedy)
{
	(void)status, (void)place, (void)what, (void)remedy;
	abort();
}

void output_write(const char *text, size_t n)
{
	(void)text, (void)n;
	abort();
}

/* Reallocates; the callers free the memory before they refuse anything. */
void *xrealloc(void *old, size_t size)
{
	void *p = realloc(old, size);

	if (p == NULL)
		abort();
	return p;
}

static void check_point_lines(const char *points, size_t size)
{
	for (size_t i = 0; i < size; i++)
		if ((points[i] == '[') != (i == 0 || points[i - 1] == '\n') &&
		    (i == 0 || points[i - 1] == '\n'))
			abort();
	if (size > 0 && memcmp(points + size - 2, "]\n", 2) != 0)
		abort();
}

static void check_camera(const struct camera *c)
{
	for (int i = 0; i < 3; i++)
		if (!(fabs(c->eye[i]) <= SCENE_MAGNITUDE_MAX &&
			fabs(c->at[i]) <= SCENE_MAGNITUDE_MAX))
			abort();
}

static void run(char *text, size_t size, int mode)
{
	static const enum scene_member bare[] = { 0, SCENE_CAMERA, SCENE_PROJECTION,
		SCENE_WINDOW };
	const struct document_wants wants = {
		.lone_member = bare[mode & 3],
		.needed = bare[mode & 3],
		.used = ~0u,
		.flat_members = mode & 7 ? 0 : SCENE_WINDOW | SCENE_DEVICE,
		.source.task = (mode & 15) == 0 ? TASK_FIT : TASK_WHOLE,
		.source.implied_type = (mode & 3) == 2 ? 1 + (mode >> 2 & 3) :
							 PROJECTION_NONE,
		.convention = mode & 16 ? &conventions[CONVENTION_GL] : NULL,
		.coordinates = mode >> 5 & 3,
	};
	static struct refusals faults;
	struct document_wants w = wants;
	struct document d;
	struct span points;

	faults.n = 0;
	w.source.faults = &faults;
	if (mode & 128) {
		struct json_source source = { .name = "a", .faults = &faults };

		if (document_read_points(&source, text, size, 2 + (mode & 1), &points))
			check_point_lines(points.s, (size_t)(points.end - points.s));
		return;
	}
	if (document_read(&d, "a", text, size, &w) != (faults.n == 0))
		abort();
	if (faults.n > 0)
		return;
	if (d.points != NULL)
		check_point_lines(d.points, d.points_size);
	if (!d.flat)
		check_camera(&d.scene.camera);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	char *const text = size > 0 ? malloc(size + LINE_MARGIN) : NULL;

	if (text == NULL)
		return 0;
	memcpy(text, data + 1, size - 1);
	run(text, size - 1, data[0]);
	free(text);
	return 0;
}
