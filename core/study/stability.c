/* SPDX-License-Identifier: MIT */
/* Shows where classical ways to compute images fail, and where exact does not.
 *
 *	stability        tests it, a line a regime
 *	stability table  for reading
 *	stability data   for stability.gp: a block a regime, a line a severity,
 *			 of each way the error in device units and in units in
 *			 the last place, -1 where the image is lost, nan where
 *			 the scene is refused
 */
#include <stdio.h>
#include <string.h>

#include "../points/transform.h"
#include "compare.h"

static bool is_lost(const struct cell *c)
{
	return c->nan || c->sign;
}

static double larger(double a, double b)
{
	return a > b ? a : b;
}

/* Keeps in worst the greatest error of each way. */
static void worsen(struct row *worst, const struct row *r)
{
	for (int way = 0; way < WAYS; way++) {
		struct cell *w = &worst->cell[way];
		const struct cell *c = &r->cell[way];

		w->units = larger(w->units, c->units);
		w->ulps = larger(w->ulps, c->ulps);
		w->nan |= c->nan;
		w->sign |= c->sign;
	}
	worst->accurate = larger(worst->accurate, r->accurate);
	worst->wrong += r->wrong;
	worst->ruled += r->ruled;
}

/* Runs a regime, shows each row and returns the worst errors of all rows. */
static struct row sweep(const struct regime *r,
    void (*show)(double severity, const struct row *))
{
	double severity[ROWS];
	int n = regime_sweep(r, severity);
	struct row worst = { 0 };

	for (int i = 0; i < n; i++) {
		struct row row;

		ways_compare(r, severity[i], &row);
		worsen(&worst, &row);
		show(severity[i], &row);
	}
	return worst;
}

static void print_cell(const struct cell *c)
{
	char ulps[16];

	if (is_lost(c)) {
		printf(" %13s", c->nan ? "NaN" : "sign");
		return;
	}
	snprintf(ulps, sizeof ulps, c->ulps < 100 ? "%.2f" : "%.0e", c->ulps);
	printf(" %7.0e %5s", c->units, ulps);
}

static void print_cells(const struct row *r)
{
	for (int way = 0; way < WAYS; way++)
		if (r->refused && way >= OUR_SINGLE)
			printf(" %13s", "refused");
		else
			print_cell(&r->cell[way]);
	putchar('\n');
}

static void print_row(double severity, const struct row *r)
{
	printf("%-9.0e", severity);
	print_cells(r);
}

static void print_heading(const char *title)
{
	printf("\n%s\n%23s%14s%14s%14s%14s%14s%14s%14s\n", title, "float", "double",
	    "double", "double", "double", "-p single", "-p double", "exact");
	printf("%23s%14s%14s%14s%14s\n", "composed", "composed", "by stages",
	    "from the eye", "LU");
}

static int table(void)
{
	struct row worst[REGIMES];

	puts("The worst errors over a few hundred points: in device units "
	     "(units of the world\n"
	     "where it leads back) and in units in the last place of a "
	     "double. NaN: an image\n"
	     "is lost. sign: it is mirrored, or what is behind the eye is "
	     "taken to be before it.");
	for (int i = 0; i < REGIMES; i++) {
		print_heading(regimes[i].title);
		puts(regimes[i].swept);
		worst[i] = sweep(&regimes[i], print_row);
	}
	print_heading("The worst of each");
	for (int i = 0; i < REGIMES; i++) {
		printf("%-9s", regimes[i].name);
		print_cells(&worst[i]);
	}
	return 0;
}

/* gnuplot does not draw infinity. */
static void print_data(double severity, const struct row *r)
{
	printf("%.3g", severity < 1e300 ? severity : 1e300);
	for (int way = 0; way < WAYS; way++) {
		const struct cell *c = &r->cell[way];

		if (r->refused && way >= OUR_SINGLE)
			printf(" nan nan");
		else if (is_lost(c))
			printf(" -1 -1");
		else
			printf(" %.2e %.2e", c->units, c->ulps);
	}
	putchar('\n');
}

static int data(void)
{
	for (int i = 0; i < REGIMES; i++) {
		printf("# %s\n", regimes[i].name);
		sweep(&regimes[i], print_data);
		puts("\n");
	}
	return 0;
}

static void skip(double severity, const struct row *r)
{
	(void)severity;
	(void)r;
}

static bool is_broken(const struct regime *r, const struct row *worst)
{
	for (int way = 0; way < OUR_SINGLE; way++) {
		const struct cell *c = &worst->cell[way];

		if ((r->broken >> way & 1) != 0 && !is_lost(c) && c->units <= r->units)
			return false;
	}
	return true;
}

/* Tests each regime, and prints the results as TAP. */
static int test(void)
{
	int failed = 0;

	printf("1..%d\n", REGIMES);
	for (int i = 0; i < REGIMES; i++) {
		const struct regime *r = &regimes[i];
		struct row w = sweep(r, skip);
		bool kept = w.wrong == 0;
		bool shown = is_broken(r, &w);

		failed += !kept || !shown;
		printf("%s %d - %s: exact within %.3f ulps, %d numbers by the "
		       "rule of errors, up to %.0f %% of the points in the "
		       "accurate phase%s%s\n",
		    kept && shown ? "ok" : "not ok", i + 1, r->title,
		    w.cell[EXACT].ulps, w.ruled, 100 * w.accurate,
		    kept ? "" : "; not the nearest, or not refused",
		    shown ? "" : "; the classical ways do not break");
		fflush(stdout);
	}
	return failed > 0;
}

int main(int argc, char **argv)
{
	kernels_choose(NULL);
	if (argc == 1)
		return test();
	if (strcmp(argv[1], "table") == 0)
		return table();
	if (strcmp(argv[1], "data") == 0)
		return data();
	fprintf(stderr, "usage: stability [table|data]\n");
	return 2;
}
