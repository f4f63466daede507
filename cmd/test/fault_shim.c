/* SPDX-License-Identifier: MIT */
/* A library that fault_test.t preloads between the program and the C library. It makes
 * calls fail, as the variable FAULT of the environment says:
 *   FAULT="CALL N ERROR"  the N-th CALL fails with this error number. CALL is malloc
 *       (also realloc and calloc), read, open, thread, and write or close of standard
 *       output. After the N-th thread all others fail, too
 *   FAULT="torn N ERROR"  the N-th read takes at most 1000 bytes,
 * and the next one fails
 *   FAULT="short"  reads and writes take 1 to 7 bytes or are
 * interrupted, and poll often
 *       says that there is nothing to read
 *   FAULT="cut N FILE"  the N-th read finds FILE truncated to 100 bytes
 *   FAULT="stack N"  the program aborts when it makes a thread without asking for a
 *       stack of at least N bytes
 *   FAULT="clock N T"  N milliseconds pass between two calls of clock_gettime; standard
 *       error is a terminal if T is 1 or 2, and standard output if T is 2 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

extern void *__libc_malloc(size_t), *__libc_calloc(size_t, size_t),
    *__libc_realloc(void *, size_t);

static char fault_kind[16], file[256];
static int number, error;
static atomic_int calls;

__attribute__((constructor)) static void set_up(void)
{
	const char *fault = getenv("FAULT");

	if (fault == NULL)
		return;
	sscanf(fault, "%15s %d %d", fault_kind, &number, &error);
	sscanf(fault, "%*[a-z] %*d %255s", file);
	unsetenv("FAULT"); /* for the program alone, not for its children */
}

static bool is_fault(const char *name)
{
	return strcmp(fault_kind, name) == 0;
}

/* Counts a call of the kind in FAULT. Returns true, with errno set, if this call is
 * the N-th. */
static bool shall_fail(const char *name)
{
	if (!is_fault(name) || atomic_fetch_add(&calls, 1) + 1 != number)
		return false;
	errno = error;
	return true;
}

void *malloc(size_t n)
{
	return shall_fail("malloc") ? NULL : __libc_malloc(n);
}

void *calloc(size_t n, size_t size)
{
	return shall_fail("malloc") ? NULL : __libc_calloc(n, size);
}

void *realloc(void *p, size_t n)
{
	return shall_fail("malloc") ? NULL : __libc_realloc(p, n);
}

/* Returns a number of bytes from 1 to 7, at most n; or 0, with EINTR in errno, for an
 * interruption. */
static size_t few_bytes(size_t n)
{
	static atomic_uint turn;
	unsigned k = atomic_fetch_add(&turn, 1) * 2654435761u >> 16;

	if (k % 8 == 0)
		errno = EINTR;
	return k % 8 < n ? k % 8 : n;
}

/* Returns how many of the n bytes a read shall take, or -1 if it shall fail. */
static ssize_t before_read(size_t n)
{
	if (shall_fail("read"))
		return -1;
	if (is_fault("torn")) {
		int k = atomic_fetch_add(&calls, 1) + 1 - number;

		errno = error;
		return k == 1 ? -1 : k == 0 && n > 1000 ? 1000 : (ssize_t)n;
	}
	if (is_fault("cut") && atomic_fetch_add(&calls, 1) + 1 == number &&
	    truncate(file, 100) != 0)
		return -1;
	if (is_fault("short") && n > 0 && (n = few_bytes(n)) == 0)
		return -1;
	return (ssize_t)n;
}

ssize_t read(int fd, void *to, size_t n)
{
	static ssize_t (*real)(int, void *, size_t);

	if (real == NULL)
		real = (ssize_t(*)(int, void *, size_t))dlsym(RTLD_NEXT, "read");
	ssize_t some = before_read(n);

	return some < 0 ? -1 : real(fd, to, (size_t)some);
}

/* open with _FILE_OFFSET_BITS=64 */
int open64(const char *, int, ...) __attribute__((alias("open")));

ssize_t write(int fd, const void *from, size_t n)
{
	static ssize_t (*real)(int, const void *, size_t);

	if (real == NULL)
		real = (ssize_t(*)(int, const void *, size_t))dlsym(RTLD_NEXT, "write");
	if (fd == STDOUT_FILENO && shall_fail("write"))
		return -1;
	if (is_fault("short") && n > 0 && (n = few_bytes(n)) == 0)
		return -1;
	return real(fd, from, n);
}

int poll(struct pollfd *p, nfds_t n, int wait)
{
	static int (*real)(struct pollfd *, nfds_t, int);

	if (real == NULL)
		real = (int (*)(struct pollfd *, nfds_t, int))dlsym(RTLD_NEXT, "poll");
	if (is_fault("short") && few_bytes(7) < 3)
		return errno == EINTR ? -1 : 0;
	return real(p, n, wait);
}

int open(const char *name, int flags, ...)
{
	static int (*real)(const char *, int, ...);

	if (real == NULL)
		real = (int (*)(const char *, int, ...))dlsym(RTLD_NEXT, "open");
	return shall_fail("open") ? -1 : real(name, flags);
}

int close(int fd)
{
	static int (*real)(int);

	if (real == NULL)
		real = (int (*)(int))dlsym(RTLD_NEXT, "close");
	if (fd == STDOUT_FILENO && shall_fail("close"))
		return -1;
	return real(fd);
}

int pthread_create(pthread_t *t, const pthread_attr_t *a, void *(*f)(void *),
    void *with)
{
	static int (
	    *real)(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);

	if (real == NULL)
		real = (int (*)(pthread_t *, const pthread_attr_t *, void *(*)(void *),
		    void *))dlsym(RTLD_NEXT, "pthread_create");
	size_t stack = 0;

	if (a != NULL)
		pthread_attr_getstacksize(a, &stack);
	if (is_fault("stack") && stack < (size_t)number)
		abort();
	/* later threads fail, too, as on a system whose limit is reached */
	return is_fault("thread") && atomic_fetch_add(&calls, 1) + 1 >= number ?
	    error :
	    real(t, a, f, with);
}

int clock_gettime(clockid_t clock, struct timespec *t)
{
	static int (*real)(clockid_t, struct timespec *);

	if (real == NULL)
		real = (int (*)(clockid_t, struct timespec *))dlsym(RTLD_NEXT,
		    "clock_gettime");
	if (!is_fault("clock"))
		return real(clock, t);
	int now = 1000 + number * atomic_fetch_add(&calls, 1);

	*t = (struct timespec){ now / 1000, now % 1000 * 1000000L };
	return 0;
}

int isatty(int fd)
{
	static int (*real)(int);

	if (real == NULL)
		real = (int (*)(int))dlsym(RTLD_NEXT, "isatty");
	if (!is_fault("clock"))
		return real(fd);
	return fd == STDERR_FILENO ? error > 0 : fd == STDOUT_FILENO && error > 1;
}
