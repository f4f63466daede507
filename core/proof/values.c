/* SPDX-License-Identifier: MIT */
/* Prints quotients, roots, sines, cosines and cotangents as the functions of core/exact
 * compute them: the operation, its operands, the exponent, and the words in
 * hexadecimal, the highest first. prove.pl compares them with its own. The operands are
 * the worst for the bound of a quotient and of a root, and rests near 45 degrees, where
 * a series is worst, near 0, and of many quarters of a turn. */
#include <stdio.h>

#include "exact/trig.h"

static void print(const char *what, double a, double b, const ex *r)
{
	printf("%s %a %a %d ", what, a, b, 64 * r->e);
	for (int i = r->n; i-- > 0;)
		printf("%016llx", (unsigned long long)r->word[i]);
	printf("\n");
}

int main(void)
{
	static const double of[] = { 3, 1 + 0x1p-52, 2 - 0x1p-52, 7, 0x1.fp62,
		0x1.fffffffffffffp63 };
	static const double angles[] = { 45 - 0x1p-46, 0.78125, 1e-9, 61.5 };

	for (int i = 0; i < 6; i++) {
		struct sum a = sum_of_double(of[i]), b = sum_of_double(3);
		struct sum quotient = sum_quotient(b, a), root = sum_sqrt(a);

		print("quotient", 3, of[i], &quotient.value);
		print("root", of[i], 2, &root.value);
	}
	for (int i = 0; i < 8; i++) {
		enum angle_unit unit = i % 2 ? ANGLE_RADIANS : ANGLE_DEGREES;
		double a = angles[i / 2];
		struct sum sine, cosine;

		trig_sin_cos(a, unit, &sine, &cosine);
		print("sine", a, unit, &sine.value);
		print("cosine", a, unit, &cosine.value);
		if (unit == ANGLE_DEGREES) {
			struct sum cot = trig_cot(a, unit);

			print("cotangent", a, unit, &cot.value);
		}
	}
	return 0;
}
