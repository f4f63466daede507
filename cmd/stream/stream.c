/* SPDX-License-Identifier: MIT */
#include "stream.h"

#include <sys/stat.h>
#include <unistd.h>

#include "answer.h"
#include "progress.h"
#include "threads.h"

/* How much of a file is left to read; 0 if fd is none. */
static long long size_of(int fd)
{
	struct stat st;
	off_t start = lseek(fd, 0, SEEK_CUR);

	if (start < 0 || fstat(fd, &st) != 0 || !S_ISREG(st.st_mode) ||
	    st.st_size < start)
		return 0;
	return st.st_size - start;
}

static void stream(struct job *j, struct point_source *s, long long size)
{
	progress_source(size);
	answer_source();
	threads_run(j, s);
}

void stream_file(struct job *j, const char *name, int fd)
{
	struct point_source s = source_of_file(name, fd);

	stream(j, &s, size_of(fd));
}

void stream_text(struct job *j, const char *name, const char *text, size_t size)
{
	struct point_source s = source_of_text(name, text, size);

	stream(j, &s, (long long)size);
}
